//! What the exact motion promises: it ends at local minima, the distance never grows faster than
//! the goal moves, and it is the same everywhere on the map.

use oracle::terrain::{Random, grid};
use oracle::{Oracle, depth_below_surface, fault_of_minimum};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const SIZE: usize = 14;

fn ground(seed: u64, relief: f64, levels: f64, voids: f64) -> Grid {
    let mut random = Random::new(seed);
    let mut height = || {
        let height = random.unit();
        let height = if levels > 0.0 { (height * levels).floor() / levels } else { height };
        if random.unit() < voids { f64::NAN } else { relief * height }
    };
    let heights: Vec<f64> = (0..SIZE * SIZE).map(|_| height()).collect();
    grid(SIZE, SIZE, false, |column, row| heights[row * SIZE + column])
}

/// Anywhere over the map, or exactly on samples and halfway between them.
fn place(random: &mut Random, ties: bool) -> f64 {
    let place = random.between(0.0, (SIZE - 1) as f64);
    if ties { (place * 2.0).round() / 2.0 } else { place }
}

fn distance(metric: &Metric, proxy: &GridPoint, goal: &GridPoint) -> f64 {
    let [columns, rows, up] = goal.relative_to(proxy.column, proxy.row, proxy.elevation);
    let columns = (columns - proxy.u) * metric.column;
    columns.hypot((rows - proxy.v) * metric.row).hypot(up * metric.up)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn every_step_ends_at_a_minimum_and_the_distance_grows_no_faster_than_the_goal_moves(
        seed in 0u64..1_000_000,
        relief in -2.0f64..4.0,
        levels in prop_oneof![Just(0.0), Just(1.0), Just(3.0)],
        voids in prop_oneof![Just(0.0), Just(0.2)],
        row in -1.0f64..1.0,
        speed in -3.0f64..1.0,
        ties: bool,
    ) {
        let relief = 10f64.powf(relief);
        let grid = ground(seed, relief, levels, voids);
        let metric = Metric { column: 1.0, row: 10f64.powf(row), up: 1.0 };
        let mut random = Random::new(seed + 1);
        let mut goal = GridPoint::new(6.5, 6.5, 2.0 * relief);
        let mut proxy = Oracle::in_space(goal);
        for _ in 0..60 {
            let to = GridPoint::new(
                place(&mut random, ties),
                place(&mut random, ties),
                relief * random.between(-0.5, 1.1),
            );
            // Part of the way there, or all of it.
            let share = if ties { 1.0 } else { 10f64.powf(speed).min(1.0) };
            let [columns, rows, up] = to.relative_to(goal.column, goal.row, goal.elevation);
            let to = GridPoint::from_sample(
                goal.column,
                goal.row,
                goal.u + share * (columns - goal.u),
                goal.v + share * (rows - goal.v),
                goal.elevation + share * up,
            );
            let before = distance(&metric, &proxy.position(), &goal);
            proxy.follow(&grid, &metric, &goal, &to, 5);
            let moved = distance(&metric, &goal, &to);
            goal = to;

            let (here, touches) = (proxy.position(), proxy.touches());
            prop_assert_eq!(fault_of_minimum(&grid, &metric, &here, touches, &goal), None);
            if touches {
                prop_assert!(depth_below_surface(&grid, &here).abs() < 1e-12);
            }
            let after = distance(&metric, &here, &goal);
            prop_assert!(after <= before + moved + 1e-12 * (before + moved + relief));
        }
    }

    #[test]
    fn a_map_moved_by_whole_cells_gives_the_same_motion(seed in 0u64..1_000_000, turn in 1usize..SIZE) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..SIZE * SIZE).map(|_| 3.0 * random.unit()).collect();
        let at = |column: usize, row: usize| heights[row * SIZE + column % SIZE];
        let planet = grid(SIZE, SIZE, true, at);
        let turned = grid(SIZE, SIZE, true, |column, row| at(column + turn, row));
        let metric = Metric { column: 1.0, row: 1.0, up: 1.0 };
        let back = |point: &GridPoint| GridPoint { column: point.column - turn as i64, ..*point };

        let mut goal = GridPoint::new(6.5, 6.5, 9.0);
        let (mut one, mut other) = (Oracle::in_space(goal), Oracle::in_space(back(&goal)));
        for _ in 0..20 {
            let to = GridPoint::new(place(&mut random, false), place(&mut random, false), 3.0 * random.unit());
            one.follow(&planet, &metric, &goal, &to, 4);
            other.follow(&turned, &metric, &back(&goal), &back(&to), 4);
            goal = to;
            prop_assert_eq!((back(&one.position()), one.touches()), (other.position(), other.touches()));
        }
    }
}
