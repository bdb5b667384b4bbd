//! Modes of interaction: what brings them, what they do to window and hand, and what they end with.

mod common;

use std::f64::consts::FRAC_PI_2;

use common::handheld::*;
use common::*;
use contact::Feature;
use devices::DeviceError;
use servo::{Interaction, Mode, SessionError, Settings, Stage, TickRecord, Window};

/// Workspace metres of a metre of terrain under `common::window`.
const SCALE: f64 = 0.01;

/// Of a force up to 8 N that may swing fully in 50 ms, in a tick: what a change of mode may change.
const SLOW_SLEW: f64 = 8.0 / 0.05 * TICK;

fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    size(std::array::from_fn(|axis| one[axis] - other[axis]))
}

fn largest_step(records: &[TickRecord]) -> f64 {
    records.windows(2).map(|pair| apart(pair[0].force, pair[1].force)).fold(0.0, f64::max)
}

/// Metres a second of the surface in the workspace, to the right, by the window's motion.
fn speed_right(before: &TickRecord, now: &TickRecord) -> f64 {
    -(now.window.east() - before.window.east()) * SCALE / TICK
}

#[test]
fn pressed_in_contact_it_pans_pressed_in_the_air_it_zooms_and_released_it_is_normal() {
    let mut play = Play::new();
    assert_eq!(play.session.state().mode, Mode::Normal);
    play.button(true);
    assert_eq!(play.session.state().mode, Mode::Zoom);
    play.button(false);
    assert_eq!(play.session.state().mode, Mode::Normal);
    play.go([0.0, 0.0, -0.005], 100);
    play.button(true);
    assert_eq!(play.session.state().mode, Mode::Pan);
    play.button(false);
    assert_eq!(play.session.state().mode, Mode::Normal);
    assert_eq!(play.session.statistics().totals.mode_changes, 4);
}

#[test]
fn a_key_and_a_script_do_as_the_button() {
    let mut play = Play::new();
    play.session.press().unwrap();
    play.rest(1);
    assert_eq!(play.session.state().mode, Mode::Zoom);
    play.session.release().unwrap();
    play.rest(1);
    assert_eq!(play.session.state().mode, Mode::Normal);
    play.session.set_mode(Mode::Pan).unwrap();
    play.rest(5);
    assert_eq!(play.session.state().mode, Mode::Pan, "also in the air");
    play.session.set_mode(Mode::Normal).unwrap();
    play.rest(1);
    assert_eq!(play.session.state().mode, Mode::Normal);
}

#[test]
fn without_modes_buttons_change_nothing_and_asking_is_refused() {
    let play = |buttons| {
        let settings = Settings { interaction: None, ..settings() };
        let mut play = Play::on(flat_ground(), window(), settings);
        play.device.lock().pose.buttons = buttons;
        play.go([0.01, 0.0, -0.005], 100);
        play
    };
    let (mut without, mut with) = (play(0), play(1));
    let unpressed = |mut records: Vec<TickRecord>| {
        records.iter_mut().for_each(|record| record.buttons = 0);
        records
    };
    assert_eq!(without.session.drain(), unpressed(with.session.drain()));
    for refused in [with.session.press(), with.session.release(), with.session.set_mode(Mode::Zoom)]
    {
        assert!(matches!(refused, Err(SessionError::WithoutModes)));
    }
}

#[test]
fn while_no_button_is_pressed_modes_change_no_bit() {
    let forces = |interaction| {
        let settings = Settings { interaction, ..settings() };
        let bumps = ground(|column, row| 0.2 * f64::from((column * 7 + row * 5) % 3));
        let mut play = Play::on(bumps, window(), settings);
        play.go([0.03, 0.02, -0.005], 300);
        play.go([-0.09, -0.02, -0.003], 500);
        play.session.drain().iter().map(|tick| (tick.force, tick.proxy)).collect::<Vec<_>>()
    };
    assert_eq!(forces(None), forces(Some(Interaction::default())));
}

#[test]
fn the_grabbed_point_stays_in_the_terrain_and_follows_the_hand() {
    let mut play = Play::touching();
    let grabbed = play.session.state().proxy;
    play.button(true);
    play.go([0.02, -0.01, -0.005], 200);
    play.rest(1500);
    let state = play.session.state();
    assert_eq!(state.proxy, grabbed, "the terrain does not move");
    assert!(state.in_contact());
    // The hand is over what it grabbed, so the window lies 2 m west and 1 m north of where it lay.
    assert!(apart([state.goal[0], state.goal[1], 0.0], grabbed) < 1e-3 / SCALE);
    let window = state.window;
    assert!((window.east() - 30.0).abs() < 0.1 && (window.north() + 31.0).abs() < 0.1);
    assert_eq!((window.width(), window.turn()), (16.0, 0.0));
    assert!(window.up().abs() < 1e-12, "{}", window.up());
    assert_eq!(play.session.window(), window);
}

#[test]
fn panning_holds_the_height_up_and_down() {
    let mut play = Play::touching();
    play.button(true);
    for height in [-0.009, 0.004] {
        play.go([0.0, 0.0, height], 100);
        play.rest(RAMPED);
        assert!((play.force()[2] + height * STIFFNESS).abs() < 1e-9, "{:?}", play.force());
    }
}

/// On a slope, where the surface pushes sideways too.
#[test]
fn grabbing_takes_over_the_force_that_acts() {
    let slope = ground(|column, _| 0.4 * (32.0 - f64::from(column)));
    let mut play = Play::on(slope, window(), settings());
    play.session.switch_off(Stage::Slew);
    play.go([0.002, 0.0, -0.005], 100);
    play.rest(RAMPED);
    let before = play.force();
    assert!(before[0] > 0.5 && before[2] > 1.0, "{before:?}");
    play.button(true);
    assert_eq!(play.session.state().mode, Mode::Pan);
    // The mass begins to yield to that force, which its damper feels at once.
    assert!(apart(play.force(), before) < 0.06, "{:?} after {before:?}", play.force());
}

#[test]
fn a_held_surface_resists_changes_of_velocity_and_not_velocity() {
    let mut play = Play::touching();
    play.button(true);
    play.session.drain();
    play.go([0.05, 0.0, -0.005], 500);
    let forces: Vec<f64> = play.session.drain().iter().map(|tick| tick.force[0]).collect();
    // 0.1 m/s at once, then evenly: friction is 0.04 N.
    let first = forces[..100].iter().copied().fold(0.0, f64::min);
    assert!(first < -0.5, "{first} N when it is pushed off");
    let late = forces[400..].iter().map(|force| (force + 0.04).abs()).fold(0.0, f64::max);
    assert!(late < 0.02, "{late} N while it moves on");
    play.rest(100);
    let brake = play.session.drain().iter().map(|tick| tick.force[0]).fold(0.0, f64::max);
    assert!(brake > 0.4, "{brake} N when it is stopped");
}

/// Pushes the surface to the right and lets it go.
fn thrown() -> Play {
    let mut play = Play::touching();
    play.button(true);
    play.go([0.03, 0.0, -0.005], 300);
    play.session.drain();
    play.button(false);
    play
}

#[test]
fn a_surface_let_go_in_motion_drifts_on_and_comes_to_a_stand() {
    let mut play = thrown();
    let let_go = play.session.window();
    play.go([0.03, 0.0, 0.02], 20);
    play.rest(4000);
    let records = play.session.drain();
    let made = (let_go.east() - play.session.window().east()) * SCALE;
    // 0.1 m/s for half a second.
    assert!((made - 0.05).abs() < 0.01, "{made} m");
    let speeds: Vec<f64> = records.windows(2).map(|pair| speed_right(&pair[0], &pair[1])).collect();
    assert!(speeds.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-6) + 1e-9));
    assert_eq!(speeds.last(), Some(&0.0));
}

#[test]
fn a_drifting_surface_is_felt_as_it_passes() {
    let bumps = ground(|column, _| 0.02 * f64::from(column % 2));
    let mut play = Play::on(bumps, window(), settings());
    play.go([0.0, 0.0, -0.005], 100);
    play.button(true);
    play.go([0.03, 0.0, -0.005], 300);
    play.button(false);
    play.rest(1000);
    let records = play.session.drain();
    let drifting = &records[records.len() - 990..];
    assert!(drifting.iter().all(|tick| tick.feature != Feature::Free));
    let heights: Vec<f64> = drifting.iter().map(|tick| tick.force[2]).collect();
    let (low, high) = heights
        .iter()
        .fold((f64::MAX, 0.0f64), |(low, high), force| (low.min(*force), high.max(*force)));
    assert!(high - low > 0.05, "from {low} N to {high} N");
}

#[test]
fn a_pressing_hand_brakes_a_drifting_surface() {
    let bumps = || ground(|column, _| 0.1 * f64::from(column % 2));
    let made = |height: f64| {
        let mut play = Play::on(bumps(), window(), settings());
        play.go([0.0, 0.0, -0.005], 100);
        play.button(true);
        play.go([0.03, 0.0, -0.005], 300);
        play.button(false);
        let let_go = play.session.window().east();
        play.go([0.03, 0.0, height], 20);
        play.rest(3000);
        (let_go - play.session.window().east()) * SCALE
    };
    let (free, pressed) = (made(0.03), made(-0.012));
    assert!(pressed < 0.8 * free, "{pressed} m of {free} m: the momentum paid for the work");
}

#[test]
fn a_wall_takes_the_momentum() {
    let mut play = Play::touching();
    play.button(true);
    // The wall is at 0.072 m.
    play.go([0.075, 0.0, -0.005], 500);
    play.rest(200);
    let force = play.force();
    assert!((force[0] + 0.003 * STIFFNESS).abs() < 1e-3, "the wall alone: {force:?}");
    let stopped = play.session.window();
    play.button(false);
    play.rest(500);
    assert_eq!(play.session.window(), stopped);

    let mut play = thrown();
    play.go([0.075, 0.0, 0.02], 90);
    let stopped = play.session.window();
    play.rest(500);
    assert_eq!(play.session.window(), stopped, "so does a wall that is touched while it drifts");
}

#[test]
fn a_surface_without_mass_adds_nothing_to_a_wall() {
    let mut play = Play::touching();
    play.session.switch_off(Stage::Slew);
    play.button(true);
    play.go([0.08, 0.0, -0.005], 400);
    for record in play.session.drain().windows(2) {
        let (moved, change) =
            (apart(record[0].hand, record[1].hand), record[1].force[0] - record[0].force[0]);
        if record[0].hand[0] > 0.072 {
            // What goes slack pushes less from tick to tick.
            assert!(change >= -STIFFNESS * moved * (1.0 + 1e-6), "{change} N for {moved} m");
        }
    }
}

#[test]
fn walls_keep_the_hand_in_the_workspace_and_can_be_left_out() {
    let pushed = |walls| {
        let mut play = Play::on(flat_ground(), window(), Settings { walls, ..settings() });
        play.go([0.076, -0.06, 0.02], 200);
        play.force()
    };
    let force = pushed(true);
    assert!(apart(force, [-0.004 * STIFFNESS, 0.006 * STIFFNESS, 0.0]) < 1e-9, "{force:?}");
    assert_eq!(pushed(false), [0.0; 3]);
}

#[test]
fn zooming_halves_the_window_every_two_centimetres_and_keeps_what_is_under_the_cursor() {
    let mut play = Play::new();
    play.go([0.03, 0.01, 0.01], 100);
    let under = play.session.state().goal;
    play.button(true);
    for (height, width) in [(0.03, 8.0), (0.04, 16.0 * 0.5f64.powf(1.5)), (-0.01, 32.0)] {
        play.go([0.03, 0.01, height], 100);
        let state = play.session.state();
        assert!((state.window.width() - width).abs() < 1e-9 * width, "{}", state.window.width());
        let aside = (state.goal[0] - under[0]).hypot(state.goal[1] - under[1]);
        assert!(aside < 1e-9, "{aside} m beside it");
    }
}

#[test]
fn zooming_holds_the_hand_in_its_place() {
    let mut play = Play::new();
    play.go([0.03, 0.01, 0.02], 100);
    play.button(true);
    play.go([0.034, 0.008, 0.02], 50);
    play.rest(RAMPED);
    let [x, y, _] = play.force();
    assert!((x + 0.004 * STIFFNESS).abs() < 1e-9 && (y - 0.002 * STIFFNESS).abs() < 1e-9);
}

#[test]
fn detents_lead_to_powers_of_two_of_the_whole_map() {
    // The map is 64 m wide, the window begins at a quarter of it.
    let mut play = Play::new();
    play.button(true);
    play.rest(RAMPED);
    assert_eq!(play.force(), [0.0; 3], "at a detent");
    for (height, expected) in
        [(0.0225, -0.2), (0.025, -0.4), (0.03, 0.0), (0.035, 0.4), (0.04, 0.0), (0.0425, -0.2)]
    {
        play.go([0.0, 0.0, height], 50);
        play.rest(RAMPED);
        let [x, y, z] = play.force();
        assert_eq!((x, y), (0.0, 0.0), "independent of what holds the hand");
        assert!((z - expected).abs() < 1e-9, "{z} N at {height} m, not {expected}");
    }
}

#[test]
fn the_limits_of_zoom_are_felt_as_walls() {
    let interaction =
        Interaction { zoom_widths: Some([8.0, 32.0]), detent_force: 0.0, ..Default::default() };
    let settings = Settings { interaction: Some(interaction), ..settings() };
    let mut play = Play::on(flat_ground(), window(), settings);
    play.button(true);
    for (height, width, force) in [
        (0.043, 8.0, -0.003),
        (0.04, 8.0, 0.0),
        (0.03, 8.0f64 * 0.5f64.powf(-0.5), 0.0),
        (-0.002, 32.0, 0.002),
        (0.0, 32.0, 0.0),
    ] {
        play.go([0.0, 0.0, height], 100);
        play.rest(RAMPED);
        let found = play.session.window().width();
        assert!((found - width).abs() < 1e-9, "{found} m at {height}");
        assert!((play.force()[2] - force * STIFFNESS).abs() < 1e-6, "{:?}", play.force());
    }
    play.go([0.0, 0.0, 0.045], 200);
    play.session.drain();
    play.button(false);
    play.rest(RAMPED);
    assert!(largest_step(&play.session.drain()) <= SLOW_SLEW * (1.0 + 1e-9));
    assert_eq!(play.force(), [0.0; 3]);
}

#[test]
fn a_window_beyond_the_limits_does_not_jump_when_zoom_begins() {
    let interaction = Interaction { zoom_widths: Some([2.0, 4.0]), ..Default::default() };
    let settings = Settings { interaction: Some(interaction), ..settings() };
    let mut play = Play::on(flat_ground(), window(), settings);
    play.button(true);
    assert!((play.session.window().width() - 16.0).abs() < 1e-9);
    play.go([0.0, 0.0, 0.06], 100);
    assert!((play.session.window().width() - 4.0).abs() < 1e-9);
}

#[test]
fn a_twist_turns_the_surface_about_the_cursor() {
    let mut play = Play::new();
    play.go([0.03, 0.01, 0.02], 100);
    let under = play.session.state().goal;
    play.button(true);
    play.twist(FRAC_PI_2, 200);
    let state = play.session.state();
    assert!((state.window.turn() + FRAC_PI_2).abs() < 1e-12, "{}", state.window.turn());
    assert!(apart([state.goal[0], state.goal[1], 0.0], [under[0], under[1], 0.0]) < 1e-9);
    assert!((state.window.width() - 16.0).abs() < 1e-9);
    assert_eq!(play.force(), [0.0; 3], "nothing is felt of it at a detent");
    // East, which was to the right, is away now.
    play.button(false);
    play.go([0.03, 0.03, 0.02], 100);
    let moved = play.session.state().goal;
    assert!((moved[0] - under[0] - 2.0).abs() < 1e-9 && (moved[1] - under[1]).abs() < 1e-9);
    // Half a turn more and back over the jump of an angle.
    play.button(true);
    play.twist(FRAC_PI_2 + 4.0, 400);
    assert!(
        (play.session.window().turn() - (std::f64::consts::TAU - FRAC_PI_2 - 4.0)).abs() < 1e-9
    );
}

#[test]
fn a_handle_is_followed_in_zoom_alone() {
    let mut play = Play::new();
    play.twist(1.0, 50);
    assert_eq!(play.session.window().turn(), 0.0);
    play.button(true);
    assert_eq!(play.session.window().turn(), 0.0, "it begins where the handle is");
    play.device.lock().pose.twist = None;
    play.rest(5);
    play.device.lock().pose.twist = Some(2.0);
    play.rest(5);
    let turned = play.session.window().turn();
    assert!((turned + 1.0).abs() < 1e-12, "what it missed is made good: {turned}");
}

/// A slope in east's direction, touched under every turn: the force turns with the window.
#[test]
fn contact_feels_the_same_under_a_turned_window() {
    let slope = || ground(|column, row| 0.3 * f64::from(column) - 0.1 * f64::from(row) - 6.4);
    let pressed = |turn: f64| {
        let turned = window().turned(turn).unwrap();
        let settings = Settings { walls: false, ..settings() };
        let mut play = Play::on(slope(), turned, settings);
        play.go([0.0, 0.0, -0.004], 100);
        play.rest(RAMPED);
        play.force()
    };
    let straight = pressed(0.0);
    assert!(straight[0] < -0.1 && straight[2] > 1.0, "{straight:?}");
    for turn in [0.3, FRAC_PI_2, 2.0, 3.1, -1.0, 100.0] {
        let [x, y, z] = pressed(turn);
        let back = [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos(), z];
        assert!(apart(back, straight) < 1e-9, "{back:?} at {turn}");
    }
}

#[test]
fn zooming_never_puts_the_hand_into_the_ground() {
    let peaks = || ground(|column, row| f64::from((column * 7 + row * 13) % 5) * 0.3);
    for deep in [-0.01, -0.05] {
        let grid = peaks();
        let mut play = Play::on(grid.clone(), window(), settings());
        play.go([0.003, 0.004, 0.02], 50);
        play.button(true);
        play.go([0.003, 0.004, 0.055], 100);
        play.go([0.003, 0.004, deep], 200);
        play.button(false);
        let state = play.session.state();
        let ground = grid.surface_elevation(&grid.layout().grid_point(state.goal)).unwrap();
        assert!(state.goal[2] > ground, "{} under {ground}", state.goal[2]);
        play.rest(RAMPED);
        assert_eq!(play.force(), [0.0; 3]);
        // And it can be touched there.
        play.go([0.003, 0.004, deep - 0.01], 50);
        play.rest(RAMPED);
        assert!(play.force()[2] > 0.5, "{:?}", play.force());
    }
}

#[test]
fn a_hand_that_is_nowhere_near_takes_no_window_away() {
    let mut play = Play::new();
    play.button(true);
    for far in [[0.0, 0.0, -1e300], [0.0, 0.0, 1e300], [f64::MAX, -f64::MAX, 0.0]] {
        play.device.lock().pose.position = far;
        play.rest(3);
        play.device.lock().pose.position = [0.0, 0.0, 0.02];
        play.rest(3);
        let state = play.session.state();
        assert!((state.window.width() - 16.0).abs() < 1e-9);
        assert!(state.window.up().abs() < 10.0, "{:?}", state.window);
        assert!((state.goal[0] - 32.0).abs() < 1e-9 && (state.goal[1] + 32.0).abs() < 1e-9);
    }
}

#[test]
fn ground_out_of_reach_comes_nearer_when_zoomed_out() {
    let far = Window::new(32.0, -32.0, 100.0, 16.0, 1.0).unwrap();
    let mut play = Play::on(flat_ground(), far, settings());
    let height = |play: &mut Play| {
        let state = play.session.state();
        (state.goal[2]) * 0.16 / state.window.width()
    };
    let before = height(&mut play);
    play.button(true);
    play.go([0.0, 0.0, -0.02], 100);
    assert!(height(&mut play) < 0.5 * before, "{} m above it, of {before} m", height(&mut play));
}

#[test]
fn a_hand_that_zoomed_in_the_ground_feels_nothing_until_it_has_come_out() {
    let mut play = Play::touching();
    play.session.set_mode(Mode::Zoom).unwrap();
    play.go([0.0, 0.0, -0.01], 100);
    play.session.drain();
    play.session.set_mode(Mode::Normal).unwrap();
    play.rest(RAMPED);
    assert!(largest_step(&play.session.drain()) <= SLOW_SLEW * (1.0 + 1e-9));
    assert_eq!(play.force(), [0.0; 3]);
    let window = play.session.window();
    let ground = -window.up() * 0.16 / window.width();
    play.go([0.0, 0.0, ground + 0.01], 100);
    play.go([0.0, 0.0, ground - 0.004], 100);
    assert!((play.force()[2] - 0.004 * STIFFNESS).abs() < 1e-6, "{:?}", play.force());
}

#[test]
fn what_a_mode_held_with_is_let_go_slowly() {
    for mode in [Mode::Pan, Mode::Zoom] {
        let mut play = Play::touching();
        play.session.set_mode(mode).unwrap();
        play.rest(RAMPED);
        play.go([0.0, 0.008, 0.01], 30);
        play.rest(5);
        assert!(size(play.force()) > 2.0, "{mode:?}: {:?}", play.force());
        play.session.drain();
        play.session.set_mode(Mode::Normal).unwrap();
        let before = play.force();
        play.rest(1);
        assert!(apart(play.force(), before) <= SLOW_SLEW * (1.0 + 1e-9));
        play.rest(80);
        assert!(largest_step(&play.session.drain()) <= SLOW_SLEW * (1.0 + 1e-9));
        assert_eq!(play.force(), [0.0; 3], "above the ground");
    }
}

#[test]
fn another_window_ends_a_mode_and_the_button_must_be_pressed_anew() {
    let mut play = Play::touching();
    play.button(true);
    play.go([0.02, 0.0, -0.005], 100);
    let elsewhere = Window::new(20.0, -40.0, 0.5, 8.0, 2.0).unwrap();
    play.session.set_window(elsewhere).unwrap();
    assert_eq!(play.session.window(), elsewhere, "at once");
    play.rest(50);
    let state = play.session.state();
    assert_eq!((state.mode, state.window), (Mode::Normal, elsewhere), "and it does not drift");
    assert_eq!(play.force(), [0.0; 3]);
    play.button(false);
    play.button(true);
    assert_eq!(play.session.state().mode, Mode::Zoom);
}

#[test]
fn poses_that_are_no_numbers_give_no_force_and_a_few_do_not_end_a_pan() {
    let mut play = Play::touching();
    play.button(true);
    play.go([0.01, 0.0, -0.008], 100);
    let good = play.device.lock().pose;
    for broken in [
        devices::Pose { twist: Some(f64::NAN), ..good },
        devices::Pose { position: [f64::NAN, 0.0, 0.0], ..good },
        devices::Pose { position: [0.0, 0.0, f64::INFINITY], ..good },
    ] {
        play.device.lock().pose = broken;
        let window = play.session.window();
        play.rest(5);
        assert_eq!(play.force(), [0.0; 3]);
        assert_eq!(play.session.window(), window);
        play.device.lock().pose = good;
        play.rest(1);
        assert_eq!(play.session.state().mode, Mode::Pan);
        play.rest(100);
        assert!(play.force()[2] > 1.0);
    }
    play.device.lock().pose.position[0] = f64::NAN;
    play.rest(150);
    play.device.lock().pose = good;
    play.rest(100);
    assert_eq!(play.session.state().mode, Mode::Normal, "the hand was lost");
    assert_eq!(play.force(), [0.0; 3], "it began anew inside the ground");
}

#[test]
fn a_device_that_goes_while_the_mode_changes_leaves_no_force() {
    for in_contact in [true, false] {
        let mut play = if in_contact { Play::touching() } else { Play::new() };
        play.device.lock().pose.buttons = 1;
        play.device.lock().error = Some(DeviceError::Gone("unplugged".into()));
        assert!(play.session.step(1).is_err());
        assert_eq!(play.force(), [0.0; 3]);
        assert_eq!(play.session.state().mode, Mode::Normal);
        play.session.press().unwrap();
        play.session.set_mode(Mode::Zoom).unwrap();
    }
    let mut play = Play::touching();
    play.button(true);
    play.device.lock().error = Some(DeviceError::Timeout("no packet".into()));
    play.rest(2);
    play.device.lock().error = None;
    play.rest(1);
    assert_eq!(play.session.state().mode, Mode::Pan, "two lost packets are forgiven");
}

#[test]
fn missed_ticks_move_a_drifting_surface_as_far_as_ticks_do() {
    let made = |stall: u64| {
        let mut play = thrown();
        play.go([0.03, 0.0, 0.03], 20);
        let before = play.session.window().east();
        play.session.stall(stall);
        play.rest(200 - stall);
        before - play.session.window().east()
    };
    let (whole, missed) = (made(0), made(50));
    assert!((whole - missed).abs() < 1e-9 * whole, "{missed} of {whole}");
}

#[test]
fn a_drifting_surface_makes_good_what_it_did_not_see() {
    let made = |lost: bool| {
        let mut play = thrown();
        play.go([0.03, 0.0, 0.03], 20);
        let before = play.session.window().east();
        if lost {
            play.device.lock().error = Some(DeviceError::Timeout("no packet".into()));
        }
        play.rest(2);
        play.device.lock().error = None;
        play.rest(100);
        before - play.session.window().east()
    };
    let (whole, lost) = (made(false), made(true));
    assert!((whole - lost).abs() < 1e-9 * whole, "{lost} of {whole}");
}

#[test]
fn a_long_stall_in_a_mode_ends_it_without_a_force() {
    for in_contact in [true, false] {
        let mut play = if in_contact { Play::touching() } else { Play::new() };
        play.button(true);
        play.session.stall(10_000);
        play.session.drain();
        play.rest(300);
        assert_eq!(play.session.state().mode, Mode::Normal);
        for record in play.session.drain() {
            assert_eq!(record.force, [0.0; 3]);
        }
    }
}

#[test]
fn the_map_ends_where_the_window_is_pushed_to_its_edge() {
    let near = Window::new(2.0, -32.0, 0.0, 16.0, 1.0).unwrap();
    let mut play = Play::on(flat_ground(), near, settings());
    play.go([0.0, 0.0, -0.005], 100);
    play.button(true);
    play.go([0.05, 0.0, -0.005], 300);
    play.rest(RAMPED);
    let window = play.session.window();
    assert!(window.east().abs() < 1e-9 && (window.north() + 32.0).abs() < 1e-9, "{window:?}");
    let force = play.force();
    assert!(force[0] < -7.0, "it holds like a wall: {force:?}");
    // The north pole, and the south.
    for (north, y, end) in [(-2.0, -0.05, 0.0), (-61.0, 0.05, -63.0)] {
        let near = Window::new(32.0, north, 0.0, 16.0, 1.0).unwrap();
        let mut play = Play::on(flat_ground(), near, settings());
        play.go([0.0, 0.0, -0.005], 100);
        play.button(true);
        play.go([0.0, y, -0.005], 300);
        play.rest(RAMPED);
        let found = play.session.window().north();
        assert!((found - end).abs() < 1e-9, "{found}");
    }
    // In the middle of a window that lies beside the map it does not jump.
    let beside = Window::new(-5.0, 3.0, 0.0, 16.0, 1.0).unwrap();
    let mut play = Play::on(flat_ground(), beside, settings());
    play.session.set_mode(Mode::Pan).unwrap();
    play.rest(50);
    assert_eq!(play.session.window(), beside);
}

#[test]
fn a_map_that_goes_round_has_no_edge_east_and_west() {
    let flat = flat_ground();
    let layout = flat.layout().with_wrap(true);
    let grid = std::sync::Arc::new(surface::Grid::from_vec(vec![0; 64 * 64 * 8], layout).unwrap());
    let near = Window::new(2.0, -32.0, 0.0, 16.0, 1.0).unwrap();
    let mut play = Play::on(grid, near, settings());
    play.go([0.0, 0.0, -0.005], 100);
    play.button(true);
    play.go([0.05, 0.0, -0.005], 300);
    play.rest(1500);
    assert!((play.session.window().east() + 3.0).abs() < 0.05);
    assert!(play.session.state().in_contact());
}

#[test]
fn numbers_of_modes_are_refused_by_name() {
    let good = Interaction::default();
    for (interaction, name) in [
        (Interaction { pan_mass: 0.0, ..good }, "pan_mass"),
        (Interaction { drift_time: f64::NAN, ..good }, "drift_time"),
        (Interaction { zoom_travel: -0.02, ..good }, "zoom_travel"),
        (Interaction { detent_force: f64::INFINITY, ..good }, "detent_force"),
        (Interaction { zoom_widths: Some([0.0, 1.0]), ..good }, "narrowest zoom width"),
        (Interaction { zoom_widths: Some([2.0, 1.0]), ..good }, "widest zoom width"),
    ] {
        let settings = Settings { interaction: Some(interaction), ..Settings::default() };
        assert_eq!(settings.validate().unwrap_err().name, name);
    }
}
