//! Motions that can be told in advance.

use oracle::terrain::{grid, hills};
use oracle::{Fault, Oracle, depth_below_surface, fault_of_minimum};
use surface::{Grid, GridPoint, Metric};

const SQUARE: Metric = Metric { column: 1.0, row: 1.0, up: 1.0 };

fn flat() -> Grid {
    grid(11, 11, false, |_, _| 0.0)
}

fn assert_near(proxy: &Oracle, [columns, rows, elevation]: [f64; 3]) {
    let point = proxy.position();
    let off =
        (point.columns() - columns).hypot(point.rows() - rows).hypot(point.elevation - elevation);
    assert!(off < 1e-12, "{point:?}, not {columns} {rows} {elevation}");
}

/// A proxy pressed onto the ground straight over `goal`, which then moves.
fn pressed(grid: &Grid, goal: &GridPoint) -> Oracle {
    let over = GridPoint { elevation: 100.0, ..*goal };
    let mut proxy = Oracle::in_space(over);
    proxy.follow(grid, &SQUARE, &over, goal, 10);
    proxy
}

#[test]
fn on_a_plane_it_is_at_the_foot_of_the_goal() {
    let grid = grid(21, 21, false, |column, row| 0.5 * column as f64 - 0.25 * row as f64);
    let goal = GridPoint::new(10.3, 9.6, 2.0);
    let mut proxy = pressed(&grid, &goal);
    let height = 2.0 - (0.5 * 10.3 - 0.25 * 9.6);
    let shift = height / (1.0 + 0.5f64.powi(2) + 0.25f64.powi(2));
    assert_near(&proxy, [10.3 + 0.5 * shift, 9.6 - 0.25 * shift, 2.0 - shift]);

    let to = GridPoint::new(12.0, 8.5, 3.0);
    proxy.follow(&grid, &SQUARE, &goal, &to, 7);
    let height = 3.0 - (0.5 * 12.0 - 0.25 * 8.5);
    let shift = height / (1.0 + 0.5f64.powi(2) + 0.25f64.powi(2));
    assert_near(&proxy, [12.0 + 0.5 * shift, 8.5 - 0.25 * shift, 3.0 - shift]);
    assert!(proxy.touches());
}

/// A ridge along column 5.
#[test]
fn a_flank_is_climbed_only_where_the_goal_is_near_it() {
    let grid = grid(11, 11, false, |column, _| if column == 5 { 2.0 } else { 0.0 });
    let goal = GridPoint::new(3.5, 5.2, -0.5);
    let mut proxy = pressed(&grid, &goal);
    assert_near(&proxy, [3.5, 5.2, 0.0]);
    let inside = GridPoint::new(4.5, 5.2, -0.5);
    proxy.follow(&grid, &SQUARE, &goal, &inside, 100);
    assert_near(&proxy, [4.0, 5.2, 0.0]);
    // From the crease it leaves where the foot on the flank, z = 2 (x - 4), is up the flank.
    let under_flank = GridPoint::new(4.5, 5.2, 0.5);
    proxy.follow(&grid, &SQUARE, &inside, &under_flank, 100);
    assert_near(&proxy, [4.5 - 2.0 * 0.5 / 5.0, 5.2, 0.6]);
}

#[test]
fn the_border_is_a_wall_and_a_hand_lifted_beyond_it_leaves() {
    let grid = flat();
    let inside = GridPoint::new(5.0, 5.0, -1.0);
    for (columns, rows) in [(14.0, 5.3), (-4.0, 5.3), (5.3, 14.0), (-9.0, 13.0)] {
        let mut proxy = pressed(&grid, &inside);
        let outside = GridPoint::new(columns, rows, -1.0);
        proxy.follow(&grid, &SQUARE, &inside, &outside, 50);
        assert_near(&proxy, [columns.clamp(0.0, 10.0), rows.clamp(0.0, 10.0), 0.0]);
        let here = proxy.position();
        assert_eq!(fault_of_minimum(&grid, &SQUARE, &here, true, &outside), None);
        let lifted = GridPoint { elevation: 1.0, ..outside };
        proxy.follow(&grid, &SQUARE, &outside, &lifted, 50);
        assert_eq!((proxy.touches(), proxy.position()), (false, lifted));
    }
}

#[test]
fn a_hole_is_fallen_into_and_left_only_upwards() {
    let grid =
        grid(11, 11, false, |column, row| if (column, row) == (5, 5) { f64::NAN } else { 0.0 });
    let mut goal = GridPoint::new(2.5, 5.2, -0.5);
    let mut proxy = pressed(&grid, &goal);
    let mut follow = |columns, rows, elevation| {
        let to = GridPoint::new(columns, rows, elevation);
        proxy.follow(&grid, &SQUARE, &goal, &to, 50);
        goal = to;
        (proxy.touches(), proxy.position() == to)
    };
    assert_eq!(follow(3.9, 5.2, -0.5), (true, false), "to the rim");
    assert_eq!(follow(5.1, 5.1, -0.5), (false, true), "over it");
    assert_eq!(follow(2.5, 5.2, -0.5), (false, true), "ground is not met from within");
    assert_eq!(follow(2.5, 5.2, 0.5), (false, true), "it comes out through the back");
    assert_eq!(follow(2.5, 5.2, -0.5), (true, false), "from above it is met again");
}

#[test]
fn faults_are_told_apart() {
    let grid = hills(50, 0.3, 7);
    let under = GridPoint::new(25.3, 25.4, 0.0);
    let goal = GridPoint { elevation: grid.surface_elevation(&under).unwrap() - 1.0, ..under };
    let proxy = pressed(&grid, &goal).position();
    let fault =
        |proxy: &GridPoint, touches, goal| fault_of_minimum(&grid, &SQUARE, proxy, touches, goal);
    assert_eq!(fault(&proxy, true, &goal), None);
    assert_eq!(fault(&proxy, false, &goal), Some(Fault::NotAtGoal));

    let aside = GridPoint::new(27.6, 25.4, 0.0);
    let aside = GridPoint { elevation: grid.surface_elevation(&aside).unwrap(), ..aside };
    assert_eq!(fault(&aside, true, &goal), Some(Fault::CloserOnSurface));

    let mirrored = GridPoint::new(
        2.0 * proxy.columns() - goal.columns(),
        2.0 * proxy.rows() - goal.rows(),
        2.0 * proxy.elevation - goal.elevation,
    );
    assert_eq!(fault(&proxy, true, &mirrored), Some(Fault::WayIsFree));
    let floating = GridPoint { elevation: proxy.elevation + 0.5, ..proxy };
    assert_eq!(fault(&floating, true, &goal), Some(Fault::WayIsFree));
}

#[test]
fn depth_is_told_in_parts_of_the_relief() {
    let grid = grid(11, 11, false, |column, _| if column == 5 { 4.0 } else { 0.0 });
    let depth = |elevation| depth_below_surface(&grid, &GridPoint::new(4.5, 5.2, elevation));
    assert_eq!(depth(2.0), 0.0);
    assert_eq!(depth(1.0), 0.25);
    assert_eq!(depth(3.0), -0.25);
    assert_eq!(depth_below_surface(&grid, &GridPoint::new(40.0, 5.2, -1.0)), 0.0);
}

/// The rim is a diagonal: rounding must not take a way along it for one through the hole.
#[test]
fn a_way_along_the_rim_of_a_hole_stays_in_contact() {
    let sample = |column, row| match (column, row) {
        (1, 0) => f64::NAN,
        (0, _) => 81.14722325848203,
        _ => 40.573611629241014,
    };
    let grid = grid(3, 3, false, sample);
    let metric = Metric { column: 1.0, row: 10f64.powf(-1.5367273001794666), up: 1.0 };
    let (along, height) = (0.8975684678526161, 44.72962883317709);
    let mut proxy = Oracle::on_surface(GridPoint::new(along, along, height));
    let from = GridPoint::new(0.6, 0.7, 44.722290682058016);
    proxy.follow(&grid, &metric, &from, &GridPoint::new(0.5, 0.5, 30.734448154675036), 1);
    assert!(proxy.touches());
}
