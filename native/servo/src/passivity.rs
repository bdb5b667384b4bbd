//! How much energy the virtual coupling has taken from the hand, watched tick by tick.
//!
//! A coupling that is passive gives back no more than it took (Hannaford and Ryu, "Time-domain
//! passivity control of haptic interfaces", 2002). A sampled spring always gives a little more: its
//! force is held while the hand moves on, which makes K/2 dx² a tick (Colgate and Schenkel,
//! "Passivity of a class of sampled-data systems: application to haptic interfaces", 1997). It does
//! no harm while the device's own damping b takes at least as much, so that is counted too: over T
//! seconds in which the hand moves by dx, damping takes b dx²/T or more (Cauchy and Schwarz), and
//! the sum stays positive exactly while K < 2b/T; with a force that acts d ticks late, while
//! K < 2b/((1 + 2d) T).

use devices::{Capabilities, NOMINAL_PERIOD};

/// Share of the energies summed since touch began that may be rounding.
const ROUNDING: f64 = 1e-9;

/// Ticks of delay that are watched; a force that acts later is taken to act that late.
const LONGEST_DELAY: usize = 16;

/// Seconds in the air after which what was owed is forgotten: it has become motion of the hand, and
/// by then the person has taken that up. Ours: a bounce on a wall is shorter.
const MEMORY: f64 = 0.1;

/// The damping, N s/m, that a device must have at least to show the stiffness that it declares:
/// K < 2b/T (Colgate and Schenkel, 1997).
pub(crate) fn declared_damping(capabilities: &Capabilities) -> f64 {
    0.5 * capabilities.max_stiffness * NOMINAL_PERIOD
}

/// What one tick shows of the coupling.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coupling {
    /// Where the hand is now, as the device tells it: workspace metres.
    pub(crate) hand: [f64; 3],
    /// The force that it wants to send now, newtons.
    pub(crate) force: [f64; 3],
    /// Metres that its spring is stretched.
    pub(crate) stretch: f64,
    /// Of its spring, N/m.
    pub(crate) stiffness: f64,
    /// Seconds since the last tick.
    pub(crate) dt: f64,
}

/// The observer, and the controller that may answer it. It is as good as what is known of the device's
/// damping: one that has less than it declares can swing unseen.
///
/// Its account is kept low, so that it does not miss what it should see: of what the damping took
/// only the last ticks count, for what was taken long ago pays for nothing now, and beyond that no
/// more stands on the account than the coupling's spring can hold. Positions are taken as the encoder
/// tells them: the spring is one on counts, and its leak is counted in the same counts as the
/// damping, so that quantisation alone makes no tick active while K is below the bound. What a
/// tremble of one count really makes (Diolaiti et al., "Stability of haptic rendering", 2006) is below
/// what such positions can show.
#[derive(Clone, Debug)]
pub(crate) struct Passivity {
    /// Of the device alone, N s/m.
    damping: f64,
    /// Ticks from a write to the force.
    delay: usize,
    controls: bool,
    /// What the last tick asked to be sent, newtons.
    asked: [f64; 3],
    /// Ticks for which forces still act that were not sent as asked.
    disturbed_ticks: usize,
    /// Sent forces, the newest first: newtons.
    sent: [[f64; 3]; LONGEST_DELAY + 1],
    /// What the damping took in the last ticks, the newest first: joules.
    taken: [f64; LONGEST_DELAY + 1],
    /// `None` before the first tick of touch.
    hand: Option<[f64; 3]>,
    /// Seconds of the last tick.
    dt: f64,
    /// Joules that stand on the account.
    energy: f64,
    /// Joules summed without their signs.
    turnover: f64,
    /// Ticks and seconds since the spring pushed.
    quiet_ticks: usize,
    quiet_seconds: f64,
    /// Joules that are kept beside the spring, as in a moving mass.
    kept: f64,
    /// Joules that something else pays in this tick.
    paid: f64,
    /// Ticks in which the account was negative.
    active_ticks: u64,
}

impl Passivity {
    /// For a device of `damping` N s/m whose forces act `delay_ticks` after they are sent.
    pub(crate) fn new(damping: f64, delay_ticks: u32) -> Passivity {
        Passivity {
            damping,
            delay: usize::try_from(delay_ticks).unwrap_or(LONGEST_DELAY).min(LONGEST_DELAY),
            controls: false,
            asked: [0.0; 3],
            disturbed_ticks: 0,
            sent: [[0.0; 3]; LONGEST_DELAY + 1],
            taken: [0.0; LONGEST_DELAY + 1],
            hand: None,
            dt: 0.0,
            energy: 0.0,
            turnover: 0.0,
            quiet_ticks: 0,
            quiet_seconds: 0.0,
            kept: 0.0,
            paid: 0.0,
            active_ticks: 0,
        }
    }

    /// Whether damping is added where the account is negative. Off at first.
    pub(crate) fn set_control(&mut self, controls: bool) {
        self.controls = controls;
    }

    /// Another figure for the device's damping, N s/m.
    pub(crate) fn set_damping(&mut self, damping: f64) {
        self.damping = damping;
    }

    /// Ticks, since it was made, in which the coupling had given more than it took.
    pub(crate) fn active_ticks(&self) -> u64 {
        self.active_ticks
    }

    /// Begins anew, as if nothing had been touched.
    pub(crate) fn begin(&mut self) {
        self.sent = [[0.0; 3]; LONGEST_DELAY + 1];
        self.taken = [0.0; LONGEST_DELAY + 1];
        self.asked = [0.0; 3];
        self.disturbed_ticks = 0;
        self.hand = None;
        self.energy = 0.0;
        self.turnover = 0.0;
        (self.kept, self.paid) = (0.0, 0.0);
    }

    /// What else may give energy in the tick to come: joules that are kept beside the spring, and
    /// joules that are paid by what drives it.
    pub(crate) fn expect(&mut self, kept: f64, paid: f64) {
        (self.kept, self.paid) = (kept, paid);
    }

    /// Keeps the account of one tick. Gives the force to send: as it is wanted, or with damping where
    /// that is asked for and the account is negative.
    pub(crate) fn tick(&mut self, coupling: &Coupling) -> [f64; 3] {
        self.asked = self.answer(coupling);
        self.asked
    }

    fn answer(&mut self, coupling: &Coupling) -> [f64; 3] {
        // A real hand has moved since the last tick, a simulated one for as long as that tick was told
        // to last. Damping takes less in more time, so the longer of the two is the careful choice.
        let dt = coupling.dt.max(std::mem::replace(&mut self.dt, coupling.dt));
        let Some(before) = self.hand.replace(coupling.hand) else {
            return coupling.force;
        };
        // A device that says it can show every spring, such as a script, takes all that is made.
        if !self.damping.is_finite() {
            return coupling.force;
        }
        let step: [f64; 3] = std::array::from_fn(|axis| coupling.hand[axis] - before[axis]);
        if !dot(step, step).is_finite() {
            // No account can be kept of such a way: a new one begins where the hand is now.
            self.begin();
            return coupling.force;
        }
        self.listen(coupling);
        let gives = self.book(step, dt);
        self.square(coupling);
        if self.energy >= -ROUNDING * self.turnover {
            return coupling.force;
        }
        self.active_ticks += u64::from(gives && self.spring_acts());
        if !self.controls {
            return coupling.force;
        }
        self.damped(coupling.force, step, dt)
    }

    /// What was sent after the tick, newtons.
    pub(crate) fn sent(&mut self, force: [f64; 3]) {
        if force != self.asked {
            self.disturbed_ticks = self.delay + 2;
        }
        self.sent[..=self.delay].rotate_right(1);
        self.sent[0] = force;
    }

    fn listen(&mut self, coupling: &Coupling) {
        if coupling.force == [0.0; 3] {
            self.quiet_ticks += 1;
            self.quiet_seconds += coupling.dt;
        } else {
            self.quiet_ticks = 0;
            self.quiet_seconds = 0.0;
        }
    }

    /// Whether a force of the spring acted since the last tick, or is asked for now.
    fn spring_acts(&self) -> bool {
        self.quiet_ticks <= self.delay + 1
    }

    /// Work of the force that acted, and of the damping, on the way of the last tick; whether the
    /// force gave more than the damping took.
    fn book(&mut self, step: [f64; 3], dt: f64) -> bool {
        let work = dot(self.sent[self.delay], step);
        // What the damping takes in the air pays for nothing.
        let counts = dt > 0.0 && self.spring_acts();
        let taken = if counts { self.damping * dot(step, step) / dt } else { 0.0 };
        self.taken[..=self.delay].rotate_right(1);
        self.taken[0] = taken;
        self.energy += taken - work + std::mem::take(&mut self.paid);
        self.turnover += taken.min(work.abs()) + work.abs();
        work > taken
    }

    /// No more stands on the account than the spring can give back, and what the damping took in the
    /// ticks whose forces are still under way. Once nothing has pushed for a while nothing is owed
    /// either. And where a force was not sent as asked (ramped in, limited in its change), another
    /// spring was felt than this one: its account begins anew.
    fn square(&mut self, coupling: &Coupling) {
        let under_way: f64 = self.taken[..self.delay].iter().sum();
        let most = stored(coupling) + self.kept + under_way;
        self.energy = self.energy.min(most);
        if self.disturbed_ticks > 0 {
            self.disturbed_ticks -= 1;
            self.energy = most;
        }
        if self.quiet_seconds > MEMORY {
            self.energy = self.energy.max(0.0);
            self.turnover = 0.0;
        }
    }

    /// The force with as much damping added as would even the account in one tick at this speed, and
    /// never more than the device's own: sampled damping can itself be too much.
    fn damped(&self, force: [f64; 3], step: [f64; 3], dt: f64) -> [f64; 3] {
        let squared = dot(step, step);
        if !(squared > 0.0 && dt > 0.0) {
            return force;
        }
        let needed = -self.energy * dt / squared;
        let added = needed.min(self.damping);
        std::array::from_fn(|axis| force[axis] - added * step[axis] / dt)
    }
}

/// Joules in a spring whose force may have been cut: where it was, more way was made under the
/// constant force.
fn stored(coupling: &Coupling) -> f64 {
    let force = dot(coupling.force, coupling.force).sqrt();
    if coupling.stiffness <= 0.0 {
        return 0.0;
    }
    (force * coupling.stretch - 0.5 * force * force / coupling.stiffness).max(0.0)
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

#[cfg(test)]
mod tests;
