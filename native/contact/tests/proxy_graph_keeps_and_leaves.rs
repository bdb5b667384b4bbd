//! Where contact begins, what keeps it and what ends it: places exactly on the surface, and ways
//! that start on it.

mod common;

use common::*;
use contact::{Contact, ContactModel, Feature, ProxyGraph};
use surface::{Grid, GridPoint};

const BUDGET: u32 = 4096;

/// A proxy brought down onto the ground over `goal`, and where it came to rest.
fn pressed(grid: &Grid, goal: &GridPoint) -> (ProxyGraph, Contact) {
    let mut model = ProxyGraph::new(BUDGET);
    model.place(GridPoint { elevation: 1000.0, ..*goal });
    let contact = model.update(grid, &SQUARE, goal);
    (model, contact)
}

#[test]
fn the_search_begins_at_the_corner_that_is_closest_to_the_goal() {
    let grid = grid(11, 11, false, |_, _| 0.0);
    // Two goals near each corner of a cell, one in either half.
    for (column, row) in [(0.2, 0.1), (0.1, 0.2), (0.9, 0.8), (0.8, 0.9), (0.9, 0.1), (0.1, 0.9)] {
        let (_, contact) = pressed(&grid, &GridPoint::new(5.0 + column, 5.0 + row, -0.1));
        assert_eq!(contact.counters.vertices, 1, "{column} {row}: its minimum is beside it");
        assert_eq!(contact.feature, Feature::Face);
    }
}

/// From each kind of place to each other kind, along the ground.
#[test]
fn a_hand_exactly_on_the_surface_stays_in_contact() {
    let grid = grid(11, 11, false, |column, row| 0.5 * column as f64 - 0.25 * row as f64);
    let on_ground = |column: f64, row: f64| GridPoint::new(column, row, 0.5 * column - 0.25 * row);
    let face = on_ground(5.25, 5.125);
    let (edge, diagonal, vertex) = (on_ground(6.0, 4.5), on_ground(4.5, 6.5), on_ground(5.0, 4.0));
    for from in [face, edge, diagonal, vertex] {
        for to in [face, edge, diagonal, vertex] {
            // Straight up from under the plane: the proxy rests where `from` is.
            let under =
                GridPoint::new(from.columns() + 0.5, from.rows() - 0.25, from.elevation - 1.0);
            let (mut model, rested) = pressed(&grid, &under);
            assert!((rested.proxy.columns() - from.columns()).abs() < 1e-12);
            let contact = model.update(&grid, &SQUARE, &to);
            assert_ne!(contact.feature, Feature::Free, "from {from:?} to {to:?}");
            assert_eq!(contact.distance(), 0.0);
            let lifted = GridPoint { elevation: to.elevation + 1e-9, ..to };
            assert_eq!(model.update(&grid, &SQUARE, &lifted).feature, Feature::Free);
        }
    }
}

/// What it lies on is where the way begins, and no rounding may have it met again.
#[test]
fn a_hand_lifted_steeply_leaves_at_once_whatever_the_proxy_lies_on() {
    let mut left = [0; 3];
    for seed in 0..200 {
        let grid = white_noise(16, 3.0, seed);
        let mut random = Random::new(seed + 1000);
        for turn in 0..16 {
            let (column, row) = (random.between(3.0, 12.0), random.between(3.0, 12.0));
            let under = GridPoint::new(column, row, random.between(-3.0, 1.0));
            let (mut model, rested) = pressed(&grid, &under);
            match rested.feature {
                Feature::Free => continue,
                Feature::Face => left[0] += 1,
                Feature::Edge => left[1] += 1,
                Feature::Vertex => left[2] += 1,
            }
            // Steeper than any ground here.
            let angle = std::f64::consts::TAU * f64::from(turn) / 16.0;
            let away = GridPoint::new(
                rested.proxy.columns() + 0.7 * angle.cos(),
                rested.proxy.rows() + 0.7 * angle.sin(),
                rested.proxy.elevation + 50.0,
            );
            let contact = model.update(&grid, &SQUARE, &away);
            assert_eq!((contact.feature, contact.proxy), (Feature::Free, away));
            let counters = contact.counters;
            assert_eq!((counters.collision_tests, counters.vertices), (1, 0), "from {rested:?}");
        }
    }
    assert!(left.iter().all(|times| *times > 100), "faces, edges and vertices: {left:?}");
}
