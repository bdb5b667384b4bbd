//! The small relief of the synthetic planet: one periodic tile of fractal ground with craters.
//!
//! Heights are in widths of a cell, so that the ground is as rough from cell to cell on a grid of
//! any size.

use crate::random::Random;

/// Samples after which the tile repeats, in both directions. Every planet is a whole number of
/// tiles around, so that it has no seam.
pub const PERIOD: usize = 1920;

/// Root mean square of the slope between neighbouring samples: Mars at 3.7 km from sample to sample.
pub const SLOPE: f64 = 0.035;

/// Of that, what fractal ground gives; the rest is craters.
const FRACTAL_SLOPE: f64 = 0.5 * SLOPE;

/// How fast relief grows with distance: differences grow as distance to this power (Hurst exponent).
pub const HURST: f64 = 0.7;

/// Craters cover this share of the ground.
const CRATERED: f64 = 0.25;

/// Smallest and largest diameter of a crater, cells.
const CRATER_CELLS: (f64, f64) = (5.0, 220.0);

/// The tile.
pub struct Tile {
    heights: Vec<f32>,
}

impl Default for Tile {
    fn default() -> Self {
        Self::new()
    }
}

impl Tile {
    /// The same tile always.
    pub fn new() -> Self {
        let mut tile = Self { heights: vec![0.0; PERIOD * PERIOD] };
        tile.add_fractal(&mut Random::new(0x4d61_7273));
        tile.scale_to(FRACTAL_SLOPE);
        tile.add_craters(&mut Random::new(0x4861_6c65));
        tile.scale_to(SLOPE);
        tile
    }

    /// One row of heights in widths of a cell, [`PERIOD`] samples.
    pub fn row(&self, row: usize) -> &[f32] {
        let first = row % PERIOD * PERIOD;
        &self.heights[first..first + PERIOD]
    }

    /// Root mean square of the difference between samples `distance` columns apart.
    fn difference(&self, distance: usize) -> f64 {
        let mut squares = 0.0;
        for row in 0..PERIOD {
            let heights = self.row(row);
            for column in 0..PERIOD {
                let step = heights[(column + distance) % PERIOD] - heights[column];
                squares += f64::from(step) * f64::from(step);
            }
        }
        (squares / (PERIOD * PERIOD) as f64).sqrt()
    }

    fn scale_to(&mut self, slope: f64) {
        let factor = (slope / self.difference(1)) as f32;
        self.heights.iter_mut().for_each(|height| *height *= factor);
    }

    /// Fractional Brownian ground: octaves of smooth periodic noise, each half as long as the one
    /// before and lower by 2^-[`HURST`], the last one a number for each sample.
    fn add_fractal(&mut self, random: &mut Random) {
        let mut nodes = 4;
        let mut amplitude = 1.0;
        while nodes <= PERIOD {
            self.add_octave(nodes, amplitude, random);
            nodes *= 2;
            amplitude *= 0.5f64.powf(HURST);
        }
        self.add_octave(PERIOD, amplitude, random);
    }

    /// Random heights at `nodes` by `nodes` places, joined smoothly.
    fn add_octave(&mut self, nodes: usize, amplitude: f64, random: &mut Random) {
        let values: Vec<f32> =
            (0..nodes * nodes).map(|_| (amplitude * random.normal()) as f32).collect();
        // Octaves are shifted, else their nodes would lie on each other and show as lines.
        let columns = Between::along(nodes, random.unit());
        let rows = Between::along(nodes, random.unit());
        for (row, at) in rows.iter().enumerate() {
            let (north, south) = (&values[at.first * nodes..], &values[at.second * nodes..]);
            for (column, on) in columns.iter().enumerate() {
                let upper = north[on.first] + on.share * (north[on.second] - north[on.first]);
                let lower = south[on.first] + on.share * (south[on.second] - south[on.first]);
                self.heights[row * PERIOD + column] += upper + at.share * (lower - upper);
            }
        }
    }

    /// Craters as on old ground: as many larger than D as D^-2, with bowl and rim.
    fn add_craters(&mut self, random: &mut Random) {
        let (smallest, largest) = CRATER_CELLS;
        let mut covered = 0.0;
        while covered < CRATERED * (PERIOD * PERIOD) as f64 {
            let share = random.unit();
            let inverse_square = (1.0 - share) / smallest.powi(2) + share / largest.powi(2);
            let diameter = inverse_square.powf(-0.5);
            covered += diameter * diameter * std::f64::consts::FRAC_PI_4;
            self.add_crater(diameter, random);
        }
    }

    fn add_crater(&mut self, diameter: f64, random: &mut Random) {
        // Larger craters are flatter (depth in km about 0.36 D^0.49, Garvin and others, 2003, at
        // 3.7 km a cell), and old ones are filled.
        let depth = 0.185 * diameter.powf(0.49) * random.between(0.3, 1.0);
        let (middle_column, middle_row) =
            (random.between(0.0, PERIOD as f64), random.between(0.0, PERIOD as f64));
        let radius = diameter / 2.0;
        let reach = (radius * EJECTA).ceil() as i64;
        for south in -reach..=reach {
            for east in -reach..=reach {
                let (column, row) =
                    (middle_column.floor() + east as f64, middle_row.floor() + south as f64);
                let distance = (column - middle_column).hypot(row - middle_row) / radius;
                let index = (row as i64).rem_euclid(PERIOD as i64) as usize * PERIOD
                    + (column as i64).rem_euclid(PERIOD as i64) as usize;
                self.heights[index] += (depth * crater_profile(distance)) as f32;
            }
        }
    }
}

/// Radii to which a crater's ejecta reach.
const EJECTA: f64 = 2.5;

/// Height of the rim, in depths.
const RIM: f64 = 0.15;

/// Height at a distance from a crater's middle in radii, in depths.
fn crater_profile(distance: f64) -> f64 {
    if distance < 1.0 {
        let square = distance * distance;
        RIM * square - (1.0 - RIM) * (1.0 - square)
    } else if distance < EJECTA {
        let end = EJECTA.powi(-3);
        RIM * (distance.powi(-3) - end) / (1.0 - end)
    } else {
        0.0
    }
}

/// Between which two nodes a sample lies, and how far from the first to the second.
struct Between {
    first: usize,
    second: usize,
    share: f32,
}

impl Between {
    /// For each sample along one side of the tile.
    fn along(nodes: usize, shift: f64) -> Vec<Self> {
        let at = |sample: usize| {
            let place = sample as f64 * nodes as f64 / PERIOD as f64 + shift;
            let share = place.fract();
            let first = place as usize % nodes;
            let smooth = share * share * (3.0 - 2.0 * share);
            Self { first, second: (first + 1) % nodes, share: smooth as f32 }
        };
        (0..PERIOD).map(at).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ground_is_as_steep_as_said_and_the_same_every_time() {
        let tile = Tile::new();
        assert!((tile.difference(1) - SLOPE).abs() < 1e-3 * SLOPE);
        assert_eq!(tile.heights, Tile::new().heights);
    }

    #[test]
    fn relief_grows_with_distance_as_on_fractal_ground() {
        let mut tile = Tile { heights: vec![0.0; PERIOD * PERIOD] };
        tile.add_fractal(&mut Random::new(1));
        for distance in [2, 8, 32] {
            let growth = tile.difference(2 * distance) / tile.difference(distance);
            assert!((growth.log2() - HURST).abs() < 0.15, "at {distance}: {growth}");
        }
    }

    #[test]
    fn a_crater_has_a_floor_a_rim_and_an_end() {
        assert_eq!(crater_profile(0.0), RIM - 1.0);
        assert!(crater_profile(1.0) > 0.0 && crater_profile(1.0 - 1e-9) > 0.0);
        assert!((crater_profile(1.0) - crater_profile(1.0 - 1e-9)).abs() < 1e-6);
        assert_eq!(crater_profile(EJECTA), 0.0);
    }
}
