//! Random sequences of updates, each looked at as closely as in the tests, for as long as one likes.
//!
//! ```text
//! cargo run --release -p contact --example fuzz_updates -- --seconds 600
//! cargo run --release -p contact --example fuzz_updates -- --seconds 60 --from 1000 --model surface_walk
//! cargo run --release -p contact --example fuzz_updates -- --seed 1234
//! ```
//!
//! A sequence is made from its seed alone: a small ground (noise, steps, planes, cliffs; with or
//! without voids and wrap), a metric, a model, a step budget, and then goals, rests, jumps, broken
//! goals, changes of metric and switches of model. The first update that breaks a promise, or panics,
//! ends the sequence: its seed and the updates up to there are the finding. `--seed` runs one
//! sequence again and shows every step; `--model` keeps to one model. An update that does not return
//! within ten seconds is a finding too. Exits with 1 if anything was found.

#[path = "../tests/common/mod.rs"]
mod common;

use common::models::all_models;
use common::random_hand::{Ground, RandomHand, cliffs};
use common::trial::{Broken, Tally, Trial};
use contact::Model;
use oracle::terrain::Random;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use surface::{Grid, GridPoint, Metric};

/// Findings shown before the fuzzing ends.
const MOST_FINDINGS: usize = 20;

/// What an update may take before it is taken to hang.
const PATIENCE: Duration = Duration::from_secs(10);

fn main() -> ExitCode {
    let number = |name| argument(name).map(|text| text.parse().expect("a whole number"));
    let only = argument("--model");
    if let Some(seed) = number("--seed") {
        let steps = Cell::new(0);
        let result = run(seed, only.as_deref(), &steps, true);
        println!("{result:?} after {} steps", steps.get());
        return if result.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    // Panics are told with their seed.
    std::panic::set_hook(Box::new(|_| ()));
    let seconds = number("--seconds").unwrap_or(60);
    fuzz(Duration::from_secs(seconds), number("--from").unwrap_or(0), only.as_deref())
}

fn argument(name: &str) -> Option<String> {
    let mut arguments = std::env::args().skip_while(|argument| argument != name);
    arguments.next()?;
    arguments.next()
}

fn fuzz(time: Duration, first: u64, only: Option<&str>) -> ExitCode {
    let current = Arc::new(AtomicU64::new(first));
    watch(&current);
    let begun = Instant::now();
    let (mut findings, mut tally) = (0, Tally::default());
    while begun.elapsed() < time && findings < MOST_FINDINGS {
        let seed = current.load(Ordering::Relaxed);
        let steps = Cell::new(0);
        let outcome = catch_unwind(AssertUnwindSafe(|| run(seed, only, &steps, false)));
        let broken = match outcome {
            Ok(Ok(seen)) => {
                tally += seen;
                None
            }
            Ok(Err(broken)) => Some(broken),
            Err(panic) => Some(format!("panic: {}", words_of(&*panic))),
        };
        if let Some(broken) = broken {
            findings += 1;
            println!("seed {seed}, {} steps: {broken}\n", steps.get());
        }
        current.store(seed + 1, Ordering::Relaxed);
    }
    let sequences = current.load(Ordering::Relaxed) - first;
    println!("{sequences} sequences in {:.0?}, {findings} findings; {tally}", begun.elapsed());
    if findings == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Ends the program where one sequence takes too long.
fn watch(current: &Arc<AtomicU64>) {
    let current = Arc::clone(current);
    std::thread::spawn(move || {
        loop {
            let seed = current.load(Ordering::Relaxed);
            std::thread::sleep(PATIENCE);
            if current.load(Ordering::Relaxed) == seed {
                println!("seed {seed} did not end within {PATIENCE:?}");
                std::process::exit(1);
            }
        }
    });
}

fn words_of(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// One sequence; `steps` counts how far it came.
fn run(seed: u64, only: Option<&str>, steps: &Cell<u32>, is_shown: bool) -> Result<Tally, Broken> {
    let mut random = Random::new(seed);
    let grid = ground(&mut random);
    let metric = metric(&mut random);
    let (model, budget) = (model(&mut random, &metric, only), budget(&mut random));
    let speed = 10f64.powf(random.between(-3.0, 1.3));
    let reach = 10f64.powf(random.between(-2.0, 3.0));
    let mut hand = RandomHand::new(&grid, speed, reach, seed ^ 0x5EED);
    let mut trial = Trial::over_the_middle(&grid, metric, &model, budget);
    if is_shown {
        show_ground(&grid);
        println!("{metric:?} {model:?} budget {budget}, {:?}", trial.proxy());
    }
    for _ in 0..10 + random.below(150) {
        steps.set(steps.get() + 1);
        let action = Action::any(&mut random, &mut hand, &trial, only);
        if is_shown {
            println!("{}: {action:?}", steps.get());
        }
        action.take(&mut trial)?;
        if is_shown {
            println!("    {:?}", trial.proxy());
        }
    }
    Ok(trial.tally)
}

/// What happens next.
#[derive(Debug)]
enum Action {
    Update(GridPoint),
    /// The goal stays until everything is walked, and on.
    Rest(GridPoint),
    Broken(GridPoint),
    Place(GridPoint),
    Zoom(Metric),
    Switch(Model, u32),
}

impl Action {
    fn any(random: &mut Random, hand: &mut RandomHand, trial: &Trial, only: Option<&str>) -> Self {
        let (grid, metric) = (trial.grid, trial.metric());
        let goal = hand.next(grid, &metric);
        match random.below(40) {
            0 => {
                let mut part =
                    || [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.5][random.below(4)];
                Self::Broken(GridPoint { u: part(), v: part(), elevation: part(), ..goal })
            }
            1 => {
                let cell = metric.column / metric.up;
                Self::Place(GridPoint { elevation: goal.elevation + 3.0 * cell, ..goal })
            }
            2 => {
                let mut power = || 10f64.powf(random.between(-1.0, 1.0));
                let (column, row, up) = (metric.column, metric.row, metric.up);
                Self::Zoom(Metric {
                    column: column * power(),
                    row: row * power(),
                    up: up * power(),
                })
            }
            3 | 4 => Self::Switch(model(random, &metric, only), budget(random)),
            5 => {
                // Off the map, or around the planet.
                let far = 10f64.powf(random.between(0.0, 4.0));
                let mut aside = || far * random.between(-1.0, 1.0);
                let (u, v) = (goal.u + aside(), goal.v + aside());
                Self::Update(GridPoint::from_sample(goal.column, goal.row, u, v, goal.elevation))
            }
            6..12 => Self::Rest(goal),
            _ => Self::Update(goal),
        }
    }

    fn take(&self, trial: &mut Trial) -> Result<(), Broken> {
        match self {
            Self::Update(goal) => trial.update(goal).map(drop),
            Self::Rest(goal) => trial.rest(goal).map(drop),
            Self::Broken(goal) if goal.is_finite() => trial.update(goal).map(drop),
            Self::Broken(goal) => trial.endure(goal),
            Self::Place(at) => {
                trial.place(*at);
                Ok(())
            }
            Self::Zoom(metric) => {
                trial.change_metric(*metric);
                Ok(())
            }
            Self::Switch(model, budget) => trial.switch(model, *budget),
        }
    }
}

fn ground(random: &mut Random) -> Grid {
    let (columns, rows) = (2 + random.below(13), 2 + random.below(13));
    if random.unit() < 0.1 {
        return cliffs(columns, rows, random);
    }
    let relief = 10f64.powf(random.between(-2.0, 2.0));
    let levels = [0, 0, 2, 3, 5][random.below(5)];
    let mut slope = || (random.between(-4.0, 4.0)).round() / 2.0;
    let slopes = [slope(), slope()];
    let plane = (random.unit() < 0.1).then_some(slopes);
    let voids = [0.0, 0.0, 0.05, 0.4][random.below(4)];
    let wraps = random.unit() < 0.3;
    Ground { columns, rows, relief, levels, plane, voids, wraps }.grid(random)
}

/// Mostly cells as wide as long; mostly heights as they are.
fn metric(random: &mut Random) -> Metric {
    let mut power = |likely: f64, most: f64| {
        if random.unit() < likely { 1.0 } else { 10f64.powf(random.between(-most, most)) }
    };
    let zoom = power(0.5, 6.0);
    Metric { column: zoom, row: zoom * power(0.6, 2.0), up: zoom * power(0.6, 6.0) }
}

fn model(random: &mut Random, metric: &Metric, only: Option<&str>) -> Model {
    let models = all_models(metric);
    loop {
        let model = models[random.below(models.len())];
        if only.is_none_or(|name| name == model.name()) {
            return model;
        }
    }
}

fn budget(random: &mut Random) -> u32 {
    if random.unit() < 0.7 { 4096 } else { 64 + random.below(200) as u32 }
}

fn show_ground(grid: &Grid) {
    let layout = grid.layout();
    println!("{layout:?}");
    for row in 0..i64::from(layout.rows()) {
        let heights: Vec<String> = (0..i64::from(layout.columns()))
            .map(|column| grid.elevation(column, row).map_or("void".into(), |z| format!("{z:?}")))
            .collect();
        println!("[{}]", heights.join(", "));
    }
}
