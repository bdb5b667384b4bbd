//! The servo's load: the share of each millisecond that it takes, in the air and on the fastest swipe.
//!
//! Table 2 of the paper on grids of the same sizes. There, the device vendor's HLOAD measured the
//! whole servo with its driver; here, each tick is measured from its wake-up to its sleep, and there is
//! no driver: a script moves the hand.

use crate::options::Options;
use contact::Model;
use contact_bench::figures::Figures;
use contact_bench::terrain::{Relief, Terrain};
use devices::{PathPoint, ScriptedDevice};
use servo::{Session, Settings, Statistics, Window};
use std::error::Error;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use surface::{ByteOrder, Grid, GridLayout, GridPoint, SampleType};

/// A grid of the paper's, and its milliseconds (Table 2, Dell PWS530).
struct Size {
    columns: u32,
    rows: u32,
    paper: f64,
}

/// MOLA at 16 and at 32 samples in a degree, and Central America in GTOPO30.
const SIZES: [Size; 3] = [
    Size { columns: 5760, rows: 2880, paper: 0.0810 },
    Size { columns: 11_520, rows: 5760, paper: 0.0812 },
    Size { columns: 4800, rows: 6000, paper: 0.0812 },
];

/// Seconds of each session.
const SECONDS: f64 = 3.0;

/// Cells in a tick on the fastest swipe (paper 4.4), and ticks of a swipe from one end to the other.
const CELLS_A_TICK: f64 = 13.4;
const SWIPE: u32 = 100;

/// Metres across the workspace.
const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

/// Widths of a cell that the hand presses into the ground, and stays over it.
const DEPTH: f64 = 0.6;
const HEIGHT: f64 = 10.0;

/// Ticks over the ground before: a hand that begins inside it touches nothing.
const BEFORE: u32 = 100;

/// Measures both models on all sizes.
pub fn measure(options: &Options, figures: &mut Figures) -> Result<(), Box<dyn Error>> {
    println!(
        "\n==== The servo's load: milliseconds of each millisecond, mean (exceeded in 0.1% of ticks)"
    );
    println!("{:<16}{:<14}{:>18}{:>18}   the paper, 2003", "grid", "model", "in the air", "swipe");
    let relief = Relief::new();
    let mut most = 0.0f64;
    for size in &SIZES {
        let grid = Arc::new(size.grid(&relief, &options.output)?);
        let name = size.name();
        for (model, prefix) in [(Model::default(), ""), (Model::ProxyGraph, "graph_")] {
            let air = run(&grid, &model, HEIGHT)?;
            let swipe = run(&grid, &model, -DEPTH)?;
            figures.set(format!("{prefix}load_air_ms_{name}"), air.mean_load());
            figures.set(format!("{prefix}load_swipe_ms_{name}"), swipe.mean_load());
            most = most.max(swipe.mean_load());
            let (air, swipe) = (shown(&air), shown(&swipe));
            println!("{name:<16}{:<14}{air:>18}{swipe:>18}   {:.4}", model.name(), size.paper);
        }
    }
    figures.set("load_share_swipe_max", most);
    println!(
        "Live sessions of {SECONDS} s on synthetic planets, a hand swept to and fro at {CELLS_A_TICK} cells a tick, {DEPTH} cells\n\
         deep. A tick is measured from wake-up to sleep: commands, device (a script), contact, force, safety\n\
         chain, record. The paper's figures are of one machine of 2002 with the driver of a real device in them;\n\
         it gives no others. Not shown: a driver's own time."
    );
    Ok(())
}

impl Size {
    fn name(&self) -> String {
        format!("{}x{}", self.columns, self.rows)
    }

    /// A part of a synthetic planet's file: planets come in whole tiles, so a row may be longer.
    fn grid(&self, relief: &Relief, folder: &Path) -> Result<Grid, Box<dyn Error>> {
        let tile = contact_bench::tile::PERIOD;
        let columns = (self.columns as usize).next_multiple_of(tile);
        let planet = Terrain::new(relief, columns, self.rows as usize);
        let path = folder.join(format!("planet-{columns}x{}.img", self.rows));
        planet.write(&path)?;
        let cell = planet.layout().cell_width();
        let (rows, sample) = (u64::from(self.rows), SampleType::I16);
        let layout =
            GridLayout::packed(rows, u64::from(self.columns), cell, cell, sample, ByteOrder::Big)?;
        let layout = layout.with_row_stride(2 * columns as u64)?;
        let grid = Grid::open(&path, layout)?;
        // Read once, so that no page of it waits for the disk.
        std::io::copy(&mut File::open(&path)?, &mut std::io::sink())?;
        Ok(grid)
    }
}

/// A live session with a hand that sweeps `height` widths of a cell over the ground.
fn run(grid: &Arc<Grid>, model: &Model, height: f64) -> Result<Statistics, Box<dyn Error>> {
    let layout = grid.layout();
    let cell = layout.cell_width();
    // The hand goes through half of the workspace's width.
    let width = 2.0 * CELLS_A_TICK * f64::from(SWIPE) * cell;
    let middle = GridPoint::new(f64::from(layout.columns() / 2), f64::from(layout.rows() / 3), 0.0);
    let [east, north, _] = layout.terrain_place(&middle);
    let window = Window::new(east, north, 0.0, width, 1.0)?;
    let scale = WORKSPACE[0] / width;
    let hand = |tick: u32| {
        let columns = CELLS_A_TICK * (to_and_fro(tick) - 0.5 * f64::from(SWIPE));
        // A little askew, so that it crosses rows and columns.
        let rows = 0.3 * columns;
        let place = GridPoint::from_sample(middle.column, middle.row, columns, rows, 0.0);
        let ground = grid.surface_elevation(&place).unwrap_or(0.0);
        let height = if tick < BEFORE { HEIGHT } else { height };
        let up = ground + height * cell;
        let position = [columns * cell * scale, -rows * cell * scale, up * scale];
        PathPoint { time: f64::from(tick) * 1e-3, position }
    };
    let ticks = (SECONDS * 1000.0) as u32;
    let device = ScriptedDevice::new((0..=ticks).map(hand).collect(), WORKSPACE)?;
    let contact = model.build(model.default_step_budget());
    let settings = Settings { ring_seconds: SECONDS + 1.0, ..Settings::default() };
    let mut session = Session::new(Arc::clone(grid), Box::new(device), contact, window, settings)?;
    session.start()?;
    std::thread::sleep(Duration::from_secs_f64(SECONDS));
    session.stop();
    let statistics = session.statistics();
    let totals = &statistics.totals;
    let in_contact = totals.contact_ticks as f64 / totals.ticks.max(1) as f64;
    if (height < 0.0) != (in_contact > 0.9) || (height > 0.0) != (in_contact < 0.1) {
        return Err(format!(
            "a hand {height} cells over the ground touched it in {in_contact} of its ticks"
        )
        .into());
    }
    Ok(statistics)
}

/// From 0 up to [`SWIPE`] and down again.
fn to_and_fro(tick: u32) -> f64 {
    let there_and_back = tick % (2 * SWIPE);
    f64::from(there_and_back.min(2 * SWIPE - there_and_back))
}

fn shown(statistics: &Statistics) -> String {
    format!("{:.4} ({:.4})", statistics.mean_load(), statistics.load(0.999))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hand_goes_to_and_fro_at_one_speed() {
        assert_eq!(
            [0, 1, 99, 100, 101, 199, 200].map(to_and_fro),
            [0.0, 1.0, 99.0, 100.0, 99.0, 1.0, 0.0]
        );
    }
}
