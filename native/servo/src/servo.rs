//! One tick: hand, goal, proxy, force.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use contact::{Contact, ContactModel, Feature};
use devices::{Capabilities, Device, Force, ParameterError, Pose};
use surface::{Grid, GridPoint};

use crate::force::{SlewLimit, declared_damping, limited, spring, stable_stiffness};
use crate::frame::ground_cells;
use crate::passivity::{Coupling, Passivity};
use crate::{Fault, Frame, TickRecord, Totals, Walls};

/// A device, a contact model and a grid, joined by a spring from the hand to the proxy.
///
/// The force passes through the same gates in every tick: finite or zero, never above the limit,
/// changing no faster than its slew limit after a switch of models, zero for ever after a fault,
/// zero when the servo is dropped.
pub struct Servo {
    device: Box<dyn Device>,
    model: Box<dyn ContactModel>,
    grid: Arc<Grid>,
    frame: Frame,
    /// N/m.
    stiffness: f64,
    /// N.
    max_force: f64,
    /// Engaged when another contact model takes over.
    slew: SlewLimit,
    /// None until they are asked for.
    walls: Option<Walls>,
    /// Watches the energy of the spring.
    passivity: Passivity,
    /// The goal of the last tick. `None` while the proxy has still to be placed at the hand.
    last_goal: Option<GridPoint>,
    latest: TickRecord,
    totals: Totals,
    fault: Option<Fault>,
}

impl Servo {
    /// Joins them. `stiffness` (N/m) and `max_force` (N), both checked by
    /// [`Settings`](crate::Settings), are cut to what the device can show.
    pub fn new(
        device: Box<dyn Device>,
        model: Box<dyn ContactModel>,
        grid: Arc<Grid>,
        frame: Frame,
        stiffness: f64,
        max_force: f64,
    ) -> Result<Servo, ParameterError> {
        let capabilities = device.capabilities();
        capabilities.validate()?;
        let origin = frame.terrain(&frame.goal([0.0; 3]));
        let max_force = max_force.min(capabilities.max_force);
        Ok(Servo {
            device,
            model,
            grid,
            frame,
            stiffness: stable_stiffness(stiffness, &capabilities),
            max_force,
            slew: SlewLimit::new(max_force),
            walls: None,
            passivity: Passivity::new(declared_damping(&capabilities), capabilities.delay_ticks),
            last_goal: None,
            latest: TickRecord::at_rest(origin),
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
        self.latest
    }

    /// The tick as it is while nothing is wrong.
    fn exchange(&mut self, time: f64, dt: f64) -> Result<(), Fault> {
        let pose = self.device.read(time)?;
        let force = self.answer(&pose, dt);
        // Asked after the update: it is in the update that a cut file is noticed.
        if self.grid.damaged() {
            return Err(Fault::GridDamaged);
        }
        self.device.write(force, dt)?;
        self.latest.force = force.newtons;
        self.passivity.sent(force.newtons);
        Ok(())
    }

    /// The force for a pose, `dt` seconds after the last one.
    fn answer(&mut self, pose: &Pose, dt: f64) -> Force {
        let inside = self.walls.map_or(pose.position, |walls| walls.inside(pose.position));
        let goal = self.frame.goal(inside);
        if !(pose.is_finite() && goal.is_finite()) {
            return self.distrust();
        }
        // The proxy begins at the hand: no force at first, even where the hand is in the ground.
        match self.last_goal {
            None => {
                self.model.place(goal);
                // There is no force to go on from.
                self.slew.disengage();
                self.passivity.begin();
            }
            Some(before) => self.totals.goal_cells += ground_cells(&before, &goal),
        }
        self.last_goal = Some(goal);

        let contact = self.model.update(&self.grid, self.frame.metric(), &goal);
        if !contact.proxy.is_finite() {
            return self.distrust_model(pose, &goal);
        }
        self.count(&contact);
        self.report(pose, &goal, &contact);
        let wanted = self.pull(pose, &goal, &contact, dt);
        self.slew.limited(wanted, dt)
    }

    /// The spring from the hand to the proxy, through the gates.
    fn pull(&mut self, pose: &Pose, goal: &GridPoint, contact: &Contact, dt: f64) -> Force {
        let stretch = self.stretch(pose, goal, contact);
        let force = spring(self.stiffness, stretch);
        if !force.is_finite() {
            return self.distrust();
        }
        let (force, was_cut) = limited(force, self.max_force);
        self.totals.clamped += u64::from(was_cut);
        self.watched(pose, force, stretch, dt)
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

    /// The force under the eyes of the passivity observer, which may add damping to it.
    fn watched(&mut self, pose: &Pose, force: Force, stretch: [f64; 3], dt: f64) -> Force {
        let coupling = Coupling {
            hand: pose.position,
            force: force.newtons,
            stretch: stretch[0].hypot(stretch[1]).hypot(stretch[2]),
            stiffness: self.stiffness,
            dt,
        };
        let newtons = self.passivity.tick(&coupling);
        self.totals.active_ticks = self.passivity.active_ticks();
        limited(Force { newtons }, self.max_force).0
    }

    /// Something was not finite: no force, at once.
    fn distrust(&mut self) -> Force {
        self.totals.not_finite += 1;
        self.slew.disengage();
        Force::ZERO
    }

    /// The model lost its proxy: no force, and it begins anew at the hand.
    fn distrust_model(&mut self, pose: &Pose, goal: &GridPoint) -> Force {
        self.last_goal = None;
        self.latest.hand = pose.position;
        self.latest.goal = self.frame.terrain(goal);
        self.latest.proxy = self.latest.goal;
        self.latest.feature = Feature::Free;
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

    fn report(&mut self, pose: &Pose, goal: &GridPoint, contact: &Contact) {
        self.latest.hand = pose.position;
        self.latest.goal = self.frame.terrain(goal);
        self.latest.proxy = self.frame.terrain(&contact.proxy);
        self.latest.feature = contact.feature;
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
        // An error here changes nothing: there is no more that could be done for the hand.
        let _ = self.device.write(Force::ZERO, 0.0);
    }

    /// Lays the workspace elsewhere. The hand then lies over other ground, so the proxy begins anew
    /// at the hand; the same window again changes nothing.
    pub fn set_frame(&mut self, frame: Frame) {
        if frame.window() != self.frame.window() {
            self.frame = frame;
            self.last_goal = None;
        }
    }

    /// Lets another contact model go on from where the proxy is, the force changing no faster than
    /// its slew limit. Gives back the one before, for a tick must free nothing.
    pub fn set_model(&mut self, mut model: Box<dyn ContactModel>) -> Box<dyn ContactModel> {
        model.take_over(self.model.proxy());
        self.slew.engage(Force { newtons: self.latest.force });
        std::mem::replace(&mut self.model, model)
    }

    /// Walls around the hand, or none, from the next tick on, the force changing no faster than its
    /// slew limit.
    pub fn set_walls(&mut self, walls: Option<Walls>) {
        self.slew.engage(Force { newtons: self.latest.force });
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
        self.device.set_target(target);
    }

    /// What the device can do.
    pub fn capabilities(&self) -> Capabilities {
        self.device.capabilities()
    }

    /// Of the spring, N/m, after the device's limit.
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// The largest force that is sent, N, after the device's limit.
    pub fn max_force(&self) -> f64 {
        self.max_force
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
    pub fn totals(&self) -> &Totals {
        &self.totals
    }

    /// Why touch ended, if it did.
    pub fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }
}

impl Drop for Servo {
    fn drop(&mut self) {
        // A driver that panics here would abort the process if another panic brought us here.
        let _ = catch_unwind(AssertUnwindSafe(|| self.release()));
    }
}
