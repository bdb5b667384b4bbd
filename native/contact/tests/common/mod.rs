//! Terrains, goals and an oracle for the tests of contact models.
#![allow(dead_code, reason = "each test program uses a part of this")]
#![allow(unused_imports, reason = "each test program uses a part of this")]

pub mod closest;
pub mod models;
pub mod random_hand;
pub mod trial;

use contact::{Contact, Feature};
pub use oracle::Fault;
pub use oracle::terrain::{Random, grid, grid_with_cells, hills, white_noise};
use surface::{Grid, GridPoint, Metric};

/// A hand wandering over a square map of `size` samples at `speed` cells an update, from above the
/// surface to `depth` cells under it.
pub struct WanderingHand {
    random: Random,
    x: f64,
    y: f64,
    heading: f64,
    depth: f64,
    size: f64,
    speed: f64,
    deepest: f64,
}

impl WanderingHand {
    pub fn new(size: usize, speed: f64, deepest: f64, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let size = size as f64;
        let (x, y) = (random.between(0.2, 0.8) * size, random.between(0.2, 0.8) * size);
        let heading = random.between(0.0, std::f64::consts::TAU);
        Self { random, x, y, heading, depth: -1.0, size, speed, deepest }
    }

    pub fn next(&mut self, grid: &Grid) -> GridPoint {
        self.heading += self.random.between(-0.2, 0.2);
        self.x += self.speed * self.heading.cos();
        self.y += self.speed * self.heading.sin();
        let most = self.size - 1.0;
        if !(0.0..=most).contains(&self.x) || !(0.0..=most).contains(&self.y) {
            self.x = self.x.clamp(0.0, most);
            self.y = self.y.clamp(0.0, most);
            self.heading += 2.0;
        }
        self.depth += self.random.between(-0.1, 0.1) * self.deepest;
        self.depth = self.depth.clamp(-0.3 * self.deepest, self.deepest);
        let under = GridPoint::new(self.x, self.y, 0.0);
        let surface = grid.surface_elevation(&under).unwrap_or(0.0);
        GridPoint { elevation: surface - self.depth, ..under }
    }
}

pub const SQUARE: Metric = Metric { column: 1.0, row: 1.0, up: 1.0 };

/// Between two points, with cells of one metre.
pub fn distance(from: &GridPoint, to: &GridPoint) -> f64 {
    let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
    (columns - from.u).hypot(rows - from.v).hypot(up)
}

/// How far below the true surface the proxy is, in parts of the relief around it (rounding only).
pub fn depth_below_surface(grid: &Grid, contact: &Contact) -> f64 {
    oracle::depth_below_surface(grid, &contact.proxy)
}

/// Why a contact is not a local minimum of the distance to the goal; `None` where it is.
pub fn fault_of_minimum(
    grid: &Grid,
    metric: &Metric,
    contact: &Contact,
    goal: &GridPoint,
) -> Option<Fault> {
    let touches = contact.feature != Feature::Free;
    oracle::fault_of_minimum(grid, metric, &contact.proxy, touches, goal)
}
