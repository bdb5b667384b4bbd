//! The stages by name, and taking one out: only where the feature `test-hooks` is compiled in.

/// A stage of the safety chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Errors of the device give zero force, and too many end touch.
    Device,
    /// A hand or a force that is no number gives zero force.
    Finite,
    /// A hand that moves as no hand does gives zero force.
    Speed,
    /// A host that does not look gives zero force.
    Host,
    /// Missed ticks give zero force.
    Late,
    /// The force never exceeds its limit.
    Clamp,
    /// The spring is never stiffer than the device can show.
    Stiffness,
    /// The proxy begins at the hand.
    Engage,
    /// The force begins at nothing and comes slowly.
    Ramp,
    /// The force changes only so fast.
    Slew,
    /// Zero force is the last thing sent.
    LastZero,
}

#[cfg(feature = "test-hooks")]
impl Stage {
    /// All of them.
    pub const ALL: [Stage; 11] = [
        Stage::Device,
        Stage::Finite,
        Stage::Speed,
        Stage::Host,
        Stage::Late,
        Stage::Clamp,
        Stage::Stiffness,
        Stage::Engage,
        Stage::Ramp,
        Stage::Slew,
        Stage::LastZero,
    ];
}

/// Which stages do their work: all.
#[cfg(not(feature = "test-hooks"))]
#[derive(Clone, Copy, Default)]
pub(crate) struct Stages(());

#[cfg(not(feature = "test-hooks"))]
impl Stages {
    /// Whether a stage does its work. Known when this is compiled, so nothing is asked in a tick.
    pub(crate) const fn are_on(self, _stage: Stage) -> bool {
        true
    }
}

/// Which stages do their work: all, or all but one.
#[cfg(feature = "test-hooks")]
#[derive(Clone, Copy, Default)]
pub(crate) struct Stages {
    off: Option<Stage>,
}

#[cfg(feature = "test-hooks")]
impl Stages {
    /// Whether a stage does its work.
    pub(crate) fn are_on(self, stage: Stage) -> bool {
        self.off != Some(stage)
    }

    pub(crate) fn switch_off(&mut self, stage: Stage) {
        self.off = Some(stage);
    }
}
