//! What the paper claims of the proxy graph (section 3.4), held against random terrains: an update
//! terminates, ends at a local minimum of the distance, and never has the proxy under the surface.

mod common;

use common::*;
use contact::{Contact, ContactModel, Feature, ProxyGraph};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const BUDGET: u32 = 4096;

/// A proxy that begins in the air over the middle of the map.
fn proxy_over(grid: &Grid, column: f64, row: f64) -> ProxyGraph {
    let mut model = ProxyGraph::new(BUDGET);
    let top = grid.range().unwrap().maximum;
    model.place(GridPoint::new(column, row, top + 10.0));
    model
}

fn assert_sound(grid: &Grid, contact: &Contact) {
    assert!(contact.proxy.is_finite(), "{contact:?}");
    assert!(contact.distance().is_finite(), "{contact:?}");
    let counters = &contact.counters;
    assert!(counters.vertices + counters.cells <= BUDGET, "{contact:?}");
    assert!(depth_below_surface(grid, contact) < 1e-9, "{contact:?}");
}

/// Shares of updates in contact that do not end as the paper says, over a wandering hand.
struct Shares {
    in_contact: usize,
    not_minimal: usize,
    cycles: u32,
    far_edges: u32,
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
    let mut shares = Shares { in_contact: 0, not_minimal: 0, cycles: 0, far_edges: 0 };
    for _ in 0..updates {
        let goal = hand.next(grid);
        let contact = model.update(grid, &metric, &goal);
        assert_sound(grid, &contact);
        assert_eq!(contact.counters.steps_left, 0, "{contact:?}");
        shares.in_contact += usize::from(contact.feature != Feature::Free);
        shares.not_minimal +=
            usize::from(fault_of_minimum(grid, &metric, &contact, &goal).is_some());
        shares.cycles += contact.counters.cycles_ended;
        shares.far_edges += contact.counters.far_edge_crossings;
    }
    assert!(shares.in_contact > updates / 4, "the hand has to touch to test anything");
    shares
}

#[test]
fn on_gentle_ground_every_update_ends_at_a_local_minimum() {
    for seed in 0..20 {
        for speed in [0.01, 0.3, 3.0, 13.4] {
            let grid = hills(200, 0.1, seed);
            let shares = wander(&grid, SQUARE, 200, speed, 2.0, 1000, seed);
            assert_eq!((shares.not_minimal, shares.cycles), (0, 0), "seed {seed} speed {speed}");
            assert_eq!(shares.far_edges, 0, "paper 4.4: none unscaled");
        }
    }
}

#[test]
fn on_white_noise_every_update_still_terminates_above_ground() {
    let (mut in_contact, mut not_minimal, mut cycles) = (0, 0, 0);
    for seed in 0..10 {
        for (slope, speed) in [(0.3, 1.0), (3.0, 0.1), (10.0, 3.0), (100.0, 0.3), (1e6, 13.4)] {
            let grid = white_noise(64, slope, seed);
            let shares = wander(&grid, SQUARE, 64, speed, slope, 1000, seed);
            in_contact += shares.in_contact;
            not_minimal += shares.not_minimal;
            cycles += shares.cycles;
        }
    }
    // The published graph does not always end at a minimum here: this is a figure, not a demand.
    println!(
        "white noise: {in_contact} updates in contact, {not_minimal} not minimal, {cycles} cycles ended"
    );
}

#[test]
fn the_oracle_sees_what_is_not_minimal() {
    let grid = hills(50, 0.3, 7);
    let goal = GridPoint::new(
        25.3,
        25.4,
        grid.surface_elevation(&GridPoint::new(25.3, 25.4, 0.0)).unwrap() - 1.0,
    );
    let mut model = proxy_over(&grid, 25.0, 25.0);
    let contact = model.update(&grid, &SQUARE, &goal);
    assert_eq!(fault_of_minimum(&grid, &SQUARE, &contact, &goal), None);
    let elsewhere = GridPoint::new(27.6, 25.4, 0.0);
    let proxy = GridPoint { elevation: grid.surface_elevation(&elsewhere).unwrap(), ..elsewhere };
    let moved = Contact { proxy, ..contact };
    assert_eq!(fault_of_minimum(&grid, &SQUARE, &moved, &goal), Some(Fault::CloserOnSurface));
    assert_eq!(contact.feature, Feature::Face, "the goal was chosen under a face");
    let mirrored = GridPoint::new(
        2.0 * contact.proxy.columns() - goal.columns(),
        2.0 * contact.proxy.rows() - goal.rows(),
        2.0 * contact.proxy.elevation - goal.elevation,
    );
    let fault = fault_of_minimum(&grid, &SQUARE, &contact, &mirrored);
    assert_eq!(fault, Some(Fault::WayIsFree));
}

#[test]
fn a_spike_met_from_far_is_released_once_the_hand_lifts() {
    let grid = white_noise(32, 5.0, 3);
    let mut model = proxy_over(&grid, 16.0, 16.0);
    for step in 0..200 {
        let goal = GridPoint::new(16.0, 16.0, 2.0 - 0.02 * f64::from(step));
        assert_sound(&grid, &model.update(&grid, &SQUARE, &goal));
    }
    let lifted = GridPoint::new(16.0, 16.0, 50.0);
    let contact = model.update(&grid, &SQUARE, &lifted);
    assert_eq!((contact.feature, contact.proxy, contact.distance()), (Feature::Free, lifted, 0.0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Distances are measured by the metric, but nothing depends on its unit.
    #[test]
    fn the_proxy_does_not_depend_on_the_unit_of_length(seed in 0u64..1000, power in -6i32..=6, slope in 0.01f64..3.0) {
        let grid = hills(60, slope, seed);
        let unit = 2f64.powi(power * 3);
        let metric = Metric { column: unit, row: unit, up: unit };
        let mut hand = WanderingHand::new(60, 0.7, 1.0, seed);
        let (mut one, mut other) = (proxy_over(&grid, 30.0, 30.0), proxy_over(&grid, 30.0, 30.0));
        for _ in 0..50 {
            let goal = hand.next(&grid);
            let (a, b) = (one.update(&grid, &SQUARE, &goal), other.update(&grid, &metric, &goal));
            prop_assert_eq!((a.proxy, a.feature, a.counters), (b.proxy, b.feature, b.counters));
        }
    }

    /// Scales and exaggerations from 1e-6 to 1e6, cells far from square, goals far and near.
    #[test]
    fn extremes_stay_finite_and_above_ground(
        seed in 0u64..1000,
        scale in -6.0f64..6.0,
        exaggeration in -6.0f64..6.0,
        width in -3.0f64..3.0,
        height in -3.0f64..3.0,
        relief in -6.0f64..6.0,
        wraps: bool,
    ) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..400).map(|_| random.between(-1.0, 1.0) * 10f64.powf(relief)).collect();
        let cells = [10f64.powf(width), 10f64.powf(height)];
        let grid = grid_with_cells(20, 20, cells, wraps, |column, row| heights[row * 20 + column]);
        let scale = 10f64.powf(scale);
        let metric = Metric { column: cells[0] * scale, row: cells[1] * scale, up: scale * 10f64.powf(exaggeration) };
        let mut model = proxy_over(&grid, 10.0, 10.0);
        for _ in 0..100 {
            let far = 10f64.powf(random.between(-3.0, 6.0));
            // Over a map that does not wrap the hand stays: from beyond the border it could come
            // back under ground, where nothing is touched.
            let east = if wraps { far } else { 9.5 };
            let goal = GridPoint::new(
                9.5 + east * random.between(-1.0, 1.0),
                random.between(0.0, 19.0),
                10f64.powf(relief) * random.between(-30.0, 2.0),
            );
            assert_sound(&grid, &model.update(&grid, &metric, &goal));
        }
    }

    /// Samples at both ends of their range side by side.
    #[test]
    fn cliffs_of_the_full_sample_range_are_climbed_and_descended(seed in 0u64..1000, speed in 0.01f64..20.0) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..900).map(|_| if random.unit() < 0.5 { -32768.0 } else { 32767.0 }).collect();
        let grid = grid(30, 30, false, |column, row| heights[row * 30 + column]);
        let mut hand = WanderingHand::new(30, speed, 5.0, seed);
        let mut model = proxy_over(&grid, 15.0, 15.0);
        for _ in 0..100 {
            let goal = hand.next(&grid);
            assert_sound(&grid, &model.update(&grid, &SQUARE, &goal));
        }
    }

    /// Goals exactly on samples, edges, diagonals and at equal distances.
    #[test]
    fn exact_ties_end(seed in 0u64..1000) {
        let mut random = Random::new(seed);
        let heights: Vec<f64> = (0..100).map(|_| (random.unit() * 3.0).floor()).collect();
        let grid = grid(10, 10, false, |column, row| heights[row * 10 + column]);
        let mut model = proxy_over(&grid, 5.0, 5.0);
        for _ in 0..200 {
            let mut half = || (random.unit() * 19.0).floor() / 2.0;
            let goal = GridPoint::new(half(), half(), half() - 6.0);
            let contact = model.update(&grid, &SQUARE, &goal);
            assert_sound(&grid, &contact);
            prop_assert_eq!(contact.counters.steps_left, 0);
        }
    }
}
