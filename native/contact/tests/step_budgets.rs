//! Step budgets: the floor that every model has, what a step stands for, and what is told of the rest.

mod common;

use common::models::{all_models, fewest_steps};
use common::random_hand::{Ground, RandomHand};
use common::trial::Trial;
use common::*;
use contact::{ContactModel, Feature, MIN_STEP_BUDGET, MIN_SUB_STEP, Model, SurfaceWalk};
use proptest::prelude::*;
use surface::{Grid, GridPoint, Metric};

const COLUMNS: usize = 6000;

fn at(model: &mut dyn ContactModel, column: f64, elevation: f64) {
    model.place(GridPoint::new(column, 50.0, elevation));
}

/// A long way from west to east, 101 rows wide.
fn road(elevation: impl Fn(usize, usize) -> f64) -> Grid {
    grid_with_cells(101, COLUMNS, [1.0, 1.0], false, elevation)
}

fn off_the_middle(row: usize) -> f64 {
    (row as f64 - 50.0).abs()
}

#[test]
fn a_budget_below_the_floor_is_raised_to_it() {
    let grid = white_noise(40, 3.0, 1);
    for model in all_models(&SQUARE) {
        let floor = model.min_step_budget();
        assert!(floor >= MIN_STEP_BUDGET && floor == fewest_steps(&*model.build(1)));
        let mut hand = WanderingHand::new(40, 20.0, 3.0, 2);
        let (mut one, mut other) = (model.build(1), model.build(floor));
        for _ in 0..200 {
            let goal = hand.next(&grid);
            let contact = one.update(&grid, &SQUARE, &goal);
            assert_eq!(contact, other.update(&grid, &SQUARE, &goal), "{model:?}");
        }
    }
}

#[test]
fn at_any_budget_a_hand_that_rises_is_let_go() {
    let grid = grid(20, 20, false, |_, _| 0.0);
    for model in all_models(&SQUARE) {
        for budget in (1..10).chain(60..70) {
            let mut trial = Trial::over_the_middle(&grid, SQUARE, &model, budget);
            for goal in [(9.5, 9.5), (9.0, 9.0), (9.0, 9.25)] {
                let pressed = trial.settle(&GridPoint::new(goal.0, goal.1, -1.0)).unwrap();
                assert_ne!(pressed.feature, Feature::Free, "{model:?} {budget}");
                let risen = trial.settle(&GridPoint::new(goal.0, goal.1, 3.0)).unwrap();
                assert_eq!(risen.feature, Feature::Free, "{model:?} {budget}");
            }
        }
    }
}

#[test]
fn what_is_left_is_told_of_the_goals_way_also_in_sub_steps() {
    let grid = road(|_, _| 0.0);
    for longest in [0.25, 1.0] {
        let mut walk = SurfaceWalk::new(1000, Some(longest));
        at(&mut walk, 10.0, 1.0);
        walk.update(&grid, &SQUARE, &GridPoint::new(10.0, 50.0, -1.0));
        let goal = GridPoint::new(5900.0, 50.0, -1.0);
        loop {
            let contact = walk.update(&grid, &SQUARE, &goal);
            let left = 5900.0 - contact.proxy.columns();
            let told = f64::from(contact.counters.steps_left);
            assert!(told >= left.round() && told <= left + 1.0, "{told} for {left}");
            if told == 0.0 {
                break;
            }
        }
    }
}

/// More flights than the graph's lists have room for, and not one circle.
#[test]
fn a_long_way_of_the_graph_is_no_circle() {
    let grid = road(|column, row| 10.0 * off_the_middle(row) + ((column + 1) % 2) as f64);
    let mut graph = Model::ProxyGraph.build(Model::ProxyGraph.default_step_budget());
    at(&mut *graph, 10.0, 2.0);
    let mut goal = GridPoint::new(10.0, 50.0, 0.0);
    graph.update(&grid, &SQUARE, &goal);
    goal = GridPoint::new(5990.0, 50.0, 0.0);
    for _ in 0..1000 {
        let contact = graph.update(&grid, &SQUARE, &goal);
        assert_eq!(contact.counters.cycles_ended, 0);
        let left = distance(&contact.proxy, &goal);
        if contact.counters.steps_left == 0 {
            assert!(left < 2.0, "ended {left} cells away");
            return;
        }
    }
    panic!("never came to an end");
}

/// A vertex shows six faces, an edge two: the budget counts them, for they take the time.
#[test]
fn a_look_around_a_vertex_counts_as_the_faces_that_it_shows() {
    let crease = |column: usize, row: usize| off_the_middle(row) - 0.3 * column as f64;
    let grid = road(crease);
    for model in [Model::SurfaceWalk { sub_step: None }, Model::GodObjectRelease] {
        let mut model = model.build(600);
        at(&mut *model, 10.0, 10.0);
        model.update(&grid, &SQUARE, &GridPoint::new(10.0, 50.0, -4.0));
        let before = model.proxy().position;
        let goal = GridPoint::new(5990.0, 50.0, -0.3 * 5990.0 - 1.0);
        let contact = model.update(&grid, &SQUARE, &goal);
        // From vertex to vertex.
        let vertices = contact.proxy.columns() - before.columns();
        assert!(contact.counters.steps_left > 0 && vertices > 10.0, "{contact:?}");
        assert!(vertices <= 101.0, "{}: {vertices} vertices in 600 steps", model.name());
    }
}

#[test]
fn sub_steps_too_short_to_lead_anywhere_are_refused() {
    for longest in [MIN_SUB_STEP * 0.999, 1e-9, 1e-300, 0.0, -1.0, f64::NAN, f64::INFINITY] {
        let built = std::panic::catch_unwind(|| SurfaceWalk::new(4096, Some(longest)));
        assert!(built.is_err(), "{longest}");
    }
    let grid = grid(20, 20, false, |_, _| 0.0);
    let mut walk = SurfaceWalk::new(MIN_STEP_BUDGET, Some(MIN_SUB_STEP));
    walk.place(GridPoint::new(3.0, 3.5, 1.0));
    let ends = |walk: &mut SurfaceWalk, column| {
        let goal = GridPoint::new(column, 3.5, -1.0);
        let mut updates = 1..;
        let mut next = || (updates.next(), walk.update(&grid, &SQUARE, &goal).counters.steps_left);
        std::iter::from_fn(|| Some(next())).find(|(_, left)| *left == 0).unwrap().0.unwrap()
    };
    ends(&mut walk, 3.0);
    assert!(ends(&mut walk, 13.0) < 100, "a tenth of a cell in an update at least");
}

/// On steep ground the point of an edge that is nearest to a far goal may be a few last places beside a
/// vertex: only there have the other faces a say.
#[test]
fn on_the_steepest_ground_no_edge_holds_a_proxy_beside_its_vertex() {
    let mut tally = common::trial::Tally::default();
    for seed in 0..2000 {
        let mut random = Random::new(seed);
        let grid = Ground { levels: 3, ..Ground::noise(12, 12, 1.0) }.grid(&mut random);
        let aspect = 10f64.powf(random.between(-2.0, 2.0));
        let up = 10f64.powf(random.between(6.0, 9.0)) * aspect.min(1.0);
        let metric = Metric { column: 1.0, row: aspect, up };
        let model = Model::SurfaceWalk { sub_step: [None, Some(1.0)][random.below(2)] };
        let mut hand = RandomHand::new(&grid, 5.0, 10.0, seed);
        let mut trial = Trial::over_the_middle(&grid, metric, &model, 4096);
        for _ in 0..60 {
            trial.update(&hand.next(&grid, &metric)).unwrap();
        }
        tally += trial.tally;
    }
    assert!(tally.in_contact > 10_000 && tally.not_minimal == 0, "{tally}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    /// Where the goal is over a sample, on its very height or a last place beside it, rounding leads around
    /// the sample: what is begun there has to end.
    #[test]
    fn at_the_floor_goals_beside_a_sample_are_come_to(
        seed in 0u64..1_000_000,
        relief in -4.0f64..9.0,
        aspect in -2.0f64..2.0,
        levels in prop_oneof![2 => Just(0usize), 1 => Just(2)],
    ) {
        let ground = Ground { levels, ..Ground::noise(20, 20, 10f64.powf(relief)) };
        let grid = ground.grid(&mut Random::new(seed));
        let metric = Metric { column: 1.0, row: 10f64.powf(aspect), up: 1.0 };
        for model in all_models(&metric) {
            let mut random = Random::new(seed + 1);
            let mut trial = Trial::over_the_middle(&grid, metric, &model, MIN_STEP_BUDGET);
            for _ in 0..20 {
                let (column, row) = (random.below(20) as i64, random.below(20) as i64);
                let height = grid.elevation(column, row).unwrap();
                let elevation = [height.next_down(), height, height.next_up()][random.below(3)];
                trial.rest(&GridPoint { column, row, u: 0.0, v: 0.0, elevation }).unwrap();
            }
        }
    }
}
