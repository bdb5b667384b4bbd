//! Voids in every pattern: a triangle with a void corner is absent, contact resumes only from above,
//! and nothing absent is ever touched.

mod common;

use common::models::{all_models, is_exact};
use common::random_hand::{Ground, RandomHand};
use common::trial::Trial;
use common::*;
use contact::Feature;
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 256;

/// Heights without rhyme, from 0 to 1; `voids` has a bit for every sample that is void.
fn ground(columns: usize, rows: usize, voids: usize) -> Grid {
    grid(rows, columns, false, |column, row| {
        let sample = row * columns + column;
        let is_void = voids >> sample & 1 == 1;
        if is_void { f64::NAN } else { ((sample * 7 + 3) % 5) as f64 / 4.0 }
    })
}

fn walk_over(grid: &Grid, columns: usize, rows: usize, steps: usize, seed: u64) {
    let (east, south) = ((columns - 1) as f64, (rows - 1) as f64);
    for model in all_models(&SQUARE) {
        let mut random = Random::new(seed);
        let start = GridPoint::new(0.5 * east, 0.5 * south, 3.0);
        let mut trial = Trial::new(grid, SQUARE, &model, BUDGET, start);
        for _ in 0..steps {
            let mut place = |most: f64| {
                let place = random.between(0.0, most);
                if random.unit() < 0.3 { (2.0 * place).round() / 2.0 } else { place }
            };
            let (x, y) = (place(east), place(south));
            let z = if random.unit() < 0.15 { 2.0 } else { random.between(-1.0, 1.2) };
            trial.update(&GridPoint::new(x, y, z)).unwrap();
        }
    }
}

#[test]
fn every_pattern_of_voids_on_two_by_two_samples() {
    for voids in 0..1 << 4 {
        walk_over(&ground(2, 2, voids), 2, 2, 200, voids as u64);
    }
}

#[test]
fn every_pattern_of_voids_on_three_by_three_samples() {
    for voids in 0..1 << 9 {
        walk_over(&ground(3, 3, voids), 3, 3, 60, voids as u64);
    }
}

#[test]
fn every_pattern_of_voids_on_four_by_three_samples() {
    for voids in 0..1 << 12 {
        walk_over(&ground(4, 3, voids), 4, 3, 12, voids as u64);
    }
}

/// What the exact motion does around holes and rims, the exact model does, at every small step.
#[test]
fn what_falls_into_a_hole_is_what_the_oracle_lets_fall() {
    let (mut fallen, mut held) = (0, 0);
    for voids in 0..1 << 9 {
        let grid = ground(3, 3, voids);
        let mut random = Random::new(voids as u64);
        let start = GridPoint::new(random.between(0.0, 2.0), random.between(0.0, 2.0), 2.0);
        let end = GridPoint::new(random.between(0.0, 2.0), random.between(0.0, 2.0), -0.5);
        let mut exact = oracle::Oracle::in_space(start);
        exact.follow(&grid, &SQUARE, &start, &end, 200);
        for model in all_models(&SQUARE) {
            let mut one = model.build(BUDGET);
            if !is_exact(&*one) {
                continue;
            }
            one.place(start);
            let mut touches = false;
            for step in 1..=200 {
                let share = f64::from(step) / 200.0;
                let between = |from: f64, to: f64| from + share * (to - from);
                let goal = GridPoint::new(
                    between(start.columns(), end.columns()),
                    between(start.rows(), end.rows()),
                    between(start.elevation, end.elevation),
                );
                touches = one.update(&grid, &SQUARE, &goal).feature != Feature::Free;
            }
            fallen += usize::from(!touches);
            held += usize::from(touches);
            assert_eq!(touches, exact.touches(), "{model:?} voids {voids:b}");
        }
    }
    println!("{fallen} fell, {held} were held");
}

#[test]
fn from_within_a_hole_ground_is_not_met_and_from_above_it_is() {
    // All but a rim of ground around the map is void.
    let rim = |column: usize, row: usize| !(2..=8).contains(&column) || !(2..=8).contains(&row);
    let grid = grid(11, 11, false, |column, row| if rim(column, row) { 0.0 } else { f64::NAN });
    for model in all_models(&SQUARE) {
        for (x, y) in [(0.6, 5.2), (9.4, 5.7), (5.2, 0.4), (5.5, 9.5), (0.5, 0.7), (9.5, 9.4)] {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            let mut touches =
                |x, y, z| trial.settle(&GridPoint::new(x, y, z)).unwrap().feature != Feature::Free;
            assert!(!touches(5.0, 5.0, -1.0), "{model:?}: nothing is there to touch");
            assert!(!touches(x, y, -1.0), "{model:?}: under ground nothing is touched");
            assert!(!touches(x, y, 1.0), "{model:?}: it comes out through the back");
            assert!(touches(x, y, -1.0), "{model:?}: and is above");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn rough_ground_full_of_holes_is_survived(
        seed in 0u64..1_000_000,
        voids in 0.0f64..0.9,
        relief in -2.0f64..4.0,
        speed in 0.01f64..10.0,
    ) {
        let relief = 10f64.powf(relief);
        let ground = Ground { voids, ..Ground::noise(14, 14, relief) };
        let grid = ground.grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 1.0 + relief, seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, 4096);
            for _ in 0..80 {
                trial.update(&hand.next(&grid, &SQUARE)).unwrap();
            }
        }
    }
}

/// A proxy exactly on a sample beside a hole is on neither side of the ground yet. Found by fuzzing.
#[test]
fn a_landing_by_rounding_does_not_hold_a_proxy_whose_way_is_free() {
    const HEIGHTS: [[f64; 4]; 4] = [
        [f64::NAN, 5.665959325394913, 2.186715250336632, f64::NAN],
        [f64::NAN, 3.0910626179113505, 0.22333657600292764, f64::NAN],
        [f64::NAN, 4.065464960480909, 3.76166527902134, 3.9033608197836394],
        [1.0573876359374972, 7.22245074634235, 7.524217276346902, f64::NAN],
    ];
    let ground = grid(4, 4, false, |column, row| HEIGHTS[row][column]);
    let metric = Metric { column: 1.29, row: 0.4, up: 0.376 };
    for model in all_models(&metric).into_iter().filter(|model| is_exact(&*model.build(BUDGET))) {
        let sample = GridPoint::from_sample(2, 1, 0.0, 0.0, HEIGHTS[1][2]);
        let mut trial = Trial::new(&ground, metric, &model, BUDGET, sample);
        let over_the_edge =
            GridPoint::from_sample(1, 0, 0.5, 0.9992254419944574, 1.7116479196975725);
        trial.rest(&over_the_edge).unwrap();
        assert_eq!(trial.proxy().position, over_the_edge, "{model:?}");
    }
}
