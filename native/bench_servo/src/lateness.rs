//! How late the servo wakes up, beside a bare thread with the same sleep and priority.
//!
//! The two take turns, a second each, never at once: what other programs and a virtual machine's host
//! do to one they then do to the other. Idle; with every core busy; with Blender building meshes.

use crate::busy::{Busy, Mesh};
use crate::options::Options;
use contact::Model;
use contact_bench::figures::Figures;
use devices::{Hand, SimulatedDevice};
use servo::bare::{Bare, bare_loop};
use servo::{Distribution, Session, Settings, Window};
use std::error::Error;
use std::sync::Arc;
use std::time::Duration;
use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// Ticks of a turn.
const TURN: u64 = 1000;

/// Measures it in every condition.
pub fn measure(options: &Options, figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    println!("\n==== Lateness, us: p50, p99, p99.9; missed ticks, of {} s each", options.seconds);
    let (mut servo, mut bare) = take_turns(options.seconds)?;
    note("idle", &mut servo, &bare, figures);
    let busy = Busy::every_core();
    (servo, bare) = take_turns(options.seconds)?;
    drop(busy);
    note("loaded", &mut servo, &bare, figures);
    match &options.mesh {
        Some(command) => {
            let mesh = Mesh::built_by(command)?;
            (servo, bare) = take_turns(options.seconds)?;
            let built = mesh.stop()?;
            note("blender", &mut servo, &bare, figures);
            println!("Blender built {built} meshes of a million vertices meanwhile.");
            figures.set("meshes_built", built);
        }
        None => {
            println!("Blender's meshes are left out: --mesh names no program that builds them.")
        }
    }
    let memory = servo.locked_memory();
    figures.set("priority", servo.priority().to_string());
    figures.set("locked_bytes", memory.locked);
    figures.set("locked_bytes_refused", memory.refused);
    println!(
        "Priority: {}. Locked in memory: {} KB; refused: {} KB.\n\
         Bare: a thread with nothing in its ticks but the clock. Servo: a live session, a simulated hand on the\n\
         ground. They take turns of {TURN} ticks. Busy: a thread without end on every core; Blender: its Python\n\
         module builds meshes in a process of its own. Not shown: a device's driver; a system without a host.",
        servo.priority(),
        memory.locked / 1024,
        memory.refused / 1024,
    );
    Ok(())
}

/// The servo and the bare thread in turn, for so many seconds each.
fn take_turns(seconds: u64) -> Result<(Session, Bare), Box<dyn Error>> {
    let mut session = pressing()?;
    let mut bare = Bare::default();
    for _ in 0..seconds {
        session.start()?;
        std::thread::sleep(Duration::from_millis(TURN));
        session.stop();
        bare += bare_loop(TURN, true);
    }
    Ok((session, bare))
}

/// A simulated hand pressed on flat ground.
fn pressing() -> Result<Session, Box<dyn Error>> {
    const SIDE: u64 = 256;
    let layout = GridLayout::packed(SIDE, SIDE, 1.0, 1.0, SampleType::I16, ByteOrder::Big)?;
    let grid = Grid::from_vec(vec![0; (2 * SIDE * SIDE) as usize], layout)?;
    let device = SimulatedDevice::new(Hand { target: [0.0, 0.0, -0.005], ..Hand::default() })?;
    let model = Model::default();
    let window = Window::new(128.0, -128.0, 0.0, 100.0, 1.0)?;
    let contact = model.build(model.default_step_budget());
    let session =
        Session::new(Arc::new(grid), Box::new(device), contact, window, Settings::default())?;
    Ok(session)
}

fn note(condition: &str, session: &mut Session, bare: &Bare, figures: &mut Figures) {
    let servo = session.statistics();
    let late = |of: &Distribution, quantile| of.quantile(quantile).unwrap_or(0) as f64 / 1000.0;
    let line = |name: &str, of: &Distribution, missed: f64| {
        let [half, most, extreme] = [0.5, 0.99, 0.999].map(|quantile| late(of, quantile));
        println!(
            "{condition:<8} {name:<6}{half:>9.1}{most:>9.1}{extreme:>10.1}   missed {:.3}%",
            100.0 * missed
        );
    };
    let missed = share(servo.totals.missed_ticks, servo.totals.ticks);
    let bare_missed = share(bare.missed, bare.ticks());
    line("servo", &servo.lateness, missed);
    line("bare", &bare.lateness, bare_missed);
    for (name, quantile) in [("p50", 0.5), ("p99", 0.99), ("p999", 0.999)] {
        let ratio = late(&servo.lateness, quantile) / late(&bare.lateness, quantile);
        figures.set(format!("lateness_{name}_over_bare_{condition}"), ratio);
        figures.set(format!("lateness_{name}_us_{condition}"), late(&servo.lateness, quantile));
    }
    figures.set(format!("missed_share_{condition}"), missed);
    figures.set(format!("missed_share_bare_{condition}"), bare_missed);
}

fn share(missed: u64, done: u64) -> f64 {
    missed as f64 / (missed + done).max(1) as f64
}
