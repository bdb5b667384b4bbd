//! The numbers of the modes.

use devices::{ParameterError, check};

/// How pan and zoom feel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    /// Of the surface that a hand pushes along, kilograms.
    ///
    /// Ours: as much as a computer mouse and a half weighs; its inertia is felt (0.2 N where a hand
    /// starts off at 1 m/s²) and does not tire.
    pub pan_mass: f64,
    /// Seconds in which friction takes a drifting surface to 1/e of its speed.
    ///
    /// Ours: a push of 0.1 m/s carries on for 5 cm, a third of a desktop device's workspace, and ends
    /// within two seconds.
    pub drift_time: f64,
    /// Metres that the hand is moved up to halve the window's width.
    ///
    /// Ours: five factors of 2 in a stroke of 10 cm, which desktop devices reach, so that a planet's
    /// map is zoomed to its cells in three strokes.
    pub zoom_travel: f64,
    /// The largest force of a detent, N.
    ///
    /// Ours: below half of the continuous force of the weakest devices (0.88 N), and well above the
    /// 0.05 N or so that a hand can tell from nothing.
    pub detent_force: f64,
    /// The narrowest and the widest window that zoom leads to, metres of terrain. `None` for 4 cells
    /// and for twice the whole map.
    pub zoom_widths: Option<[f64; 2]>,
}

impl Default for Interaction {
    fn default() -> Self {
        Interaction {
            pan_mass: 0.2,
            drift_time: 0.5,
            zoom_travel: 0.02,
            detent_force: 0.4,
            zoom_widths: None,
        }
    }
}

impl Interaction {
    /// Checks every number.
    pub fn validate(&self) -> Result<(), ParameterError> {
        check::positive("pan_mass", self.pan_mass)?;
        check::positive("drift_time", self.drift_time)?;
        check::positive("zoom_travel", self.zoom_travel)?;
        check::not_negative("detent_force", self.detent_force)?;
        if let Some([narrowest, widest]) = self.zoom_widths {
            check::positive("narrowest zoom width", narrowest)?;
            check::positive("widest zoom width", widest)?;
            if narrowest > widest {
                let expected = "no less than the narrowest";
                return Err(ParameterError { name: "widest zoom width", value: widest, expected });
            }
        }
        Ok(())
    }
}
