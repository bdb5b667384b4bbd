//! What is touched: a grid, how much higher it is made, and where on it the hand moves.

use contact::{Place, Proxy};
use surface::{Grid, GridPoint, Half, Metric, Triangle};

/// Workspace metres for the width of a cell.
pub const CELL: f64 = 1e-3;

/// How the hand moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Wandering, pressed into the ground.
    Swipe,
    /// The same, but in and out of the ground.
    Poke,
}

/// Where on the grid the hand stays.
pub enum Field<'a> {
    /// Between these rows, all around the planet.
    Rows(f64, f64),
    /// In a part of the grid: west, east, north, south.
    Part(f64, f64, f64, f64),
    /// Near a line that runs from west to east: its row at a column, and how far from it, in cells.
    Along(&'a dyn Fn(f64) -> f64, f64),
}

/// A grid to touch, and how.
pub struct Scene<'a> {
    /// In names of figures.
    pub key: &'static str,
    /// In tables.
    pub title: String,
    /// The ground.
    pub grid: &'a Grid,
    /// Heights are multiplied by this.
    pub exaggeration: f64,
    /// How the hand moves.
    pub mode: Mode,
    /// Where it moves.
    pub field: Field<'a>,
}

impl Scene<'_> {
    /// The workspace's metric.
    pub fn metric(&self) -> Metric {
        metric(self.grid, self.exaggeration)
    }

    /// Metres of elevation for a cell's width of height in the workspace.
    pub fn metres_for_a_cell(&self) -> f64 {
        self.grid.layout().cell_width() / self.exaggeration
    }
}

/// The workspace's metric over a grid whose heights are multiplied by `exaggeration`.
pub fn metric(grid: &Grid, exaggeration: f64) -> Metric {
    let layout = grid.layout();
    let row = CELL * layout.cell_height() / layout.cell_width();
    Metric { column: CELL, row, up: CELL * exaggeration / layout.cell_width() }
}

/// The vector from one point to another in the workspace, in widths of a cell.
pub fn between(from: &GridPoint, to: &GridPoint, metric: &Metric) -> [f64; 3] {
    let [columns, rows, metres] = to.relative_to(from.column, from.row, from.elevation);
    let row = metric.row / metric.column;
    [columns - from.u, (rows - from.v) * row, metres * metric.up / metric.column]
}

/// Length of a vector.
pub fn length(vector: [f64; 3]) -> f64 {
    vector[0].hypot(vector[1]).hypot(vector[2])
}

/// A proxy in the air at a point, or on the surface there: then in the triangle under the point.
pub fn proxy_at(position: GridPoint, touches: bool) -> Proxy {
    if !touches {
        return Proxy::in_space(position);
    }
    let half = if position.u >= position.v { Half::NorthEast } else { Half::SouthWest };
    let triangle = Triangle { column: position.column, row: position.row, half };
    Proxy { position, place: Place::Face(triangle) }
}
