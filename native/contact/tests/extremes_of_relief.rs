//! Grounds that leave no room for error: perfect planes, perfect ties, cliffs, spikes, pits, and grids
//! of a single cell.

mod common;

use common::models::all_models;
use common::random_hand::{Ground, RandomHand, cliffs};
use common::trial::Trial;
use common::*;
use contact::Feature;
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

fn try_all(grid: &Grid, metric: Metric, goals: &[GridPoint]) {
    for model in all_models(&metric) {
        let mut trial = Trial::over_the_middle(grid, metric, &model, BUDGET);
        for goal in goals {
            trial.rest(goal).unwrap();
        }
    }
}

/// Goals at every quarter of a cell over a map of a few cells, at each of these heights, in an order
/// without rhyme.
fn quarters(grid: &Grid, elevations: &[f64], seed: u64) -> Vec<GridPoint> {
    let (columns, rows) = (grid.layout().columns() as usize, grid.layout().rows() as usize);
    let mut goals: Vec<GridPoint> = (0..=4 * (columns - 1))
        .flat_map(|x| (0..=4 * (rows - 1)).map(move |y| (x as f64 / 4.0, y as f64 / 4.0)))
        .flat_map(|(x, y)| elevations.iter().map(move |z| GridPoint::new(x, y, *z)))
        .collect();
    let mut random = Random::new(seed);
    for last in (1..goals.len()).rev() {
        goals.swap(last, random.below(last + 1));
    }
    goals
}

#[test]
fn on_grids_of_two_by_two_every_goal_is_followed() {
    let levels = [-1.0, 0.0, 2.0];
    for pattern in 0..81 {
        let height = |sample: u32| levels[pattern / 3usize.pow(sample) % 3];
        let grid = grid(2, 2, false, |column, row| height((2 * row + column) as u32));
        let goals = quarters(&grid, &[-2.0, -0.5, 0.0, 0.5, 2.5], pattern as u64);
        try_all(&grid, SQUARE, &goals[..40]);
    }
}

#[test]
fn a_planet_of_two_columns_can_be_walked_around() {
    for seed in 0..20 {
        let ground = Ground { wraps: true, ..Ground::noise(2, 3, 1.0) };
        let grid = ground.grid(&mut Random::new(seed));
        let goals: Vec<_> =
            (0..100).map(|step| GridPoint::new(0.13 * f64::from(step), 1.1, 0.2)).collect();
        try_all(&grid, SQUARE, &goals);
    }
}

/// Sides of one square, a ridge, a crease, a spike, a pit, steps: whole numbers, so that goals are
/// exactly over samples and edges, on the surface, and at equal distances from several places.
#[test]
fn perfect_ties_are_broken_and_kept() {
    let shapes: [fn(i32, i32) -> i32; 9] = [
        |_, _| 0,
        |x, _| (x - 3).abs(),
        |x, _| -(x - 3).abs(),
        |x, y| (x - 3).abs().max((y - 3).abs()),
        |x, y| -(x - 3).abs().max((y - 3).abs()),
        |x, y| if (x, y) == (3, 3) { 4 } else { 0 },
        |x, y| if (x, y) == (3, 3) { -4 } else { 0 },
        |x, y| (x + y) % 2,
        |x, _| x / 2 * 3,
    ];
    for (number, shape) in shapes.iter().enumerate() {
        let grid = grid(7, 7, false, |x, y| f64::from(shape(x as i32, y as i32)));
        let goals = quarters(&grid, &[-6.0, -1.0, -0.5, 0.0, 0.5, 1.0, 3.0], number as u64);
        try_all(&grid, SQUARE, &goals[..600]);
        let long_cells = Metric { column: 1.0, row: 4.0, up: 0.5 };
        try_all(&grid, long_cells, &goals[600..900]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    /// On a plane all triangles agree: the proxy is the goal's foot, of whatever they are made.
    #[test]
    fn on_a_plane_the_proxy_is_the_foot_of_the_goal(
        seed in 0u64..1_000_000,
        east in -3.0f64..3.0,
        south in -3.0f64..3.0,
        whole: bool,
    ) {
        let plane = if whole { [east.round(), south.round()] } else { [east, south] };
        let ground = Ground { plane: Some(plane), ..Ground::noise(60, 60, 0.0) };
        let grid = ground.grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut random = Random::new(seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            let is_point = common::models::is_point(&*model.build(BUDGET));
            for _ in 0..40 {
                let (x, y) = (random.between(25.0, 35.0), random.between(25.0, 35.0));
                let height = random.between(-2.0, 0.5);
                let on_plane = plane[0] * x + plane[1] * y;
                let goal = GridPoint::new(x, y, on_plane + height);
                let contact = trial.settle(&goal).unwrap();
                if !is_point {
                    continue;
                }
                let shift = height.min(0.0) / (1.0 + plane[0].powi(2) + plane[1].powi(2));
                let foot = [x + plane[0] * shift, y + plane[1] * shift, on_plane + height - shift];
                let proxy = &contact.proxy;
                let off = [proxy.columns() - foot[0], proxy.rows() - foot[1], proxy.elevation - foot[2]];
                prop_assert!(off.iter().all(|part| part.abs() < 1e-10), "{model:?}: {off:?}, {contact:?}");
                let touches = contact.feature != Feature::Free;
                prop_assert!(touches || height > -1e-10, "{model:?}: {contact:?}");
            }
        }
    }

    #[test]
    fn neighbours_at_both_ends_of_sixteen_bits_let_nobody_through(
        seed in 0u64..1_000_000,
        speed in 0.001f64..20.0,
        reach in -1.0f64..5.0,
    ) {
        let grid = cliffs(14, 14, &mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 10f64.powf(reach), seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for _ in 0..100 {
                trial.update(&hand.next(&grid, &SQUARE)).unwrap();
            }
        }
    }

    #[test]
    fn white_noise_is_walked_over(
        seed in 0u64..1_000_000,
        slope in -2.0f64..6.0,
        speed in 0.001f64..20.0,
        levels in prop_oneof![Just(0usize), Just(2), Just(3)],
    ) {
        let slope = 10f64.powf(slope);
        let grid = Ground { levels, ..Ground::noise(14, 14, slope) }.grid(&mut Random::new(seed));
        for model in all_models(&SQUARE) {
            let mut hand = RandomHand::new(&grid, speed, 1.0 + slope, seed);
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, BUDGET);
            for _ in 0..100 {
                trial.update(&hand.next(&grid, &SQUARE)).unwrap();
            }
        }
    }
}
