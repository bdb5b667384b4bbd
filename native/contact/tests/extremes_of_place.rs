//! Wherever on the planet: nothing depends on how far the column is from the first, in any model.

mod common;

use common::models::all_models;
use common::random_hand::RandomHand;
use common::trial::Trial;
use common::*;
use proptest::prelude::*;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, SampleType};

const BUDGET: u32 = 4096;

/// Columns of the widest grids that people touch: a planet at 128 to 256 samples a degree.
const WIDE: usize = 70_000;

/// The ground repeats after so many columns.
const PERIOD: usize = 35;

const ROWS: usize = 24;

/// 16-bit samples that repeat, on a wide map.
fn wide_map(columns: usize, wraps: bool, seed: u64) -> Grid {
    let mut random = Random::new(seed);
    let pattern: Vec<i16> =
        (0..ROWS * PERIOD).map(|_| random.between(-2.0, 12.0).round() as i16).collect();
    let bytes = (0..ROWS * columns)
        .map(|sample| pattern[sample / columns * PERIOD + sample % columns % PERIOD])
        .flat_map(i16::to_be_bytes)
        .collect();
    let (sample, order) = (SampleType::I16, ByteOrder::Big);
    let layout = GridLayout::packed(ROWS as u64, columns as u64, 1.0, 1.0, sample, order).unwrap();
    let layout = layout.with_values(0.25, 0.0).unwrap().with_wrap(wraps);
    Grid::from_vec(bytes, layout).unwrap()
}

fn moved(point: &GridPoint, columns: i64) -> GridPoint {
    GridPoint { column: point.column + columns, ..*point }
}

/// The same hand here and `columns` further east, for every model.
fn assert_same_there(grid: &Grid, columns: i64, speed: f64, seed: u64) {
    for model in all_models(&SQUARE) {
        let start = GridPoint::new(PERIOD as f64, ROWS as f64 / 2.0, 20.0);
        let mut here = Trial::new(grid, SQUARE, &model, BUDGET, start);
        let mut there = Trial::new(grid, SQUARE, &model, BUDGET, moved(&start, columns));
        // Never nearer to the border here or there than the walk can come.
        let narrow = hills(PERIOD, 0.3, seed);
        let mut hand = RandomHand::new(&narrow, speed, 1.0, seed);
        for _ in 0..100 {
            let over = hand.next(&narrow, &SQUARE);
            let goal = GridPoint {
                column: over.column + (PERIOD / 2) as i64,
                row: over.row.min(ROWS as i64 - 1),
                elevation: over.elevation + 0.5,
                ..over
            };
            let a = here.update(&goal).unwrap();
            let b = there.update(&moved(&goal, columns)).unwrap();
            assert_eq!(moved(&a.proxy, columns), b.proxy, "{model:?} seed {seed}");
            assert_eq!(
                (a.feature, a.normal(), a.distance(), a.counters),
                (b.feature, b.normal(), b.distance(), b.counters),
                "{model:?} seed {seed}"
            );
        }
    }
}

#[test]
fn at_column_seventy_thousand_every_bit_is_the_same() {
    for seed in 0..3 {
        let grid = wide_map(WIDE, false, seed);
        for speed in [0.01, 0.5, 13.4] {
            assert_same_there(&grid, (WIDE - 4 * PERIOD) as i64, speed, seed);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(20) })]

    /// On a planet that wraps, also after many turns around it.
    #[test]
    fn after_turns_around_the_planet_every_bit_is_the_same(
        seed in 0u64..1000,
        turns in -1_000_000i64..1_000_000,
        speed in 0.01f64..20.0,
    ) {
        let grid = wide_map(8 * PERIOD, true, seed);
        assert_same_there(&grid, turns * PERIOD as i64, speed, seed);
    }

    /// A jump around the planet, to its other side and back.
    #[test]
    fn teleports_end_within_the_budget(seed in 0u64..1000, budget in 16u32..200, far in 2.0f64..11.0) {
        let grid = wide_map(8 * PERIOD, true, seed);
        let mut random = Random::new(seed);
        let far = 10f64.powf(far);
        let goals: Vec<GridPoint> = (0..20)
            .map(|_| {
                let row = random.between(0.0, ROWS as f64 - 1.0);
                GridPoint::new(random.between(-far, far), row, random.between(-1.0, 3.5))
            })
            .collect();
        for model in all_models(&SQUARE) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, budget);
            for goal in &goals {
                trial.update(goal).unwrap();
            }
        }
    }
}
