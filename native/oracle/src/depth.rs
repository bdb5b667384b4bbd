//! How far under the surface a proxy is.

use crate::patch::patches_at;
use surface::{Grid, GridPoint};

/// How far below the true surface the proxy is, in parts of the relief around it (the range of the
/// samples within two cells, or the greatest of them where that is more: that is what their rounding
/// scales with). Negative above it; 0 where there is no surface.
pub fn depth_below_surface(grid: &Grid, proxy: &GridPoint) -> f64 {
    let patches = patches_at(grid, proxy);
    let Some(patch) = patches.first() else {
        return 0.0;
    };
    let (u, v) = patch.place_of(proxy);
    let below = patch.elevation(u, v) - proxy.elevation;

    let (mut low, mut high) = (proxy.elevation, proxy.elevation);
    for column in -1..=2 {
        for row in -1..=2 {
            if let Some(z) = grid.elevation(proxy.column + column, proxy.row + row) {
                (low, high) = (low.min(z), high.max(z));
            }
        }
    }
    below / (high - low).max(high.abs()).max(low.abs()).max(f64::MIN_POSITIVE)
}
