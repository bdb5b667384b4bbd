//! One tick: hand, goal, proxy, force.

use std::sync::Arc;

use contact::{Contact, ContactModel, Feature};
use devices::{Capabilities, Device, Force, ParameterError, Pose};
use surface::{Grid, GridPoint};

use crate::force::spring;
use crate::frame::ground_cells;
use crate::memory::Piece;
use crate::modes::{Changed, Hand, Hold, Modes, STYLUS};
use crate::passivity::{Coupling, Passivity, declared_damping};
use crate::safety::{Heartbeat, Reading, Safety, Stage};
use crate::{Fault, Frame, Held, Limits, Mode, Settings, TickRecord, Totals, Walls};

/// A device, a contact model and a grid, joined by a spring from the hand to the proxy.
///
/// The servo says which force it wants; which one the hand gets is for the safety chain to say,
/// which alone has the device.
pub struct Servo {
    safety: Safety,
    model: Box<dyn ContactModel>,
    grid: Arc<Grid>,
    frame: Frame,
    /// None until they are asked for.
    walls: Option<Walls>,
    /// None where buttons change nothing.
    modes: Option<Modes>,
    /// Watches the energy of the spring.
    passivity: Passivity,
    /// The goal of the last tick. `None` while the proxy has still to be placed at the hand.
    last_goal: Option<GridPoint>,
    /// Where the proxy was last.
    last_proxy: GridPoint,
    /// Seconds before this tick in which no hand was seen.
    unseen: f64,
    latest: TickRecord,
    totals: Totals,
    fault: Option<Fault>,
}

impl Servo {
    /// Joins them. What `settings` ask for is cut to what the device can show.
    pub fn new(
        device: Box<dyn Device>,
        model: Box<dyn ContactModel>,
        grid: Arc<Grid>,
        frame: Frame,
        settings: &Settings,
    ) -> Result<Servo, ParameterError> {
        let origin = frame.goal([0.0; 3]);
        let capabilities = device.capabilities();
        let safety = Safety::new(device, settings)?;
        let interaction = settings.interaction;
        let modes =
            interaction.map(|numbers| Modes::new(numbers, &capabilities, safety.limits(), &frame));
        Ok(Servo {
            safety,
            model,
            grid,
            frame,
            walls: settings.walls.then(|| Walls::of_workspace(capabilities.workspace)),
            modes,
            passivity: Passivity::new(declared_damping(&capabilities), capabilities.delay_ticks),
            last_goal: None,
            last_proxy: origin,
            unseen: 0.0,
            latest: TickRecord::at_rest(frame.terrain(&origin), frame.window()),
            totals: Totals::default(),
            fault: None,
        })
    }

    /// Reads the hand, moves the proxy and sends the force, which acts for `dt` seconds. `time` is
    /// in seconds on the session's clock.
    ///
    /// After a fault it sends zero force and reports the last hand and proxy.
    pub fn tick(&mut self, time: f64, dt: f64) -> TickRecord {
        self.totals.ticks += 1;
        self.latest = TickRecord {
            tick: self.totals.ticks,
            time,
            force: [0.0; 3],
            vertices: 0,
            faces: 0,
            collision_tests: 0,
            cells: 0,
            ..self.latest
        };
        if self.fault.is_some() {
            self.release();
        } else if let Err(fault) = self.exchange(time, dt) {
            self.fail(fault);
        }
        self.latest.mode = self.mode();
        self.latest.window = self.frame.window();
        self.latest
    }

    /// The tick as it is while nothing is wrong.
    fn exchange(&mut self, time: f64, dt: f64) -> Result<(), Fault> {
        let wanted = match self.safety.read(time, dt)? {
            Reading::Hand { pose, followed } => self.answer(&pose, followed, dt),
            Reading::Nothing => {
                self.unseen += dt;
                Force::ZERO
            }
        };
        // Asked after the update: it is in the update that a cut file is noticed.
        if self.grid.damaged() {
            return Err(Fault::GridDamaged);
        }
        self.latest.force = self.safety.send(wanted, time, dt)?.newtons;
        self.passivity.sent(self.latest.force);
        Ok(())
    }

    /// The force that a pose asks for, `dt` seconds after the last one; `followed` says whether the
    /// hand came here as hands do.
    fn answer(&mut self, pose: &Pose, followed: bool, dt: f64) -> Force {
        let since = dt + std::mem::take(&mut self.unseen);
        let inside = self.walls.map_or(pose.position, |walls| walls.inside(pose.position));
        let goal = self.frame.goal(inside);
        if self.safety.is_on(Stage::Finite) && !goal.is_finite() {
            return self.distrust();
        }
        // The proxy begins at the hand: no force at first, even where the hand is in the ground.
        let before = self.last_goal.filter(|_| followed);
        if before.is_none() && self.safety.is_on(Stage::Engage) {
            self.engage(goal);
        }
        let is_at_wall = self.walls.is_some_and(|walls| !walls.hold(pose.position));
        let hand = Hand { pose, inside, is_at_wall, dt: since };
        if let Some(hold) = self.steer(&hand) {
            let goal = self.frame.goal(inside);
            self.last_goal = Some(goal);
            return self.hold(pose, &goal, &hold, dt);
        }
        // A surface that drifts takes the goal over other ground.
        let goal = if self.modes.is_some() { self.frame.goal(inside) } else { goal };
        if let Some(before) = before {
            self.totals.goal_cells += ground_cells(&before, &goal);
        }
        self.last_goal = Some(goal);
        self.touch(pose, &goal, dt)
    }

    /// Lets the modes look at the hand, and move the window. `None` where contact is felt.
    fn steer(&mut self, hand: &Hand<'_>) -> Option<Hold> {
        let modes = self.modes.as_mut()?;
        let proxy = (self.latest.feature != Feature::Free).then_some(self.last_proxy);
        if let Some(changed) = modes.look(hand, &self.frame, &self.grid, proxy) {
            self.safety.hand_over();
            if changed == Changed::BeginsAtHand {
                self.model.place(self.frame.goal(hand.inside));
            }
        }
        self.totals.mode_changes = modes.changes();
        modes.step(hand, &mut self.frame, self.safety.stiffness())
    }

    /// The force of contact.
    fn touch(&mut self, pose: &Pose, goal: &GridPoint, dt: f64) -> Force {
        let contact = self.model.update(&self.grid, self.frame.metric(), goal);
        if self.safety.is_on(Stage::Finite) && !contact.proxy.is_finite() {
            return self.distrust_model(pose, goal);
        }
        self.last_proxy = contact.proxy;
        self.count(&contact);
        self.report(pose, goal, &contact);
        let stretch = self.stretch(pose, goal, &contact);
        if let Some(modes) = &mut self.modes {
            let force = self.safety.clamped(spring(self.safety.stiffness(), stretch));
            self.passivity.expect(0.0, modes.pay(force.newtons));
        }
        self.pull(pose, stretch, [0.0; 3], dt)
    }

    /// The force of a mode that holds the hand.
    fn hold(&mut self, pose: &Pose, goal: &GridPoint, hold: &Hold, dt: f64) -> Force {
        self.report_hand(pose, goal);
        if self.mode() == Mode::Zoom {
            self.report_free();
            self.last_proxy = *goal;
        }
        let mut stretch = hold.stretch;
        if let Some(walls) = self.walls.filter(|_| hold.has_walls) {
            for (part, of_walls) in stretch.iter_mut().zip(walls.push(pose.position, None)) {
                *part += of_walls;
            }
        }
        self.passivity.expect(hold.kept, 0.0);
        self.pull(pose, stretch, hold.beside, dt)
    }

    fn engage(&mut self, goal: GridPoint) {
        self.model.place(goal);
        self.safety.engage();
        self.passivity.begin();
        self.end_mode();
        self.latest.feature = Feature::Free;
        self.latest.normal = [0.0; 3];
    }

    /// Back to normal mode, over a surface at rest.
    fn end_mode(&mut self) {
        if let Some(modes) = &mut self.modes {
            modes.begin();
            self.totals.mode_changes = modes.changes();
        }
    }

    /// The spring from the hand to where it shall be, and newtons `beside` it, under the eyes of the
    /// passivity observer, which may add damping to it.
    fn pull(&mut self, pose: &Pose, stretch: [f64; 3], beside: [f64; 3], dt: f64) -> Force {
        let stiffness = self.safety.stiffness();
        let mut force = spring(stiffness, stretch);
        for (newtons, more) in force.newtons.iter_mut().zip(beside) {
            *newtons += more;
        }
        if !force.is_finite() {
            // No energy to keep account of: the safety chain lets none of it through.
            return force;
        }
        let clamped = self.safety.clamped(force);
        let coupling = Coupling {
            hand: pose.position,
            force: clamped.newtons,
            stretch: stretch[0].hypot(stretch[1]).hypot(stretch[2]),
            stiffness,
            dt,
        };
        let newtons = self.passivity.tick(&coupling);
        self.totals.active_ticks = self.passivity.active_ticks();
        // As it is, the chain shall cut and count it.
        if newtons == clamped.newtons { force } else { Force { newtons } }
    }

    /// From the hand to where it shall be, metres.
    fn stretch(&self, pose: &Pose, goal: &GridPoint, contact: &Contact) -> [f64; 3] {
        let in_contact = contact.feature != Feature::Free;
        let surface = in_contact.then(|| self.frame.displacement(goal, &contact.proxy));
        match self.walls {
            Some(walls) => walls.push(pose.position, surface),
            None => surface.unwrap_or([0.0; 3]),
        }
    }

    /// Something was not finite: no force, at once.
    fn distrust(&mut self) -> Force {
        self.safety.distrust();
        Force::ZERO
    }

    /// The model lost its proxy: no force, and it begins anew at the hand.
    fn distrust_model(&mut self, pose: &Pose, goal: &GridPoint) -> Force {
        self.last_goal = None;
        self.report_hand(pose, goal);
        self.report_free();
        self.distrust()
    }

    fn count(&mut self, contact: &Contact) {
        let counters = &contact.counters;
        let totals = &mut self.totals;
        totals.contact_ticks += u64::from(contact.feature != Feature::Free);
        totals.vertices += u64::from(counters.vertices);
        totals.faces += u64::from(counters.faces);
        totals.collision_tests += u64::from(counters.collision_tests);
        totals.cells += u64::from(counters.cells);
        totals.far_edge_crossings += u64::from(counters.far_edge_crossings);
        totals.far_edge_loops += u64::from(counters.far_edge_loops);
        totals.cycles_ended += u64::from(counters.cycles_ended);
        totals.unfinished += u64::from(counters.steps_left > 0);
    }

    fn report_hand(&mut self, pose: &Pose, goal: &GridPoint) {
        let is_key_down = self.modes.as_ref().is_some_and(Modes::is_key_down);
        self.latest.hand = pose.position;
        self.latest.goal = self.frame.terrain(goal);
        self.latest.buttons = pose.buttons | if is_key_down { STYLUS } else { 0 };
        self.latest.twist = pose.twist;
    }

    /// Nothing is touched.
    fn report_free(&mut self) {
        self.latest.proxy = self.latest.goal;
        self.latest.feature = Feature::Free;
        self.latest.normal = [0.0; 3];
    }

    fn report(&mut self, pose: &Pose, goal: &GridPoint, contact: &Contact) {
        self.report_hand(pose, goal);
        self.latest.proxy = self.frame.terrain(&contact.proxy);
        self.latest.feature = contact.feature;
        self.latest.normal = match contact.feature {
            Feature::Free => [0.0; 3],
            _ => self.frame.turned(contact.normal()),
        };
        self.latest.vertices = contact.counters.vertices;
        self.latest.faces = contact.counters.faces;
        self.latest.collision_tests = contact.counters.collision_tests;
        self.latest.cells = contact.counters.cells;
    }

    /// Ends touch: zero force now and in every tick to come. The first fault is kept.
    pub fn fail(&mut self, fault: Fault) {
        self.fault.get_or_insert(fault);
        self.release();
    }

    /// Sends zero force, and has the proxy placed at the hand in the next tick.
    pub fn release(&mut self) {
        self.last_goal = None;
        self.latest.force = [0.0; 3];
        self.end_mode();
        self.safety.release();
    }

    /// Lays the workspace elsewhere. The hand then lies over other ground, so the proxy begins anew
    /// at the hand, in normal mode; the same window again changes nothing.
    pub fn set_frame(&mut self, frame: Frame) {
        if frame.window() != self.frame.window() {
            self.frame = frame;
            self.last_goal = None;
        }
    }

    /// Where the workspace lies now.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// What the hand's motion does.
    pub fn mode(&self) -> Mode {
        self.modes.as_ref().map_or(Mode::Normal, Modes::mode)
    }

    /// Changes the mode from the next tick on, whatever the button says; nothing without modes.
    pub fn set_mode(&mut self, mode: Mode) {
        if let Some(modes) = &mut self.modes {
            modes.force(mode);
        }
    }

    /// A key that is the stylus button; nothing without modes.
    pub fn press(&mut self, is_down: bool) {
        if let Some(modes) = &mut self.modes {
            modes.press(is_down);
        }
    }

    /// How far a simulated handle shall be turned, radians.
    pub fn set_twist(&mut self, radians: f64) {
        self.safety.set_twist(radians);
    }

    /// Lets another contact model go on from where the proxy is, the force changing no faster than
    /// its slew limit. Gives back the one before, for a tick must free nothing.
    pub fn set_model(&mut self, mut model: Box<dyn ContactModel>) -> Box<dyn ContactModel> {
        model.take_over(self.model.proxy());
        self.safety.hand_over();
        std::mem::replace(&mut self.model, model)
    }

    /// Walls around the hand, or none, from the next tick on, the force changing no faster than its
    /// slew limit.
    pub fn set_walls(&mut self, walls: Option<Walls>) {
        self.safety.hand_over();
        self.walls = walls;
    }

    /// Whether damping is added when the passivity observer finds that the spring gives more energy
    /// than it took (Hannaford and Ryu, 2002). Off at first.
    pub fn set_passivity_control(&mut self, controls: bool) {
        self.passivity.set_control(controls);
    }

    /// The device's own damping, N s/m, where it is known better than what the stiffness it declares
    /// says of it; the passivity observer counts on that much.
    pub fn set_device_damping(&mut self, damping: f64) {
        self.passivity.set_damping(damping);
    }

    /// Where a simulated hand shall go (workspace metres).
    pub fn set_target(&mut self, target: [f64; 3]) {
        self.safety.set_target(target);
    }

    /// Deadlines passed without a tick.
    pub(crate) fn miss(&mut self, ticks: u64) {
        self.safety.miss(ticks);
    }

    /// What every tick needs beside the servo itself.
    pub(crate) fn memory(&self) -> [Piece; 2] {
        [Piece::of(&*self.model), self.safety.memory()]
    }

    /// What the device can do.
    pub fn capabilities(&self) -> Capabilities {
        self.safety.capabilities()
    }

    /// From now on there shall be no force while `heartbeat` stands still for longer than so many
    /// seconds; `None` ends that.
    pub(crate) fn watch_host(&mut self, heartbeat: Option<(Arc<Heartbeat>, f64)>) {
        self.safety.watch_host(heartbeat);
    }

    /// Takes a stage out of the safety chain.
    #[cfg(feature = "test-hooks")]
    pub(crate) fn switch_off(&mut self, stage: Stage) {
        self.safety.switch_off(stage);
    }

    /// What holds, after the device's limits.
    pub fn limits(&self) -> &Limits {
        self.safety.limits()
    }

    /// Why the force is away, or not yet wholly back.
    pub fn held(&self) -> Option<Held> {
        self.safety.held()
    }

    /// The name of the contact model in charge.
    pub fn model(&self) -> &'static str {
        self.model.name()
    }

    /// The newest tick.
    pub fn latest(&self) -> &TickRecord {
        &self.latest
    }

    /// Counts so far; missed and dropped ticks are not seen from here.
    pub fn totals(&self) -> Totals {
        Totals { trips: *self.safety.trips(), ..self.totals }
    }

    /// Why touch ended, if it did.
    pub fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }
}
