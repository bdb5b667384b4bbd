//! What samples of other types cost, and what they lose: the same ground held in four ways.

use crate::cache::{CAN_FLUSH, Lines, Warmth};
use crate::contenders::{CONTENDERS, Contender, GRAPH, WALK};
use crate::path::Hand;
use crate::planet::Planet;
use crate::scene::{Field, Mode, Scene};
use crate::statistics::Spread;
use crate::terrain::Terrain;
use crate::timing::{BLOCK, Entry, Runner, Stopwatch, Track};
use crate::trace::trace;
use surface::{ByteOrder, Grid, GridError, GridLayout, SampleType};

/// Speeds, cells per update.
pub const SPEEDS: [f64; 2] = [1.0, 13.4];

/// Models timed.
pub const MODELS: [&str; 2] = [WALK, GRAPH];

/// Updates timed in each state of the caches.
const UPDATES: usize = 4096;

/// One way of holding samples.
pub struct StorageRow {
    /// In figures.
    pub key: &'static str,
    /// In tables.
    pub title: &'static str,
    /// Bytes of all samples.
    pub bytes: u64,
    /// Root mean square and most that heights are off, metres.
    pub error: [f64; 2],
    /// For each model, speed and state (hot, cold), nanoseconds.
    pub times: Vec<Timed>,
}

/// A time in a storage.
pub struct Timed {
    /// The model.
    pub model: &'static str,
    /// Cells per update.
    pub speed: f64,
    /// State of the caches.
    pub warmth: Warmth,
    /// Nanoseconds.
    pub spread: Spread,
}

/// Holds a planet's heights in every way, and times touch on each.
pub fn measure(planet: &Planet, stopwatch: &Stopwatch) -> Result<Vec<StorageRow>, GridError> {
    let heights = heights(&planet.terrain);
    let layout = planet.terrain.layout();
    let held = |sample, bytes| Grid::from_vec(bytes, of_type(&layout, sample));
    let to_i16 = |height: &f64| Terrain::sample(*height).to_be_bytes();
    let grids = [
        held(SampleType::I16, heights.iter().flat_map(to_i16).collect())?,
        held(
            SampleType::F32,
            heights.iter().flat_map(|height| (*height as f32).to_be_bytes()).collect(),
        )?,
        held(SampleType::F64, heights.iter().flat_map(|height| height.to_be_bytes()).collect())?,
    ];
    let off_i16 = error(&heights, |height| f64::from(Terrain::sample(height)));
    let off_f32 = error(&heights, |height| f64::from(height as f32));
    let row = |key, title, grid: &Grid, error| {
        let bytes = grid.layout().byte_length();
        StorageRow { key, title, bytes, error, times: Vec::new() }
    };
    let mut rows = [
        row("i16_mapped", "i16, mapped file", &planet.grid, off_i16),
        row("i16", "i16, in memory", &grids[0], off_i16),
        row("f32", "f32, in memory", &grids[1], off_f32),
        row("f64", "f64, in memory", &grids[2], [0.0; 2]),
    ];
    drop(heights);
    let grids: Vec<&Grid> = std::iter::once(&planet.grid).chain(&grids).collect();
    for speed in SPEEDS {
        time(&grids, speed, stopwatch, &mut rows);
    }
    Ok(rows.into())
}

fn time(grids: &[&Grid], speed: f64, stopwatch: &Stopwatch, rows: &mut [StorageRow]) {
    let scenes: Vec<_> = grids.iter().map(|grid| scene(grid)).collect();
    let course = Hand::new(speed, 5).over(&scenes[0], UPDATES);
    let models = CONTENDERS.iter().filter(|contender| MODELS.contains(&contender.key));
    let models: Vec<_> = models.collect();
    let lines: Vec<_> = scenes
        .iter()
        .map(|scene| {
            let follow = |model: &&Contender| trace(&mut *model.build(), scene, &course);
            let traces: Vec<_> = models.iter().map(follow).collect();
            Lines::around(scene, &course, &traces, &[], BLOCK)
        })
        .collect();
    let tracks: Vec<_> = scenes
        .iter()
        .zip(&lines)
        .map(|(scene, lines)| Track {
            grid: scene.grid,
            metric: scene.metric(),
            course: &course,
            lines: Some(lines),
        })
        .collect();
    for warmth in [Warmth::Hot, Warmth::Cold] {
        if warmth == Warmth::Cold && !CAN_FLUSH {
            continue;
        }
        let mut entries = Vec::new();
        for track in &tracks {
            for model in &models {
                entries.push(Entry { runner: Runner::Model(model.build()), track });
            }
        }
        let times = stopwatch.race(&mut entries, warmth);
        for (index, spread) in times.into_iter().enumerate() {
            let model = models[index % models.len()].key;
            rows[index / models.len()].times.push(Timed { model, speed, warmth, spread });
        }
    }
}

fn scene(grid: &Grid) -> Scene<'_> {
    let rows = f64::from(grid.layout().rows());
    Scene {
        key: "storage",
        title: String::new(),
        grid,
        exaggeration: 1.0,
        mode: Mode::Swipe,
        field: Field::Rows(rows / 12.0, rows * 11.0 / 12.0),
    }
}

/// Every height before it is rounded, row by row, metres.
fn heights(terrain: &Terrain) -> Vec<f64> {
    let layout = terrain.layout();
    let mut heights = vec![0.0; layout.samples() as usize];
    for (row, heights) in heights.chunks_exact_mut(layout.columns() as usize).enumerate() {
        terrain.row(row, heights);
    }
    heights
}

fn of_type(layout: &GridLayout, sample: SampleType) -> GridLayout {
    let (rows, columns) = (u64::from(layout.rows()), u64::from(layout.columns()));
    let (width, height) = (layout.cell_width(), layout.cell_height());
    GridLayout::packed(rows, columns, width, height, sample, ByteOrder::Big)
        .expect("a layout that was possible with smaller samples")
        .with_wrap(layout.wraps())
}

/// Root mean square and most that `stored` is off.
fn error(heights: &[f64], stored: impl Fn(f64) -> f64) -> [f64; 2] {
    let off = heights.iter().map(|height| (stored(*height) - height).abs());
    let (squares, most) =
        off.fold((0.0, 0.0f64), |(squares, most), off| (squares + off * off, most.max(off)));
    [(squares / heights.len() as f64).sqrt(), most]
}
