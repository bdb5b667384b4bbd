//! The god-object with constraint release: exact in the end, on whatever ground, with a collision test
//! for each triangle.

mod common;

use common::*;
use contact::{ContactModel, Feature, GodObjectRelease};
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// A proxy that begins in the air over the map.
fn proxy_over(grid: &Grid, column: f64, row: f64) -> GodObjectRelease {
    let mut model = GodObjectRelease::new(BUDGET);
    let top = grid.range().unwrap().maximum;
    model.place(GridPoint::new(column, row, top + 10.0));
    model
}

/// What happened over a wandering hand.
#[derive(Default, Debug)]
struct Seen {
    in_contact: usize,
    not_minimal: usize,
    moved_again: usize,
}

fn wander(grid: &Grid, metric: &Metric, size: usize, speed: f64, depth: f64, seed: u64) -> Seen {
    let mut hand = WanderingHand::new(size, speed, depth, seed);
    let mut model = proxy_over(grid, size as f64 / 2.0, size as f64 / 2.0);
    let mut seen = Seen::default();
    for _ in 0..500 {
        let goal = hand.next(grid);
        let contact = model.update(grid, metric, &goal);
        assert!(depth_below_surface(grid, &contact) < 1e-9, "{contact:?}");
        assert_eq!(contact.counters.steps_left, 0, "{contact:?}");
        seen.in_contact += usize::from(contact.feature != Feature::Free);
        seen.not_minimal += usize::from(fault_of_minimum(grid, metric, &contact, &goal).is_some());
        seen.moved_again += usize::from(model.update(grid, metric, &goal).proxy != contact.proxy);
    }
    seen
}

#[test]
fn updates_end_at_local_minima_and_a_still_hand_stays_there_bit_for_bit() {
    let (mut in_contact, mut not_minimal) = (0, 0);
    for seed in 0..5 {
        for (slope, depth) in [(0.1, 2.0), (2.0, 5.0)] {
            for speed in [0.01, 0.3, 3.0, 13.4] {
                let ground = hills(200, slope, seed);
                let seen = wander(&ground, &SQUARE, 200, speed, depth, seed);
                assert_eq!((seen.not_minimal, seen.moved_again), (0, 0), "hills {slope} {speed}");
            }
        }
        for (slope, speed) in [(0.3, 1.0), (3.0, 0.1), (10.0, 3.0), (100.0, 0.3), (1e6, 13.4)] {
            let ground = white_noise(64, slope, seed);
            let seen = wander(&ground, &SQUARE, 64, speed, slope, seed);
            assert_eq!(seen.moved_again, 0, "noise {slope} {speed}");
            in_contact += seen.in_contact;
            not_minimal += seen.not_minimal;
        }
    }
    // At slopes of a million, rounding may hide the last of the way.
    assert!(not_minimal * 1000 <= in_contact, "{not_minimal} of {in_contact}");
}

#[test]
fn cells_that_are_not_square_change_nothing_of_that() {
    for (row, up) in [(0.01, 1.0), (100.0, 1.0), (1.0, 20.0), (3.0, 1e-3)] {
        let ground = hills(60, 0.3, 9);
        let metric = Metric { column: 1.0, row, up };
        let seen = wander(&ground, &metric, 60, 1.0, 2.0, 5);
        assert_eq!((seen.not_minimal, seen.moved_again), (0, 0), "row {row} up {up}");
    }
}

#[test]
fn no_update_ends_farther_from_the_hand_than_it_begins() {
    for seed in 0..20 {
        let ground = white_noise(32, 5.0, seed);
        let mut random = Random::new(seed);
        let mut model = proxy_over(&ground, 16.0, 16.0);
        for step in 0..600 {
            let column = 16.0 + 0.002 * f64::from(step);
            let goal = GridPoint::new(column, 16.3, random.between(-3.0, 2.0));
            let before = distance(&model.proxy().position, &goal);
            let contact = model.update(&ground, &SQUARE, &goal);
            assert!(contact.distance() <= before * (1.0 + 1e-14), "{before} {contact:?}");
        }
    }
}

#[test]
fn every_triangle_crossed_costs_a_collision_test() {
    let ground = hills(200, 0.1, 4);
    let mut model = proxy_over(&ground, 50.0, 50.0);
    let goal = |column: f64| {
        let under = GridPoint::new(column, 50.3, 0.0);
        GridPoint { elevation: ground.surface_elevation(&under).unwrap() - 0.5, ..under }
    };
    model.update(&ground, &SQUARE, &goal(50.2));
    let still = model.update(&ground, &SQUARE, &goal(50.2));
    assert_eq!(still.counters.collision_tests, 0, "in its triangle nothing is in the way");
    let swiped = model.update(&ground, &SQUARE, &goal(60.2));
    // Ten columns: twenty triangles, but for where the way bends.
    let tests = swiped.counters.collision_tests;
    assert!((16..=24).contains(&tests), "{swiped:?}");
}

#[test]
fn a_crease_is_followed_to_its_lowest_point() {
    // A valley along the rows that falls to row 6 and rises again.
    let ground = grid(13, 9, false, |column, row| {
        (column as f64 - 4.0).abs() + 0.1 * (row as f64 - 6.0).abs()
    });
    let mut model = proxy_over(&ground, 2.2, 1.3);
    let contact = model.update(&ground, &SQUARE, &GridPoint::new(4.0, 6.0, -3.0));
    assert_eq!(contact.feature, Feature::Vertex);
    assert_eq!((contact.proxy.columns(), contact.proxy.rows()), (4.0, 6.0));
    let aside = model.update(&ground, &SQUARE, &GridPoint::new(4.0, 3.4, -0.3));
    assert_eq!(aside.feature, Feature::Edge, "{aside:?}");
    assert_eq!(aside.proxy.columns(), 4.0);
}
