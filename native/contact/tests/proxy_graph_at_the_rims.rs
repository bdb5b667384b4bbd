//! The proxy graph where a map ends: holes, borders, the seam of a planet, and the step budget.

mod common;

use common::*;
use contact::{ContactModel, Feature, MIN_STEP_BUDGET, ProxyGraph};
use proptest::prelude::*;
use surface::{Grid, GridPoint};

const BUDGET: u32 = 4096;

fn proxy_at(column: f64, row: f64, elevation: f64) -> ProxyGraph {
    let mut model = ProxyGraph::new(BUDGET);
    model.place(GridPoint::new(column, row, elevation));
    model
}

/// Flat ground at height 0 with one void sample in the middle: a hole of six triangles.
fn ground_with_a_hole() -> Grid {
    grid(11, 11, false, |column, row| if (column, row) == (5, 5) { f64::NAN } else { 0.0 })
}

#[test]
fn a_hole_is_fallen_into_and_left_only_upwards() {
    let grid = ground_with_a_hole();
    let mut model = proxy_at(5.0, 5.0, 3.0);
    let mut update = |column, row, elevation| {
        model.update(&grid, &SQUARE, &GridPoint::new(column, row, elevation))
    };
    assert_eq!(update(5.1, 5.1, -2.0).feature, Feature::Free, "nothing is there to touch");
    assert_eq!(update(2.0, 2.0, -2.0).feature, Feature::Free, "under ground nothing is touched");
    assert_eq!(update(2.0, 2.0, 1.0).feature, Feature::Free, "it comes out through the back");
    let touched = update(2.3, 2.2, -1.0);
    assert_eq!((touched.feature, touched.proxy.elevation), (Feature::Face, 0.0));
}

#[test]
fn void_is_never_touched() {
    let grid = ground_with_a_hole();
    let mut model = proxy_at(0.5, 5.2, 3.0);
    for step in 0..=1000 {
        let goal = GridPoint::new(0.5 + 0.01 * f64::from(step), 5.2, -0.5);
        let contact = model.update(&grid, &SQUARE, &goal);
        if contact.feature != Feature::Free {
            assert_eq!(contact.proxy.elevation, 0.0);
            assert!(grid.surface_elevation(&contact.proxy).is_some(), "{contact:?}");
        }
    }
}

#[test]
fn ground_beside_a_hole_is_not_met_from_within() {
    let grid = ground_with_a_hole();
    // Along the ground and over its rim, and through the air.
    for (elevation, came_by) in [(-0.5, Feature::Face), (1.0, Feature::Free)] {
        let mut model = proxy_at(3.7, 5.2, 3.0);
        let mut update = |column, row, elevation| {
            model.update(&grid, &SQUARE, &GridPoint::new(column, row, elevation)).feature
        };
        assert_eq!(update(3.7, 5.2, elevation), came_by);
        assert_eq!(update(4.7, 5.3, -0.5), Feature::Free, "it fell in");
        assert_eq!(update(3.7, 5.2, -0.5), Feature::Free, "the ground was met from below");
    }
}

#[test]
fn an_edge_with_a_hole_on_either_side_is_no_way_down() {
    // A deep sample east of (5, 5), close to the hand, with no ground beside the way to it.
    let grid = grid(11, 11, false, |column, row| match (column, row) {
        (5, 4) | (6, 6) => f64::NAN,
        (6, 5) => -100.0,
        _ => 0.0,
    });
    let mut model = proxy_at(4.9, 5.0, 3.0);
    let contact = model.update(&grid, &SQUARE, &GridPoint::new(4.9, 5.0, -50.0));
    assert_eq!(contact.proxy.elevation, 0.0, "{contact:?}");
    assert_eq!((contact.proxy.columns(), contact.proxy.rows()), (4.9, 5.0));
}

#[test]
fn the_border_of_the_map_holds_a_proxy_in_contact() {
    let grid = grid(11, 11, false, |_, _| 0.0);
    for (column, row) in [(14.0, 5.3), (-4.0, 5.3), (5.3, 14.0), (5.3, -4.0), (-9.0, 13.0)] {
        let mut model = proxy_at(5.0, 5.0, 1.0);
        model.update(&grid, &SQUARE, &GridPoint::new(5.0, 5.0, -1.0));
        let outside = GridPoint::new(column, row, -1.0);
        for _ in 0..3 {
            let contact = model.update(&grid, &SQUARE, &outside);
            assert_ne!(contact.feature, Feature::Free);
            let (x, y) = (contact.proxy.columns(), contact.proxy.rows());
            assert_eq!((x, y), (column.clamp(0.0, 10.0), row.clamp(0.0, 10.0)));
            assert_eq!(contact.proxy.elevation, 0.0);
        }
        let lifted = GridPoint { elevation: 1.0, ..outside };
        let contact = model.update(&grid, &SQUARE, &lifted);
        assert_eq!((contact.feature, contact.distance()), (Feature::Free, 0.0));
    }
}

#[test]
fn a_hand_that_was_never_on_the_map_is_not_pulled_onto_it() {
    let grid = grid(11, 11, false, |_, _| 0.0);
    let mut model = proxy_at(-20.0, 5.0, 1.0);
    for elevation in [1.0, -1.0, 10.0] {
        let goal = GridPoint::new(-20.0, 5.0, elevation);
        assert_eq!(model.update(&grid, &SQUARE, &goal).distance(), 0.0);
    }
    let over = model.update(&grid, &SQUARE, &GridPoint::new(5.3, 5.2, -1.0));
    assert_eq!(over.proxy.elevation, 0.0, "coming in from above it touches");
}

#[test]
fn a_hand_that_begins_inside_the_ground_feels_nothing_until_it_is_out() {
    let grid = hills(60, 0.3, 5);
    let under = GridPoint::new(30.2, 30.4, grid.range().unwrap().minimum - 1.0);
    let mut model = proxy_at(under.columns(), under.rows(), under.elevation);
    let moved = GridPoint { column: 35, ..under };
    assert_eq!(model.update(&grid, &SQUARE, &moved).feature, Feature::Free);
    let out = GridPoint { elevation: 50.0, ..moved };
    assert_eq!(model.update(&grid, &SQUARE, &out).feature, Feature::Free);
    assert_ne!(model.update(&grid, &SQUARE, &moved).feature, Feature::Free);
}

#[test]
fn broken_goals_leave_the_proxy_where_it_is() {
    let grid = hills(60, 0.3, 5);
    let mut model = proxy_at(30.2, 30.4, 50.0);
    let before = model.update(&grid, &SQUARE, &GridPoint::new(30.0, 30.0, -1.0));
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for goal in [
            GridPoint::new(broken, 1.0, 1.0),
            GridPoint::new(1.0, broken, 1.0),
            GridPoint::new(1.0, 1.0, broken),
        ] {
            let contact = model.update(&grid, &SQUARE, &goal);
            assert_eq!((contact.proxy, contact.feature), (before.proxy, before.feature));
        }
    }
    let no_metric = surface::Metric { up: 0.0, ..SQUARE };
    assert_eq!(model.update(&grid, &no_metric, &before.proxy).proxy, before.proxy);
}

#[test]
fn a_goal_beyond_the_budget_is_reached_over_the_next_updates() {
    let grid = hills(1000, 0.1, 11);
    let mut patient = ProxyGraph::new(MIN_STEP_BUDGET);
    patient.place(GridPoint::new(5.0, 5.0, 20.0));
    let mut quick = proxy_at(5.0, 5.0, 20.0);
    let goal = GridPoint::new(990.3, 980.7, grid.range().unwrap().minimum - 3.0);
    let expected = quick.update(&grid, &SQUARE, &goal);
    let (mut updates, mut left) = (0, u32::MAX);
    loop {
        let contact = patient.update(&grid, &SQUARE, &goal);
        updates += 1;
        assert!(contact.counters.vertices + contact.counters.cells <= MIN_STEP_BUDGET);
        if contact.counters.steps_left == 0 {
            assert_eq!((contact.proxy, contact.feature), (expected.proxy, expected.feature));
            break;
        }
        assert!(contact.counters.steps_left <= left, "it comes nearer");
        left = contact.counters.steps_left;
        assert!(updates < 100);
    }
    assert!(updates > 10);
}

#[test]
fn a_teleport_across_planets_ends_within_the_budget() {
    let planet = grid(50, 100, true, |column, row| ((column * 7 + row * 13) % 5) as f64 * 0.1);
    let mut model = proxy_at(50.0, 25.0, 5.0);
    for columns in [1e6, -1e9, 1e12, f64::MAX, 0.0] {
        let contact = model.update(&planet, &SQUARE, &GridPoint::new(columns, 25.3, -5.0));
        assert!(contact.counters.vertices + contact.counters.cells <= BUDGET);
        assert!(contact.proxy.is_finite());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// On a planet it does not matter where the file begins.
    #[test]
    fn the_seam_cannot_be_felt(seed in 0u64..1000, turn in 1usize..40, speed in 0.01f64..5.0) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..40 * 40).map(|_| random.unit()).collect();
        let at = |column: usize, row: usize| heights[row * 40 + column % 40];
        let planet = grid(40, 40, true, at);
        let turned = grid(40, 40, true, |column, row| at(column + turn, row));
        let (mut one, mut other) = (proxy_at(20.0, 20.0, 5.0), proxy_at(20.0 - turn as f64, 20.0, 5.0));
        let (mut column, mut heading) = (20.0, 0.3f64);
        for _ in 0..200 {
            heading += random.between(-0.1, 0.1);
            column += speed * heading.cos();
            let goal = GridPoint::new(column, 20.0 + 5.0 * heading.sin(), random.between(-1.0, 0.7));
            let a = one.update(&planet, &SQUARE, &goal);
            let b = other.update(&turned, &SQUARE, &GridPoint { column: goal.column - turn as i64, ..goal });
            let shifted = GridPoint { column: b.proxy.column + turn as i64, ..b.proxy };
            prop_assert_eq!((a.proxy, a.feature, a.counters), (shifted, b.feature, b.counters));
        }
    }

    /// Random voids: the proxy rests only on triangles that exist, and every update ends.
    #[test]
    fn rough_ground_full_of_holes_is_survived(seed in 0u64..10_000, voids in 0.0f64..0.9, speed in 0.01f64..20.0) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..900)
            .map(|_| if random.unit() < voids { f64::NAN } else { random.between(0.0, 3.0) })
            .collect();
        let grid = grid(30, 30, false, |column, row| heights[row * 30 + column]);
        let mut hand = WanderingHand::new(30, speed, 2.0, seed);
        let mut model = proxy_at(15.0, 15.0, 9.0);
        for _ in 0..100 {
            let goal = hand.next(&grid);
            let contact = model.update(&grid, &SQUARE, &goal);
            prop_assert!(contact.proxy.is_finite() && contact.distance().is_finite());
            prop_assert_eq!(contact.counters.steps_left, 0);
            if contact.feature != Feature::Free {
                prop_assert!(depth_below_surface(&grid, &contact).abs() < 1e-9, "{:?}", contact);
            }
        }
    }
}
