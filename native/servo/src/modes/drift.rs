//! A surface that was let go in motion: momentum carries it on, friction brakes it.

use super::{Bounds, Hand, Knobs, seconds};
use crate::Frame;

/// Workspace metres a second below which the surface stands. Ours: what moves by less than a
/// millimetre in a second is felt and seen as standing.
const STANDING: f64 = 1e-3;

/// The surface under a hand that does not hold it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Drift {
    /// Workspace metres a second, right and away.
    velocity: [f64; 2],
    /// Metres that it made in this tick.
    way: [f64; 2],
    /// Joules that its momentum has paid for work on the hand, and may get back from it.
    lent: f64,
    bounds: Bounds,
}

impl Drift {
    pub(super) fn new(velocity: [f64; 2], bounds: Bounds) -> Drift {
        Drift { velocity, way: [0.0; 2], lent: 0.0, bounds }
    }

    pub(super) fn velocity(&self) -> [f64; 2] {
        self.velocity
    }

    /// Moves the surface on, exactly as friction lets it. A hand at a wall takes its momentum.
    pub(super) fn step(&mut self, knobs: &Knobs, hand: &Hand<'_>, frame: &mut Frame) {
        self.way = [0.0; 2];
        if self.velocity == [0.0; 2] {
            return;
        }
        let [right, away] = self.velocity;
        if hand.is_at_wall || right.hypot(away) < STANDING {
            self.velocity = [0.0; 2];
            return;
        }
        let time = knobs.interaction.drift_time;
        let left = (-seconds(hand.dt) / time).exp();
        let way = self.velocity.map(|speed| speed * time * (1.0 - left));
        let origin = frame.origin();
        let window = frame.window();
        let moved = frame.pinned(&origin, [way[0], way[1], 0.0], window.width(), window.turn());
        let Some(moved) = moved else {
            self.velocity = [0.0; 2];
            return;
        };
        self.velocity = self.velocity.map(|speed| speed * left);
        self.way = way;
        *frame = moved;
        if let Some(back) = self.bounds.push_back(&moved) {
            // What is left of its way is along the map's edge, and so is what is left of its speed.
            let [right, away, _] = back.workspace(&origin);
            self.way = [right, away];
            let share = left / (time * (1.0 - left));
            self.velocity = self.way.map(|metres| metres * share);
            *frame = back;
        }
    }

    /// Pays for the work of `force`, newtons on the hand, on the way of this tick, as a mass rolling
    /// over hills would: uphill it becomes slower, downhill it gets back what it paid, and never more.
    /// Gives the joules that were paid.
    pub(super) fn pay(&mut self, force: [f64; 3], mass: f64) -> f64 {
        let work = force[0] * self.way[0] + force[1] * self.way[1];
        let [right, away] = self.velocity;
        let speed = right.hypot(away);
        if !work.is_finite() || speed == 0.0 {
            return 0.0;
        }
        let energy = 0.5 * mass * speed * speed;
        let paid = work.clamp(-self.lent, energy);
        self.lent = (self.lent + paid).max(0.0);
        let share = (1.0 - paid / energy).max(0.0).sqrt();
        if share.is_finite() {
            self.velocity = self.velocity.map(|metres| metres * share);
        }
        paid
    }
}
