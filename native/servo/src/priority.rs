//! Real-time priority for the loop's thread, where the system grants it.
//!
//! Linux: SCHED_FIFO, which takes root, CAP_SYS_NICE or a limit on real-time priority (`ulimit -r`,
//! `LimitRTPRIO=`); desktops seldom grant it unasked. Windows: the multimedia class scheduler. macOS:
//! a time-constraint policy. Only the Linux way has been tried.

use audio_thread_priority::{
    RtPriorityHandle, demote_current_thread_from_real_time, promote_current_thread_to_real_time,
};

/// Asked for as an audio thread asks that fills a buffer every millisecond: so many frames of it, at
/// so many a second.
const FRAMES: u32 = 48;
const FRAMES_PER_SECOND: u32 = 48_000;

/// How the system schedules the loop's thread.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Priority {
    /// Like every other thread: nothing else was asked for, or it has not run live yet.
    #[default]
    Normal,
    /// Before all ordinary threads.
    RealTime,
    /// Like every other thread, for the system refused: its words.
    Refused(String),
}

/// Real-time priority of the calling thread, until it is dropped there.
pub(crate) struct Promotion(Option<RtPriorityHandle>);

impl Promotion {
    /// Asks for it.
    pub(crate) fn ask() -> (Promotion, Priority) {
        match promote_current_thread_to_real_time(FRAMES, FRAMES_PER_SECOND) {
            Ok(handle) => (Promotion(Some(handle)), Priority::RealTime),
            Err(error) => (Promotion(None), Priority::Refused(error.to_string())),
        }
    }

    /// Does without.
    pub(crate) fn none() -> (Promotion, Priority) {
        (Promotion(None), Priority::Normal)
    }
}

impl Drop for Promotion {
    fn drop(&mut self) {
        if let Some(handle) = self.0.take() {
            // The thread ends soon; one that stays promoted until then harms nobody.
            let _ = demote_current_thread_from_real_time(handle);
        }
    }
}

impl std::fmt::Display for Priority {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Priority::Normal => write!(f, "normal"),
            Priority::RealTime => write!(f, "real-time"),
            Priority::Refused(words) => write!(f, "normal: real-time was refused ({words})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_the_system_says_the_thread_goes_on_and_goes_back() {
        let before = policy();
        let (promotion, priority) = Promotion::ask();
        assert_ne!(priority, Priority::Normal);
        assert_eq!(policy() != before, priority == Priority::RealTime);
        drop(promotion);
        assert_eq!(policy(), before);
    }

    #[test]
    fn a_refusal_is_told_in_the_systems_words() {
        let words = Priority::Refused("not permitted".to_owned()).to_string();
        assert_eq!(words, "normal: real-time was refused (not permitted)");
    }

    #[cfg(target_os = "linux")]
    fn policy() -> i32 {
        // That the thread's children begin without it is set on the way, and stays.
        const RESET_ON_FORK: i32 = 0x4000_0000;
        // SAFETY: 0 is the calling thread; nothing is written to.
        unsafe { libc::sched_getscheduler(0) & !RESET_ON_FORK }
    }

    #[cfg(not(target_os = "linux"))]
    fn policy() -> i32 {
        0
    }
}
