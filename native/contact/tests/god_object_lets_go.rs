//! The god-object without release where its constraints have to end: over holes, and between walls.

mod common;

use common::random_hand::Ground;
use common::trial::Trial;
use common::*;
use contact::{ContactModel, Feature, GodObject, MIN_STEP_BUDGET, Model};
use surface::{Grid, GridPoint, Metric};

/// Flat ground at height 0 with a trench of void from column 10 to column 210.
fn ground_with_a_void_trench() -> Grid {
    grid(11, 240, false, |column, _| if (11..210).contains(&column) { f64::NAN } else { 0.0 })
}

/// The budget may end in the midst of the hole: there no plane holds the proxy either.
#[test]
fn over_a_hole_it_is_out_of_contact_wherever_the_budget_ends() {
    let ground = ground_with_a_void_trench();
    for budget in MIN_STEP_BUDGET..2 * MIN_STEP_BUDGET {
        let mut model = GodObject::new(budget);
        model.place(GridPoint::new(5.2, 5.3, 0.1));
        model.update(&ground, &SQUARE, &GridPoint::new(5.2, 5.3, -0.5));
        for _ in 0..40 {
            let contact = model.update(&ground, &SQUARE, &GridPoint::new(230.2, 5.4, -0.5));
            let is_over_hole = contact.proxy.columns() > 10.0 && contact.proxy.columns() < 210.0;
            assert!(!is_over_hole || contact.feature == Feature::Free, "{budget}: {contact:?}");
            let depth = depth_below_surface(&ground, &contact);
            assert!(contact.feature == Feature::Free || depth <= 0.0, "{budget}: {contact:?}");
        }
    }
}

/// Where its plane leads out over a hole it goes on to the goal, and touches what is on its way there.
#[test]
fn what_slid_out_over_a_hole_does_not_pass_through_the_ground_behind_it() {
    // Beyond the trench the ground is lower: a proxy that slid out at height 0 meets it from above.
    let height = |column: usize| match column {
        0..=10 => 0.0,
        11..=29 => f64::NAN,
        _ => -20.0,
    };
    let ground = grid(11, 60, false, |column, _| height(column));
    let mut model = GodObject::new(4096);
    model.place(GridPoint::new(5.2, 5.3, 0.1));
    model.update(&ground, &SQUARE, &GridPoint::new(5.2, 5.3, -0.5));
    // Its foot on the plane of height 0 is over the hole.
    let over_hole = GridPoint::new(28.2, 5.4, -0.5);
    assert_eq!(model.update(&ground, &SQUARE, &over_hole).feature, Feature::Free);
    let contact = model.update(&ground, &SQUARE, &GridPoint::new(40.2, 5.4, -22.0));
    assert_ne!(contact.feature, Feature::Free, "{contact:?}");
    assert_eq!(contact.proxy.elevation, -20.0, "{contact:?}");
}

/// Planes that are parallel to rounding give way to each other: to and fro, were it not seen.
#[test]
fn in_a_cleft_whose_walls_are_parallel_to_rounding_it_comes_to_an_end() {
    let (low, high) = (-32768.0, 32767.0);
    let cleft = grid(2, 2, false, |column, row| if column == row { low } else { high });
    let narrow = Metric { up: 7e5, ..SQUARE };
    let wall = GridPoint::new(0.6, 0.2, -1000.0);
    for below in [1e-7, 4e-7, 1e-3, 1.0, 1000.0] {
        let mut trial = Trial::over_the_middle(&cleft, narrow, &Model::GodObject, 4096);
        trial.rest(&wall).unwrap();
        trial.rest(&GridPoint::new(0.5, 0.5, low - below)).unwrap();
    }
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let ground = Ground { levels: 3, ..Ground::noise(6, 6, 65535.0) }.grid(&mut random);
        let metric = Metric { up: 10f64.powf(random.between(4.0, 7.0)), ..SQUARE };
        let mut trial = Trial::over_the_middle(&ground, metric, &Model::GodObject, 4096);
        for _ in 0..40 {
            let (x, y) = (random.between(0.0, 5.0), random.between(0.0, 5.0));
            trial.rest(&GridPoint::new(x, y, -random.between(0.0, 1000.0))).unwrap();
        }
    }
}
