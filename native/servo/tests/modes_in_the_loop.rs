//! Every mode with a hand in the loop: it comes to rest at the default stiffness.

mod common;

use common::*;
use devices::{Grip, Hand, Mechanism, SimulatedDevice};
use servo::{Frame, Interaction, Mode, Servo, Settings};

/// Metres in a count of the encoder.
const COUNT: f64 = 1e-5;

/// Counts between which a hand that rests may tremble: what a spring on counts does.
const TREMBLE: f64 = 3.0;

struct Loop {
    servo: Servo,
    ticks: u64,
}

impl Loop {
    /// A hand 1 cm above flat ground, on a device of 0.1 kg with 2 N s/m of its own.
    fn new(grip: Grip, delay_ticks: u32) -> Loop {
        let hand = Hand { target: [0.0, 0.0, 0.01], max_force: 20.0, ..grip.hand() };
        let mechanism = Mechanism {
            mass: 0.1,
            damping: 2.0,
            metres_per_count: COUNT,
            delay_ticks,
            // What its own damping lets it show, half of 2 b / T.
            max_stiffness: Some(2000.0),
        };
        let device = SimulatedDevice::held(hand, mechanism).unwrap();
        let ground = flat_ground();
        let frame = Frame::new(window(), 0.16, ground.layout()).unwrap();
        let interaction = Some(Interaction::default());
        let settings =
            Settings { max_force: 20.0, walls: true, interaction, ..Settings::default() };
        let servo = Servo::new(Box::new(device), proxy_graph(), ground, frame, &settings).unwrap();
        let mut this = Loop { servo, ticks: 0 };
        this.run(1000);
        this
    }

    /// Metres from end to end, in each axis, over so many ticks.
    fn run(&mut self, ticks: u64) -> f64 {
        let mut ends = [[f64::MAX, f64::MIN]; 3];
        for _ in 0..ticks {
            self.ticks += 1;
            let hand = self.servo.tick(self.ticks as f64 * 1e-3, 1e-3).hand;
            for ([low, high], metres) in ends.iter_mut().zip(hand) {
                (*low, *high) = (low.min(metres), high.max(metres));
            }
        }
        ends.iter().map(|[low, high]| high - low).fold(0.0, f64::max)
    }

    fn pull(&mut self, target: [f64; 3]) {
        self.servo.set_target(target);
    }

    /// Pulled elsewhere with a mode on, it must come to rest, and let go too.
    fn settles(&mut self, mode: Mode, aims: &[[f64; 3]], words: &str) {
        self.servo.press(true);
        for aim in aims {
            self.pull(*aim);
            self.run(1);
            assert_eq!(self.servo.mode(), mode, "{words}");
            self.run(6000);
            let swing = self.run(1000);
            assert!(swing <= TREMBLE * COUNT, "{words}, {mode:?} to {aim:?}: {swing} m");
        }
        self.servo.press(false);
        self.run(6000);
        let swing = self.run(1000);
        assert!(swing <= TREMBLE * COUNT, "{words}, after {mode:?}: {swing} m");
    }
}

fn everyone(try_it: impl Fn(&mut Loop, &str)) {
    for grip in Grip::ALL {
        for delay in [0, 1] {
            try_it(&mut Loop::new(grip, delay), &format!("{}, {delay} late", grip.name()));
        }
    }
}

#[test]
fn a_pan_comes_to_rest_also_at_walls() {
    everyone(|rig, words| {
        rig.pull([0.0, 0.0, -0.02]);
        rig.run(2000);
        let aims = [[0.03, 0.01, -0.02], [0.12, 0.0, -0.02], [0.11, 0.1, 0.02], [0.0, 0.0, -0.02]];
        rig.settles(Mode::Pan, &aims, words);
    });
}

#[test]
fn a_zoom_comes_to_rest_also_at_its_limits_and_between_detents() {
    everyone(|rig, words| {
        let aims = [
            [0.01, 0.0, 0.02],
            [0.0, 0.0, 0.0153],
            [0.0, 0.0, 0.0201],
            [-0.01, 0.02, 0.12],
            [0.0, 0.0, -0.12],
        ];
        rig.settles(Mode::Zoom, &aims, words);
    });
}

#[test]
fn a_stable_mode_is_never_active_for_long() {
    everyone(|rig, words| {
        rig.pull([0.0, 0.0, -0.02]);
        rig.run(2000);
        let before = rig.servo.totals().active_ticks;
        rig.settles(Mode::Pan, &[[0.03, 0.01, -0.02], [0.0, 0.0, -0.02]], words);
        let active = rig.servo.totals().active_ticks - before;
        println!("{words}: {active} active ticks of 21000");
        assert!(active < 210, "{words}: {active} ticks");
    });
}
