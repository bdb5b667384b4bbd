//! What is pressed on: flat ground, a slope, and a canyon's wall at heights x20.

use contact_bench::terrain::{Relief, Terrain};
use contact_bench::tile::PERIOD;
use servo::{Frame, Window};
use std::error::Error;
use std::sync::Arc;
use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// Metres across the workspace.
pub const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

/// Samples along the sides of ground that is made here.
const SIDE: usize = 64;

/// A grid and where the workspace lies on it.
pub struct Ground {
    /// The grid.
    pub grid: Arc<Grid>,
    /// The workspace's place.
    pub frame: Frame,
}

impl Ground {
    /// At z = 0 everywhere.
    pub fn flat() -> Result<Self, Box<dyn Error>> {
        Self::plane(0.0)
    }

    /// Through the origin, `rise` metres up for each metre to the right.
    pub fn plane(rise: f64) -> Result<Self, Box<dyn Error>> {
        let middle = (SIDE / 2) as f64;
        let heights = (0..SIDE * SIDE).map(|sample| rise * ((sample % SIDE) as f64 - middle));
        // A cell is 2 mm of workspace.
        let window = Window::new(middle, -middle, 0.0, 80.0, 1.0)?;
        Self::of(heights.collect(), SIDE, 1.0, window)
    }

    /// The wall of the synthetic planet's canyon, heights x20, a cell of 3.7 km being 1 mm; the origin
    /// lies on the ground at `column`.
    pub fn canyon(column: usize) -> Result<Self, Box<dyn Error>> {
        let relief = Relief::new();
        let terrain = Terrain::new(&relief, 3 * PERIOD, 3 * PERIOD / 2);
        let cell = terrain.layout().cell_width();
        let first_row = terrain.canyon_wall(column as f64).0 as usize - SIDE / 2;
        let mut row = vec![0.0; 3 * PERIOD];
        let mut heights = Vec::with_capacity(SIDE * SIDE);
        for south in 0..SIDE {
            terrain.row(first_row + south, &mut row);
            heights.extend((0..SIDE).map(|east| f64::from(Terrain::sample(row[column + east]))));
        }
        let middle = (SIDE / 2) as f64;
        let up = heights[SIDE / 2 * SIDE + SIDE / 2];
        let window = Window::new(middle * cell, -middle * cell, up, 160.0 * cell, 20.0)?;
        Self::of(heights, SIDE, cell, window)
    }

    fn of(
        heights: Vec<f64>,
        side: usize,
        cell: f64,
        window: Window,
    ) -> Result<Self, Box<dyn Error>> {
        let bytes = heights.into_iter().flat_map(f64::to_le_bytes).collect();
        let (rows, little) = (side as u64, ByteOrder::Little);
        let layout = GridLayout::packed(rows, rows, cell, cell, SampleType::F64, little)?;
        let frame = Frame::new(window, WORKSPACE[0], &layout)?;
        Ok(Self { grid: Arc::new(Grid::from_vec(bytes, layout)?), frame })
    }
}
