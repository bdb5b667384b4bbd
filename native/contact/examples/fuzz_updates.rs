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
//! ends the sequence: its seed, the model, and the updates up to there are the finding. `--seed` runs one
//! sequence again and shows every step; `--model` keeps to one model. An update that does not return
//! within ten seconds is a finding too. Exits with 1 if anything was found.

#[path = "../tests/common/mod.rs"]
mod common;

use common::models::all_models;
use common::random_hand::{Ground, RandomHand, cliffs};
use common::trial::{Broken, Tally, Trial};
use contact::{MIN_STEP_BUDGET, Model};
use oracle::terrain::Random;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
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
        let seen = Seen::default();
        let result = run(seed, only.as_deref(), &seen, true);
        println!("{result:?} after {} steps", seen.steps.get());
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
    let mut findings = 0;
    let mut by_model: BTreeMap<String, (Tally, u32)> = BTreeMap::new();
    while begun.elapsed() < time && findings < MOST_FINDINGS {
        let seed = current.load(Ordering::Relaxed);
        let seen = Seen::default();
        let outcome = catch_unwind(AssertUnwindSafe(|| run(seed, only, &seen, false)));
        let broken = match outcome {
            Ok(Ok(())) => None,
            Ok(Err(broken)) => Some(broken),
            Err(panic) => Some(format!("panic: {}", words_of(&*panic))),
        };
        for (name, tally) in seen.tallies.take() {
            by_model.entry(name).or_default().0 += tally;
        }
        if let Some(broken) = broken {
            findings += 1;
            by_model.entry(seen.model.take()).or_default().1 += 1;
            println!("seed {seed}, {} steps: {broken}\n", seen.steps.get());
        }
        current.store(seed + 1, Ordering::Relaxed);
    }
    let sequences = current.load(Ordering::Relaxed) - first;
    for (name, (tally, findings)) in &by_model {
        println!("{name}: {findings} findings, {tally}");
    }
    println!("{sequences} sequences in {:.0?}, {findings} findings", begun.elapsed());
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

/// What is known of a sequence, also where it breaks off.
#[derive(Default)]
struct Seen {
    /// How far it came.
    steps: Cell<u32>,
    /// The model that answers.
    model: RefCell<String>,
    /// What those before it did.
    tallies: RefCell<Vec<(String, Tally)>>,
}

impl Seen {
    /// From now on this model answers.
    fn begin(&self, model: &Model) {
        let knob = match model {
            Model::SurfaceWalk { sub_step: Some(longest) } => format!(" by {longest}"),
            _ => String::new(),
        };
        self.model.replace(format!("{}{knob}", model.name()));
    }

    /// The model that answered does not answer any more.
    fn end(&self, trial: &mut Trial) {
        let tally = std::mem::take(&mut trial.tally);
        self.tallies.borrow_mut().push((self.model.borrow().clone(), tally));
    }
}

/// One sequence.
fn run(seed: u64, only: Option<&str>, seen: &Seen, is_shown: bool) -> Result<(), Broken> {
    let mut random = Random::new(seed);
    let grid = ground(&mut random);
    let metric = within_range(metric(&mut random), &grid);
    let (model, budget) = (model(&mut random, &metric, only), budget(&mut random));
    let speed = 10f64.powf(random.between(-3.0, 1.3));
    let reach = 10f64.powf(random.between(-2.0, 3.0));
    let mut hand = RandomHand::new(&grid, speed, reach, seed ^ 0x5EED);
    let mut trial = Trial::over_the_middle(&grid, metric, &model, budget);
    seen.begin(&model);
    if is_shown {
        show_ground(&grid);
        println!("{metric:?} {model:?} budget {budget}, {:?}", trial.proxy());
    }
    for _ in 0..10 + random.below(150) {
        seen.steps.set(seen.steps.get() + 1);
        let action = Action::any(&mut random, &mut hand, &trial, only);
        if is_shown {
            println!("{}: {action:?}", seen.steps.get());
        }
        if let Action::Switch(model, _) = &action {
            seen.end(&mut trial);
            seen.begin(model);
        }
        let taken = action.take(&mut trial);
        if taken.is_err() {
            seen.end(&mut trial);
        }
        taken?;
        if is_shown {
            println!("    {:?}", trial.proxy());
        }
    }
    seen.end(&mut trial);
    Ok(())
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
                let zoomed =
                    Metric { column: column * power(), row: row * power(), up: up * power() };
                Self::Zoom(within_range(zoomed, grid))
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

/// The metric, brought back to what models are asked to bear: cells up to 100 times longer than wide or
/// wider than long, and heights from 1e-6 to 1e9 times what a cell is wide.
fn within_range(metric: Metric, grid: &Grid) -> Metric {
    let Metric { column, row, up } = metric;
    let row = row.clamp(column / 100.0, column * 100.0);
    let height = grid.range().map_or(1.0, |range| range.maximum.abs().max(range.minimum.abs()));
    // Samples of less than a metre are not asked to be stretched farther for it.
    let most = 1e9 * column.min(row) / height.max(1.0);
    Metric { column, row, up: up.clamp(1e-6 * column, most) }
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
    match random.below(10) {
        0 => MIN_STEP_BUDGET,
        1..3 => MIN_STEP_BUDGET + random.below(200) as u32,
        _ => 4096,
    }
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
