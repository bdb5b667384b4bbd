//! Every figure of the tables under its name: `<scene>_<speed>_<model>_<measure>` and the like.

use crate::cache::Warmth;
use crate::cell::{LIMITS, index_of};
use crate::conduct::Conduct;
use crate::contenders::{CONTENDERS, WALK};
use crate::decimation::{self, DecimationRow};
use crate::figures::{Figures, spoken};
use crate::goals::SWIPE;
use crate::sizes::SizeRow;
use crate::statistics::share;
use crate::storage::StorageRow;
use crate::tables::SceneCells;
use crate::worst::{WorstRow, worst_p99};

/// Keeps everything that the tables show.
pub fn note_scenes(scenes: &[SceneCells], figures: &mut Figures) {
    for scene in scenes {
        for cell in &scene.cells {
            let prefix = format!("{}_{}", scene.key, spoken(cell.speed));
            let keys = CONTENDERS.iter().map(|contender| contender.key).chain(LIMITS);
            for (index, key) in keys.enumerate() {
                for (state, times) in [("hot", &cell.times.hot), ("cold", &cell.times.cold)] {
                    if let Some(spread) = times.get(index) {
                        figures.set_times(&format!("{prefix}_{key}_{state}"), spread);
                    }
                }
            }
            let [walk, graph] = cell.times.loads;
            figures.set(format!("{prefix}_limit_walk_samples"), walk);
            figures.set(format!("{prefix}_limit_graph_vertices"), graph);
            figures.set(format!("{prefix}_lines"), cell.times.lines);
            figures.set(format!("{prefix}_oracle_not_minimal"), cell.oracle_not_minimal);
            for (index, contender) in CONTENDERS.iter().enumerate() {
                let name = format!("{prefix}_{}", contender.key);
                note_conduct(&name, &cell.conducts[index], figures);
                let errors = &cell.errors[index];
                figures.set(format!("{name}_miss"), errors.missed);
                figures.set(format!("{name}_miss_from_oracle"), errors.missed_from_oracle);
                figures.set(format!("{name}_miss_in_100_steps"), errors.missed_in_steps);
                figures.set(format!("{name}_excess_mean"), errors.excess.mean);
                figures.set(format!("{name}_excess_p99"), errors.excess.p99);
                figures.set(format!("{name}_excess_most"), errors.excess.worst);
                figures.set(format!("{name}_direction_median"), errors.direction.median);
                figures.set(format!("{name}_direction_p99"), errors.direction.p99);
                if let Some(not_minimal) = errors.not_minimal {
                    figures.set(format!("{name}_not_minimal"), not_minimal);
                }
            }
        }
    }
}

fn note_conduct(name: &str, conduct: &Conduct, figures: &mut Figures) {
    let moving = conduct.updates - conduct.held;
    let per_update = [
        ("vertices", conduct.vertices),
        ("faces", conduct.faces),
        ("collision_tests", conduct.collision_tests),
        ("far_edge_share", conduct.far_edge_updates),
        ("cycles", conduct.cycles),
    ];
    for (count, number) in per_update {
        figures.set(format!("{name}_{count}"), conduct.per_update(number));
    }
    figures.set(format!("{name}_far_loop_share"), share(conduct.far_edge_loops, conduct.far_edges));
    figures.set(format!("{name}_in_contact"), share(conduct.in_contact, moving));
    figures.set(format!("{name}_unfinished"), conduct.unfinished);
    figures.set(format!("{name}_grew"), share(conduct.grew, conduct.updates));
    figures.set(format!("{name}_restless"), share(conduct.restless, conduct.held));
    figures.set(format!("{name}_under_surface"), conduct.under_surface);
    figures.set(format!("{name}_jump_median"), conduct.jump.median);
    figures.set(format!("{name}_jump_p99"), conduct.jump.p99);
    figures.set(format!("{name}_jump_most"), conduct.jump.worst);
}

/// Keeps what larger planets cost.
pub fn note_sizes(rows: &[SizeRow], names: &[&str], figures: &mut Figures) {
    for row in rows {
        for (times, name) in row.times.iter().zip(names) {
            let state = row.warmth.name();
            let prefix = format!("size_{name}_{}_{}_{state}", spoken(row.speed), row.key);
            figures.set_times(&prefix, times);
            let ratio = times.median / row.times[0].median;
            figures.set(format!("{prefix}_ratio"), ratio);
            if row.speed == SWIPE && row.key == WALK && *name != names[0] {
                let ending = if row.warmth == Warmth::Untouched { "" } else { state };
                let goal = format!("walk_{name}_over_{} {ending}", names[0]);
                figures.set(goal.trim_end().replace(' ', "_"), ratio);
            }
        }
    }
}

/// Keeps what storage costs.
pub fn note_storage(rows: &[StorageRow], figures: &mut Figures) {
    for row in rows {
        let prefix = format!("storage_{}", row.key);
        figures.set(format!("{prefix}_bytes"), row.bytes);
        figures.set(format!("{prefix}_error_rms_m"), row.error[0]);
        figures.set(format!("{prefix}_error_most_m"), row.error[1]);
        for time in &row.times {
            let (speed, state) = (spoken(time.speed), time.warmth.name());
            figures.set_times(&format!("{prefix}_{speed}_{}_{state}", time.model), &time.spread);
        }
    }
}

/// Keeps what decimation saves and loses.
pub fn note_decimation(rows: &[DecimationRow], figures: &mut Figures) {
    for row in rows {
        let prefix = format!("decimated_{}", row.factor);
        figures.set(format!("{prefix}_bytes"), row.bytes);
        figures.set(format!("{prefix}_error_rms_m"), row.error[0]);
        figures.set(format!("{prefix}_error_most_m"), row.error[1]);
        for (speed, spread) in decimation::SPEEDS.iter().zip(&row.times) {
            figures.set_times(&format!("{prefix}_{}_hot", spoken(*speed)), spread);
        }
        for (exaggeration, texture) in decimation::EXAGGERATIONS.iter().zip(&row.texture) {
            figures.set(format!("{prefix}_texture_kept_x{exaggeration}"), texture.kept);
            figures.set(format!("{prefix}_texture_wrong_x{exaggeration}"), texture.wrong);
        }
    }
}

/// Keeps the worst updates.
pub fn note_worst(rows: &[WorstRow], scenes: &[SceneCells], figures: &mut Figures) {
    for row in rows {
        figures.set(format!("worst_update_us_{}", row.key), row.microseconds);
        let [median, p90] = row.first_try;
        figures.set(format!("worst_update_first_try_us_{}", row.key), median);
        figures.set(format!("worst_update_first_try_p90_us_{}", row.key), p90);
        figures.set(format!("worst_update_crease_us_{}", row.key), row.crease);
        let [hot, cold] = worst_p99(scenes, index_of(row.key));
        figures.set(format!("worst_p99_hot_us_{}", row.key), hot);
        figures.set(format!("worst_p99_cold_us_{}", row.key), cold);
        figures.set(format!("worst_update_steps_{}", row.key), row.steps);
        figures.set(format!("worst_update_left_over_{}", row.key), row.left_over);
        figures.set(format!("worst_update_updates_{}", row.key), row.updates);
        figures.set(format!("worst_update_never_done_{}", row.key), row.unfinished);
    }
}
