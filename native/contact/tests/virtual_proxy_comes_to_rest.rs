//! The sphere comes to rest: around edges and corners that the goal is close to, on ground far higher
//! than its cells are wide, within small budgets, and at the rims of holes.

mod common;

use common::random_hand::{Ground, RandomHand};
use common::trial::Trial;
use common::*;
use contact::{Contact, ContactModel, Model, VirtualProxy};
use surface::{Grid, GridPoint, Metric};

/// Cell widths; it fits the smallest budget.
const RADIUS: f64 = 0.05;

/// The smallest budget, one near it, and the default.
const BUDGETS: [u32; 3] = [100, 200, 1024];

/// Updates until nothing is left to walk, and the last contact.
fn updates_until_rest(model: &mut VirtualProxy, grid: &Grid, goal: &GridPoint) -> (u32, Contact) {
    for updates in 1..1000 {
        let contact = model.update(grid, &SQUARE, goal);
        if contact.counters.steps_left == 0 {
            return (updates, contact);
        }
    }
    panic!("it never comes to rest at {goal:?}");
}

/// Begins over `from`, and then has a goal so far from the `sharp` place in the plane of columns and
/// heights, `angle` radians from straight up. Where it rests, and after how many updates.
fn turned_around(
    grid: &Grid,
    sharp: &GridPoint,
    nearness: f64,
    angle: f64,
    budget: u32,
) -> (u32, [f64; 2]) {
    let mut model = VirtualProxy::new(RADIUS, budget);
    let at = |distance: f64, angle: f64| {
        let u = sharp.u + distance * angle.sin();
        let elevation = sharp.elevation + distance * angle.cos();
        GridPoint::from_sample(sharp.column, sharp.row, u, sharp.v, elevation)
    };
    // In touch on the other side.
    model.place(at(2.0 * RADIUS, -0.9));
    updates_until_rest(&mut model, grid, &at(0.9 * RADIUS, -0.9));
    let (updates, contact) = updates_until_rest(&mut model, grid, &at(nearness * RADIUS, angle));
    let [columns, _, up] = contact.proxy.relative_to(sharp.column, sharp.row, sharp.elevation);
    // As an angle and a distance: of this the goal's are the minimum.
    let aside = columns - sharp.u;
    (updates, [aside.atan2(up), aside.hypot(up)])
}

/// A goal close to what the sphere turns around leaves it a long way by small steps.
#[test]
fn around_an_edge_or_a_corner_beside_the_goal_it_turns_in_a_few_updates() {
    let ridge = grid(11, 11, false, |column, _| -3.0 * (column as f64 - 5.0).abs());
    let spike = grid(11, 11, false, |column, row| if (column, row) == (5, 5) { 9.0 } else { 0.0 });
    let (on_ridge, on_spike) = (GridPoint::new(5.0, 5.3, 0.0), GridPoint::new(5.0, 5.0, 9.0));
    for (ground, sharp) in [(&ridge, &on_ridge), (&spike, &on_spike)] {
        for power in 1..=5 {
            let nearness = 10f64.powi(-power);
            for angle in [-0.5, 0.0, 0.3, 0.8] {
                for budget in BUDGETS {
                    let (updates, [found, distance]) =
                        turned_around(ground, sharp, nearness, angle, budget);
                    let told =
                        format!("{nearness} {angle} {budget}: {updates}, {found} {distance}");
                    assert!(
                        updates <= [40, 20, 3][BUDGETS.iter().position(|b| *b == budget).unwrap()],
                        "{told}"
                    );
                    assert!((distance - RADIUS).abs() < 1e-4 * RADIUS, "{told}");
                    // The squared distance to the goal is 1e-12 of the squared radius from its least.
                    assert!((found - angle).abs() < 1e-2 + 4e-6 / nearness, "{told}");
                }
            }
        }
    }
}

#[test]
fn on_ground_many_times_as_high_as_its_cells_are_wide_it_comes_to_rest() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let levels = [0, 2, 3][random.below(3)];
        let ground = Ground { levels, ..Ground::noise(9, 9, 1.0) }.grid(&mut random);
        let metric = Metric { up: 10f64.powf(random.between(1.0, 6.0)), ..SQUARE };
        let model = Model::VirtualProxy { radius: [0.02, 0.25, 1.2][seed as usize % 3] };
        let mut hand = RandomHand::new(&ground, 0.5, 1.0, seed);
        let mut trial = Trial::over_the_middle(&ground, metric, &model, 1024);
        for _ in 0..40 {
            let goal = hand.next(&ground, &metric);
            let mut updates = 0;
            while trial.update(&goal).unwrap().counters.steps_left > 0 {
                updates += 1;
                assert!(updates < 30, "seed {seed} at {goal:?}");
            }
        }
    }
}

/// A centre exactly over the rim of a hole is over ground: under it, it is not in contact with what
/// lies deeper in the hole.
#[test]
fn under_the_rim_of_a_hole_it_is_inside_the_ground() {
    let height = 2.837072477651122;
    let heights = [[f64::NAN, height, 0.0], [height, 0.0, 0.0], [height / 2.0, height, f64::NAN]];
    let ground = grid(3, 3, false, |column, row| heights[row][column]);
    let cell = 262986.07897794334;
    let metric = Metric { column: cell, row: cell, up: 3073997699.851901 };
    let model = Model::VirtualProxy { radius: 0.25 * cell };
    let mut trial = Trial::over_the_middle(&ground, metric, &model, 4096);
    for (x, y, elevation) in [
        (0.19573507781035793, 0.17529804556143413, -0.6195155158536823),
        (0.19244257341145574, 0.17261144763103262, -0.40321182358835383),
        (1.0323062652325003, 1.4883002236905993, -1.2454922650113308e-9),
        (1.0, 1.0, 6.729234685453898e-10),
    ] {
        trial.update(&GridPoint::new(x, y, elevation)).unwrap();
    }
}

/// From the side of the map it may touch the rim and come in under it; from above it may not.
#[test]
fn coming_in_over_a_border_from_above_it_stays_above() {
    for seed in 0..60 {
        let relief = 10f64.powi(seed as i32 % 4);
        let ground = white_noise(8, relief, seed);
        let top = ground.range().unwrap().maximum;
        let mut random = Random::new(seed);
        let model = Model::VirtualProxy { radius: 0.25 };
        for (x, y) in [(-3.0, 3.3), (10.0, 3.7), (3.5, -3.0), (2.1, 10.0)] {
            let outside = GridPoint::new(x, y, top + 1.0);
            let mut trial = Trial::new(&ground, SQUARE, &model, 1024, outside);
            trial.settle(&outside).unwrap();
            let mut inside = || random.between(0.5, 6.5);
            let (x, y) = (inside(), inside());
            trial.settle(&GridPoint::new(x, y, top + 1.0)).unwrap();
            for depth in [0.0, 1.0, 10.0] {
                let under = GridPoint::new(x, y, -depth * relief);
                let contact = trial.rest(&under).unwrap();
                assert_ne!(contact.feature, contact::Feature::Free, "seed {seed} at {under:?}");
            }
        }
    }
}

/// Where it came out of the ground is seen, if not in the same update then in the next: from there it
/// touches.
#[test]
fn having_come_out_of_the_ground_at_the_end_of_its_budget_it_touches() {
    let ground = white_noise(12, 1.0, 5);
    let top = ground.range().unwrap().maximum;
    for start in 0..1000 {
        let mut model = VirtualProxy::new(RADIUS, 200);
        // In from the side, under the ground: the budget ends anywhere along the way.
        model.place(GridPoint::new(-2.2 - 0.05 * f64::from(start), 5.3, -9.0));
        let over = GridPoint::new(4.7, 5.6, top + 0.1);
        while model.update(&ground, &SQUARE, &over).proxy != over {}
        let under = GridPoint { elevation: -2.0, ..over };
        let (_, contact) = updates_until_rest(&mut model, &ground, &under);
        assert_ne!(contact.feature, contact::Feature::Free, "{start}: {contact:?}");
    }
}

/// Beside the map nothing is around, and no height too far to be flown to in so many cells.
#[test]
fn beside_the_map_it_flies_as_far_as_its_budget_reaches_whatever_the_height() {
    let ground = white_noise(4, 1.0, 7);
    for power in [0, 6, 9, 12, 15] {
        let mut model = VirtualProxy::new(RADIUS, 1024);
        model.place(GridPoint::new(-500.5, 1.2, 10f64.powi(power)));
        let goal = GridPoint::new(-100.5, 1.2, -10f64.powi(power));
        let (updates, contact) = updates_until_rest(&mut model, &ground, &goal);
        assert!(contact.proxy == goal && updates < 12, "{power}: {updates} {contact:?}");
    }
}
