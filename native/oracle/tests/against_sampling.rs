//! The oracle against something duller still: heights of the surface, sampled densely.

use oracle::terrain::{Random, hills, white_noise};
use oracle::{Oracle, fault_of_minimum};
use surface::{Grid, GridPoint, Metric};

const SQUARE: Metric = Metric { column: 1.0, row: 1.0, up: 1.0 };

fn plain(point: &GridPoint) -> [f64; 3] {
    [point.columns(), point.rows(), point.elevation]
}

fn apart(a: &GridPoint, b: &GridPoint) -> f64 {
    let (a, b) = (plain(a), plain(b));
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

fn on_surface(grid: &Grid, columns: f64, rows: f64) -> Option<GridPoint> {
    let over = GridPoint::new(columns, rows, 0.0);
    grid.surface_elevation(&over).map(|elevation| GridPoint { elevation, ..over })
}

/// Points of the surface in rings around a point, out to `radius` cells.
fn around(grid: &Grid, center: &GridPoint, radius: f64) -> Vec<GridPoint> {
    let mut points = Vec::new();
    for ring in 1..=4 {
        for turn in 0..180 {
            let angle = std::f64::consts::TAU * f64::from(turn) / 180.0;
            let out = radius * f64::from(ring) / 4.0;
            let (columns, rows) =
                (center.columns() + out * angle.cos(), center.rows() + out * angle.sin());
            points.extend(on_surface(grid, columns, rows));
        }
    }
    points
}

fn goal_under(grid: &Grid, random: &mut Random, size: f64, deepest: f64) -> GridPoint {
    let (columns, rows) = (random.between(2.0, size - 3.0), random.between(2.0, size - 3.0));
    let over = on_surface(grid, columns, rows).unwrap();
    GridPoint { elevation: over.elevation - random.between(0.0, deepest), ..over }
}

#[test]
fn where_it_comes_to_rest_no_sample_around_is_nearer() {
    let mut touched = 0;
    for seed in 0..60 {
        for (slope, depth) in [(0.3, 1.0), (3.0, 2.0), (30.0, 10.0)] {
            let grid = white_noise(12, slope, seed);
            let mut random = Random::new(seed + 77);
            let mut proxy = Oracle::in_space(GridPoint::new(6.0, 6.0, slope + 1.0));
            let mut goal = proxy.position();
            for _ in 0..20 {
                let next = goal_under(&grid, &mut random, 12.0, depth);
                proxy.follow(&grid, &SQUARE, &goal, &next, 20);
                goal = next;
                let here = proxy.position();
                if !proxy.touches() {
                    assert_eq!(here, goal);
                    continue;
                }
                touched += 1;
                let distance = apart(&here, &goal);
                for point in around(&grid, &here, 1e-6) {
                    assert!(apart(&point, &goal) > distance - 1e-9, "seed {seed}: {here:?}");
                }
            }
        }
    }
    assert!(touched > 1000, "{touched}");
}

/// A proxy that is moved to the nearest of many samples around it, again and again.
fn sampled_descent(grid: &Grid, mut here: GridPoint, goal: &GridPoint) -> GridPoint {
    for radius in [0.02, 1e-3, 1e-4] {
        loop {
            let nearest = around(grid, &here, radius)
                .into_iter()
                .min_by(|a, b| apart(a, goal).total_cmp(&apart(b, goal)))
                .unwrap();
            if apart(&nearest, goal) >= apart(&here, goal) {
                break;
            }
            here = nearest;
        }
    }
    here
}

#[test]
fn it_descends_to_where_many_small_steps_lead() {
    let (mut tried, mut same) = (0, 0);
    for seed in 0..60 {
        let grid = hills(24, 1.5, seed);
        let mut random = Random::new(seed);
        let start = on_surface(&grid, random.between(8.0, 16.0), random.between(8.0, 16.0));
        let start = start.unwrap();
        let aside = |random: &mut Random| random.between(-2.0, 2.0);
        let goal = GridPoint::new(
            start.columns() + aside(&mut random),
            start.rows() + aside(&mut random),
            start.elevation - 2.0,
        );
        if goal.elevation > on_surface(&grid, goal.columns(), goal.rows()).unwrap().elevation {
            continue;
        }
        let mut proxy = Oracle::on_surface(start);
        proxy.follow(&grid, &SQUARE, &goal, &goal, 1);
        let expected = sampled_descent(&grid, start, &goal);
        tried += 1;
        same += usize::from(proxy.touches() && apart(&proxy.position(), &expected) < 0.02);
    }
    // Where ways part, small steps may take the other.
    println!("{same} of {tried} ends are the same");
    assert!(tried > 40 && same * 100 >= 95 * tried, "{same} of {tried}");
}

#[test]
fn a_flight_ends_where_samples_of_its_way_go_under() {
    let mut hits = 0;
    for seed in 0..200 {
        let grid = white_noise(12, 3.0, seed);
        let mut random = Random::new(seed + 5);
        let mut over = || random.between(0.5, 10.5);
        let from = GridPoint::new(over(), over(), 3.5);
        let (to_columns, to_rows) = (over(), over());
        let to = GridPoint::new(to_columns, to_rows, random.between(-2.0, 4.0));
        let at = |t: f64| {
            let (a, b) = (plain(&from), plain(&to));
            let [x, y, z] = [0, 1, 2].map(|axis| a[axis] + t * (b[axis] - a[axis]));
            GridPoint::new(x, y, z)
        };
        let is_under = |t: f64| {
            let point = at(t);
            point.elevation < on_surface(&grid, point.columns(), point.rows()).unwrap().elevation
        };
        let first = (0..=100_000).map(|step| f64::from(step) / 1e5).find(|t| is_under(*t));

        let mut proxy = Oracle::in_space(from);
        proxy.follow(&grid, &SQUARE, &from, &to, 1);
        match first {
            None => assert_eq!((proxy.touches(), proxy.position()), (false, to), "seed {seed}"),
            Some(t) => {
                hits += 1;
                // It goes on from there over the surface, perhaps into the open again.
                let (here, touches) = (proxy.position(), proxy.touches());
                assert!(apart(&here, &to) <= apart(&at(t), &to) + 1e-3, "seed {seed}");
                let fault = fault_of_minimum(&grid, &SQUARE, &here, touches, &to);
                assert_eq!(fault, None, "seed {seed}");
                // Where the goal is just under the surface, it stays where it met it.
                let mut stopped = Oracle::in_space(from);
                let just_under = at(t + 1e-5);
                stopped.follow(&grid, &SQUARE, &from, &just_under, 1);
                assert!(apart(&stopped.position(), &at(t)) < 1e-3, "seed {seed}");
            }
        }
    }
    assert!(hits > 50, "{hits}");
}
