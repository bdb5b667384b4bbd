//! Which part of the terrain lies under the hand.

use devices::{ParameterError, check};

/// The workspace frame laid over the terrain: moved to pan, narrowed to zoom, turned by a twist of
/// the stylus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    east: f64,
    north: f64,
    up: f64,
    width: f64,
    exaggeration: f64,
    turn: f64,
}

impl Window {
    /// A window whose workspace origin lies at (`east`, `north`) terrain metres and at the elevation
    /// `up`; `width` metres of terrain span the width of the device's workspace, and heights are
    /// multiplied by `exaggeration`. The workspace's x points east.
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
        Ok(Window { east, north, up, width, exaggeration, turn: 0.0 })
    }

    /// The same window with the workspace's x pointing `radians` north of east: turned about the
    /// vertical, counter-clockwise seen from above.
    pub fn turned(self, radians: f64) -> Result<Window, ParameterError> {
        check::finite("window turn", radians)?;
        Ok(Window { turn: radians, ..self })
    }

    /// The same size elsewhere; every number must be what [`new`](Self::new) takes.
    pub(crate) fn moved(self, [east, north, up]: [f64; 3], width: f64, turn: f64) -> Window {
        Window { east, north, up, width, turn, ..self }
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

    /// Radians from east to the workspace's x, counter-clockwise seen from above.
    pub fn turn(&self) -> f64 {
        self.turn
    }
}
