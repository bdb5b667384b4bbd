//! What the paper claims of the proxy graph in sections 3.3 and 3.4, tried on rough ground: an update
//! ends, it ends at a local minimum, and the distance grows no faster than the goal moves. The first
//! needs a rule that the paper does not have; the others do not hold for the graph, and do for the walk.

mod common;

use common::*;
use contact::Model;
use surface::GridPoint;

const BUDGET: u32 = 4096;
const SIZE: usize = 48;

/// Updates of one model over the same slow hands on white noise.
#[derive(Debug, Default)]
struct Tally {
    updates: u32,
    not_minimal: u32,
    grew: u32,
    circles_ended: u32,
    unfinished: u32,
}

fn tally(model: Model, slope: f64, speed: f64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..12 {
        let grid = white_noise(SIZE, slope, seed);
        let mut hand = WanderingHand::new(SIZE, speed, 0.3 * slope, seed);
        let mut model = model.build(BUDGET);
        let first = hand.next(&grid);
        model.place(GridPoint { elevation: slope + 1.0, ..first });
        let mut before = (first, model.update(&grid, &SQUARE, &first).distance());
        for _ in 0..2500 {
            let goal = hand.next(&grid);
            let contact = model.update(&grid, &SQUARE, &goal);
            let moved = distance(&before.0, &goal);
            let most = before.1 + moved;
            tally.updates += 1;
            tally.grew += u32::from(contact.distance() > most + 1e-9 * (1.0 + most));
            tally.circles_ended += contact.counters.cycles_ended;
            tally.unfinished += u32::from(contact.counters.steps_left > 0);
            let fault = fault_of_minimum(&grid, &SQUARE, &contact, &goal);
            tally.not_minimal += u32::from(fault.is_some());
            before = (goal, contact.distance());
        }
    }
    println!("{} at {speed} cells, slope {slope}: {tally:?}", model.name());
    tally
}

#[test]
fn the_published_graph_can_let_the_distance_grow_and_miss_the_minimum() {
    let tally = tally(Model::ProxyGraph, 20.0, 0.01);
    assert_eq!(tally.unfinished, 0, "with circles ended, every update ends");
    assert!(tally.grew > 0, "paper 3.4: the distance grows no faster than the goal moves");
    assert!(tally.not_minimal > 0, "paper 3.4: an update ends at a local minimum");
}

#[test]
fn the_published_graph_runs_in_circles_that_have_to_be_ended() {
    let tally = tally(Model::ProxyGraph, 10.0, 1.0);
    assert!(tally.circles_ended > 0);
}

#[test]
fn the_walk_keeps_what_the_paper_claims() {
    for (slope, speed) in [(20.0, 0.01), (10.0, 1.0)] {
        let tally = tally(Model::default(), slope, speed);
        assert_eq!((tally.unfinished, tally.grew, tally.not_minimal), (0, 0, 0));
    }
}
