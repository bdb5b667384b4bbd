//! What may change under a touching hand: the model, the zoom, the exaggeration, the place of the
//! hand; and how little an update may be allowed to do.

mod common;

use common::models::{all_models, is_point};
use common::random_hand::{Ground, RandomHand};
use common::trial::{MOST_GROWTH, Trial};
use common::*;
use contact::{Feature, MIN_STEP_BUDGET, Model};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// Models for which the distance falls in every step, from wherever they begin.
fn never_raises_the_distance(model: &Model) -> bool {
    matches!(model.build(1).name(), "surface_walk" | "god_object_release")
}

/// Presses with one model, goes on with the other, and tells by how much the distance grew.
fn grown_by_switching(grid: &Grid, from: &Model, to: &Model, goals: &[GridPoint]) -> Vec<f64> {
    let mut trial = Trial::over_the_middle(grid, SQUARE, from, BUDGET);
    let mut grown = Vec::new();
    for goal in goals {
        let before = trial.settle(goal).unwrap();
        trial.switch(to, BUDGET).unwrap();
        let after = trial.update(goal).unwrap();
        assert!(
            after.feature != Feature::Free || before.feature == Feature::Free,
            "{from:?} to {to:?} lost contact at {goal:?}: {before:?} {after:?}"
        );
        grown.push(after.distance() - before.distance() * (1.0 + MOST_GROWTH));
        trial.switch(from, BUDGET).unwrap();
    }
    grown
}

#[test]
fn switching_models_in_touch_keeps_the_contact_and_the_place() {
    for (slope, seed) in [(0.2, 1), (1.0, 2), (10.0, 3), (10.0, 4)] {
        let grid = white_noise(16, slope, seed);
        let mut random = Random::new(seed);
        let goals: Vec<GridPoint> = (0..100)
            .map(|_| {
                let (x, y) = (random.between(1.0, 14.0), random.between(1.0, 14.0));
                GridPoint::new(x, y, -random.between(0.1, 1.0 + slope))
            })
            .collect();
        for from in all_models(&SQUARE) {
            for to in all_models(&SQUARE) {
                let is_measured = [from, to].iter().all(|model| is_point(&*model.build(1)));
                let grown = grown_by_switching(&grid, &from, &to, &goals);
                let rounding = 1e-12 * slope;
                let times = grown.iter().filter(|growth| **growth > rounding).count();
                if is_measured && times > 0 {
                    println!(
                        "slope {slope}: {from:?} to {to:?} grew {times} times of {}",
                        goals.len()
                    );
                    assert!(!never_raises_the_distance(&to), "{from:?} to {to:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    /// Zoom and exaggeration move what is nearest; the proxy goes there over the ground.
    #[test]
    fn zoom_and_exaggeration_may_change_in_mid_contact(
        seed in 0u64..1_000_000,
        slope in -2.0f64..2.0,
        speed in 0.001f64..5.0,
    ) {
        let grid = Ground::noise(14, 14, 10f64.powf(slope)).grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 2.0, seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            let mut zooms = Random::new(seed + 1);
            for step in 0..80 {
                if step % 5 == 4 {
                    let mut power = |most: f64| 10f64.powf(zooms.between(-most, most));
                    let zoom = power(3.0);
                    let metric = Metric { column: zoom, row: zoom * power(1.0), up: zoom * power(3.0) };
                    trial.change_metric(metric);
                }
                let metric = trial.metric();
                trial.update(&hand.next(&grid, &metric)).unwrap();
            }
        }
    }

    /// Small budgets are kept, and what is left over is walked in the next updates, to an end.
    #[test]
    fn small_budgets_are_kept_and_come_to_an_end(
        seed in 0u64..1_000_000,
        slope in -2.0f64..3.0,
        budget in MIN_STEP_BUDGET..2 * MIN_STEP_BUDGET,
        speed in 0.1f64..20.0,
    ) {
        let slope = 10f64.powf(slope);
        let grid = Ground::noise(20, 20, slope).grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 1.0 + slope, seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, budget);
            for step in 0..40 {
                let goal = hand.next(&grid, &SQUARE);
                if step % 2 == 0 {
                    trial.rest(&goal).unwrap();
                } else {
                    // The goal moves on before the way is gone.
                    trial.update(&goal).unwrap();
                }
            }
        }
    }

    /// A circle of the graph, of the walk around a vertex, and the constraints of a god-object that moves
    /// nowhere, may take more steps than one update has: the next one has to know of them.
    #[test]
    fn what_takes_several_updates_in_one_place_comes_to_an_end(
        seed in 0u64..1_000_000,
        slope in -2.0f64..3.0,
        budget in 1..MIN_STEP_BUDGET + 8,
        speed in 0.1f64..20.0,
    ) {
        let slope = 10f64.powf(slope);
        let grid = Ground::noise(20, 20, slope).grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 1.0 + slope, seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, budget);
            for _ in 0..20 {
                trial.rest(&hand.next(&grid, &SQUARE)).unwrap();
            }
        }
    }

    /// Everything at once: models, budgets, metrics and places change between updates.
    #[test]
    fn anything_may_change_at_any_time(seed in 0u64..1_000_000, voids in prop_oneof![Just(0.0), Just(0.2)]) {
        let ground = Ground { voids, ..Ground::noise(14, 14, 2.0) };
        let grid = ground.grid(&mut Random::new(seed));
        let mut random = Random::new(seed + 1);
        let mut hand = RandomHand::new(&grid, 0.5, 2.0, seed);
        let mut trial = Trial::over_the_middle(&grid, SQUARE, &all_models(&SQUARE)[0], BUDGET);
        for _ in 0..200 {
            let metric = trial.metric();
            match random.below(12) {
                0 | 1 => {
                    let models = all_models(&metric);
                    trial.switch(&models[random.below(models.len())], 16 + random.below(4096) as u32).unwrap();
                }
                2 => {
                    let mut power = || 10f64.powf(random.between(-2.0, 2.0));
                    trial.change_metric(Metric { column: power(), row: power(), up: power() });
                }
                3 => {
                    let over = hand.next(&grid, &metric);
                    trial.place(GridPoint { elevation: over.elevation + 5.0, ..over });
                }
                _ => {
                    trial.update(&hand.next(&grid, &metric)).unwrap();
                }
            }
        }
    }
}
