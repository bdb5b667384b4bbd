//! The god-object with constraint release: exact in the end, on whatever ground.

mod common;

use common::*;
use contact::{Contact, ContactModel, Feature, GodObjectRelease};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// A proxy that begins in the air over the middle of the map.
fn proxy_over(grid: &Grid, column: f64, row: f64) -> GodObjectRelease {
    let mut model = GodObjectRelease::new(BUDGET);
    let top = grid.range().unwrap().maximum;
    model.place(GridPoint::new(column, row, top + 10.0));
    model
}

fn assert_sound(grid: &Grid, contact: &Contact) {
    assert!(contact.proxy.is_finite() && contact.distance.is_finite(), "{contact:?}");
    let counters = &contact.counters;
    assert!(counters.vertices + counters.faces + counters.cells <= BUDGET, "{contact:?}");
    assert!(depth_below_surface(grid, contact) < 1e-9, "{contact:?}");
}

/// Shares of updates in contact that do not end as the paper says, over a wandering hand.
#[derive(Default, Debug)]
struct Shares {
    in_contact: usize,
    not_minimal: usize,
    cycles: u32,
    not_still: usize,
    crossings: f64,
    tests: u32,
}

fn wander(
    grid: &Grid,
    metric: Metric,
    size: usize,
    speed: f64,
    depth: f64,
    updates: usize,
    seed: u64,
) -> Shares {
    let mut hand = WanderingHand::new(size, speed, depth, seed);
    let mut model = proxy_over(grid, size as f64 / 2.0, size as f64 / 2.0);
    let mut shares = Shares::default();
    for _ in 0..updates {
        let goal = hand.next(grid);
        let contact = model.update(grid, &metric, &goal);
        assert_sound(grid, &contact);
        assert_eq!(contact.counters.steps_left, 0, "{contact:?}");
        shares.in_contact += usize::from(contact.feature != Feature::Free);
        if let Some(_f) = fault_of_minimum(grid, &metric, &contact, &goal) {
            shares.not_minimal += 1;
            if shares.not_minimal < 2 {
                println!("{_f:?} {contact:?} {goal:?}");
            }
        }
        shares.cycles += contact.counters.cycles_ended;
        shares.tests += contact.counters.collision_tests;
        let again = model.update(grid, &metric, &goal);
        shares.not_still += usize::from(again.proxy != contact.proxy);
    }
    shares
}

#[test]
fn scratch() {
    for seed in 0..5 {
        for speed in [0.01, 0.3, 3.0, 13.4] {
            let grid = hills(200, 0.1, seed);
            println!("hills {speed} {:?}", wander(&grid, SQUARE, 200, speed, 2.0, 1000, seed));
        }
        for (slope, speed) in [(0.3, 1.0), (3.0, 0.1), (10.0, 3.0), (100.0, 0.3), (1e6, 13.4)] {
            let grid = white_noise(64, slope, seed);
            println!(
                "noise {slope} {speed} {:?}",
                wander(&grid, SQUARE, 64, speed, slope, 1000, seed)
            );
        }
    }
}
