//! One trial: a hand comes down on something and is held there. Does it come to rest?

use crate::stability::ground::{Ground, WORKSPACE};
use crate::stability::plain_wall::PlainWall;
use crate::stability::theory::Plant;
use contact::{Model, SurfaceWalk};
use devices::{Device, Hand, Mechanism, SimulatedDevice};
use servo::{Servo, Settings, Walls};
use std::error::Error;
use std::sync::Arc;

/// Metres in a count of the encoder: what delta-type devices and the better arms have.
pub const COUNT: f64 = 1e-5;

/// Newtons: never the limit here.
const MOST_FORCE: f64 = 1e9;

/// Seconds of a look at the swing, and looks of the longest trial: a minute.
const LOOK: f64 = 0.5;
const LONGEST: usize = 120;

/// Looks before a swing is judged, in which the hand comes down; and looks between which a swing
/// must become less to count as dying out.
const LANDING: usize = 3;
const APART: usize = 6;

/// Times the swing that counts as rest, above which a swing that does not become less is given up
/// at once; a smaller one may yet step down to rest, and has the whole minute.
const CLEARLY: f64 = 3.0;

/// A wall at the right of the workspace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wall {
    /// There is none.
    None,
    /// Its force is added.
    Added(f64),
    /// It is mixed with the surface's by the servo.
    Mixed(f64),
}

/// What is tried.
#[derive(Clone)]
pub struct Trial<'a> {
    /// Pressed on.
    pub ground: &'a Ground,
    /// Held in.
    pub hand: Hand,
    /// Holds.
    pub mechanism: Mechanism,
    /// Where the hand begins, workspace metres.
    pub start: [f64; 3],
    /// Where it is pressed down, workspace metres.
    pub aim: [f64; 3],
    /// How far it is pressed in by a spring of the passive bound's stiffness, metres. Less far, and
    /// the swings of a stiff spring, which come off the wall, would be lost among the counts.
    pub press: [f64; 3],
    /// A swing of no more than this, metres, is rest.
    pub rest: f64,
    /// Hertz.
    pub rate: f64,
    /// Beside the surface.
    pub wall: Wall,
    /// Whether the passivity controller may add damping.
    pub controls: bool,
}

/// How it ended.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// Whether it came to rest, or was on the way there when time was over.
    pub is_stable: bool,
    /// Metres from end to end of the last swing, of the axis that swings most.
    pub swing: f64,
    /// Ticks in which the observer found the spring to have given more than it took.
    pub active_ticks: u64,
    /// Ticks.
    pub ticks: u64,
}

/// A hand that does as good as nothing but press: what brakes is the device alone, so that the
/// passive bound and the exact boundary are nearest to each other.
pub fn weight() -> Hand {
    Hand { mass: 1e-3, muscle_stiffness: 1.0, damping: 0.0, ..Hand::default() }
}

/// A device of 0.1 kg.
pub fn mechanism(damping: f64, delay_ticks: u32, metres_per_count: f64) -> Mechanism {
    // The servo would cut the stiffness to what the device says, and here that is what is sought.
    let max_stiffness = Some(f64::INFINITY);
    Mechanism { mass: 0.1, damping, metres_per_count, delay_ticks, max_stiffness }
}

impl Trial<'_> {
    /// Hand and device as theory sees them.
    pub fn plant(&self) -> Plant {
        Plant {
            mass: self.hand.mass + self.mechanism.mass,
            damping: self.hand.damping + self.mechanism.damping,
            stiffness: self.hand.muscle_stiffness,
            period: 1.0 / self.rate,
            delay: self.mechanism.delay_ticks,
        }
    }

    /// Presses against a spring of `stiffness` N/m until the hand rests, swings on, or time is over.
    pub fn run(&self, stiffness: f64) -> Result<Outcome, Box<dyn Error>> {
        let mut servo = self.servo(stiffness)?;
        let mut swings = Vec::new();
        let mut is_stable = None;
        while is_stable.is_none() && swings.len() < LONGEST {
            swings.push(self.look(&mut servo));
            is_stable = self.judged(&swings);
        }
        // Dying out when time is over: it is on its way to rest, or a cycle near it.
        let is_dying = || swings[LONGEST - 1] < swings[LONGEST - 1 - APART];
        let is_stable = is_stable.unwrap_or_else(is_dying);
        Ok(outcome(is_stable, &servo, &swings[swings.len() - 1..]))
    }

    /// Presses for as long as a trial may last, whatever happens; the swing is that of the last quarter.
    pub fn last(&self, stiffness: f64) -> Result<Outcome, Box<dyn Error>> {
        let mut servo = self.servo(stiffness)?;
        let swings: Vec<f64> = (0..LONGEST).map(|_| self.look(&mut servo)).collect();
        let outcome = outcome(true, &servo, &swings[LONGEST * 3 / 4..]);
        Ok(Outcome { is_stable: outcome.swing <= self.rest, ..outcome })
    }

    /// The swing of the next half second.
    fn look(&self, servo: &mut Servo) -> f64 {
        let period = 1.0 / self.rate;
        let mut swing = Swing::default();
        for _ in 0..(LOOK * self.rate) as u64 {
            let time = (servo.totals().ticks + 1) as f64 * period;
            swing.add(servo.tick(time, period).hand);
        }
        swing.size()
    }

    /// Whether it rests, or swings no less than it did; `None` while neither is clear.
    fn judged(&self, swings: &[f64]) -> Option<bool> {
        let (&last, before) = swings.split_last()?;
        if before.len() < LANDING {
            return None;
        }
        if last <= self.rest * (1.0 + 1e-9) {
            return Some(true);
        }
        if before.len() < LANDING + APART {
            return None;
        }
        let earlier = before[before.len() - APART];
        (last >= earlier && last > CLEARLY * self.rest).then_some(false)
    }

    fn servo(&self, stiffness: f64) -> Result<Servo, Box<dyn Error>> {
        let hand =
            Hand { target: self.start, max_force: MOST_FORCE, workspace: WORKSPACE, ..self.hand };
        let rig = SimulatedDevice::held(hand, self.mechanism)?;
        let device: Box<dyn Device> = match self.wall {
            Wall::Added(at) => Box::new(PlainWall::new(rig, at, stiffness)),
            Wall::None | Wall::Mixed(_) => Box::new(rig),
        };
        let model = Box::new(SurfaceWalk::new(Model::default().default_step_budget(), None));
        let grid = Arc::clone(&self.ground.grid);
        let settings = Settings { stiffness, max_force: MOST_FORCE, ..Settings::default() };
        let mut servo = Servo::new(device, model, grid, self.ground.frame, &settings)?;
        servo.set_device_damping(self.plant().damping);
        servo.set_passivity_control(self.controls);
        if let Wall::Mixed(at) = self.wall {
            servo.set_walls(Some(Walls::new(at, 1.0)?));
        }
        let newtons_a_metre = self.plant().passive_bound();
        let pull = newtons_a_metre / hand.muscle_stiffness;
        let pulled = |axis: usize| self.aim[axis] + self.press[axis] * pull;
        servo.set_target(std::array::from_fn(pulled));
        Ok(servo)
    }
}

fn outcome(is_stable: bool, servo: &Servo, swings: &[f64]) -> Outcome {
    let swing = swings.iter().copied().fold(0.0, f64::max);
    let totals = servo.totals();
    Outcome { is_stable, swing, active_ticks: totals.active_ticks, ticks: totals.ticks }
}

/// The box that positions lie in.
struct Swing {
    low: [f64; 3],
    high: [f64; 3],
}

impl Default for Swing {
    fn default() -> Self {
        Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] }
    }
}

impl Swing {
    fn add(&mut self, position: [f64; 3]) {
        for (axis, metres) in position.into_iter().enumerate() {
            self.low[axis] = self.low[axis].min(metres);
            self.high[axis] = self.high[axis].max(metres);
        }
    }

    fn size(&self) -> f64 {
        (0..3).map(|axis| self.high[axis] - self.low[axis]).fold(0.0, f64::max)
    }
}
