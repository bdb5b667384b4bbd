//! Allocations in ticks: there must be none.

use contact::Model;
use contact_bench::figures::Figures;
use contact_bench::terrain::{Relief, Terrain};
use contact_bench::tile::PERIOD;
use devices::{PathPoint, ScriptedDevice};
use servo::{Session, Settings, Window};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::error::Error;
use std::sync::Arc;
use surface::Grid;

thread_local! {
    /// Allocations of this thread, freed blocks too.
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// The system's allocator, counting.
pub struct Counting;

// SAFETY: everything is passed on to the system's allocator as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }
}

/// Ticks that are counted in.
const TICKS: u32 = 20_000;

/// Of every kind.
const MODELS: [Model; 5] = [
    Model::SurfaceWalk { sub_step: Some(1.0) },
    Model::ProxyGraph,
    Model::GodObject,
    Model::GodObjectRelease,
    Model::VirtualProxy { radius: 0.001 },
];

/// Metres across the workspace.
const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

/// Counts while a session is stepped over rough ground, into it and out of it.
pub fn measure(figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    let relief = Relief::new();
    let terrain = Terrain::new(&relief, PERIOD, 256);
    let mut heights = vec![0.0; PERIOD];
    let mut bytes = Vec::new();
    for row in 0..256 {
        terrain.row(row, &mut heights);
        bytes.extend(heights.iter().flat_map(|height| Terrain::sample(*height).to_be_bytes()));
    }
    let grid = Arc::new(Grid::from_vec(bytes, terrain.layout())?);
    let mut most = 0;
    for model in MODELS {
        most += count(&grid, &model)?;
    }
    figures.set("tick_allocations", most);
    println!("\n==== Allocations in {TICKS} ticks of every contact model: {most}");
    Ok(())
}

fn count(grid: &Arc<Grid>, model: &Model) -> Result<u64, Box<dyn Error>> {
    let cell = grid.layout().cell_width();
    let window = Window::new(900.0 * cell, -128.0 * cell, 0.0, 200.0 * cell, 20.0)?;
    let path = (0..TICKS).map(|tick| {
        let phase = f64::from(tick);
        let x = 0.07 * (phase * 0.013).sin();
        PathPoint {
            time: phase * 1e-3,
            position: [x, 0.04 * (phase * 0.007).sin(), 0.02 * (phase * 0.02).sin()],
        }
    });
    let device = ScriptedDevice::new(path.collect(), WORKSPACE)?;
    let contact = model.build(model.default_step_budget());
    let mut session =
        Session::new(Arc::clone(grid), Box::new(device), contact, window, Settings::default())?;
    let before = COUNT.get();
    session.step(u64::from(TICKS))?;
    let counted = COUNT.get() - before;
    assert!(session.statistics().totals.contact_ticks > 0, "the hand touches the ground");
    Ok(counted)
}
