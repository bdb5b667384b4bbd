//! Every model at every scale: vertical scale 1e-6 to 1e9, cells 1e-6 to 1e6 wide and up to a
//! hundred times longer than wide, heights in doubles and in 16-bit samples.

mod common;

use common::models::all_models;
use common::random_hand::{Ground, RandomHand, cliffs};
use common::trial::{Tally, Trial};
use common::*;
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// Every model under the same hand.
fn try_all(grid: &Grid, metric: Metric, speed: f64, reach: f64, seed: u64) {
    for model in all_models(&metric) {
        let mut hand = RandomHand::new(grid, speed, reach, seed);
        let mut trial = Trial::over_the_middle(grid, metric, &model, BUDGET);
        for _ in 0..60 {
            trial.update(&hand.next(grid, &metric)).unwrap();
        }
    }
}

fn power(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|power| 10f64.powf(power))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(150) })]

    #[test]
    fn whatever_the_scales_all_models_keep_their_promises(
        seed in 0u64..1_000_000,
        width in power(-6.0, 6.0),
        aspect in power(-2.0, 2.0),
        vertical in power(-6.0, 9.0),
        relief in power(-2.0, 1.0),
        levels in prop_oneof![3 => Just(0usize), 1 => Just(2), 1 => Just(3)],
        wraps: bool,
        speed in power(-3.0, 1.5),
        reach in power(-3.0, 3.0),
    ) {
        let ground = Ground { levels, wraps, ..Ground::noise(12, 12, relief) };
        let grid = ground.grid(&mut Random::new(seed));
        // Heights in cells, times the vertical scale.
        let metric = Metric { column: width, row: width * aspect, up: width * vertical };
        try_all(&grid, metric, speed, reach, seed);
    }

    #[test]
    fn samples_at_both_ends_of_sixteen_bits_are_climbed_and_descended(
        seed in 0u64..1_000_000,
        width in power(-6.0, 6.0),
        aspect in power(-2.0, 2.0),
        exaggeration in power(-3.0, 3.0),
        speed in power(-3.0, 1.5),
        reach in power(-2.0, 5.0),
    ) {
        let grid = cliffs(12, 12, &mut Random::new(seed));
        let metric = Metric { column: width, row: width * aspect, up: exaggeration };
        try_all(&grid, metric, speed, reach, seed);
    }
}

/// Not a demand but a figure: how often the others do what the exact model never does.
#[test]
fn what_only_the_exact_model_promises_is_counted_for_the_others() {
    for (name, slope) in [("gentle", 0.1), ("unscaled noise", 0.5), ("x20", 10.0), ("x1e6", 1e6)] {
        let metric = SQUARE;
        for model in all_models(&metric) {
            let mut tally = Tally::default();
            for seed in 0..20 {
                let grid = hills(40, slope, seed);
                let mut hand =
                    WanderingHand::new(40, [0.03, 0.3, 3.0][seed as usize % 3], 2.0, seed);
                let mut trial = Trial::over_the_middle(&grid, metric, &model, BUDGET);
                for step in 0..200 {
                    let goal = hand.next(&grid);
                    trial.update(&goal).unwrap();
                    if step % 10 == 0 {
                        trial.rest(&goal).unwrap();
                    }
                }
                tally += trial.tally;
            }
            println!("{name:16} {model:?}: {tally}");
            assert!(tally.in_contact * 4 > tally.updates, "the hand has to touch to test anything");
        }
    }
}

/// The unit of length is nobody's business.
#[test]
fn nothing_depends_on_the_unit_of_length() {
    for unit in [-18, 18].map(|power| 2f64.powi(power)) {
        let scaled = Metric { column: unit, row: unit, up: unit };
        for (one, other) in all_models(&SQUARE).into_iter().zip(all_models(&scaled)) {
            for seed in 0..10 {
                let grid = hills(40, 1.0, seed);
                let start = GridPoint::new(20.0, 20.0, 100.0);
                let mut hand = RandomHand::new(&grid, 0.5, 2.0, seed);
                let mut one = Trial::new(&grid, SQUARE, &one, BUDGET, start);
                let mut other = Trial::new(&grid, scaled, &other, BUDGET, start);
                for _ in 0..100 {
                    let goal = hand.next(&grid, &SQUARE);
                    let (a, b) = (one.update(&goal).unwrap(), other.update(&goal).unwrap());
                    assert_eq!((a.proxy, a.feature, a.counters), (b.proxy, b.feature, b.counters));
                }
            }
        }
    }
}
