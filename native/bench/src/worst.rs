//! The worst update there is: the goal jumps across the planet, or along a straight crease, while the
//! proxy is in touch.

use crate::contenders::{CONTENDERS, Contender};
use crate::random::Random;
use crate::scene::{CELL, Scene};
use crate::statistics::{Spread, quantile};
use crate::tables::SceneCells;
use crate::timing::Stopwatch;
use contact::Contact;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Metric, SampleType};

/// Jumps for each model.
const JUMPS: usize = 300;

/// How deep the goal is after a jump, widths of a cell.
const DEPTH: f64 = 1.0;

/// Tries of each jump along a crease.
const CREASE_TRIES: usize = 7;

/// Updates after which a jump that is not walked out is given up.
const MOST_UPDATES: u32 = 2000;

/// The worst of all jumps of one model.
pub struct WorstRow {
    /// The model.
    pub key: &'static str,
    /// Microseconds of the slowest first update after a jump, the least of three tries: caches warm.
    pub microseconds: f64,
    /// Microseconds of the first tries, caches as the jump finds them: median and 90th percentile.
    pub first_try: [f64; 2],
    /// Microseconds of the slowest jump along a crease, the least of [`CREASE_TRIES`].
    pub crease: f64,
    /// Most steps (vertices, faces and cells) in one update.
    pub steps: u32,
    /// Share of jumps that left something to walk.
    pub left_over: f64,
    /// Most updates that it took to walk all of it.
    pub updates: u32,
    /// Jumps that were given up.
    pub unfinished: u32,
}

/// Measures all models.
pub fn measure(scene: &Scene, stopwatch: &Stopwatch) -> Vec<WorstRow> {
    CONTENDERS.iter().map(|contender| jump(contender, scene, stopwatch)).collect()
}

fn jump(contender: &Contender, scene: &Scene, stopwatch: &Stopwatch) -> WorstRow {
    let mut random = Random::new(11);
    let metric = scene.metric();
    let mut model = contender.build();
    model.place(above(scene, &mut random));
    let mut row = WorstRow {
        key: contender.key,
        microseconds: 0.0,
        first_try: [0.0; 2],
        crease: crease(contender, stopwatch),
        steps: 0,
        left_over: 0.0,
        updates: 0,
        unfinished: 0,
    };
    let mut first_tries = Vec::with_capacity(JUMPS);
    for _ in 0..JUMPS {
        let goal = below(scene, &mut random);
        let begin = model.proxy();
        let shared = std::cell::RefCell::new(&mut model);
        let (first_try, nanoseconds, first) = stopwatch.first_and_least_of(
            3,
            || shared.borrow_mut().take_over(begin),
            || shared.borrow_mut().update(scene.grid, &metric, &goal),
        );
        first_tries.push(first_try / 1e3);
        row.microseconds = row.microseconds.max(nanoseconds / 1e3);
        row.steps = row.steps.max(steps(&first));
        row.left_over += f64::from(first.counters.steps_left > 0) / JUMPS as f64;
        let (mut updates, mut left) = (1, first.counters.steps_left);
        while left > 0 && updates < MOST_UPDATES {
            let contact = model.update(scene.grid, &metric, &goal);
            row.steps = row.steps.max(steps(&contact));
            left = contact.counters.steps_left;
            updates += 1;
        }
        row.updates = row.updates.max(updates);
        row.unfinished += u32::from(left > 0);
    }
    let spread = Spread::of(first_tries.clone());
    first_tries.sort_unstable_by(f64::total_cmp);
    row.first_try = [spread.median, quantile(&first_tries, 0.9)];
    row
}

/// A crease that leads straight from vertex to vertex: of all ground the one whose steps take longest.
/// Microseconds of the slowest of several shapes.
fn crease(contender: &Contender, stopwatch: &Stopwatch) -> f64 {
    let shapes = [(-0.3, 10.0), (-0.3, 1.0), (-0.3, 0.5), (0.0, 1.0), (0.0, 0.3)];
    // The cells of the scenes are a thousandth of these wide, and the sphere is as small.
    let metric = Metric { column: CELL, row: CELL, up: CELL };
    let times = shapes.map(|(slope, wall)| {
        let grid = creased(slope, wall);
        let start = GridPoint::new(10.0, 50.0, slope * 10.0);
        let goal = GridPoint::new(5990.0, 50.0, slope * 5990.0 - 1.0);
        let model = std::cell::RefCell::new(contender.build());
        let (_, nanoseconds, _) = stopwatch.first_and_least_of(
            CREASE_TRIES,
            || {
                let mut model = model.borrow_mut();
                model.place(GridPoint { elevation: start.elevation + 1.0, ..start });
                model.update(
                    &grid,
                    &metric,
                    &GridPoint { elevation: start.elevation - 1.0, ..start },
                );
            },
            || model.borrow_mut().update(&grid, &metric, &goal),
        );
        nanoseconds / 1e3
    });
    times.into_iter().fold(0.0, f64::max)
}

fn creased(slope: f64, wall: f64) -> Grid {
    let samples = (0..101).flat_map(|row| {
        (0..6000).map(move |column| f64::from(row - 50i32).abs() * wall + slope * f64::from(column))
    });
    let bytes = samples.flat_map(|height| height.to_be_bytes()).collect();
    let layout = GridLayout::packed(101, 6000, 1.0, 1.0, SampleType::F64, ByteOrder::Big);
    Grid::from_vec(bytes, layout.expect("a layout")).expect("as many bytes as samples need")
}

/// The slowest hundredth of the updates of a model, of all scenes and speeds the worst, microseconds:
/// caches hot and cold.
pub fn worst_p99(scenes: &[SceneCells], index: usize) -> [f64; 2] {
    let cells = || scenes.iter().flat_map(|scene| &scene.cells);
    let worst =
        |spread: Option<&Spread>, worst: f64| spread.map_or(worst, |s| worst.max(s.p99 / 1e3));
    [
        cells().fold(0.0, |most, cell| worst(cell.times.hot.get(index), most)),
        cells().fold(0.0, |most, cell| worst(cell.times.cold.get(index), most)),
    ]
}

fn steps(contact: &Contact) -> u32 {
    contact.counters.vertices + contact.counters.faces + contact.counters.cells
}

fn above(scene: &Scene, random: &mut Random) -> GridPoint {
    let goal = below(scene, random);
    GridPoint { elevation: goal.elevation + 2.0 * DEPTH * scene.metres_for_a_cell(), ..goal }
}

fn below(scene: &Scene, random: &mut Random) -> GridPoint {
    let layout = scene.grid.layout();
    let column = random.between(0.0, f64::from(layout.columns() - 1));
    let row = random.between(1.0, f64::from(layout.rows() - 2));
    let place = GridPoint::new(column, row, 0.0);
    let surface = scene.grid.surface_elevation(&place).unwrap_or(0.0);
    GridPoint { elevation: surface - DEPTH * scene.metres_for_a_cell(), ..place }
}
