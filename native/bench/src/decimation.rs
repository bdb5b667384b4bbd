//! Touch at full detail against touch of every second, fourth and eighth sample.

use crate::cache::{Lines, Warmth};
use crate::conduct::force;
use crate::contenders::{CONTENDERS, Contender, WALK};
use crate::path::{Course, Hand};
use crate::random::Random;
use crate::scene::{Field, Mode, Scene, length, proxy_at};
use crate::statistics::Spread;
use crate::timing::{BLOCK, Entry, Runner, Stopwatch, Track};
use contact::{Contact, Proxy};
use surface::{ByteOrder, Grid, GridError, GridLayout, GridPoint, Metric, SampleType};

/// Every so many samples are kept, in both directions.
pub const FACTORS: [usize; 4] = [1, 2, 4, 8];

/// Speeds, cells of the full grid per update.
pub const SPEEDS: [f64; 3] = [0.3, 1.0, 13.4];

/// Vertical exaggerations at which texture is compared.
pub const EXAGGERATIONS: [f64; 2] = [1.0, 5.0];

/// Updates timed, and updates whose force is compared.
const UPDATES: usize = 4096;
const FELT: usize = 40_960;

/// Cells of the full grid: what varies over a shorter way is texture.
pub const TEXTURE_CELLS: f64 = 16.0;

/// Cells per update of the hand that feels texture, and how deep it presses, widths of a cell.
const FEELING_SPEED: f64 = 0.3;
const FEELING_DEPTH: f64 = 1.0;

/// Places at which heights are compared.
const PLACES: usize = 400_000;

/// Touch with every so many samples.
pub struct DecimationRow {
    /// 1 for full detail.
    pub factor: usize,
    /// Bytes of all samples.
    pub bytes: u64,
    /// Nanoseconds of the walk, hot, at each of [`SPEEDS`].
    pub times: Vec<Spread>,
    /// Root mean square and most that the surface is off at the samples of the full grid, metres.
    pub error: [f64; 2],
    /// At each of [`EXAGGERATIONS`].
    pub texture: Vec<Texture>,
}

/// What is left of the force's texture.
#[derive(Clone, Copy, Debug)]
pub struct Texture {
    /// Root mean square of the force's texture, of that at full detail.
    pub kept: f64,
    /// Root mean square of the texture's difference from full detail, of the texture at full detail.
    pub wrong: f64,
}

/// Decimates a grid and touches all of its versions.
pub fn measure(full: &Grid, stopwatch: &Stopwatch) -> Result<Vec<DecimationRow>, GridError> {
    let grids: Vec<Grid> =
        FACTORS.iter().map(|factor| decimated(full, *factor)).collect::<Result<_, _>>()?;
    let walk = CONTENDERS.iter().find(|contender| contender.key == WALK);
    let walk = walk.expect("the walk is a contender");
    let mut rows: Vec<DecimationRow> = FACTORS
        .iter()
        .zip(&grids)
        .map(|(&factor, grid)| DecimationRow {
            factor,
            bytes: grid.layout().byte_length(),
            times: Vec::new(),
            error: error(full, grid, factor),
            texture: Vec::new(),
        })
        .collect();
    for speed in SPEEDS {
        let times = time(walk, full, &grids, speed, stopwatch);
        rows.iter_mut().zip(times).for_each(|(row, spread)| row.times.push(spread));
    }
    for exaggeration in EXAGGERATIONS {
        let found = textures(walk, full, &grids, exaggeration);
        rows.iter_mut().zip(found).for_each(|(row, texture)| row.texture.push(texture));
    }
    Ok(rows)
}

/// Every `factor`-th sample of every `factor`-th row, in memory.
fn decimated(full: &Grid, factor: usize) -> Result<Grid, GridError> {
    let layout = full.layout();
    let (rows, columns) = (layout.rows() as usize / factor, layout.columns() as usize / factor);
    let sample = |row: usize, column: usize| {
        let elevation = full.elevation((column * factor) as i64, (row * factor) as i64);
        (elevation.unwrap_or(0.0) as i16).to_be_bytes()
    };
    let samples = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let bytes = samples.flat_map(|(row, column)| sample(row, column)).collect();
    let cell = factor as f64;
    let (width, height) = (cell * layout.cell_width(), cell * layout.cell_height());
    let (rows, columns) = (rows as u64, columns as u64);
    let coarse = GridLayout::packed(rows, columns, width, height, SampleType::I16, ByteOrder::Big)?;
    Grid::from_vec(bytes, coarse.with_wrap(layout.wraps()))
}

fn scene(grid: &Grid, exaggeration: f64) -> Scene<'_> {
    let rows = f64::from(grid.layout().rows());
    Scene {
        key: "decimation",
        title: String::new(),
        grid,
        exaggeration,
        mode: Mode::Swipe,
        field: Field::Rows(rows / 12.0, rows * 11.0 / 12.0),
    }
}

/// The workspace of the full grid, over a grid with larger cells.
fn workspace(full: &Scene, factor: usize) -> Metric {
    let Metric { column, row, up } = full.metric();
    Metric { column: factor as f64 * column, row: factor as f64 * row, up }
}

/// The same path, in cells of a decimated grid.
fn coarser(course: &Course, factor: usize) -> Course {
    let cell = factor as f64;
    let place = |point: &GridPoint| {
        let (column, row) = (point.columns() / cell, point.rows() / cell);
        GridPoint::new(column, row, point.elevation)
    };
    let start = |proxy: &Proxy| proxy_at(place(&proxy.position), false);
    Course {
        goals: course.goals.iter().map(place).collect(),
        leg: course.leg,
        starts: course.starts.iter().map(start).collect(),
    }
}

fn time(
    walk: &Contender,
    full: &Grid,
    grids: &[Grid],
    speed: f64,
    stopwatch: &Stopwatch,
) -> Vec<Spread> {
    let whole = scene(full, 1.0);
    let course = Hand::new(speed, 6).over(&whole, UPDATES);
    let scenes: Vec<_> = grids.iter().map(|grid| scene(grid, 1.0)).collect();
    let courses: Vec<_> = FACTORS.iter().map(|factor| coarser(&course, *factor)).collect();
    let traces = traces(walk, &whole, grids, &course);
    let lines: Vec<_> = (0..grids.len())
        .map(|grid| {
            let trace = std::slice::from_ref(&traces[grid]);
            Lines::around(&scenes[grid], &courses[grid], trace, &[], BLOCK)
        })
        .collect();
    let tracks: Vec<_> = (0..grids.len())
        .map(|grid| Track {
            grid: &grids[grid],
            metric: workspace(&whole, FACTORS[grid]),
            course: &courses[grid],
            lines: Some(&lines[grid]),
        })
        .collect();
    let entry = |track| Entry { runner: Runner::Model(walk.build()), track };
    stopwatch.race(&mut tracks.iter().map(entry).collect::<Vec<_>>(), Warmth::Hot)
}

/// The walk along a path of the full grid, on every version of it.
fn traces(walk: &Contender, full: &Scene, grids: &[Grid], course: &Course) -> Vec<Vec<Contact>> {
    let follow = |(grid, &factor): (&Grid, &usize)| {
        let (metric, course) = (workspace(full, factor), coarser(course, factor));
        let mut model = walk.build();
        let update = |(update, goal)| {
            if let Some(start) = course.start_at(update) {
                model.take_over(start);
            }
            model.update(grid, &metric, goal)
        };
        course.goals.iter().enumerate().map(update).collect()
    };
    grids.iter().zip(&FACTORS).map(follow).collect()
}

/// How a slow hand at even depth feels the texture of every version.
fn textures(walk: &Contender, full: &Grid, grids: &[Grid], exaggeration: f64) -> Vec<Texture> {
    let whole = scene(full, exaggeration);
    let hand = Hand {
        follows: FEELING_SPEED / TEXTURE_CELLS,
        depth: (FEELING_DEPTH, FEELING_DEPTH),
        ..Hand::new(FEELING_SPEED, 7)
    };
    let course = hand.over(&whole, FELT);
    let metric = whole.metric();
    let felt: Vec<Vec<[f64; 3]>> = traces(walk, &whole, grids, &course)
        .iter()
        .map(|trace| {
            let forces: Vec<_> = trace.iter().map(|contact| force(contact, &metric)).collect();
            forces.chunks(course.leg).flat_map(texture).collect()
        })
        .collect();
    let at_full = root_mean_square(&felt[0]);
    let compare = |coarse: &Vec<[f64; 3]>| {
        let wrong: Vec<_> = coarse.iter().zip(&felt[0]).map(|(a, b)| minus(*a, *b)).collect();
        Texture {
            kept: root_mean_square(coarse) / at_full,
            wrong: root_mean_square(&wrong) / at_full,
        }
    };
    felt.iter().map(compare).collect()
}

/// The force less its mean over the way around.
fn texture(forces: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let half = (0.5 * TEXTURE_CELLS / FEELING_SPEED) as usize;
    let inner = half..forces.len().saturating_sub(half);
    let around = |update: usize| {
        let near = &forces[update - half..=update + half];
        let sum = near.iter().fold([0.0; 3], |sum, force| minus(sum, force.map(|part| -part)));
        minus(forces[update], sum.map(|part| part / near.len() as f64))
    };
    inner.map(around).collect()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn root_mean_square(vectors: &[[f64; 3]]) -> f64 {
    let squares: f64 = vectors.iter().map(|vector| length(*vector).powi(2)).sum();
    (squares / vectors.len().max(1) as f64).sqrt()
}

/// Root mean square and most that a decimated surface is off at random samples of the full grid.
fn error(full: &Grid, coarse: &Grid, factor: usize) -> [f64; 2] {
    let layout = full.layout();
    let mut random = Random::new(8);
    let (mut squares, mut most, mut compared) = (0.0, 0.0f64, 0u32);
    for _ in 0..PLACES {
        let column = random.below(layout.columns() as usize) as i64;
        let row = random.below(layout.rows() as usize - FACTORS[3]) as i64;
        let cell = factor as f64;
        let place = GridPoint::new(column as f64 / cell, row as f64 / cell, 0.0);
        if let (Some(exact), Some(found)) =
            (full.elevation(column, row), coarse.surface_elevation(&place))
        {
            let off = (found - exact).abs();
            (squares, most, compared) = (squares + off * off, most.max(off), compared + 1);
        }
    }
    [(squares / f64::from(compared.max(1))).sqrt(), most]
}
