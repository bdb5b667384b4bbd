//! Elevation grids for touch: samples stay where their bytes lie, and the triangulated surface
//! over them is derived on demand.
//!
//! * [`GridLayout`] says where the samples lie and what they mean;
//! * [`Grid`] joins a layout with bytes (a mapped file, a foreign buffer);
//! * [`Heightfield`] reads elevations from it, for one sample type, without copies;
//! * [`Triangle`] and the [`lattice`] describe the triangulation (paper 3.5: one fixed diagonal);
//! * [`ray`] casts segments at it (paper 3.5: a digital differential analyser with cell culling).
//!
//! "Paper" is Walker and Salisbury, *Large Haptic Topographic Maps: MarsView and the Proxy Graph
//! Algorithm*, 2003. This crate knows no device, clock, thread or Python.

mod grid;
mod guard;
mod heightfield;
pub mod lattice;
mod layout;
mod metric;
mod point;
mod prefetch;
mod range;
pub mod ray;
mod sample;
pub mod section;
mod storage;

pub use grid::{Grid, GridError};
pub use heightfield::Heightfield;
pub use lattice::{Half, Triangle};
pub use layout::{GridLayout, LayoutError};
pub use metric::Metric;
pub use point::GridPoint;
pub use range::GridRange;
pub use sample::{ByteOrder, Sample, SampleType, readers};
pub use storage::KeepAlive;
