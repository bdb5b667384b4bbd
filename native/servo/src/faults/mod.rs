//! Faults, injected: a faulty device, a faulty host and a faulty contact model, in random sequences,
//! and a judge that holds every force to the promises of the safety chain.
//!
//! The judge sees what the device was told and knows what was done to the session; it computes its
//! bounds by itself. So [`run_without`] a stage must find promises broken, and [`run`] none. All of
//! it is stepped: a stall of 10 s is ten thousand deadlines let pass, and takes no time.

mod ground;
mod judge;
mod kind;
mod puppet;
mod random;
mod sequence;
mod witness;

pub use kind::Kind;

use crate::Stage;
use random::Random;

/// What a run found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Random sequences, each with faults of its own.
    pub sequences: u64,
    /// Faults injected.
    pub injected: u64,
    /// Faults after which every promise was kept.
    pub survived: u64,
    /// Newtons: the largest force that was told to the device between the time stated for a fault
    /// and its end.
    pub force_after_fault_max_n: f64,
    /// Faults injected of each kind, in the order of [`Kind::ALL`].
    pub of_each_kind: [u64; Kind::ALL.len()],
    /// Promises broken, in words, with the number of the sequence; no more than [`TOLD`].
    pub broken: Vec<String>,
}

/// Broken promises that a report keeps in words.
pub const TOLD: usize = 20;

/// Injects faults in so many random sequences, which `seed` decides.
pub fn run(sequences: u64, seed: u64) -> Report {
    run_with(sequences, seed, None)
}

/// The same with a stage of the safety chain switched off.
pub fn run_without(stage: Stage, sequences: u64, seed: u64) -> Report {
    run_with(sequences, seed, Some(stage))
}

fn run_with(sequences: u64, seed: u64, off: Option<Stage>) -> Report {
    let mut report = Report { sequences, ..Report::default() };
    for number in 0..sequences {
        let outcomes = sequence::play(&mut Random::new(seed, number), off);
        for outcome in outcomes {
            report.injected += u64::from(outcome.kind.is_some());
            if let Some(kind) = outcome.kind {
                report.of_each_kind[kind as usize] += 1;
                report.survived += u64::from(outcome.broken.is_empty());
            }
            let force = outcome.force_after_fault;
            report.force_after_fault_max_n = report.force_after_fault_max_n.max(force);
            for words in outcome.broken {
                if report.broken.len() < TOLD {
                    report.broken.push(format!("sequence {number}, {:?}: {words}", outcome.kind));
                }
            }
        }
    }
    report
}
