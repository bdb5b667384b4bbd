//! The ends of the map: without wrap a wall for a proxy on the map, with wrap no end at all.

mod common;

use common::models::{all_models, is_point};
use common::trial::Trial;
use common::*;
use contact::Feature;
use proptest::prelude::*;
use surface::GridPoint;

const BUDGET: u32 = 4096;
const SIZE: usize = 12;

#[test]
fn contact_is_never_lost_while_the_goal_is_inside_the_map() {
    // Along all four borders and over their corners, on them and close to them, pressing.
    let last = (SIZE - 1) as f64;
    for seed in 0..30 {
        let grid = white_noise(SIZE, [0.3, 3.0, 30.0][seed as usize % 3], seed);
        let mut random = Random::new(seed);
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for step in 0..200 {
                let along = last * f64::from(step % 50) / 49.0;
                let near = [0.0, 0.0, 1e-9, 0.3][random.below(4)];
                let (x, y) = match step / 50 {
                    0 => (along, near),
                    1 => (last - near, along),
                    2 => (last - along, last - near),
                    _ => (near, last - along),
                };
                let goal = GridPoint::new(x, y, -random.between(0.01, 3.0));
                let contact = trial.settle(&goal).unwrap();
                assert_ne!(contact.feature, Feature::Free, "{model:?} seed {seed} at {goal:?}");
            }
        }
    }
}

#[test]
fn the_border_is_a_wall_that_is_slid_along() {
    let grid = grid(SIZE, SIZE, false, |_, _| 0.0);
    let last = (SIZE - 1) as f64;
    for model in all_models(&SQUARE) {
        if !is_point(&*model.build(BUDGET)) {
            continue;
        }
        let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
        trial.settle(&GridPoint::new(5.0, 5.0, -1.0)).unwrap();
        for (x, y) in [
            (last + 3.0, 5.3),
            (last + 3.0, 9.1),
            (last + 2.0, last + 5.0),
            (3.3, -4.0),
            (-9.0, -0.1),
        ] {
            let outside = GridPoint::new(x, y, -1.0);
            let contact = trial.settle(&outside).unwrap();
            assert_ne!(contact.feature, Feature::Free, "{model:?} at {outside:?}");
            let (column, row) = (contact.proxy.columns(), contact.proxy.rows());
            assert_eq!((column, row), (x.clamp(0.0, last), y.clamp(0.0, last)), "{model:?}");
        }
        let lifted = GridPoint::new(last + 3.0, 5.3, 1.0);
        let contact = trial.settle(&lifted).unwrap();
        assert_eq!((contact.feature, contact.proxy), (Feature::Free, lifted), "{model:?}");
    }
}

/// A hand that was lifted beyond the border comes in through the air and touches again; one that
/// comes in under the ground does not.
#[test]
fn a_hand_that_comes_in_from_outside_touches_from_above_only() {
    let grid = hills(SIZE, 0.5, 3);
    let last = (SIZE - 1) as f64;
    for model in all_models(&SQUARE) {
        for (x, y) in [(last + 4.0, 5.3), (-4.0, 5.3), (5.3, last + 4.0), (5.3, -4.0)] {
            for (height, touches) in [(50.0, true), (-50.0, false)] {
                let outside = GridPoint::new(x, y, 50.0);
                let mut trial = Trial::new(&grid, SQUARE, &model, BUDGET, outside);
                trial.settle(&GridPoint { elevation: height, ..outside }).unwrap();
                trial.settle(&GridPoint::new(5.2, 5.4, height)).unwrap();
                let contact = trial.settle(&GridPoint::new(5.2, 5.4, -20.0)).unwrap();
                assert_eq!(contact.feature != Feature::Free, touches, "{model:?} from {x} {y}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    /// In and out over the borders, at any height and speed: nothing breaks, and what touches is on
    /// the ground.
    #[test]
    fn hands_that_cross_borders_are_survived(
        seed in 0u64..1_000_000,
        wraps: bool,
        relief in -1.0f64..3.0,
        beyond in 0.0f64..20.0,
    ) {
        let relief = 10f64.powf(relief);
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..SIZE * SIZE).map(|_| relief * random.unit()).collect();
        let grid = grid(SIZE, SIZE, wraps, |column, row| heights[row * SIZE + column]);
        let last = (SIZE - 1) as f64;
        let goals: Vec<GridPoint> = (0..80)
            .map(|_| {
                let mut place = || random.between(-beyond, last + beyond);
                let (x, y) = (place(), place());
                // Often exactly on the border.
                let on_border = |place: f64| if place.fract().abs() < 0.2 { place.clamp(0.0, last) } else { place };
                GridPoint::new(on_border(x), on_border(y), relief * random.between(-1.0, 1.5))
            })
            .collect();
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for goal in &goals {
                trial.update(goal).unwrap();
            }
        }
    }

    /// On a planet it does not matter where the file begins.
    #[test]
    fn the_seam_cannot_be_felt(seed in 0u64..1_000_000, turn in 1usize..SIZE, relief in -1.0f64..2.0) {
        let relief = 10f64.powf(relief);
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..SIZE * SIZE).map(|_| relief * random.unit()).collect();
        let at = |column: usize, row: usize| heights[row * SIZE + column % SIZE];
        let planet = grid(SIZE, SIZE, true, at);
        let turned = grid(SIZE, SIZE, true, |column, row| at(column + turn, row));
        let shift = turn as i64;
        let back = |point: &GridPoint| GridPoint { column: point.column - shift, ..*point };
        let goals: Vec<GridPoint> = (0..60)
            .map(|step| {
                let x = 0.4 * f64::from(step) + random.unit();
                GridPoint::new(x, random.between(0.0, (SIZE - 1) as f64), relief * random.between(-0.5, 1.1))
            })
            .collect();
        for model in all_models(&SQUARE) {
            let start = GridPoint::new(5.0, 5.0, relief + 1.0);
            let mut one = Trial::new(&planet, SQUARE, &model, BUDGET, start);
            let mut other = Trial::new(&turned, SQUARE, &model, BUDGET, back(&start));
            for goal in &goals {
                let (a, b) = (one.update(goal).unwrap(), other.update(&back(goal)).unwrap());
                prop_assert_eq!((back(&a.proxy), a.feature, a.counters), (b.proxy, b.feature, b.counters));
            }
        }
    }
}
