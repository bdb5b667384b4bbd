//! Wall and surface at once: added plainly, and mixed. And a limit cycle under passivity control.

use crate::stability::ground::Ground;
use crate::stability::trial::{COUNT, Outcome, Trial, Wall, weight};
use crate::stability::{DAMPING, DELAYS, DEPTH, RATE, pressed};
use contact_bench::figures::Figures;
use std::error::Error;

/// Share of the passive bound at which wall and surface are each well stable.
const SHARE: f64 = 0.75;

/// Metres up for each metre to the right: 80 degrees, a canyon's wall at heights x20.
const RISE: f64 = 5.67;

/// Metres from the origin to the wall.
const WALL: f64 = 0.02;

/// Times the passive bound, for a cycle to be damped.
const BEYOND: f64 = 1.3;

/// Presses a hand into the corner of wall and slope.
pub fn measure(figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    println!(
        "\n==== A wall and a slope of {RISE} at once, each at {SHARE} of the stable stiffness, {RATE} Hz, b {DAMPING} N s/m"
    );
    let slope = Ground::plane(RISE)?;
    let (mut plain_worst, mut mixed_worst): (f64, f64) = (f64::INFINITY, 0.0);
    for delay in DELAYS {
        let run = |wall| {
            let trial = corner(&slope, delay, wall);
            trial.last(SHARE * trial.plant().passive_bound())
        };
        let (plain, mixed) = (run(Wall::Added(WALL))?, run(Wall::Mixed(WALL))?);
        // Straight into the slope, or the hand would slide off it.
        let press = [DEPTH * RISE / RISE.hypot(1.0), 0.0, -DEPTH / RISE.hypot(1.0)];
        let alone = Trial { press, ..corner(&slope, delay, Wall::None) };
        let alone = alone.last(SHARE * alone.plant().passive_bound())?;
        println!(
            "{delay} late: slope alone {}; added {}; mixed {}",
            told(&alone),
            told(&plain),
            told(&mixed)
        );
        plain_worst = plain_worst.min(plain.swing);
        mixed_worst = mixed_worst.max(mixed.swing);
        figures.set(format!("mixed_plain_limit_cycle_mm_d{delay}"), plain.swing * 1e3);
        figures.set(format!("mixed_attenuated_limit_cycle_counts_d{delay}"), counts(&mixed));
        figures.set(format!("mixed_plain_active_ticks_d{delay}"), plain.active_ticks);
        figures.set(format!("mixed_attenuated_active_ticks_d{delay}"), mixed.active_ticks);
    }
    figures.set("mixed_plain_limit_cycle_mm", plain_worst * 1e3);
    figures.set("mixed_attenuated_limit_cycle_counts", (mixed_worst / COUNT).round());
    println!(
        "\
Added: the wall's force comes on top of the servo's, as in the paper's early work (section 4.2); along the slope's
normal the two are nearly twice as stiff as each. Mixed: Servo with walls. Swings are from end to end over the last
quarter of a minute, as the encoder of {} um tells them; the figures are the least of the added and the most of the
mixed ones. The observer watches the servo's own spring, not a wall that is added behind its back.
Not shown: walls that meet in a corner with the surface (the mixing room's property tests have them).",
        COUNT * 1e6
    );
    Ok(())
}

/// A little above the corner of wall and slope, and pressed against both.
fn corner(slope: &Ground, delay: u32, wall: Wall) -> Trial<'_> {
    Trial {
        start: [WALL - 1e-3, 0.0, RISE * WALL + 2e-3],
        aim: [WALL, 0.0, RISE * WALL],
        press: [2.0 * DEPTH, 0.0, -0.2 * DEPTH],
        wall,
        ..pressed(slope, weight(), DAMPING, delay)
    }
}

/// A spring beyond the bound, with and without the controller.
pub fn measure_control(flat: &Ground, figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    println!(
        "\n==== A spring at {BEYOND} of the passive bound, with and without passivity control"
    );
    let mut worst: f64 = 0.0;
    for delay in DELAYS {
        let run = |controls| {
            let trial = pressed(flat, weight(), DAMPING, delay);
            Trial { controls, ..trial.clone() }.last(BEYOND * trial.plant().passive_bound())
        };
        let (without, with) = (run(false)?, run(true)?);
        println!("{delay} late: without {}; with {}", told(&without), told(&with));
        worst = worst.max(with.swing / without.swing);
        figures.set(format!("uncontrolled_limit_cycle_mm_d{delay}"), without.swing * 1e3);
        figures.set(format!("controlled_limit_cycle_mm_d{delay}"), with.swing * 1e3);
        let active = without.active_ticks as f64 / without.ticks as f64;
        figures.set(format!("observer_active_share_beyond_bound_d{delay}"), active);
    }
    figures.set("controlled_limit_cycle_share", worst);
    println!(
        "\
Active: ticks in which the observer finds that the spring has given more than it took. The controller (Hannaford and
Ryu 2002) evens that with at most as much damping as the device has itself: the cycle becomes smaller, and does not
end. It is no leave to go beyond the bound, and off unless asked for."
    );
    Ok(())
}

fn counts(outcome: &Outcome) -> f64 {
    (outcome.swing / COUNT).round()
}

fn told(outcome: &Outcome) -> String {
    format!(
        "{:.3} mm ({} active of {} ticks)",
        outcome.swing * 1e3,
        outcome.active_ticks,
        outcome.ticks
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swing_at(share: f64, wall: Wall) -> f64 {
        let slope = Ground::plane(RISE).unwrap();
        let trial = corner(&slope, 0, wall);
        trial.last(share * trial.plant().passive_bound()).unwrap().swing
    }

    #[test]
    fn wall_and_slope_added_are_stable_up_to_half_the_bound_and_mixed_up_to_the_bound() {
        let two_counts = 2.0 * COUNT * (1.0 + 1e-9);
        assert!(swing_at(0.4, Wall::Added(WALL)) <= two_counts);
        assert!(swing_at(0.6, Wall::Added(WALL)) > 1e-3);
        assert!(swing_at(SHARE, Wall::Mixed(WALL)) <= two_counts);
        assert!(swing_at(1.1, Wall::Mixed(WALL)) > 1e-3);
    }
}
