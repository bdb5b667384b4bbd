//! The Python module `proxygraph`: converts and names, decides nothing. Its contract, with shapes,
//! units and errors, is `proxygraph.pyi`.

mod choice;
mod columns;
mod contacts;
mod decode;
mod devices;
mod errors;
mod grid;
mod model;
mod numbers;
mod recording;
mod session;
mod state;
mod take;
mod ticks;

use pyo3::prelude::*;
use pyo3::types::PyTuple;

// Nobody shall ship a module whose safety can be switched off, although nothing in it would do so.
#[cfg(not(debug_assertions))]
const _: () = assert!(!servo::HAS_TEST_HOOKS, "build proxygraph alone, without the test hooks");

/// Touch elevation grids: proxy contact models and a 1 kHz haptic servo.
///
/// Every class and call is described in the stub proxygraph.pyi beside this module, which editors
/// and type checkers show: frames, units, errors, and the sections of the paper.
#[pymodule(name = "proxygraph")]
mod module {
    use super::*;
    #[pymodule_export]
    use crate::choice::model_descriptions;
    #[pymodule_export]
    use crate::contacts::Contacts;
    #[pymodule_export]
    use crate::decode::{CancelledError, DecodeError, Progress};
    #[pymodule_export]
    use crate::decode::{EsriAscii, GeoTiff, RawSamples, UsgsDem};
    #[pymodule_export]
    use crate::devices::{PlaybackDevice, ScriptedDevice, SimulatedDevice};
    #[pymodule_export]
    use crate::errors::{GridError, SessionError};
    #[pymodule_export]
    use crate::grid::{Grid, GridLayout, GridRange};
    #[pymodule_export]
    use crate::model::{Contact, ContactModel};
    #[pymodule_export]
    use crate::recording::Recording;
    #[pymodule_export]
    use crate::session::{Session, Window};
    #[pymodule_export]
    use crate::state::{State, Statistics};
    #[pymodule_export]
    use crate::take::{Take, TakeError, TakeInUseError, claim_take, read_take};
    #[pymodule_export]
    use crate::ticks::Ticks;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("STALE_AFTER", servo::STALE_AFTER)?;
        module.add("MODELS", PyTuple::new(module.py(), crate::choice::names())?)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
