//! Faults of every kind, in random sequences, and a proof that each stage of the safety chain is
//! needed: without it the same sequences break a promise.

use servo::Stage;
use servo::faults::{Kind, run, run_without};

/// Any number will do; with this one the tests are the same every time.
const SEED: u64 = 4;

const SEQUENCES: u64 = 1000;

/// Enough for every stage to be missed.
const SEQUENCES_WITHOUT: u64 = 100;

#[test]
fn every_fault_is_survived_without_a_force() {
    let report = run(SEQUENCES, SEED);
    assert_eq!(report.broken, [] as [String; 0]);
    assert_eq!(report.survived, report.injected);
    assert!(report.injected >= SEQUENCES, "{} faults", report.injected);
    assert_eq!(report.force_after_fault_max_n, 0.0);
    for (kind, count) in Kind::ALL.iter().zip(report.of_each_kind) {
        assert!(count > 0, "{kind:?} was never injected");
    }
}

#[test]
fn without_any_one_stage_a_promise_is_broken() {
    for stage in Stage::ALL {
        let report = run_without(stage, SEQUENCES_WITHOUT, SEED);
        assert_ne!(report.broken, [] as [String; 0], "{stage:?} is not needed");
        assert!(report.survived < report.injected, "no fault needs {stage:?}");
    }
}
