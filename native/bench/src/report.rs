//! The tables of the bench, each with what it does not show.

use crate::cell::index_of;
use crate::conduct::{Conduct, ROUNDING};
use crate::contenders::{GRAPH, RADIUS};
use crate::decimation::{self, DecimationRow};
use crate::sizes::SizeRow;
use crate::statistics::share;
use crate::storage::{StorageRow, Timed};
use crate::tables::{SceneCells, nanoseconds, percent, short};
use crate::worst::{WorstRow, worst_p99};

/// What an update costs.
pub fn print_times(scenes: &[SceneCells]) {
    println!("\n==== What an update costs");
    for scene in scenes {
        scene.print_times("ns, caches hot: median/p99/p99.9", |cell| &cell.times.hot);
        scene.print_times("ns, caches cold: median/p99/p99.9", |cell| &cell.times.cold);
    }
    println!(
        "\
Each update is timed on its own through the trait that the servo calls, less what the clock takes. limit_walk
loads one sample for each triangle under the straight line from proxy to proxy, limit_graph three for each vertex
that the graph visits; chained: every address waits for the value before, free: none does. Hot: the lines of
16 updates were read twice before; cold: they were flushed and the translation cache swept, so that where a
hand crosses less than a cell in an update only the first of the 16 is cold. surface_walk_sub_1 and _sub_0_25 move
the goal by at most one and a quarter cell at a time; the sphere of virtual_proxy has a radius of {RADIUS} cell.
Not shown: a page's first touch, a live thread's wake-up, other programs. Tails (p99.9) of a few thousand
updates belong to the system and to its other guests as much as to the models. Unscaled and on canyon walls, at
1 and 13.4 cells, the quietest of three races counts. Where other programs run, models slow down more than chains
of loads do. Absolute numbers are this machine's; ratios within a table travel better."
    );
}

/// What models visit.
pub fn print_visits(scenes: &[SceneCells]) {
    println!("\n==== What an update visits (updates in contact)");
    for scene in scenes {
        let count = |conduct: &Conduct, count: u64| short(conduct.per_update(count));
        scene.print_models("triangles or vertices looked at; collision tests", |cell, index| {
            let conduct = &cell.conducts[index];
            let visited = conduct.vertices + conduct.faces;
            format!("{}; {}", count(conduct, visited), count(conduct, conduct.collision_tests))
        });
        let graph = index_of(GRAPH);
        scene.print_line("graph: far edges, %", |cell| {
            percent(cell.conducts[graph].per_update(cell.conducts[graph].far_edge_updates))
        });
        scene.print_line("graph: loops, % of them", |cell| {
            let conduct = &cell.conducts[graph];
            percent(share(conduct.far_edge_loops, conduct.far_edges))
        });
        scene.print_line("graph: cycles ended, %", |cell| {
            percent(cell.conducts[graph].per_update(cell.conducts[graph].cycles))
        });
        scene.print_line("updates in contact, %", |cell| {
            let conduct = &cell.conducts[graph];
            percent(share(conduct.in_contact, conduct.updates - conduct.held))
        });
    }
    println!(
        "\
The paper (section 4.4, MOLA at 16 samples per degree, a person's hand): 13.4 vertices an update on the
fastest swipe, 1.01 collision tests an update over a session, no far edge unscaled; heights x20 on the walls
of Valles Marineris: far edges in 3.5% of updates, and 0.1% of them in loops. Our hand is a script, 0.3 to 2
cells deep: how deep it presses moves collision tests and far edges more than the model does, so these are for
comparison, not for equality."
    );
}

/// Where proxies end.
pub fn print_errors(scenes: &[SceneCells]) {
    println!("\n==== Where the proxy ends, against the oracle");
    for scene in scenes {
        scene.print_models(
            "% of updates over half a cell away: freely; from the oracle's state; so in 100 steps",
            |cell, index| {
                let errors = &cell.errors[index];
                let shares = [errors.missed, errors.missed_from_oracle, errors.missed_in_steps];
                shares.map(percent).join("; ")
            },
        );
        scene.print_models(
            "farther from the goal than the oracle, cells: mean/p99/most",
            |cell, index| {
                let excess = &cell.errors[index].excess;
                [excess.mean, excess.p99, excess.worst].map(short).join("/")
            },
        );
        scene.print_models(
            "angle between its force and the oracle's, degrees: median/p99",
            |cell, index| {
                let direction = &cell.errors[index].direction;
                [direction.median, direction.p99].map(short).join("/")
            },
        );
        scene.print_models("% not at a local minimum", |cell, index| {
            cell.errors[index].not_minimal.map_or("-".to_owned(), percent)
        });
        scene.print_line("oracle", |cell| percent(cell.oracle_not_minimal));
    }
    println!(
        "\
The oracle follows the goal in 100 steps an update, by brute force. Over rough ground a goal that moves many
cells in one step has more than one nearest point within reach: going on freely, a model that once fell to the
other side of a ridge is elsewhere for a while; from the oracle's state, only what one update does is counted;
and where the goal too moves in the oracle's steps, only that the model's motion is another one.
Of the sphere the point nearest to the goal is compared, and a local minimum of a point means nothing to it.
Not shown: what a person would notice."
    );
}

/// Whether energy can come out of a model.
pub fn print_passivity(scenes: &[SceneCells]) {
    println!("\n==== Whether the hand could gain energy (all updates)");
    for scene in scenes {
        scene.print_models(
            "% whose distance grew faster than the goal moved; % of held hands that felt a change",
            |cell, index| {
                let conduct = &cell.conducts[index];
                let grew = percent(share(conduct.grew, conduct.updates));
                format!("{grew}; {}", percent(share(conduct.restless, conduct.held)))
            },
        );
        scene.print_models("force jump per motion of the goal: median/p99/most", |cell, index| {
            let jump = &cell.conducts[index].jump;
            [jump.median, jump.p99, jump.worst].map(short).join("/")
        });
    }
    println!(
        "\
Grown: by more than {ROUNDING:e} of distance, goal's motion and a cell's width together. A hand is held still
after every eighth update, until no steps are left; then not one bit of proxy and force may change.
A jump of 1 is what an exact proxy gives on flat ground; more is felt as a kick. Section 3.4 of the paper
claims that the distance never grows faster than the goal moves."
    );
}

/// Whether size matters.
pub fn print_sizes(rows: &[SizeRow], names: &[&str]) {
    println!(
        "\n==== What a larger planet costs: ns, median/p99/p99.9, and the ratio of medians to the first"
    );
    print!("{:<44}", "");
    println!("{}", names.iter().map(|name| format!("{name:>26}")).collect::<String>());
    for row in rows {
        let state = row.warmth.name();
        print!("{:<14}{:>6} cells, {state:<15}", row.key, row.speed);
        for times in &row.times {
            let ratio = times.median / row.times[0].median;
            print!("{:>26}", format!("{} ({ratio:.2})", nanoseconds(times)));
        }
        println!();
    }
    println!(
        "\
The same local terrain at random places; blocks of all planets shuffled. Untouched: only one line in each page
was read before; hot and cold as above. Hot shows the model; cold adds page tables that take more lines where
rows are longer (in a virtual machine twice over); untouched adds that a small grid lies in the last-level cache
from before and a large one does not. Not shown: the first touch of a page (a fault of about a microsecond
where the file is in the page cache, much more where a virtual machine's host has taken the page away, a wait
for the disk where it is not there at all)."
    );
}

/// Which samples to store.
pub fn print_storage(rows: &[StorageRow]) {
    println!("\n==== How samples are stored (unscaled)");
    let line = |name: String, show: &dyn Fn(&StorageRow) -> String| {
        let columns = rows.iter().map(|row| format!("{:>22}", show(row)));
        println!("{name:<40}{}", columns.collect::<String>());
    };
    line(String::new(), &|row| row.title.to_owned());
    line("MB".to_owned(), &|row| format!("{:.0}", row.bytes as f64 / 1e6));
    line("heights off, m: rms; most".to_owned(), &|row| row.error.map(short).join("; "));
    for (index, Timed { model, speed, warmth, .. }) in rows[0].times.iter().enumerate() {
        let name = format!("{model}, {speed} cells, {}, ns", warmth.name());
        line(name, &|row| nanoseconds(&row.times[index].spread));
    }
    println!(
        "\
Times are median/p99/p99.9; all samples are big-endian, as in files. Not shown: grids that a type of two bytes
lets fit the page cache and one of eight does not."
    );
}

/// What decimation saves and loses.
pub fn print_decimation(rows: &[DecimationRow]) {
    println!("\n==== Touch of every n-th sample");
    print!("{:<6}{:>8}{:>22}", "n", "MB", "off, m: rms; most");
    for speed in decimation::SPEEDS {
        print!("{:>22}", format!("ns at {speed} cells"));
    }
    for exaggeration in decimation::EXAGGERATIONS {
        print!("{:>32}", format!("texture x{exaggeration}: kept; wrong"));
    }
    println!();
    for row in rows {
        let [rms, most] = row.error.map(short);
        let megabytes = row.bytes as f64 / 1e6;
        print!("{:<6}{megabytes:>8.1}{:>22}", row.factor, format!("{rms}; {most}"));
        for spread in &row.times {
            print!("{:>22}", nanoseconds(spread));
        }
        for texture in &row.texture {
            let (kept, wrong) = (percent(texture.kept), percent(texture.wrong));
            print!("{:>32}", format!("{kept}%; {wrong}%"));
        }
        println!();
    }
    println!(
        "\
The surface walk, caches hot, the same path in metres; speeds in cells of the full grid. Texture: the force on a
slow hand less its mean over {} cells around; kept is its strength (rms), wrong is the strength of its difference
from full detail, both as shares of full detail. Not shown: what a person would notice; averaging, which would
keep less of it than leaving out samples does.",
        decimation::TEXTURE_CELLS
    );
}

/// The worst updates.
pub fn print_worst(rows: &[WorstRow], scenes: &[SceneCells]) {
    println!("\n==== The goal jumps across the planet (x20, default step budgets)");
    println!(
        "{:<24}{:>12}{:>22}{:>12}{:>22}{:>10}{:>16}{:>14}{:>12}",
        "us:",
        "warm, worst",
        "first try: median/p90",
        "crease",
        "worst p99: hot/cold",
        "steps",
        "left over, %",
        "most updates",
        "never done"
    );
    for row in rows {
        let pair = |[one, other]: [f64; 2]| format!("{one:.1}/{other:.1}");
        println!(
            "{:<24}{:>12.1}{:>22}{:>12.1}{:>22}{:>10}{:>16}{:>14}{:>12}",
            row.key,
            row.microseconds,
            pair(row.first_try),
            row.crease,
            pair(worst_p99(scenes, index_of(row.key))),
            row.steps,
            percent(row.left_over),
            row.updates,
            row.unfinished
        );
    }
    println!(
        "\
Warm: the slowest first update after a jump, each tried three times and the least counts, for what other
programs add is not the model's. First try: the same updates as the jump finds the caches, which is what a hand
meets: where a budget of steps meets ground that is in no cache, an update takes two to three times as long, and
a tenth of a millisecond is not kept. Crease: a jump along 6000 cells of a straight crease, the least of seven.
Worst p99: of all scenes and speeds above. Steps are vertices, faces and cells in one update. What is left
over is walked in the next updates. Not shown: pages that are not in memory."
    );
}
