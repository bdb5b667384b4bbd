//! Steps over far edges that come round to where they began (paper 3.3).

mod common;

use common::*;
use contact::{ContactModel, Feature, ProxyGraph};
use surface::{Grid, GridPoint};

#[test]
fn a_far_edge_loop_ends_at_the_closest_point_of_an_edge() {
    let mut loops_ended_inside_an_edge = 0;
    for seed in 0..200 {
        let grid = white_noise(32, 20.0, seed);
        let mut hand = WanderingHand::new(32, 0.5, 20.0, seed);
        let mut model = ProxyGraph::new(4096);
        model.place(GridPoint::new(16.0, 16.0, 100.0));
        for _ in 0..500 {
            let goal = hand.next(&grid);
            let contact = model.update(&grid, &SQUARE, &goal);
            if contact.counters.far_edge_loops == 0 {
                continue;
            }
            assert_eq!(contact.feature, Feature::Edge, "{contact:?}");
            let off = distance_from_closest_of_its_edge(&grid, &contact.proxy, &goal);
            assert!(off < 1e-9, "seed {seed}: {off} from the minimum, {contact:?}");
            let inside = (contact.proxy.u, contact.proxy.v) != (0.0, 0.0);
            loops_ended_inside_an_edge += usize::from(inside);
        }
    }
    assert!(loops_ended_inside_an_edge > 0, "there was nothing to test");
}

/// How far the proxy is from the closest point to `goal` of an edge it lies on; of several edges,
/// the least.
fn distance_from_closest_of_its_edge(grid: &Grid, proxy: &GridPoint, goal: &GridPoint) -> f64 {
    let corner = |(column, row): (i64, i64)| {
        let elevation = grid.elevation(column, row)?;
        Some([column as f64, row as f64, elevation])
    };
    let here = [proxy.columns(), proxy.rows(), proxy.elevation];
    let hand = [goal.columns(), goal.rows(), goal.elevation];
    let mut least = f64::INFINITY;
    for column in proxy.column - 1..=proxy.column + 1 {
        for row in proxy.row - 1..=proxy.row + 1 {
            for (east, south) in [(1, 0), (0, 1), (1, 1)] {
                let ends = (corner((column, row)), corner((column + east, row + south)));
                let (Some(from), Some(to)) = ends else { continue };
                if distance(here, closest_on_edge(here, from, to)) < 1e-9 {
                    least = least.min(distance(here, closest_on_edge(hand, from, to)));
                }
            }
        }
    }
    least
}

fn closest_on_edge(point: [f64; 3], from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let edge = [0, 1, 2].map(|axis| to[axis] - from[axis]);
    let way = [0, 1, 2].map(|axis| point[axis] - from[axis]);
    let product = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let share = (product(way, edge) / product(edge, edge)).clamp(0.0, 1.0);
    [0, 1, 2].map(|axis| from[axis] + share * edge[axis])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}
