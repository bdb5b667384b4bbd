//! How stiff the virtual spring can be in closed loop: measured, beside theory.

mod boundary;
mod ground;
mod mixed;
mod plain_wall;
mod theory;
mod trial;

use boundary::Boundary;
use contact_bench::figures::{Figures, spoken};
use devices::{Grip, Hand};
use ground::Ground;
use std::error::Error;
use trial::{COUNT, Trial, Wall, mechanism, weight};

/// Hertz.
const RATES: [f64; 5] = [250.0, 500.0, 1000.0, 2000.0, 4000.0];

/// Of the device, N s/m.
const DAMPINGS: [f64; 3] = [0.5, 2.0, 8.0];

/// Ticks.
const DELAYS: [u32; 3] = [0, 1, 2];

/// The damping and rate of the other tables.
const DAMPING: f64 = 2.0;
const RATE: f64 = 1000.0;

/// Columns of the synthetic planet at whose canyon wall the hand is pressed down.
const PLACES: [usize; 4] = [300, 1700, 3100, 4500];

/// Metres above the ground from which the hand comes down.
const ABOVE: f64 = 2e-3;

/// Metres that it is pressed in by a spring of the passive bound's stiffness.
const DEPTH: f64 = 1e-3;

/// Swings that count as rest, metres: of a servo that is stable; of one that is still, too; and of
/// one whose encoder tells every motion.
const STABLE: f64 = 10.0 * COUNT;
const STILL: f64 = 2.0 * COUNT;
const NO_SWING: f64 = 1e-7;

/// Measures all of it.
pub fn measure(figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    let flat = Ground::flat()?;
    let mut tally = Tally {
        still: f64::INFINITY,
        ideal_error: 0.0,
        worst: [None; 3],
        passive_ticks: 0,
        false_alarms: 0,
    };
    measure_map(&flat, &mut tally, figures)?;
    measure_grips(&flat, &mut tally, figures)?;
    measure_canyon(&mut tally, figures)?;
    tally.note(figures);
    mixed::measure(figures)?;
    mixed::measure_control(&flat, figures)
}

/// The worst of all boundaries, delay by delay, and what the observer said.
struct Tally {
    /// Of swings that stay below two counts, over theory.
    still: f64,
    /// How far the boundary without an encoder is from the exact one, as a share.
    ideal_error: f64,
    worst: [Option<f64>; DELAYS.len()],
    passive_ticks: u64,
    false_alarms: u64,
}

impl Tally {
    fn add(&mut self, delay: u32, boundary: &Boundary) {
        let worst = &mut self.worst[delay as usize];
        let ratio = boundary.ratio();
        *worst = Some(worst.map_or(ratio, |before| before.min(ratio)));
        self.watch(boundary);
    }

    fn watch(&mut self, boundary: &Boundary) {
        self.passive_ticks += boundary.passive_ticks;
        self.false_alarms += boundary.false_alarms;
    }

    fn note(&self, figures: &mut Figures) {
        for (delay, worst) in self.worst.iter().enumerate() {
            if let Some(worst) = worst {
                figures.set(format!("stable_stiffness_over_theory_d{delay}"), *worst);
            }
        }
        let all = self.worst.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        figures.set("stable_stiffness_over_theory", all);
        figures.set("still_stiffness_over_theory", self.still);
        figures.set("without_encoder_off_exact", self.ideal_error);
        figures.set("observer_false_alarms", self.false_alarms);
        figures.set("observer_ticks_below_bound", self.passive_ticks);
    }
}

/// Pressed straight down.
fn pressed(ground: &Ground, hand: Hand, damping: f64, delay: u32) -> Trial<'_> {
    Trial {
        ground,
        hand,
        mechanism: mechanism(damping, delay, COUNT),
        start: [0.0, 0.0, ABOVE],
        aim: [0.0; 3],
        press: [0.0, 0.0, -DEPTH],
        rest: STABLE,
        rate: RATE,
        wall: Wall::None,
        controls: false,
    }
}

fn measure_map(
    flat: &Ground,
    tally: &mut Tally,
    figures: &mut Figures,
) -> Result<(), Box<dyn Error>> {
    println!("\n==== The stiffest stable spring on a flat wall");
    println!(
        "N/m by theory; over theory: measured stable, measured still, exact; measured without an encoder, over exact"
    );
    for damping in DAMPINGS {
        for delay in DELAYS {
            println!("b {damping} N s/m, {delay} ticks late");
            for rate in RATES {
                measure_point(flat, damping, delay, rate, tally, figures)?;
            }
        }
    }
    println!(
        "\
The whole servo (Servo::tick: contact model, spring, gates, observer) on a simulated device of 0.1 kg whose only
brake is its own damping b; a weight comes down {} mm and presses a spring of theory's stiffness in by {} mm. Stable:
after the perturbation the swing ends below {:.1} mm; still: below two counts of the encoder, {} um each. Theory is
K < 2b/((1 + 2d)T), d ticks from reading to pushing (Colgate and Schenkel 1997; Diolaiti et al. 2006). Exact is where
this very mass, sampled and held, has a root on the unit circle. Without an encoder measured and exact agree. With one,
a spring below the boundary trembles by some counts: to swings of 2, 3, 4 and 10 counts from end to end a staircase is
up to 1.27, 1.12, 1.07 and 1.02 times as stiff as the line through it (its describing function), so that swings of 3
counts can live from 0.89 of the exact boundary on. Which do depends on the stiffness to some digits, and no bisection
finds the lowest. The tremble is of counts, not of metres: a finer encoder makes it smaller. Not shown: Coulomb
friction (helps), flexible drives and cables (hurt), motors' limits (the force is not cut here), late ticks, and people, who are not passive at a few hertz.",
        ABOVE * 1e3,
        DEPTH * 1e3,
        STABLE * 1e3,
        COUNT * 1e6
    );
    Ok(())
}

fn measure_point(
    flat: &Ground,
    damping: f64,
    delay: u32,
    rate: f64,
    tally: &mut Tally,
    figures: &mut Figures,
) -> Result<(), Box<dyn Error>> {
    let stable = Trial { rate, ..pressed(flat, weight(), damping, delay) };
    let still = Trial { rest: STILL, ..stable.clone() };
    let smooth =
        Trial { rest: NO_SWING, mechanism: mechanism(damping, delay, 0.0), ..stable.clone() };
    let (found, quiet) = (Boundary::of(&stable)?, Boundary::of(&still)?);
    let ideal = Boundary::of(&smooth)?;
    tally.add(delay, &found);
    tally.watch(&quiet);
    tally.watch(&ideal);
    tally.still = tally.still.min(quiet.ratio());
    tally.ideal_error = tally.ideal_error.max((ideal.measured / ideal.exact - 1.0).abs());
    println!(
        "{rate:>8} Hz {:>8.0} {:>7.3} {:>7.3} {:>7.3} {:>9.4}",
        found.passive,
        found.ratio(),
        quiet.ratio(),
        found.exact / found.passive,
        ideal.measured / ideal.exact
    );
    let name = format!("stiffness_{rate}hz_b{}_d{delay}", spoken(damping));
    figures.set(name.clone(), found.measured);
    figures.set(format!("{name}_theory"), found.passive);
    figures.set(format!("{name}_still"), quiet.measured);
    figures.set(format!("{name}_exact"), found.exact);
    figures.set(format!("{name}_without_encoder"), ideal.measured);
    Ok(())
}

fn measure_grips(
    flat: &Ground,
    tally: &mut Tally,
    figures: &mut Figures,
) -> Result<(), Box<dyn Error>> {
    println!(
        "\n==== The same held in hands, at {RATE} Hz, b {DAMPING} N s/m: measured over theory with all damping (with the device's alone)"
    );
    for grip in Grip::ALL {
        let mut line = format!("{:<10}", grip.name());
        for delay in DELAYS {
            let found = Boundary::of(&pressed(flat, grip.hand(), DAMPING, delay))?;
            tally.add(delay, &found);
            let of_device = found.ratio() * (DAMPING + grip.hand().damping) / DAMPING;
            line += &format!(" | {delay} late: {:.3} ({of_device:.2})", found.ratio());
            let name = format!("stiffness_over_theory_{}_d{delay}", grip.name());
            figures.set(name, found.ratio());
            figures.set(format!("stiffness_over_device_{}_d{delay}", grip.name()), of_device);
        }
        println!("{line}");
    }
    println!(
        "\
A hand's damping helps like the device's, so that a spring that is safe for the device alone is safe in every one of
these hands. Not shown: a grip between hand and handle that gives."
    );
    Ok(())
}

fn measure_canyon(tally: &mut Tally, figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    println!(
        "\n==== On the canyon's wall, heights x20, relaxed hand: measured over theory (without an encoder, over exact); worst of {} places",
        PLACES.len()
    );
    let grounds: Vec<Ground> = PLACES.into_iter().map(Ground::canyon).collect::<Result<_, _>>()?;
    for delay in DELAYS {
        let mut line = format!("{delay} late");
        for rate in [RATES[0], RATE, RATES[4]] {
            let (mut worst, mut ideal) = (f64::INFINITY, f64::INFINITY);
            for ground in &grounds {
                let hand = Grip::Relaxed.hand();
                let trial = Trial { rate, ..pressed(ground, hand, DAMPING, delay) };
                let smooth = Trial { mechanism: mechanism(DAMPING, delay, 0.0), ..trial.clone() };
                let (found, without) = (Boundary::of(&trial)?, Boundary::of(&smooth)?);
                tally.add(delay, &found);
                tally.watch(&without);
                worst = worst.min(found.ratio());
                ideal = ideal.min(without.measured / without.exact);
            }
            line += &format!(" | {rate} Hz: {worst:.3} ({ideal:.4})");
            let name = format!("stiffness_over_theory_canyon_{rate}hz_d{delay}");
            figures.set(name.clone(), worst);
            figures.set(format!("{name}_without_encoder"), ideal);
        }
        println!("{line}");
    }
    println!(
        "\
The ground does not make a spring stiffer than a plane does: the proxy is its nearest point. What is below 1 is the
encoder's, as without it. Where more than 1 was found the swing leaves the ground and ends elsewhere.
Not shown: a hand that swipes while it presses, other ground."
    );
    Ok(())
}
