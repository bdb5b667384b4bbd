//! The faults that are injected.

/// What goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A read fails once, or twice in a row.
    ReadFails,
    /// Every read fails.
    ReadFailsForGood,
    /// Every tenth read fails.
    EveryTenthReadFails,
    /// A packet is too short, once.
    ShortRead,
    /// The device is unplugged.
    Gone,
    /// A write fails once.
    WriteFails,
    /// Every write fails.
    WriteFailsForGood,
    /// The position jumps by a metre, and stays there for a while.
    Jump,
    /// The position jumps by a metre for a single tick.
    JumpAndBack,
    /// Positions are not numbers, for some ticks.
    NotANumber,
    /// Positions are infinite, for some ticks.
    Infinite,
    /// Buttons go up and down in every tick.
    Buttons,
    /// Two to twenty ticks are missed.
    MissedTicks,
    /// The device does not answer for 100 ms.
    Stall100Ms,
    /// The device does not answer for 1 s.
    Stall1S,
    /// The device does not answer for 10 s.
    Stall10S,
    /// The host's timer is not called for 10 s.
    SilentHost,
    /// The contact model panics.
    ModelPanics,
    /// The contact model loses its proxy.
    ModelNotANumber,
    /// The contact model's proxy jumps.
    ModelJumps,
    /// The mapped file is cut.
    FileCut,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 21] = [
        Kind::ReadFails,
        Kind::ReadFailsForGood,
        Kind::EveryTenthReadFails,
        Kind::ShortRead,
        Kind::Gone,
        Kind::WriteFails,
        Kind::WriteFailsForGood,
        Kind::Jump,
        Kind::JumpAndBack,
        Kind::NotANumber,
        Kind::Infinite,
        Kind::Buttons,
        Kind::MissedTicks,
        Kind::Stall100Ms,
        Kind::Stall1S,
        Kind::Stall10S,
        Kind::SilentHost,
        Kind::ModelPanics,
        Kind::ModelNotANumber,
        Kind::ModelJumps,
        Kind::FileCut,
    ];

    /// Words that the message must have, where the fault ends touch.
    pub(super) fn ends_touch_with(self) -> Option<&'static str> {
        match self {
            Kind::ReadFailsForGood => Some("did not answer in time: no packet"),
            Kind::EveryTenthReadFails => Some("failed 10 times within a second"),
            Kind::Gone => Some("the device is gone: unplugged"),
            Kind::WriteFailsForGood => Some("did not answer in time: not sent"),
            Kind::ModelPanics => Some("a mistake in the program: the puppet panics"),
            Kind::FileCut => Some("terrain's file was cut"),
            _ => None,
        }
    }
}
