//! Modes changed at random, with everything else going on: the force makes no step beyond its slew
//! limit, momentum never adds energy, and nothing is lost.

mod common;

use common::handheld::*;
use common::*;
use contact::Feature;
use devices::{DeviceError, Pose};
use servo::{Mode, Session, Stage, TickRecord, Window};

/// Changes of mode that are tried, at the least.
const CHANGES: u64 = 10_000;

/// Kilograms, as by default.
const PAN_MASS: f64 = 0.2;

/// N s/m, on a device that can show everything.
const PAN_DAMPING: f64 = 8.0;

/// Any deterministic numbers will do.
struct Random(u64);

impl Random {
    fn whole(&mut self, below: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % below
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.whole(1 << 24) as f64 / f64::from(1 << 24)
    }
}

/// A hand that heads for one place after another, in and above the ground and beyond the walls, with
/// up to 0.6 m/s.
struct Wanderer {
    random: Random,
    aim: [f64; 3],
    speed: f64,
    spin: f64,
}

impl Wanderer {
    fn move_on(&mut self, pose: &mut Pose) {
        if self.random.whole(150) == 0 {
            self.aim = [
                self.random.between(-0.09, 0.09),
                self.random.between(-0.07, 0.07),
                self.random.between(-0.07, 0.03),
            ];
            self.speed = self.random.between(0.0, 0.6);
            self.spin = self.random.between(-6.0, 6.0);
        }
        let way: [f64; 3] = std::array::from_fn(|axis| self.aim[axis] - pose.position[axis]);
        let metres = size(way);
        let share = if metres > 0.0 { (self.speed * TICK / metres).min(1.0) } else { 0.0 };
        for (place, part) in pose.position.iter_mut().zip(way) {
            *place += share * part;
        }
        pose.twist = pose.twist.map(|twist| twist + self.spin * TICK);
        if self.random.whole(25) == 0 {
            pose.buttons ^= 1;
        }
    }
}

fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Workspace metres that the surface moved by.
fn surface_way(before: &TickRecord, now: &TickRecord) -> f64 {
    let [east, north] =
        [now.window.east() - before.window.east(), now.window.north() - before.window.north()];
    east.hypot(north) * 0.16 / now.window.width()
}

/// Behind a wall of the workspace.
fn is_at_wall(hand: [f64; 3]) -> bool {
    hand[0].abs() > 0.072 || hand[1].abs() > 0.054
}

/// What a run came to.
#[derive(Default)]
struct Figures {
    /// Of the slew limit.
    force_step: f64,
    /// Of the slew limit of a change, in the ticks of changes.
    step_at_change: f64,
    /// How fast the force grows, of the slew limit.
    rise: f64,
    /// Newtons.
    largest: f64,
    /// Joules that a drift had beyond what it was let go with.
    energy_gain: f64,
    drift_ticks: u64,
    wall_touches: u64,
    zooms: u64,
    turns: u64,
    contacts: u64,
}

impl Figures {
    fn look(&mut self, before: &TickRecord, now: &TickRecord, drift: &mut Drifting) {
        let step = size(std::array::from_fn(|axis| now.force[axis] - before.force[axis]));
        let slew = 8.0 / 0.005 * TICK;
        self.force_step = self.force_step.max(step / slew);
        let more = size(now.force) - size(before.force);
        self.rise = self.rise.max(more * TICK / (slew * (now.time - before.time)));
        self.largest = self.largest.max(size(now.force));
        if now.mode != before.mode {
            self.step_at_change = self.step_at_change.max(step / (0.1 * slew));
        }
        self.wall_touches += u64::from(is_at_wall(now.hand) && !is_at_wall(before.hand));
        self.zooms += u64::from(now.window.width() != before.window.width());
        self.turns += u64::from(now.window.turn() != before.window.turn());
        self.contacts += u64::from(now.mode == Mode::Normal && now.feature != Feature::Free);
        let energy = drift.energy(before, now);
        if now.mode == Mode::Normal && before.mode == Mode::Normal {
            // What the window's metres of a planet, and the time between two ticks, round.
            let rounding = 1e-9 * drift.let_go_with + 1e-15;
            self.energy_gain = self.energy_gain.max(energy - drift.let_go_with - rounding);
            self.drift_ticks += u64::from(energy > 0.0);
        } else {
            drift.let_go_with = energy;
        }
    }
}

/// The surface's momentum, by what the window does.
#[derive(Default)]
struct Drifting {
    /// Joules.
    let_go_with: f64,
}

impl Drifting {
    fn energy(&self, before: &TickRecord, now: &TickRecord) -> f64 {
        if now.mode == Mode::Zoom || before.window.width() != now.window.width() {
            return 0.0;
        }
        let speed = surface_way(before, now) / TICK;
        0.5 * PAN_MASS * speed * speed
    }
}

fn wander(
    seed: u64,
    changes: u64,
    mut disturb: impl FnMut(&mut Random, &mut Session, &Shared),
) -> Figures {
    let hills = ground(|column, row| {
        (f64::from(column) * 0.7).sin() * 0.3
            + f64::from((column * 7919 + row * 104_729) % 17) / 40.0
    });
    let mut play = Play::on(hills, window(), settings());
    let random = Random(seed);
    let mut hand = Wanderer { random, aim: [0.0; 3], speed: 0.1, spin: 0.0 };
    let mut figures = Figures::default();
    let mut drift = Drifting::default();
    let mut before = None;
    while play.session.statistics().totals.mode_changes < changes {
        for _ in 0..1000 {
            hand.move_on(&mut play.device.lock().pose);
            disturb(&mut hand.random, &mut play.session, &play.device);
            play.rest(1);
        }
        for record in play.session.drain() {
            for number in record.force.iter().chain(&record.goal).chain(&record.proxy) {
                assert!(number.is_finite(), "{record:?}");
            }
            if let Some(before) = before.replace(record) {
                figures.look(&before, &record, &mut drift);
            }
        }
    }
    figures
}

#[test]
fn ten_thousand_changes_make_no_step_and_no_energy() {
    let figures = wander(7, CHANGES, |_, _, _| {});
    println!(
        "force_step_over_slew_limit_max {}, at a change {} of the slower limit, pan_drift_energy_gain {} J, \
         {} ticks of drift, {} walls, {} zooms, {} turns, {} contacts",
        figures.force_step,
        figures.step_at_change,
        figures.energy_gain,
        figures.drift_ticks,
        figures.wall_touches,
        figures.zooms,
        figures.turns,
        figures.contacts
    );
    assert!(figures.force_step <= 1.0 + 1e-9, "{} of the slew limit", figures.force_step);
    assert!(figures.step_at_change <= 1.0 + 1e-9, "{}", figures.step_at_change);
    assert!(figures.energy_gain <= 0.0, "{} J", figures.energy_gain);
    // All of it was there.
    for count in [
        figures.drift_ticks,
        10 * figures.wall_touches,
        figures.zooms,
        figures.turns,
        figures.contacts,
    ] {
        assert!(count > 1000, "{count}");
    }
}

/// What makes no step without the slew limit needs none. Grabs only, between walls: what is let go with
/// a force jumps to none without it, and behind a wall pan does not mix as normal mode does.
#[test]
fn grabs_make_no_step_of_their_own() {
    let mut largest = 0.0f64;
    let mut grabs = 0;
    for seed in 0..20 {
        let mut play = Play::new();
        play.session.switch_off(Stage::Slew);
        let mut hand = Wanderer { random: Random(seed), aim: [0.0; 3], speed: 0.1, spin: 0.0 };
        for _ in 0..20_000 {
            hand.move_on(&mut play.device.lock().pose);
            play.rest(1);
        }
        for trio in play.session.drain().windows(3) {
            let (before, now) = (&trio[1], &trio[2]);
            let is_grab = before.mode == Mode::Normal && now.mode == Mode::Pan;
            if is_grab && !is_at_wall(before.hand) && !is_at_wall(now.hand) {
                grabs += 1;
                let apart = |one: [f64; 3], other: [f64; 3]| {
                    size(std::array::from_fn(|axis| one[axis] - other[axis]))
                };
                let change = apart(now.force, before.force);
                let moved = apart(now.hand, before.hand);
                let slid = surface_way(&trio[0], before);
                // The spring's share of the hand's way, and the damper's of how fast they meet.
                let expected = STIFFNESS * moved + PAN_DAMPING * (moved + slid) / TICK;
                largest = largest.max(change - expected);
            }
        }
    }
    assert!(grabs > 100, "{grabs}");
    assert!(largest < 0.1, "{largest} N");
}

#[test]
fn windows_models_scripts_errors_and_stalls_in_between_do_no_harm() {
    let mut disturbances = 0u64;
    let mut lasts = 0;
    let figures = wander(11, 2000, |random, session, device| {
        if lasts > 0 {
            lasts -= 1;
            if lasts == 0 {
                let mut script = device.lock();
                script.error = None;
                if !script.pose.is_finite() {
                    script.pose = Pose { twist: Some(0.0), ..Pose::at([0.0, 0.0, 0.02]) };
                }
            }
            return;
        }
        if random.whole(400) != 0 {
            return;
        }
        disturbances += 1;
        match random.whole(9) {
            0 | 1 => session.set_mode(Mode::ALL[random.whole(3) as usize]).unwrap(),
            2 => session.set_model(proxy_graph()).unwrap(),
            3 => session.stall(random.whole(200)),
            4 => session.press().unwrap(),
            5 => session.release().unwrap(),
            6 => {
                lasts = 2;
                device.lock().error = Some(DeviceError::Timeout("no packet".into()));
            }
            7 => {
                lasts = 1 + random.whole(150);
                let axis = random.whole(4) as usize;
                let pose = &mut device.lock().pose;
                match axis {
                    3 => pose.twist = Some(f64::NAN),
                    axis => pose.position[axis] = f64::NAN,
                }
            }
            _ => {
                let window = session.window();
                let width = random.between(2.0, 100.0);
                let up = random.between(-1.0, 1.0);
                let other = Window::new(random.between(0.0, 64.0), window.north(), up, width, 1.5);
                let turned = other.unwrap().turned(random.between(-4.0, 4.0));
                session.set_window(turned.unwrap()).unwrap();
            }
        }
    });
    assert!(disturbances > 300, "{disturbances}");
    assert!(figures.contacts > 1000 && figures.drift_ticks > 100);
    // What is taken away at once is no step; a rise is limited whatever happens.
    assert!(figures.rise <= 1.0 + 1e-9, "{} of the slew limit", figures.rise);
    assert!(figures.largest <= 8.0 * (1.0 + 1e-9), "{} N", figures.largest);
}

/// From a pebble to a planet, at seams, edges and poles, and where the window lies far beside the map.
#[test]
fn modes_work_at_every_scale_and_every_edge() {
    for scale in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
        for wraps in [false, true] {
            for place in [[0.0, 0.0], [63.0, 0.0], [0.0, -63.0], [31.0, -63.0], [200.0, 300.0]] {
                let layout = surface::GridLayout::packed(
                    64,
                    64,
                    scale,
                    scale,
                    surface::SampleType::F64,
                    surface::ByteOrder::Little,
                );
                let layout = layout.unwrap().with_wrap(wraps);
                let bumps = |index: u32| f64::from((index * 7919) % 17) / 40.0 * scale;
                let bytes = (0..64 * 64).flat_map(|index| bumps(index).to_le_bytes()).collect();
                let grid = std::sync::Arc::new(surface::Grid::from_vec(bytes, layout).unwrap());
                let [east, north] = place.map(|cells: f64| cells * scale);
                let window = Window::new(east, north, 0.0, 16.0 * scale, 1.0).unwrap();
                let mut play = Play::on(grid, window, settings());
                let mut hand = Wanderer { random: Random(5), aim: [0.0; 3], speed: 0.1, spin: 0.0 };
                for _ in 0..3000 {
                    hand.move_on(&mut play.device.lock().pose);
                    play.rest(1);
                }
                let widths = [4.0 * scale, 128.0 * scale];
                for record in play.session.drain() {
                    let window = record.window;
                    let numbers = [window.east(), window.north(), window.up(), window.turn()];
                    assert!(numbers.iter().chain(&record.force).all(|number| number.is_finite()));
                    let rounding = 1e-12 * scale;
                    assert!(
                        window.width() >= widths[0] - rounding
                            && window.width() <= widths[1] + rounding
                    );
                }
                assert!(play.session.statistics().totals.mode_changes > 50);
            }
        }
    }
}
