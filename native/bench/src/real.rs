//! Ground that is not made up by a planet's generator: Mars as measured, and noise.

use crate::random::Random;
use std::path::Path;
use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// MOLA's topography at 4 samples in a degree: rows, columns, metres from sample to sample.
const MOLA: (u64, u64, f64) = (720, 1440, 14_818.0);

/// Rows and columns of the noise, and metres from sample to sample.
const NOISE: (u64, f64) = (512, 1000.0);

/// Valles Marineris on that grid (280 to 308 E, 5 to 15 S): west, east, north, south.
pub const VALLES: [f64; 4] = [1120.0, 1232.0, 380.0, 420.0];

/// Mars at 4 samples in a degree; the text says why it is not there.
///
/// `path` is its label or its data file.
pub fn mars(path: Option<&Path>) -> Result<Grid, String> {
    let path = path.ok_or("no grid was named")?.with_extension("img");
    let (rows, columns, cell) = MOLA;
    let layout = GridLayout::packed(rows, columns, cell, cell, SampleType::I16, ByteOrder::Big)
        .map_err(|error| error.to_string())?
        .with_wrap(true);
    let found = std::fs::metadata(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    if found.len() != layout.byte_length() {
        let (found, expected) = (found.len(), layout.byte_length());
        let path = path.display();
        return Err(format!(
            "{path} holds {found} bytes; MOLA's topography at 4 pixels per degree has {expected}"
        ));
    }
    Grid::open(&path, layout).map_err(|error| error.to_string())
}

/// Heights that know nothing of each other, even between 0 and one cell: the roughest ground.
pub fn white_noise() -> Grid {
    let (side, cell) = NOISE;
    let mut random = Random::new(20);
    let samples =
        (0..side * side).flat_map(|_| (random.below(cell as usize + 1) as i16).to_be_bytes());
    let layout = GridLayout::packed(side, side, cell, cell, SampleType::I16, ByteOrder::Big);
    let layout = layout.expect("a possible layout").with_wrap(true);
    Grid::from_vec(samples.collect(), layout).expect("as many bytes as the layout has")
}
