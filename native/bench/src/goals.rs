//! The figures that the work is held to, by the names that they have there.

use crate::cell::{Cell, GRAPH_CHAINED, WALK_CHAINED, WALK_FREE, index_of};
use crate::conduct::Conduct;
use crate::contenders::{GRAPH, RELEASE, WALK, WALK_BY_ONE};
use crate::figures::Figures;
use crate::statistics::share;
use crate::tables::SceneCells;

/// The speed of the fastest swipes in the paper, cells per update.
pub const SWIPE: f64 = 13.4;

/// Names and what is to be reached, in the order in which they are shown.
const GOALS: [(&str, &str); 28] = [
    ("walk_over_graph_13", "<= 1.0"),
    ("walk_over_graph_1", "<= 0.5"),
    ("walk_over_release_13", "<= 0.06"),
    ("walk_over_dependent_limit_13_hot", "<= 4.0; stretch 3.0"),
    ("graph_over_dependent_limit_13_hot", "<= 6.5"),
    ("release_over_dependent_limit_13_hot", "<= 75"),
    ("walk_over_independent_limit_13_cold", "<= 2.0; stretch 1.3"),
    ("walk_133M_over_33M", "<= 1.05"),
    ("walk_133M_over_33M_hot", "reported"),
    ("walk_133M_over_33M_cold", "reported"),
    ("walk_10G_over_33M", "<= 1.05"),
    ("walk_10G_over_33M_hot", "reported"),
    ("walk_10G_over_33M_cold", "reported"),
    ("walk_miss_x1", "0"),
    ("walk_miss_x20_swipe", "<= 0.025"),
    ("walk_miss_x20_canyon", "<= 0.05"),
    ("walk_substep_miss_x20_canyon", "<= 0.008"),
    ("walk_substep_cost", "<= 2.0"),
    ("walk_miss_x20_canyon_in_100_steps", "reported: not the step's, but the motion's"),
    ("graph_miss_x20_canyon", "reported"),
    ("walk_passivity_violations", "0"),
    ("walk_updates_checked", ">= 1000000"),
    ("graph_vertices_13", "13 to 15.5; paper 13.4"),
    ("graph_collision_tests_13", "1.00 to 1.15; paper 1.01"),
    ("graph_far_edge_share_x1", "< 0.0001; paper 0"),
    ("graph_far_edge_share_x20_canyon", "0.01 to 0.06; paper 0.035"),
    ("graph_far_loop_share", "reported; paper 0.001"),
    ("under_surface_updates", "0"),
];

/// Works them out of the scenes.
pub fn note(scenes: &[SceneCells], figures: &mut Figures) {
    let scene = |key: &str| scenes.iter().find(|scene| scene.key == key);
    if let Some(plain) = scene("x1") {
        note_costs(plain, figures);
        note_visits(plain, figures);
        let walk = index_of(WALK);
        let missed = plain.cells.iter().map(|cell| cell.errors[walk].missed);
        figures.set("walk_miss_x1", missed.fold(0.0, f64::max));
    }
    if let Some(cell) = scene("x20").and_then(|scene| scene.at(SWIPE)) {
        figures.set("walk_miss_x20_swipe", cell.errors[index_of(WALK)].missed_from_oracle);
    }
    if let Some(canyon) = scene("x20_canyon") {
        note_canyon(canyon, figures);
    }
    note_passivity(scenes, figures);
}

/// Prints those that were measured.
pub fn print(figures: &Figures) {
    println!("\n==== The figures that count");
    println!("{:<40}{:>14}   to reach", "", "found");
    for (name, goal) in GOALS {
        if let Some(found) = figures.get(name) {
            println!("{name:<40}{found:>14}   {goal}");
        }
    }
}

/// Times are hot and unscaled unless named otherwise; all ratios are of medians.
fn note_costs(plain: &SceneCells, figures: &mut Figures) {
    let hot = |cell: &Cell, key: &str| cell.times.hot[index_of(key)].median;
    if let Some(cell) = plain.at(1.0) {
        figures.set("walk_over_graph_1", hot(cell, WALK) / hot(cell, GRAPH));
    }
    let Some(cell) = plain.at(SWIPE) else { return };
    let ratios = [
        ("walk_over_graph_13", WALK, GRAPH),
        ("walk_over_release_13", WALK, RELEASE),
        ("walk_over_dependent_limit_13_hot", WALK, WALK_CHAINED),
        ("graph_over_dependent_limit_13_hot", GRAPH, GRAPH_CHAINED),
        ("release_over_dependent_limit_13_hot", RELEASE, GRAPH_CHAINED),
    ];
    for (name, key, limit) in ratios {
        figures.set(name, hot(cell, key) / hot(cell, limit));
    }
    if !cell.times.cold.is_empty() {
        let cold = |key| cell.times.cold[index_of(key)].median;
        figures.set("walk_over_independent_limit_13_cold", cold(WALK) / cold(WALK_FREE));
    }
}

fn note_visits(plain: &SceneCells, figures: &mut Figures) {
    let graph = index_of(GRAPH);
    if let Some(cell) = plain.at(SWIPE) {
        let conduct = &cell.conducts[graph];
        figures.set("graph_vertices_13", conduct.per_update(conduct.vertices));
        figures.set("graph_collision_tests_13", conduct.per_update(conduct.collision_tests));
    }
    let all = together(plain, graph);
    figures.set("graph_far_edge_share_x1", all.per_update(all.far_edge_updates));
}

fn note_canyon(canyon: &SceneCells, figures: &mut Figures) {
    let (walk, by_one, graph) = (index_of(WALK), index_of(WALK_BY_ONE), index_of(GRAPH));
    if let Some(cell) = canyon.at(SWIPE) {
        let errors = &cell.errors;
        figures.set("walk_miss_x20_canyon", errors[walk].missed_from_oracle);
        figures.set("walk_substep_miss_x20_canyon", errors[by_one].missed_from_oracle);
        figures.set("walk_miss_x20_canyon_in_100_steps", errors[walk].missed_in_steps);
        figures.set("graph_miss_x20_canyon", errors[graph].missed);
        let hot = &cell.times.hot;
        figures.set("walk_substep_cost", hot[by_one].median / hot[walk].median);
    }
    if let Some(cell) = canyon.at(1.0) {
        let conduct = &cell.conducts[graph];
        let far = conduct.per_update(conduct.far_edge_updates);
        figures.set("graph_far_edge_share_x20_canyon", far);
    }
    let all = together(canyon, graph);
    figures.set("graph_far_loop_share", share(all.far_edge_loops, all.far_edges));
}

fn note_passivity(scenes: &[SceneCells], figures: &mut Figures) {
    let walk = index_of(WALK);
    let mut all = Conduct::default();
    scenes.iter().for_each(|scene| all.add(&together(scene, walk)));
    figures.set("walk_passivity_violations", all.grew + all.restless);
    figures.set("walk_updates_checked", all.updates);
    figures.set("walk_held_hands_checked", all.held);
    let conducts = scenes.iter().flat_map(|scene| &scene.cells).flat_map(|cell| &cell.conducts);
    let under: u64 = conducts.map(|conduct| conduct.under_surface).sum();
    figures.set("under_surface_updates", under);
}

/// What a model did in a scene at all speeds.
fn together(scene: &SceneCells, index: usize) -> Conduct {
    let mut all = Conduct::default();
    scene.cells.iter().for_each(|cell| all.add(&cell.conducts[index]));
    all
}
