//! Constraints that are not released (paper figure 4), and beside each what releasing them does.

mod common;

use common::*;
use contact::{Contact, ContactModel, Feature, GodObject, GodObjectRelease, Place};
use surface::{Grid, GridPoint};

const BUDGET: u32 = 4096;

/// Without and with release.
fn both() -> [Box<dyn ContactModel>; 2] {
    [Box::new(GodObject::new(BUDGET)), Box::new(GodObjectRelease::new(BUDGET))]
}

/// The outcome of the swipe from over `from` to `to` in one update, without and with release, and
/// of a second update with the hand held still.
fn swipe(grid: &Grid, from: GridPoint, to: GridPoint) -> [[Contact; 2]; 2] {
    both().map(|mut model| {
        model.place(GridPoint { elevation: 10.0, ..from });
        let pressed = model.update(grid, &SQUARE, &from);
        assert_eq!((pressed.feature, pressed.proxy.elevation), (Feature::Face, 0.0));
        [model.update(grid, &SQUARE, &to), model.update(grid, &SQUARE, &to)]
    })
}

/// Flat up to column 5, from there falling (or rising) by `slope` a column.
fn bent(slope: f64) -> Grid {
    grid(9, 21, false, |column, _| slope * (column as f64 - 5.0).max(0.0))
}

#[test]
fn where_ground_falls_away_the_proxy_floats_and_with_release_it_does_not() {
    let ground = bent(-0.5);
    let (from, to) = (GridPoint::new(3.3, 4.2, -0.5), GridPoint::new(9.3, 4.4, -4.0));
    let [[floating, fallen], [released, _]] = swipe(&ground, from, to);

    let under = ground.surface_elevation(&floating.proxy).unwrap();
    assert_eq!(floating.proxy.elevation, 0.0, "in the plane of the flat ground");
    assert!(under < -2.0, "high over the ground: {under}");
    assert!((floating.proxy.columns() - 9.3).abs() < 1e-12, "over the hand");
    assert_ne!(floating.feature, Feature::Free, "and its spring pulls");

    assert_eq!(fault_of_minimum(&ground, &SQUARE, &released, &to), None);
    assert!(released.distance() < 0.5 * floating.distance());
    assert_eq!(
        fault_of_minimum(&ground, &SQUARE, &fallen, &to),
        None,
        "constraints are found anew"
    );
}

#[test]
fn where_ground_rises_the_proxy_sticks_and_with_release_it_does_not() {
    let ground = bent(0.2);
    let (from, to) = (GridPoint::new(3.3, 4.2, -0.5), GridPoint::new(9.3, 4.4, -0.5));
    let [[stuck, freed], [released, _]] = swipe(&ground, from, to);

    assert!((stuck.proxy.columns() - 5.0).abs() < 1e-12, "where the two planes meet: {stuck:?}");
    assert_eq!(fault_of_minimum(&ground, &SQUARE, &stuck, &to), Some(Fault::CloserOnSurface));
    assert_eq!(stuck.feature, Feature::Edge, "two planes hold it");

    assert_eq!(fault_of_minimum(&ground, &SQUARE, &released, &to), None);
    assert!(released.proxy.columns() > 9.0, "up the slope to the hand: {released:?}");
    assert_eq!(fault_of_minimum(&ground, &SQUARE, &freed, &to), None, "constraints are found anew");
}

#[test]
fn three_planes_leave_a_single_point() {
    // A pit whose sides the hand is swept over.
    let ground = grid(9, 9, false, |column, row| {
        let away = |at: usize| (at as f64 - 4.0).abs();
        away(column).max(away(row)) + 0.1 * column as f64
    });
    let mut model = GodObject::new(BUDGET);
    model.place(GridPoint::new(1.5, 2.2, 10.0));
    model.update(&ground, &SQUARE, &GridPoint::new(1.5, 2.2, 0.0));
    let contact = model.update(&ground, &SQUARE, &GridPoint::new(4.1, 4.2, -20.0));
    assert_eq!(contact.feature, Feature::Vertex, "{contact:?}");
    assert!(depth_below_surface(&ground, &contact) < 1e-12);
}

#[test]
fn a_floating_proxy_is_handed_over_in_space_above() {
    let ground = bent(-0.5);
    let mut model = GodObject::new(BUDGET);
    model.place(GridPoint::new(3.3, 4.2, 10.0));
    model.update(&ground, &SQUARE, &GridPoint::new(3.3, 4.2, -0.5));
    model.update(&ground, &SQUARE, &GridPoint::new(9.3, 4.4, -4.0));
    let proxy = model.proxy();
    assert_eq!(proxy.place, Place::Space(surface::ray::Side::Above));
    let mut next = GodObjectRelease::new(BUDGET);
    next.take_over(proxy);
    let goal = GridPoint::new(9.3, 4.4, -4.0);
    let contact = next.update(&ground, &SQUARE, &goal);
    assert_eq!(fault_of_minimum(&ground, &SQUARE, &contact, &goal), None);
}

/// What the paper calls viscosity: a hand over many triangles an update leaves the proxy behind.
#[test]
fn on_ground_of_many_triangles_only_release_keeps_up_with_a_fast_hand() {
    let ground = hills(200, 0.5, 3);
    let not_minimal = both().map(|mut model| {
        let mut hand = WanderingHand::new(200, 5.0, 2.0, 3);
        model.place(GridPoint::new(100.0, 100.0, 100.0));
        let is_not_minimal = |goal: GridPoint| {
            let contact = model.update(&ground, &SQUARE, &goal);
            fault_of_minimum(&ground, &SQUARE, &contact, &goal).is_some()
        };
        (0..1000)
            .map(|_| hand.next(&ground))
            .filter(|goal| goal.is_finite())
            .map(is_not_minimal)
            .filter(|is_not| *is_not)
            .count()
    });
    assert!(not_minimal[0] > 300, "{not_minimal:?} of 1000");
    assert_eq!(not_minimal[1], 0);
}
