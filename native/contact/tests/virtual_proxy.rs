//! The sphere: it never sinks into the ground, never comes to rest short of a minimum, and is as large
//! as it was made.

mod common;

use common::closest::closest_on_triangle;
use common::*;
use contact::{Contact, ContactModel, Feature, Model, Place, Proxy, ProxyGraph, VirtualProxy};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// A sphere that begins in the air.
fn sphere_over(grid: &Grid, radius: f64, column: f64, row: f64) -> VirtualProxy {
    let mut model = VirtualProxy::new(radius, BUDGET);
    let top = grid.range().unwrap().maximum;
    model.place(GridPoint::new(column, row, top + 10.0 + 2.0 * radius));
    model
}

/// Workspace metres from a point to the closest place of the surface, within `reach` of it.
fn clearance(grid: &Grid, metric: &Metric, point: &GridPoint, reach: f64) -> f64 {
    let columns = (reach / metric.column).ceil() as i64 + 1;
    let rows = (reach / metric.row).ceil() as i64 + 1;
    let corner = |column: i64, row: i64| {
        let elevation = grid.elevation(column, row)?;
        let east = ((column - point.column) as f64 - point.u) * metric.column;
        let south = ((row - point.row) as f64 - point.v) * metric.row;
        Some([east, south, (elevation - point.elevation) * metric.up])
    };
    let mut least = f64::INFINITY;
    for column in point.column - columns..=point.column + columns {
        for row in point.row - rows..=point.row + rows {
            let (north_west, south_east) = (corner(column, row), corner(column + 1, row + 1));
            for third in [corner(column + 1, row), corner(column, row + 1)] {
                if let (Some(a), Some(b), Some(c)) = (north_west, south_east, third) {
                    let nearest = closest_on_triangle([0.0; 3], &[a, b, c]);
                    least = least.min(nearest[0].hypot(nearest[1]).hypot(nearest[2]));
                }
            }
        }
    }
    least
}

/// Whether a small step in any of many directions would bring the sphere closer to `goal` without
/// touching more than it does.
fn can_come_closer(
    grid: &Grid,
    radius: f64,
    contact: &Contact,
    goal: &GridPoint,
    random: &mut Random,
) -> bool {
    let step = 0.01 * radius;
    (0..60).any(|_| {
        let [x, y, z] = [0; 3].map(|_| random.between(-1.0, 1.0));
        let size = x.hypot(y).hypot(z);
        let part = |along: f64| step * along / size;
        let moved = GridPoint::from_sample(
            contact.proxy.column,
            contact.proxy.row,
            contact.proxy.u + part(x),
            contact.proxy.v + part(y),
            contact.proxy.elevation + part(z),
        );
        // The border of the map holds the centre as well.
        let is_on_map = grid.surface_elevation(&moved).is_some();
        is_on_map
            && distance(&moved, goal) < contact.distance() - 1e-3 * step
            && clearance(grid, &SQUARE, &moved, radius) >= radius
    })
}

#[test]
fn it_rests_a_radius_above_a_plane_on_the_foot_of_the_goal() {
    let ground = grid(21, 21, false, |column, row| 0.5 * column as f64 - 0.25 * row as f64);
    for radius in [1e-6, 0.01, 0.4, 1.0, 3.3] {
        let mut model = sphere_over(&ground, radius, 10.0, 10.0);
        let under = GridPoint::new(10.3, 9.2, 0.0);
        let goal = GridPoint { elevation: 0.5 * 10.3 - 0.25 * 9.2 - 0.7, ..under };
        let contact = model.update(&ground, &SQUARE, &goal);
        // Unit normal of the plane: (-0.5, 0.25, 1), rows running south.
        let size = (0.25f64 + 0.0625 + 1.0).sqrt();
        let along = (0.7 / size + radius) / size;
        let expected = [10.3 - 0.5 * along, 9.2 + 0.25 * along, goal.elevation + along];
        let found = [contact.proxy.columns(), contact.proxy.rows(), contact.proxy.elevation];
        for axis in 0..3 {
            assert!((found[axis] - expected[axis]).abs() < 1e-9, "{radius} {found:?} {expected:?}");
        }
        assert!((contact.distance() - (0.7 / size + radius)).abs() < 1e-9);
        assert_eq!(contact.feature, Feature::Face);
    }
}

#[test]
fn it_glides_far_over_flat_ground_in_one_update() {
    let ground = grid(11, 40, false, |_, _| 0.0);
    for radius in [0.01, 0.5, 2.0] {
        let mut model = sphere_over(&ground, radius, 4.3, 5.2);
        model.update(&ground, &SQUARE, &GridPoint::new(4.3, 5.2, -0.5));
        let contact = model.update(&ground, &SQUARE, &GridPoint::new(34.7, 5.9, -0.5));
        assert_eq!(contact.counters.steps_left, 0);
        assert!((contact.proxy.columns() - 34.7).abs() < 1e-9, "{radius} {contact:?}");
        assert!((contact.proxy.elevation - radius).abs() < 1e-9, "{radius} {contact:?}");
        // A cell at a time.
        assert!(contact.counters.collision_tests < 40, "{contact:?}");
    }
}

#[test]
fn it_spans_a_gap_that_a_point_would_fall_into() {
    // A narrow cleft along the rows.
    let ground = grid(21, 21, false, |column, _| if column == 10 { -5.0 } else { 0.0 });
    let goal = GridPoint::new(10.0, 10.3, -1.0);
    let mut point = ProxyGraph::new(BUDGET);
    point.place(GridPoint::new(10.0, 10.3, 20.0));
    assert!(point.update(&ground, &SQUARE, &goal).proxy.elevation < -0.9);
    let mut sphere = sphere_over(&ground, 2.0, 10.0, 10.3);
    let contact = sphere.update(&ground, &SQUARE, &goal);
    // On the two edges beside the cleft, a cell away on either side.
    assert!((contact.proxy.elevation - 3f64.sqrt()).abs() < 1e-6, "{contact:?}");
    assert_eq!(contact.feature, Feature::Edge);
}

#[test]
fn in_the_air_its_centre_is_at_the_goal_and_nothing_is_touched() {
    let ground = hills(60, 0.3, 5);
    let mut model = sphere_over(&ground, 0.5, 30.0, 30.0);
    let top = ground.range().unwrap().maximum;
    for step in 0..100 {
        let goal = GridPoint::new(30.0 + 0.2 * f64::from(step), 30.0, top + 0.6);
        let contact = model.update(&ground, &SQUARE, &goal);
        assert_eq!(
            (contact.proxy, contact.distance(), contact.feature),
            (goal, 0.0, Feature::Free)
        );
    }
}

#[test]
fn it_never_sinks_never_gives_way_and_ends_where_it_can_come_no_closer() {
    let (mut in_contact, mut short) = (0, 0);
    for seed in 0..3 {
        for radius in [0.05, 0.3, 1.0, 2.5] {
            for (slope, speed, noise) in [
                (0.1, 0.01, false),
                (0.1, 3.0, false),
                (1.0, 13.4, false),
                (0.3, 1.0, true),
                (3.0, 0.1, true),
                (10.0, 3.0, true),
                (100.0, 0.3, true),
            ] {
                let ground =
                    if noise { white_noise(64, slope, seed) } else { hills(64, slope, seed) };
                let mut hand = WanderingHand::new(64, speed, if noise { slope } else { 2.0 }, seed);
                let mut model = sphere_over(&ground, radius, 32.0, 32.0);
                let mut random = Random::new(seed);
                for _ in 0..100 {
                    let goal = hand.next(&ground);
                    let before = distance(&model.proxy().position, &goal);
                    let contact = model.update(&ground, &SQUARE, &goal);
                    assert!(contact.distance() <= before * (1.0 + 1e-14), "{contact:?}");
                    let found = clearance(&ground, &SQUARE, &contact.proxy, radius);
                    assert!(found >= radius * (1.0 - 1e-6), "{found} of {radius}: {contact:?}");
                    if contact.counters.steps_left > 0 {
                        continue;
                    }
                    assert_eq!(model.update(&ground, &SQUARE, &goal).proxy, contact.proxy);
                    if contact.feature != Feature::Free {
                        in_contact += 1;
                        assert!(found <= radius * (1.0 + 1e-4), "it hovers: {found} {contact:?}");
                        short += usize::from(can_come_closer(
                            &ground,
                            radius,
                            &contact,
                            &goal,
                            &mut random,
                        ));
                    }
                }
            }
        }
    }
    assert!(in_contact > 4000);
    assert_eq!(short, 0, "of {in_contact}");
}

#[test]
fn taking_over_from_a_point_it_comes_out_of_the_ground_where_it_is() {
    for seed in 0..20 {
        let ground = white_noise(20, 2.0, seed);
        let mut random = Random::new(seed);
        for _ in 0..20 {
            let goal = GridPoint::new(random.between(3.0, 16.0), random.between(3.0, 16.0), -0.5);
            let mut point = ProxyGraph::new(BUDGET);
            point.place(GridPoint { elevation: 20.0, ..goal });
            let touched = point.update(&ground, &SQUARE, &goal);
            for radius in [0.01, 0.3, 1.5] {
                let mut sphere = VirtualProxy::new(radius, BUDGET);
                sphere.take_over(point.proxy());
                let contact = sphere.update(&ground, &SQUARE, &goal);
                assert_ne!(contact.feature, Feature::Free);
                let found = clearance(&ground, &SQUARE, &contact.proxy, radius);
                assert!(found >= radius * (1.0 - 1e-6), "{found} of {radius}: {contact:?}");
                // Not farther than straight up over all that is around would be.
                let apart = distance(&touched.proxy, &contact.proxy);
                assert!(apart < 2.5 + 4.0 * radius, "{apart} with {radius}");
            }
        }
    }
}

#[test]
fn a_point_takes_over_from_it_with_a_ray_from_its_centre() {
    let ground = hills(60, 0.3, 8);
    let mut sphere = sphere_over(&ground, 0.5, 30.0, 30.0);
    let goal = GridPoint::new(31.0, 30.4, -20.0);
    let rested = sphere.update(&ground, &SQUARE, &goal);
    let handed = sphere.proxy();
    assert_eq!(handed.position, rested.proxy);
    assert_eq!(handed.place, Place::Space(surface::ray::Side::Above));
    let mut point = ProxyGraph::new(BUDGET);
    point.take_over(handed);
    assert_ne!(point.update(&ground, &SQUARE, &goal).feature, Feature::Free);
}

/// The hand zooms: the same metres are fewer or more cells.
#[test]
fn zooming_in_contact_it_comes_out_of_the_ground_and_stays_in_contact() {
    let ground = hills(60, 0.5, 8);
    let mut sphere = sphere_over(&ground, 0.2, 30.0, 30.0);
    for zoom in [1.0, 0.5, 0.1, 1.0, 0.05, 4.0, 0.2] {
        let metric = Metric { column: zoom, row: zoom, up: zoom };
        let goal = GridPoint::new(31.0, 30.4, -20.0);
        let contact = sphere.update(&ground, &metric, &goal);
        assert_ne!(contact.feature, Feature::Free, "zoom {zoom}");
        let found = clearance(&ground, &metric, &contact.proxy, 0.2);
        assert!(found >= 0.2 * (1.0 - 1e-6), "zoom {zoom}: {found}");
    }
}

#[test]
fn put_down_reaching_into_the_ground_it_moves_out_and_put_down_inside_it_touches_nothing() {
    let ground = grid(21, 21, false, |_, _| 0.0);
    let over = |elevation| GridPoint::new(10.0, 10.0, elevation);
    let mut model = VirtualProxy::new(1.0, BUDGET);
    model.place(over(0.4));
    let contact = model.update(&ground, &SQUARE, &over(0.4));
    assert_eq!(contact.feature, Feature::Face);
    assert!((contact.proxy.elevation - 1.0).abs() < 1e-9, "{contact:?}");

    model.place(over(-0.4));
    let mut feature = |elevation| model.update(&ground, &SQUARE, &over(elevation)).feature;
    assert_eq!([feature(-0.4), feature(-2.0), feature(0.1)], [Feature::Free; 3]);
    assert_eq!(feature(-0.2), Feature::Face, "its centre had come out");
}

#[test]
fn a_sphere_too_large_for_its_budget_is_as_large_as_fits() {
    let ground = grid(200, 200, false, |_, _| 0.0);
    let mut model = sphere_over(&ground, 1000.0, 100.0, 100.0);
    let radius = model.radius(&SQUARE);
    assert!((10.0..16.0).contains(&radius), "{radius}");
    let contact = model.update(&ground, &SQUARE, &GridPoint::new(100.0, 100.0, -1.0));
    assert!(contact.counters.cells <= BUDGET);
    let mut contact = contact;
    while contact.counters.steps_left > 0 {
        contact = model.update(&ground, &SQUARE, &GridPoint::new(100.0, 100.0, -1.0));
    }
    assert!((contact.proxy.elevation - radius).abs() < 1e-9 * radius, "{contact:?}");
    let small = VirtualProxy::new(2.0, BUDGET);
    assert_eq!(small.radius(&SQUARE), 2.0);
}

#[test]
#[should_panic(expected = "radius")]
fn a_sphere_without_a_radius_cannot_be_made() {
    Model::VirtualProxy { radius: f64::NAN }.build(BUDGET);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// Cells far from square, all scales of metric: the sphere is round in the workspace.
    #[test]
    fn it_never_sinks_under_any_metric(
        seed in 0u64..1000,
        scale in -12i32..9,
        row in -2.0f64..2.0,
        up in -3.0f64..3.0,
        share in 0.02f64..2.0,
    ) {
        let ground = white_noise(20, 1.0, seed);
        let column = 10f64.powi(scale);
        let metric = Metric { column, row: column * 10f64.powf(row), up: column * 10f64.powf(up) };
        let mut model = VirtualProxy::new(share * metric.column.min(metric.row), BUDGET);
        let radius = model.radius(&metric);
        let mut random = Random::new(seed);
        model.take_over(Proxy {
            position: GridPoint::new(10.0, 10.0, 2.0 + 2.0 * radius / metric.up),
            place: Place::Space(surface::ray::Side::Above),
        });
        for _ in 0..50 {
            let goal = GridPoint::new(random.between(0.0, 19.0), random.between(0.0, 19.0), random.between(-1.0, 1.5));
            let contact = model.update(&ground, &metric, &goal);
            let found = clearance(&ground, &metric, &contact.proxy, radius);
            prop_assert!(found >= radius * (1.0 - 1e-6), "{} of {}: {:?}", found, radius, contact);
        }
    }
}
