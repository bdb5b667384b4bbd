//! Pan: the hand holds a point of the surface and pushes the surface along.
//!
//! The surface is a mass on the servo's spring: the spring that led the hand to the proxy leads it to
//! the point held, so that grabbing changes no force. The mass is moved on implicitly (backward
//! Euler), which never makes energy: over a tick, mass and spring gain no more than the spring's
//! force times the hand's way, for every step and every hand.

use devices::{Capabilities, NOMINAL_PERIOD};
use surface::GridPoint;

use super::{Bounds, Hand, Hold, Interaction, Knobs, seconds};
use crate::{Frame, Limits};

/// Of the critical damping. Ours: a surface that is stopped overshoots by a quarter of its way and
/// stands within two swings, and a hand at 0.3 m/s that grabs one at rest is knocked by 2.4 N, not 6.
const DAMPING: f64 = 0.4;

/// Seconds in which the spring of a surface without mass goes slack. Ours: soon enough for "cut", in
/// the paper's words, and ten ticks long, so that it is no knock.
const SLACK: f64 = 0.01;

/// The point that is held.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pan {
    held: GridPoint,
    /// Where it is in the workspace, metres.
    at: [f64; 3],
    /// Of the surface, workspace metres a second.
    velocity: [f64; 2],
    /// Where the hand was last, between the walls.
    inside: [f64; 2],
    bounds: Bounds,
}

/// The damping of the coupling, N s/m: as much as `DAMPING` asks for, as far as the device can show it.
///
/// A sampled damper B costs 2 B/T of the stable stiffness (Colgate and Schenkel, "Passivity of a
/// class of sampled-data systems", 1997: b > K T/2 + B); half of what the spring leaves of it is
/// taken. A hand that holds the device is a damper too.
pub(super) fn damping(
    interaction: &Interaction,
    capabilities: &Capabilities,
    limits: &Limits,
) -> f64 {
    let delays = 1.0 + 2.0 * f64::from(capabilities.delay_ticks);
    let left = (capabilities.max_stiffness / delays - limits.stiffness).max(0.0);
    let wanted = 2.0 * DAMPING * (limits.stiffness * interaction.pan_mass).sqrt();
    wanted.min(0.25 * NOMINAL_PERIOD * left)
}

impl Pan {
    /// Holds the grid point `held`, where it lies under `frame`, of a surface that moves.
    pub(super) fn grab(held: GridPoint, hand: &Hand<'_>, frame: &Frame, velocity: [f64; 2]) -> Pan {
        Pan {
            held,
            at: frame.workspace(&held),
            velocity,
            inside: [hand.inside[0], hand.inside[1]],
            bounds: Bounds::around(frame),
        }
    }

    pub(super) fn velocity(&self) -> [f64; 2] {
        self.velocity
    }

    /// Moves the surface on by a tick, and the window with it.
    pub(super) fn step(
        &mut self,
        knobs: &Knobs,
        hand: &Hand<'_>,
        frame: &mut Frame,
        stiffness: f64,
    ) -> Hold {
        let inside = [hand.inside[0], hand.inside[1]];
        let before = std::mem::replace(&mut self.inside, inside);
        let hand_way: [f64; 2] = std::array::from_fn(|axis| inside[axis] - before[axis]);
        let dt = seconds(hand.dt);
        // In a tick that follows a late one closely a hand seems faster than it is.
        let damping = knobs.pan_damping * (dt / NOMINAL_PERIOD).min(1.0);
        if hand.is_at_wall {
            self.follow(dt);
        } else {
            self.move_on(knobs, damping, hand_way, dt, stiffness);
        }
        self.lay(frame, dt);
        let mut beside = [0.0; 3];
        if hand.is_at_wall {
            self.velocity = [0.0; 2];
        } else if dt > 0.0 {
            for axis in 0..2 {
                beside[axis] = damping * (self.velocity[axis] - hand_way[axis] / dt);
            }
        }
        let [x, y, z] = self.at;
        let [right, away] = self.velocity;
        Hold {
            stretch: [x - inside[0], y - inside[1], z - hand.pose.position[2]],
            beside,
            kept: 0.5 * knobs.interaction.pan_mass * (right * right + away * away),
            has_walls: true,
        }
    }

    /// At a wall the surface has no mass: no momentum is left, and what the spring is stretched by
    /// goes slack. As the point inside does not move while the hand is pressed into the wall, the
    /// spring adds nothing to the wall's stiffness.
    fn follow(&mut self, dt: f64) {
        let share = (-dt / SLACK).exp();
        for (at, inside) in self.at.iter_mut().zip(self.inside) {
            *at = inside + (*at - inside) * share;
        }
    }

    /// Moves the mass on.
    fn move_on(
        &mut self,
        knobs: &Knobs,
        damping: f64,
        hand_way: [f64; 2],
        dt: f64,
        stiffness: f64,
    ) {
        let mass = knobs.interaction.pan_mass;
        let friction = mass / knobs.interaction.drift_time;
        let inertia = mass + dt * (friction + damping) + dt * dt * stiffness;
        for (axis, way) in hand_way.into_iter().enumerate() {
            let stretch = self.inside[axis] - self.at[axis];
            let momentum = mass * self.velocity[axis];
            self.velocity[axis] = (momentum + dt * stiffness * stretch + damping * way) / inertia;
            self.at[axis] += dt * self.velocity[axis];
        }
    }

    /// Lays the window so that the point held is where it shall be, as far as the map reaches: beyond
    /// that the surface stands, and the hand feels it.
    fn lay(&mut self, frame: &mut Frame, dt: f64) {
        let before = frame.workspace(&self.held);
        let window = frame.window();
        let Some(moved) = frame.pinned(&self.held, self.at, window.width(), window.turn()) else {
            (self.at, self.velocity) = (before, [0.0; 2]);
            return;
        };
        *frame = moved;
        if let Some(back) = self.bounds.push_back(&moved) {
            *frame = back;
            let [x, y, _] = back.workspace(&self.held);
            (self.at[0], self.at[1]) = (x, y);
            let made = [x - before[0], y - before[1]];
            self.velocity = made.map(|metres| if dt > 0.0 { metres / dt } else { 0.0 });
        }
    }
}
