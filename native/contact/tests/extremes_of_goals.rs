//! Goals that no hand can mean: not numbers, without end, far beyond the map or the planet, or too
//! small to tell from nothing.

mod common;

use common::models::{all_models, may_float};
use common::trial::Trial;
use common::*;
use contact::Feature;
use surface::{GridPoint, Metric};

const BUDGET: u32 = 4096;

#[test]
fn goals_that_are_not_finite_leave_the_proxy_and_its_contact() {
    let grid = hills(40, 0.5, 5);
    for model in all_models(&SQUARE) {
        let mut one = model.build(BUDGET);
        one.place(GridPoint::new(20.2, 20.4, 50.0));
        let goal = GridPoint::new(20.0, 20.0, -20.0);
        let touched = one.update(&grid, &SQUARE, &goal);
        assert_ne!(touched.feature, Feature::Free, "{model:?}");
        let before = one.proxy();
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for goal in [
                GridPoint { u: broken, ..goal },
                GridPoint { v: broken, ..goal },
                GridPoint { elevation: broken, ..goal },
            ] {
                let contact = one.update(&grid, &SQUARE, &goal);
                assert_eq!((contact.proxy, contact.feature), (before.position, touched.feature));
                assert_eq!(one.proxy(), before, "{model:?}");
                assert_eq!(contact.distance(), 0.0, "{model:?}");
                assert!(contact.normal().iter().all(|part| part.is_finite()), "{model:?}");
                assert_eq!(contact.counters, Default::default(), "{model:?}");
            }
        }
        for lengths in [[0.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, f64::NAN]] {
            let [column, row, up] = lengths;
            let contact = one.update(&grid, &Metric { column, row, up }, &goal);
            assert_eq!((contact.proxy, one.proxy()), (before.position, before), "{model:?}");
        }
        let after = one.update(&grid, &SQUARE, &goal);
        assert_ne!(after.feature, Feature::Free, "{model:?}: as if nothing had been");
    }
}

#[test]
fn places_that_are_not_finite_are_not_gone_to() {
    for model in all_models(&SQUARE) {
        let mut one = model.build(BUDGET);
        one.place(GridPoint::new(3.0, 4.0, 5.0));
        let before = one.proxy();
        for broken in [f64::NAN, f64::INFINITY] {
            one.place(GridPoint::new(broken, 1.0, 1.0));
            one.place(GridPoint::new(1.0, 1.0, broken));
            assert_eq!(one.proxy(), before, "{model:?}");
        }
    }
}

/// As deep as 1e12 cells, and as high.
#[test]
fn goals_far_below_are_pulled_at_and_far_above_are_followed() {
    for seed in 0..10 {
        let grid = white_noise(20, 2.0, seed);
        let mut random = Random::new(seed);
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for power in 0..12 {
                let depth = 10f64.powi(power);
                let (x, y) = (random.between(1.0, 18.0), random.between(1.0, 18.0));
                let below = trial.settle(&GridPoint::new(x, y, -depth)).unwrap();
                assert_ne!(below.feature, Feature::Free, "{model:?}");
                let above = GridPoint::new(x, y, 3.0 + depth);
                let mut contact = trial.settle(&above).unwrap();
                if may_float(&*model.build(BUDGET)) {
                    // A plane met by rounding where it lifts off holds it until the update's end.
                    contact = trial.settle(&above).unwrap();
                }
                assert_eq!((contact.feature, contact.proxy), (Feature::Free, above), "{model:?}");
            }
        }
    }
}

#[test]
fn goals_far_outside_are_followed_and_come_back_from() {
    for wraps in [false, true] {
        let grid = grid(12, 12, wraps, |column, row| ((column * 5 + row * 3) % 4) as f64 * 0.3);
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, 64);
            for power in 0..20 {
                let far = 10f64.powi(power);
                for (x, y) in [(far, 5.0), (-far, 5.0), (5.0, far), (5.0, -far), (far, -far)] {
                    for z in [-1.0, far, -far] {
                        trial.update(&GridPoint::new(x, y, z)).unwrap();
                    }
                    // Back through the air, and touching again.
                    trial.place(GridPoint::new(5.3, 5.4, 30.0));
                    let over = trial.settle(&GridPoint::new(5.3, 5.4, 20.0)).unwrap();
                    assert_eq!(over.feature, Feature::Free, "{model:?}");
                    let under = trial.settle(&GridPoint::new(5.3, 5.4, -2.0)).unwrap();
                    assert_ne!(under.feature, Feature::Free, "{model:?}");
                }
            }
        }
    }
}

/// Motions and depths down to the smallest numbers there are.
#[test]
fn denormal_goals_are_taken_as_they_are() {
    let tiny = [0.0, f64::from_bits(1), f64::MIN_POSITIVE, 1e-300, 1e-160, 1e-20, -1e-20, -1e-160]
        .into_iter()
        .chain([-f64::MIN_POSITIVE, -f64::from_bits(1), -0.0]);
    for height in [0.0, 1e-300, 1e-20] {
        let grid =
            grid(6, 6, false, |column, row| if (column + row) % 2 == 0 { height } else { 0.0 });
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for elevation in tiny.clone() {
                for aside in tiny.clone() {
                    trial.settle(&GridPoint::new(3.0 + aside, 3.0, elevation)).unwrap();
                    trial.settle(&GridPoint::new(2.5, 2.5 + aside, elevation)).unwrap();
                }
            }
        }
    }
}
