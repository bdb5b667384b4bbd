//! Faults injected in random sequences, and what became of the force.

use contact_bench::figures::Figures;
use servo::faults::{Kind, run};
use std::error::Error;

/// Random sequences.
const SEQUENCES: u64 = 1000;

/// Of all random numbers in them.
const SEED: u64 = 2003;

/// Injects them, prints what they were, and keeps the figures.
pub fn measure(figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    let report = run(SEQUENCES, SEED);
    println!("\n==== Faults injected in {} random sequences", report.sequences);
    for (kind, count) in Kind::ALL.iter().zip(report.of_each_kind) {
        println!("{:<40}{count:>8}", format!("{kind:?}"));
    }
    for broken in &report.broken {
        println!("broken: {broken}");
    }
    figures.set("faults_injected", report.injected);
    figures.set("faults_survived", report.survived);
    figures.set("force_after_fault_max_n", report.force_after_fault_max_n);
    println!(
        "Survived: every promise of the safety chain was kept, the cause was told in words, and touch went on or\n\
         could be started again. The force is the largest that was sent after the time stated for each fault\n\
         (README, Reliability). Not shown: faults of real drivers and of the system."
    );
    Ok(())
}
