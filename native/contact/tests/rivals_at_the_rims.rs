//! The god-objects and the virtual proxy where a map ends: holes, borders, the seam of a planet, broken
//! numbers, and the step budget. What the proxy graph does there, they do.

mod common;

use common::*;
use contact::{Contact, ContactModel, Feature, Model, Place};
use proptest::prelude::*;
use surface::ray::Side;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;
const RADIUS: f64 = 0.25;

const RIVALS: [Model; 3] =
    [Model::GodObject, Model::GodObjectRelease, Model::VirtualProxy { radius: RADIUS }];

fn at(rival: &Model, column: f64, row: f64, elevation: f64) -> Box<dyn ContactModel> {
    let mut model = rival.build(BUDGET);
    model.place(GridPoint::new(column, row, elevation));
    model
}

/// How high over flat ground a proxy rests.
fn rest(rival: &Model) -> f64 {
    if let Model::VirtualProxy { radius } = rival { *radius } else { 0.0 }
}

fn steps(contact: &Contact) -> u32 {
    contact.counters.vertices + contact.counters.faces + contact.counters.cells
}

/// Flat ground at height 0 with one void sample in the middle: a hole of six triangles.
fn ground_with_a_hole() -> Grid {
    grid(11, 11, false, |column, row| if (column, row) == (5, 5) { f64::NAN } else { 0.0 })
}

#[test]
fn names_choose_the_models_that_bear_them() {
    for rival in RIVALS {
        assert_eq!(rival.build(BUDGET).name(), rival.name());
    }
}

#[test]
fn a_hole_is_fallen_into_and_left_only_upwards() {
    let grid = ground_with_a_hole();
    for rival in RIVALS {
        let mut model = at(&rival, 5.0, 5.0, 3.0);
        let mut update = |column, row, elevation| {
            model.update(&grid, &SQUARE, &GridPoint::new(column, row, elevation))
        };
        let free = Feature::Free;
        assert_eq!(update(5.1, 5.1, -2.0).feature, free, "nothing is there to touch: {rival:?}");
        assert_eq!(update(2.0, 2.0, -2.0).feature, free, "nor under ground: {rival:?}");
        assert_eq!(update(2.0, 2.0, 1.0).feature, free, "out through the back: {rival:?}");
        let touched = update(2.3, 2.2, -1.0);
        assert_eq!(touched.feature, Feature::Face, "{rival:?}");
        assert!((touched.proxy.elevation - rest(&rival)).abs() < 1e-9, "{touched:?}");
    }
}

#[test]
fn a_sphere_rests_on_the_rim_of_a_hole_that_it_does_not_fit() {
    let grid = ground_with_a_hole();
    let mut model = at(&Model::VirtualProxy { radius: 1.5 }, 5.0, 5.0, 3.0);
    let contact = model.update(&grid, &SQUARE, &GridPoint::new(5.0, 5.0, -1.0));
    assert!(matches!(contact.feature, Feature::Edge | Feature::Vertex), "{contact:?}");
    // It touches the two opposite sides of the hole that are nearest, half a diagonal away, or the
    // two others that close it: no lower than where four samples at distance 1 hold it.
    let lowest = (1.5f64 * 1.5 - 1.0).sqrt();
    assert!((lowest..1.5).contains(&contact.proxy.elevation), "{contact:?}");
}

#[test]
fn void_is_never_touched_by_a_point() {
    let grid = ground_with_a_hole();
    for rival in &RIVALS[..2] {
        let mut model = at(rival, 0.5, 5.2, 3.0);
        for step in 0..=1000 {
            let goal = GridPoint::new(0.5 + 0.01 * f64::from(step), 5.2, -0.5);
            let contact = model.update(&grid, &SQUARE, &goal);
            if contact.feature != Feature::Free {
                assert_eq!(contact.proxy.elevation, 0.0);
                assert!(grid.surface_elevation(&contact.proxy).is_some(), "{contact:?}");
            }
        }
    }
}

#[test]
fn ground_beside_a_hole_is_not_met_from_within() {
    let grid = ground_with_a_hole();
    for rival in RIVALS {
        let mut model = at(&rival, 4.7, 5.3, 3.0);
        let mut update = |column, row, elevation| {
            model.update(&grid, &SQUARE, &GridPoint::new(column, row, elevation)).feature
        };
        assert_eq!(update(4.7, 5.3, -0.9), Feature::Free, "it fell in: {rival:?}");
        assert_eq!(update(3.0, 5.2, -0.9), Feature::Free, "met from below: {rival:?}");
    }
}

#[test]
fn the_border_of_the_map_holds_a_proxy_in_contact() {
    let grid = grid(11, 11, false, |_, _| 0.0);
    for rival in RIVALS {
        for (column, row) in [(14.0, 5.3), (-4.0, 5.3), (5.3, 14.0), (5.3, -4.0), (-9.0, 13.0)] {
            let mut model = at(&rival, 5.0, 5.0, 1.0);
            model.update(&grid, &SQUARE, &GridPoint::new(5.0, 5.0, -1.0));
            let outside = GridPoint::new(column, row, -1.0);
            for _ in 0..3 {
                let contact = model.update(&grid, &SQUARE, &outside);
                assert_ne!(contact.feature, Feature::Free, "{rival:?}");
                let (x, y) = (contact.proxy.columns(), contact.proxy.rows());
                let near = (column.clamp(0.0, 10.0), row.clamp(0.0, 10.0));
                assert!((x - near.0).abs() < 1e-9 && (y - near.1).abs() < 1e-9, "{contact:?}");
                assert!((contact.proxy.elevation - rest(&rival)).abs() < 1e-9, "{contact:?}");
            }
            let lifted = GridPoint { elevation: 1.0, ..outside };
            let contact = model.update(&grid, &SQUARE, &lifted);
            assert_eq!((contact.feature, contact.distance()), (Feature::Free, 0.0));
        }
    }
}

/// On ground that leads out over the border, the border is a constraint to slide along.
#[test]
fn along_the_border_the_proxy_slides_to_the_closest_place() {
    let slope = grid(11, 11, false, |column, row| 0.5 * column as f64 + 0.4 * row as f64);
    for rival in RIVALS {
        let mut model = at(&rival, 8.3, 5.4, 20.0);
        // Far under the slope: its foot lies beyond the western border.
        let goal = GridPoint::new(1.0, 6.0, -6.0);
        let mut contact = model.update(&slope, &SQUARE, &goal);
        for _ in 0..5 {
            contact = model.update(&slope, &SQUARE, &goal);
        }
        assert_eq!(contact.proxy.columns(), 0.0, "{rival:?} {contact:?}");
        // On the border's profile, which rises by 0.4 a row: the foot from 6 rows south.
        let row = (6.0 - 0.4 * 6.0) / (1.0 + 0.4 * 0.4);
        if rest(&rival) == 0.0 {
            assert!((contact.proxy.rows() - row).abs() < 1e-9, "{rival:?} {contact:?}");
        }
    }
}

#[test]
fn a_hand_that_was_never_on_the_map_is_not_pulled_onto_it() {
    let grid = grid(11, 11, false, |_, _| 0.0);
    for rival in RIVALS {
        let mut model = at(&rival, -20.0, 5.0, 1.0);
        for elevation in [1.0, -1.0, 10.0] {
            let goal = GridPoint::new(-20.0, 5.0, elevation);
            assert_eq!(model.update(&grid, &SQUARE, &goal).distance(), 0.0);
        }
        let over = model.update(&grid, &SQUARE, &GridPoint::new(5.3, 5.2, -1.0));
        let height = over.proxy.elevation;
        assert!((height - rest(&rival)).abs() < 1e-9, "from above it touches: {over:?}");
    }
}

#[test]
fn a_hand_that_begins_inside_the_ground_feels_nothing_until_it_is_out() {
    let grid = hills(60, 0.3, 5);
    let under = GridPoint::new(30.2, 30.4, grid.range().unwrap().minimum - 1.0);
    for rival in RIVALS {
        let mut model = at(&rival, under.columns(), under.rows(), under.elevation);
        let moved = GridPoint { column: 35, ..under };
        assert_eq!(model.update(&grid, &SQUARE, &moved).feature, Feature::Free);
        let out = GridPoint { elevation: 50.0, ..moved };
        assert_eq!(model.update(&grid, &SQUARE, &out).feature, Feature::Free);
        assert_ne!(model.update(&grid, &SQUARE, &moved).feature, Feature::Free);
    }
}

#[test]
fn broken_goals_and_metrics_leave_the_proxy_where_it_is() {
    let grid = hills(60, 0.3, 5);
    for rival in RIVALS {
        let mut model = at(&rival, 30.2, 30.4, 50.0);
        let before = model.update(&grid, &SQUARE, &GridPoint::new(30.0, 30.0, -1.0));
        assert_ne!(before.feature, Feature::Free);
        let mut is_kept = |metric: &Metric, goal: GridPoint| {
            let contact = model.update(&grid, metric, &goal);
            assert_eq!((contact.proxy, contact.feature), (before.proxy, before.feature));
        };
        for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            is_kept(&SQUARE, GridPoint::new(broken, 1.0, 1.0));
            is_kept(&SQUARE, GridPoint::new(1.0, broken, 1.0));
            is_kept(&SQUARE, GridPoint::new(1.0, 1.0, broken));
        }
        for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            is_kept(&Metric { up: length, ..SQUARE }, before.proxy);
            is_kept(&Metric { column: length, ..SQUARE }, before.proxy);
        }
    }
}

#[test]
fn a_goal_beyond_the_budget_is_reached_over_the_next_updates() {
    let grid = hills(400, 0.1, 11);
    let goal = GridPoint::new(390.3, 380.7, grid.range().unwrap().minimum - 3.0);
    for rival in RIVALS {
        let budget = rival.min_step_budget();
        let mut patient = rival.build(budget);
        patient.place(GridPoint::new(5.0, 5.0, 20.0));
        let (mut updates, mut has_arrived) = (0, false);
        while !has_arrived {
            let contact = patient.update(&grid, &SQUARE, &goal);
            updates += 1;
            assert!(steps(&contact) <= budget, "{contact:?}");
            assert!(updates < 1000, "{contact:?}");
            let [columns, rows, _] = contact.proxy.relative_to(goal.column, goal.row, 0.0);
            // The god-object without release may also stick on the way, and goes on from there.
            let is_near = (columns - goal.u).abs() < 3.0 && (rows - goal.v).abs() < 3.0;
            has_arrived = contact.counters.steps_left == 0 && is_near;
        }
        assert!(updates > 5, "{rival:?}");
    }
}

#[test]
fn a_teleport_across_planets_ends_within_the_budget() {
    let planet = grid(50, 100, true, |column, row| ((column * 7 + row * 13) % 5) as f64 * 0.1);
    for rival in RIVALS {
        let mut model = at(&rival, 50.0, 25.0, 5.0);
        for columns in [1e6, -1e9, 1e12, f64::MAX, 0.0] {
            let contact = model.update(&planet, &SQUARE, &GridPoint::new(columns, 25.3, -5.0));
            assert!(steps(&contact) <= BUDGET, "{contact:?}");
            assert!(contact.proxy.is_finite() && contact.distance().is_finite());
        }
    }
}

/// Every model goes on where any other is, from contact into contact.
#[test]
fn models_take_over_from_each_other_in_contact() {
    let ground = hills(60, 0.3, 8);
    let kinds = [Model::ProxyGraph, RIVALS[0], RIVALS[1], RIVALS[2]];
    let mut random = Random::new(5);
    for _ in 0..50 {
        let under = GridPoint::new(random.between(5.0, 55.0), random.between(5.0, 55.0), 0.0);
        let height = ground.surface_elevation(&under).unwrap();
        let goal = GridPoint { elevation: height - random.between(0.1, 1.0), ..under };
        for from in &kinds {
            for to in &kinds {
                let mut one = at(from, goal.columns(), goal.rows(), 50.0);
                let before = one.update(&ground, &SQUARE, &goal);
                let mut other = to.build(BUDGET);
                other.take_over(one.proxy());
                let after = other.update(&ground, &SQUARE, &goal);
                assert_ne!(after.feature, Feature::Free, "{from:?} to {to:?}");
                let apart = distance(&before.proxy, &after.proxy);
                assert!(apart < 3.0 * RADIUS, "{from:?} to {to:?}: {apart}");
            }
        }
    }
}

#[test]
fn what_touches_nothing_is_handed_over_in_space() {
    let ground = hills(60, 0.3, 8);
    for rival in RIVALS {
        let mut model = at(&rival, 30.0, 30.0, 50.0);
        model.update(&ground, &SQUARE, &GridPoint::new(31.2, 31.3, 40.0));
        assert_eq!(model.proxy().place, Place::Space(Side::Above), "{rival:?}");
        assert_eq!(model.proxy().position, GridPoint::new(31.2, 31.3, 40.0));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 50, failure_persistence: None, ..ProptestConfig::default() })]

    /// On a planet it does not matter where the file begins, and nothing depends on the column.
    #[test]
    fn the_seam_cannot_be_felt_and_whole_cells_shift_nothing(
        seed in 0u64..1000, turn in 1usize..40, around in -2000i64..2000, speed in 0.01f64..5.0,
    ) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..40 * 40).map(|_| random.unit()).collect();
        let height = |column: usize, row: usize| heights[row * 40 + column % 40];
        let planet = grid(40, 40, true, height);
        let turned = grid(40, 40, true, |column, row| height(column + turn, row));
        let shift = turn as i64 + 40 * around;
        for rival in RIVALS {
            let start = GridPoint::new(20.0, 20.0, 5.0);
            let (mut one, mut other) = (rival.build(BUDGET), rival.build(BUDGET));
            one.place(start);
            other.place(GridPoint { column: start.column - shift, ..start });
            let (mut column, mut heading) = (20.0, 0.3f64);
            for _ in 0..100 {
                heading += random.between(-0.1, 0.1);
                column += speed * heading.cos();
                let goal = GridPoint::new(column, 20.0 + 5.0 * heading.sin(), random.between(-1.0, 0.7));
                let a = one.update(&planet, &SQUARE, &goal);
                let b = other.update(&turned, &SQUARE, &GridPoint { column: goal.column - shift, ..goal });
                let shifted = GridPoint { column: b.proxy.column + shift, ..b.proxy };
                prop_assert_eq!((a.proxy, a.feature, a.counters), (shifted, b.feature, b.counters));
            }
        }
    }

    /// Random voids: every update ends, finite, and a point in contact is on what exists.
    #[test]
    fn rough_ground_full_of_holes_is_survived(seed in 0u64..10_000, voids in 0.0f64..0.9, speed in 0.01f64..20.0) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..900)
            .map(|_| if random.unit() < voids { f64::NAN } else { random.between(0.0, 3.0) })
            .collect();
        let grid = grid(30, 30, false, |column, row| heights[row * 30 + column]);
        for rival in RIVALS {
            let mut hand = WanderingHand::new(30, speed, 2.0, seed);
            let mut model = at(&rival, 15.0, 15.0, 9.0);
            for _ in 0..100 {
                let goal = hand.next(&grid);
                let contact = model.update(&grid, &SQUARE, &goal);
                prop_assert!(contact.proxy.is_finite() && contact.distance().is_finite());
                prop_assert!(steps(&contact) <= BUDGET);
                if contact.feature != Feature::Free {
                    prop_assert!(depth_below_surface(&grid, &contact) < 1e-9, "{:?} {:?}", rival, contact);
                }
            }
        }
    }

    /// Scales and exaggerations from 1e-6 to 1e6, reliefs to 1e100 m, cells far from square.
    #[test]
    fn extremes_stay_finite_and_above_ground(
        seed in 0u64..1000,
        scale in -12.0f64..9.0,
        exaggeration in -6.0f64..6.0,
        width in -3.0f64..3.0,
        height in -3.0f64..3.0,
        relief in prop_oneof![-6.0f64..6.0, 90.0f64..99.5],
        wraps: bool,
    ) {
        let mut random = Random::new(seed);
        let size = 10f64.powf(relief);
        let heights: Vec<f64> = (0..400).map(|_| random.between(-1.0, 1.0) * size).collect();
        let cells = [10f64.powf(width), 10f64.powf(height)];
        let grid = grid_with_cells(20, 20, cells, wraps, |column, row| heights[row * 20 + column]);
        let scale = 10f64.powf(scale);
        let metric = Metric { column: cells[0] * scale, row: cells[1] * scale, up: scale * 10f64.powf(exaggeration) };
        let radius = metric.column * random.between(0.01, 3.0);
        for rival in [RIVALS[0], RIVALS[1], Model::VirtualProxy { radius }] {
            // Wholly over the ground: what reaches into it touches nothing.
            let mut model = at(&rival, 10.0, 10.0, size * 1.5 + 2.0 * radius / metric.up);
            for _ in 0..50 {
                let far = 10f64.powf(random.between(-3.0, 6.0));
                let east = if wraps { far } else { 9.5 };
                let goal = GridPoint::new(
                    9.5 + east * random.between(-1.0, 1.0),
                    random.between(0.0, 19.0),
                    size * random.between(-30.0, 2.0),
                );
                let contact = model.update(&grid, &metric, &goal);
                prop_assert!(contact.proxy.is_finite() && contact.distance().is_finite());
                prop_assert!(steps(&contact) <= BUDGET);
                prop_assert!(depth_below_surface(&grid, &contact) < 1e-9, "{:?} {:?}", rival, contact);
            }
        }
    }

    /// Goals exactly on samples, edges, diagonals and at equal distances.
    #[test]
    fn exact_ties_end(seed in 0u64..1000) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..100).map(|_| (random.unit() * 3.0).floor()).collect();
        let grid = grid(10, 10, false, |column, row| heights[row * 10 + column]);
        for rival in RIVALS {
            let mut model = at(&rival, 5.0, 5.0, 9.0);
            for _ in 0..100 {
                let mut half = || (random.unit() * 19.0).floor() / 2.0;
                let goal = GridPoint::new(half(), half(), half() - 6.0);
                let contact = model.update(&grid, &SQUARE, &goal);
                prop_assert!(depth_below_surface(&grid, &contact) < 1e-9, "{:?} {:?}", rival, contact);
                prop_assert!(steps(&contact) <= BUDGET);
            }
        }
    }
}
