//! Which part of the terrain lies under the hand.

use devices::{ParameterError, check};

/// The workspace frame laid over the terrain: moved to pan, narrowed to zoom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    east: f64,
    north: f64,
    up: f64,
    width: f64,
    exaggeration: f64,
}

impl Window {
    /// A window whose workspace origin lies at (`east`, `north`) terrain metres and at the elevation
    /// `up`; `width` metres of terrain span the width of the device's workspace, and heights are
    /// multiplied by `exaggeration`.
    pub fn new(
        east: f64,
        north: f64,
        up: f64,
        width: f64,
        exaggeration: f64,
    ) -> Result<Window, ParameterError> {
        check::finite("window east", east)?;
        check::finite("window north", north)?;
        check::finite("window up", up)?;
        check::positive("window width", width)?;
        check::positive("exaggeration", exaggeration)?;
        Ok(Window { east, north, up, width, exaggeration })
    }

    /// Terrain metres under the workspace's origin.
    pub fn east(&self) -> f64 {
        self.east
    }

    /// Terrain metres under the workspace's origin.
    pub fn north(&self) -> f64 {
        self.north
    }

    /// The elevation, in metres, at the workspace's z = 0.
    pub fn up(&self) -> f64 {
        self.up
    }

    /// Metres of terrain across the width of the workspace.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Of heights, the same for eye and hand.
    pub fn exaggeration(&self) -> f64 {
        self.exaggeration
    }
}
