//! The worst update there is: the goal jumps across the planet while the proxy is in touch.

use crate::contenders::{CONTENDERS, Contender};
use crate::random::Random;
use crate::scene::Scene;
use crate::timing::Stopwatch;
use contact::Contact;
use surface::GridPoint;

/// Jumps for each model.
const JUMPS: usize = 300;

/// How deep the goal is after a jump, widths of a cell.
const DEPTH: f64 = 1.0;

/// Updates after which a jump that is not walked out is given up.
const MOST_UPDATES: u32 = 2000;

/// The worst of all jumps of one model.
pub struct WorstRow {
    /// The model.
    pub key: &'static str,
    /// Microseconds of the slowest first update after a jump, the least of three tries.
    pub microseconds: f64,
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
        steps: 0,
        left_over: 0.0,
        updates: 0,
        unfinished: 0,
    };
    for _ in 0..JUMPS {
        let goal = below(scene, &mut random);
        let begin = model.proxy();
        let shared = std::cell::RefCell::new(&mut model);
        let (nanoseconds, first) = stopwatch.least_of_three(
            || shared.borrow_mut().take_over(begin),
            || shared.borrow_mut().update(scene.grid, &metric, &goal),
        );
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
    row
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
