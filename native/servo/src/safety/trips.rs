//! How often each stage has acted, and why the force is away now.

/// Counts since the session was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trips {
    /// Ticks whose pose or force was not finite.
    pub not_finite: u64,
    /// Reads and writes that the device failed.
    pub device_errors: u64,
    /// Times that the hand was too fast for a hand.
    pub speed_cuts: u64,
    /// Times that the host was silent for too long.
    pub host_cuts: u64,
    /// Times that too many ticks were missed in a row.
    pub late_cuts: u64,
    /// Ticks whose force was cut to the limit.
    pub clamped: u64,
    /// Ticks whose force was held back because it had just begun, or come back.
    pub ramped: u64,
    /// Ticks whose force was not yet what it should be, because it may change only so fast.
    pub slew_limited: u64,
    /// Times that the proxy was placed at the hand.
    pub engaged: u64,
}

/// Why the force is away, or not yet wholly back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// The host has not looked for too long.
    Host,
    /// Ticks were missed.
    Late,
    /// The hand was too fast for a hand.
    Speed,
    /// The device failed.
    Device,
    /// A position or a force was not a number.
    NotFinite,
    /// The device has played all that it had to play.
    Finished,
    /// The hand is under the ground without touching it: touch begins only from above. No stage of
    /// the chain says so; a session finds it when somebody looks.
    Below,
}

impl Held {
    /// In small letters.
    pub fn name(self) -> &'static str {
        match self {
            Held::Host => "host",
            Held::Late => "late",
            Held::Speed => "speed",
            Held::Device => "device",
            Held::NotFinite => "not_finite",
            Held::Finished => "finished",
            Held::Below => "below",
        }
    }
}

/// Why the force is taken away in this tick and in the one before, a bit for each reason.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reasons {
    now: u8,
    before: u8,
}

impl Reasons {
    pub(crate) fn begin_tick(&mut self) {
        self.before = std::mem::take(&mut self.now);
    }

    /// Whether neither this tick nor the one before had this reason up to now.
    pub(crate) fn is_new(&mut self, why: Held) -> bool {
        let bit = 1 << why as u8;
        let is_new = (self.now | self.before) & bit == 0;
        self.now |= bit;
        is_new
    }
}
