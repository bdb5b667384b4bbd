//! What the safety chain did, in words for the person.

use super::slew::rate_at_switch;
use crate::{Limits, Recording, Totals};

/// What a stage did since the session was made, why, and what can be done about it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Warning {
    /// The hand is under the ground now.
    #[error(
        "The hand is under the ground, and touch begins only from above: lift it out and come down again."
    )]
    Below,
    /// The take's file gets no more.
    #[error(
        "The take is in memory only: its file {path} cannot be written ({words}). Stop the recording \
         to keep it, and free space on the disk."
    )]
    Spool {
        /// The file.
        path: String,
        /// The system's.
        words: String,
    },
    /// Ticks are missing in the take.
    #[error(
        "The take has lost {0} ticks, because the computer was too busy or its memory is full: stop \
         the recording to keep what there is."
    )]
    TakeDropped(u64),
    /// The spring is softer than was asked for.
    #[error(
        "The stiffness was cut from {asked:.0} to {given:.0} N/m: the device would tremble with more."
    )]
    Stiffness {
        /// N/m.
        asked: f64,
        /// N/m.
        given: f64,
    },
    /// The host was silent.
    #[error(
        "The force was taken away {} because Blender, or the program that touches, did not answer \
         for a while: let go of the surface before long work.",
        often(.0)
    )]
    Host(u64),
    /// Ticks were missed.
    #[error(
        "The force was taken away {} because the computer was too busy to keep time: close other \
         programs.",
        often(.0)
    )]
    Late(u64),
    /// The hand was too fast.
    #[error(
        "The force was taken away {} because the handle moved faster than {max_speed:.1} m/s: hold \
         it, and calibrate the device if you did.",
        often(.times)
    )]
    Speed {
        /// Times.
        times: u64,
        /// m/s.
        max_speed: f64,
    },
    /// The device failed.
    #[error(
        "The device failed {} and was forgiven: check its cable, and use no hub between.",
        often(.0)
    )]
    Device(u64),
    /// Something was no number.
    #[error(
        "A position or a force was not a number {}, and no force was given: calibrate the device, \
         and report it if that does not help.",
        often(.0)
    )]
    NotFinite(u64),
    /// The passivity observer found the spring active.
    #[error(
        "The spring gave the hand more energy than it took for {seconds:.2} s: hold the handle more \
         firmly, have passivity control on, or lower the stiffness."
    )]
    Active {
        /// s.
        seconds: f64,
    },
    /// The force was cut.
    #[error("The force was cut to its limit of {max_force:.1} N for {seconds:.1} s: press less.")]
    Clamped {
        /// N.
        max_force: f64,
        /// s.
        seconds: f64,
    },
    /// The force lagged.
    #[error(
        "The force rose or fell more slowly than it should for {seconds:.2} s: its change is \
         limited to {max_slew:.0} N/s, and to {at_switch:.0} N/s after a switch of models."
    )]
    SlewLimited {
        /// N/s.
        max_slew: f64,
        /// While another contact model takes over, N/s.
        at_switch: f64,
        /// s.
        seconds: f64,
    },
    /// The contact model ran out of steps.
    #[error(
        "The contact model had not come to the hand's place at the end of {0} ticks: let it go in larger \
         sub-steps, take a smaller sphere, or give it a larger step budget."
    )]
    Unfinished(u64),
    /// Ticks were lost to who drains them.
    #[error("{0} ticks were lost, because nobody drained them in time.")]
    Dropped(u64),
}

/// Ticks below which neither a cut nor a late force, nor an unfinished update, is told: a landing or a
/// jump across the map is no trouble. As long as the force takes to come back.
const WORTH_TELLING: u64 = 50;

fn often(count: &u64) -> String {
    match count {
        1 => "once".to_owned(),
        _ => format!("{count} times"),
    }
}

impl Warning {
    /// What is to be told of a take in the making.
    pub(crate) fn of_recording(recording: Recording) -> impl Iterator<Item = Warning> {
        let path = recording.spool.unwrap_or_default().display().to_string();
        let spool = recording.failure.map(|words| Warning::Spool { path, words });
        let dropped = recording.dropped;
        spool.into_iter().chain((dropped > 0).then_some(Warning::TakeDropped(dropped)))
    }

    /// All that is to be told, the gravest first.
    pub(crate) fn all(limits: &Limits, totals: &Totals) -> Vec<Warning> {
        let trips = &totals.trips;
        // Ticks are a millisecond each.
        let seconds = |ticks: u64| ticks as f64 / crate::engine::TICKS_PER_SECOND;
        let worth_telling = |ticks: u64| if ticks < WORTH_TELLING { 0 } else { ticks };
        let told = [
            (trips.not_finite, Warning::NotFinite(trips.not_finite)),
            (trips.device_errors, Warning::Device(trips.device_errors)),
            (
                trips.speed_cuts,
                Warning::Speed { times: trips.speed_cuts, max_speed: limits.max_speed },
            ),
            (trips.host_cuts, Warning::Host(trips.host_cuts)),
            (trips.late_cuts, Warning::Late(trips.late_cuts)),
            (
                u64::from(limits.stiffness < limits.asked_stiffness),
                Warning::Stiffness { asked: limits.asked_stiffness, given: limits.stiffness },
            ),
            (totals.active_ticks, Warning::Active { seconds: seconds(totals.active_ticks) }),
            (totals.dropped, Warning::Dropped(totals.dropped)),
            (worth_telling(totals.unfinished), Warning::Unfinished(totals.unfinished)),
            (
                worth_telling(trips.clamped),
                Warning::Clamped { max_force: limits.max_force, seconds: seconds(trips.clamped) },
            ),
            (
                worth_telling(trips.slew_limited),
                Warning::SlewLimited {
                    max_slew: limits.max_slew,
                    at_switch: rate_at_switch(limits.max_slew, limits.max_force),
                    seconds: seconds(trips.slew_limited),
                },
            ),
        ];
        told.into_iter().filter(|(count, _)| *count > 0).map(|(_, warning)| warning).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Settings, Trips};
    use devices::Capabilities;

    #[test]
    fn nothing_happened_and_nothing_is_told() {
        let limits = Limits::new(&Settings::default(), &Capabilities::unlimited([0.1; 3]));
        assert_eq!(Warning::all(&limits, &Totals::default()), []);
    }

    #[test]
    fn what_happened_is_told_with_its_number() {
        let capabilities =
            Capabilities { max_stiffness: 300.0, ..Capabilities::unlimited([0.1; 3]) };
        let limits = Limits::new(&Settings::default(), &capabilities);
        let trips = Trips { host_cuts: 2, clamped: 1500, slew_limited: 49, ..Trips::default() };
        let totals = Totals { trips, unfinished: 50, ..Totals::default() };
        let told: Vec<String> =
            Warning::all(&limits, &totals).iter().map(ToString::to_string).collect();
        assert_eq!(told.len(), 4);
        assert!(told[0].contains("taken away 2 times because Blender"), "{}", told[0]);
        assert_eq!(often(&1), "once");
        assert!(told[1].contains("from 500 to 300 N/m"), "{}", told[1]);
        assert!(told[2].contains("at the end of 50 ticks"), "{}", told[2]);
        assert!(told[3].contains("limit of 8.0 N for 1.5 s"), "{}", told[3]);
    }
}
