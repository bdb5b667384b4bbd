//! A device that plays a hand that was recorded.

use std::ops::RangeInclusive;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::check;
use crate::track::{Moment, PathError, Track, between, share};
use crate::{Capabilities, Device, DeviceError, Force, ParameterError, Pose};

/// How much faster than it was recorded a hand may be played.
const SPEEDS: RangeInclusive<f64> = 0.1..=100.0;

/// Seconds: what is nearer than this to a recorded moment is that moment, to the bit. Sums of ticks are
/// rounded, by less than this in an hour; a tick is a million times longer.
const SAME_MOMENT: f64 = 1e-9;

/// A recorded hand at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandMoment {
    /// Seconds on the clock of the session in which it was recorded.
    pub time: f64,
    /// Workspace metres.
    pub position: [f64; 3],
    /// Radians about the vertical; `None` where the handle did not tell.
    pub twist: Option<f64>,
    /// A bit each; as they are until the next moment.
    pub buttons: u32,
}

impl Moment for HandMoment {
    fn time(&self) -> f64 {
        self.time
    }

    fn is_finite(&self) -> bool {
        let numbers = self.position.iter().chain(&self.twist).chain([&self.time]);
        numbers.into_iter().all(|number| number.is_finite())
    }
}

impl HandMoment {
    /// A moment between this one and a later one.
    fn on_the_way_to(&self, to: &HandMoment, time: f64) -> HandMoment {
        if time - self.time < SAME_MOMENT {
            return *self;
        }
        if to.time - time < SAME_MOMENT {
            return *to;
        }
        let share = share(self.time, to.time, time);
        let position =
            std::array::from_fn(|axis| between(self.position[axis], to.position[axis], share));
        let twists = self.twist.zip(to.twist);
        let twist = twists.map_or(self.twist, |(from, to)| Some(between(from, to, share)));
        HandMoment { time, position, twist, buttons: self.buttons }
    }
}

/// Plays a recorded hand, straight and evenly between its moments, from its first moment on, which is
/// where the hand is when it is first read.
///
/// A session whose ticks are those of the recording reads every moment to the bit. Past the last one
/// the hand rests there and is [finished](Device::is_finished). It takes every force and does not move
/// by it.
#[derive(Clone, Debug)]
pub struct PlaybackDevice {
    hand: Track<HandMoment>,
    /// Of the first and the last moment, seconds.
    ends: [f64; 2],
    speed: f64,
    workspace: [f64; 3],
    /// When it was first read, on the session's clock.
    began: Option<f64>,
    finished: Arc<AtomicBool>,
}

impl PlaybackDevice {
    /// A device playing `hand`, whose times must rise, `speed` times as fast as it was recorded (0.1
    /// to 100), in a workspace of that size (metres).
    pub fn new(
        hand: Vec<HandMoment>,
        speed: f64,
        workspace: [f64; 3],
    ) -> Result<PlaybackDevice, PathError> {
        check::workspace(workspace)?;
        if !SPEEDS.contains(&speed) {
            let (name, expected) = ("speed", "a number from 0.1 to 100");
            return Err(ParameterError { name, value: speed, expected }.into());
        }
        let hand = Track::new(hand)?;
        let (first, last) = hand.ends().ok_or(PathError::Empty)?;
        let ends = [first.time, last.time];
        let finished = Arc::default();
        Ok(PlaybackDevice { hand, ends, speed, workspace, began: None, finished })
    }

    /// Seconds that it plays.
    pub fn seconds(&self) -> f64 {
        let [first, last] = self.ends;
        (last - first) / self.speed
    }

    /// Becomes true in the first tick past the last moment, for whoever waits for the end while a
    /// session has the device.
    pub fn finished(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.finished)
    }
}

impl Device for PlaybackDevice {
    fn capabilities(&self) -> Capabilities {
        Capabilities::unlimited(self.workspace)
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        let began = *self.began.get_or_insert(time);
        let [first, last] = self.ends;
        let played = first + (time - began) * self.speed;
        if played > last + SAME_MOMENT {
            self.finished.store(true, Ordering::Release);
        }
        let moment = match self.hand.around(played) {
            Some((from, Some(to))) => from.on_the_way_to(to, played),
            Some((only, None)) => *only,
            None => return Err(DeviceError::Gone("there is no hand to play".into())),
        };
        let HandMoment { position, buttons, twist, .. } = moment;
        Ok(Pose { position, buttons, twist })
    }

    fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
        Ok(())
    }

    fn is_finished(&self) -> bool {
        self.finished.load(Ordering::Acquire)
    }
}
