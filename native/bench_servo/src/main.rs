//! The servo measured, with the code that the wheel ships.
//!
//! One file for each part; a part prints its tables, says what they do not show, and adds its
//! figures to one report, which goes to `servo.json` in the output folder.

mod allocations;
mod busy;
mod faults;
mod lateness;
mod load;
mod options;
mod stability;

use contact_bench::figures::Figures;
use contact_bench::machine::{self, Machine};
use options::{Options, USAGE};
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

/// Measures one thing, prints it, and keeps its figures.
type Part = fn(&Options, &mut Figures) -> Result<(), Box<dyn Error>>;

#[global_allocator]
static ALLOCATOR: allocations::Counting = allocations::Counting;

/// What is measured, in this order.
const PARTS: [(&str, Part); 5] = [
    ("stability", |_, figures| stability::measure(figures)),
    ("faults", |_, figures| faults::measure(figures)),
    ("allocations", |_, figures| allocations::measure(figures)),
    ("load", load::measure),
    ("lateness", lateness::measure),
];

/// Figures that count, and what they should be.
const GOALS: [(&str, &str); 20] = [
    ("stable_stiffness_over_theory", ">= 0.9"),
    ("stable_stiffness_over_theory_d0", ">= 0.9"),
    ("stable_stiffness_over_theory_d1", ">= 0.9"),
    ("stable_stiffness_over_theory_d2", "reported"),
    ("still_stiffness_over_theory", "reported: the encoder's tremble"),
    ("without_encoder_off_exact", "reported"),
    ("mixed_plain_limit_cycle_mm", "> 0.1: the paper's instability"),
    ("mixed_attenuated_limit_cycle_counts", "<= 2"),
    ("observer_false_alarms", "0"),
    ("controlled_limit_cycle_share", "< 1"),
    ("faults_injected", ">= 1000"),
    ("faults_survived", "all"),
    ("force_after_fault_max_n", "0"),
    ("tick_allocations", "0"),
    ("load_share_swipe_max", "<= 0.25: the paper's bound; 0.01"),
    ("lateness_p99_over_bare_idle", "<= 1.5"),
    ("lateness_p99_over_bare_loaded", "reported"),
    ("lateness_p99_over_bare_blender", "reported"),
    ("missed_share_idle", "reported"),
    ("missed_share_loaded", "reported"),
];

fn main() -> ExitCode {
    if std::env::args().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let options = match Options::read(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(mistake) => {
            eprintln!("{mistake}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    if machine::IS_TUNED {
        eprintln!("This program was compiled for one processor (target-cpu); the wheel is not.");
        return ExitCode::from(2);
    }
    match run(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let began = Instant::now();
    std::fs::create_dir_all(&options.output)?;
    let machine = Machine::found();
    println!("{}", machine.line());
    let mut figures = Figures::default();
    machine.note(&mut figures);
    for (name, measure) in PARTS {
        eprintln!("[bench] {name}");
        measure(options, &mut figures)?;
    }
    print_goals(&figures);
    figures.set("seconds", began.elapsed().as_secs_f64().round());
    let path = options.output.join("servo.json");
    figures.write(&path)?;
    println!("\nFigures: {} ({:.0} s)", path.display(), began.elapsed().as_secs_f64());
    Ok(())
}

fn print_goals(figures: &Figures) {
    println!("\n==== The figures that count");
    println!("{:<40}{:>14}   to reach", "", "found");
    for (name, goal) in GOALS {
        if let Some(found) = figures.get(name) {
            println!("{name:<40}{found:>14}   {goal}");
        }
    }
}
