//! The oracle: where the exact proxy is, for tests and benches of contact models. Slow.
//!
//! The exact proxy is the one of the continuous motion: while the goal moves, it goes straight
//! through the air until it meets the surface, and on the surface down the steepest descent of the
//! distance to the goal, until no way leads nearer or the straight way is open again.
//!
//! * [`Oracle`] follows a goal in small steps;
//! * [`fault_of_minimum`] says why a proxy is not at a local minimum of the distance;
//! * [`depth_below_surface`] says how far a proxy is under the surface;
//! * [`terrain`] makes small grounds to try it on.
//!
//! It shares nothing with the contact models but the reading of a sample: no rings of edges, no
//! search along cells, no adjacency. At every step it asks all triangles that hold the point.
//!
//! What it assumes of the surface: every cell is split from its north-west to its south-east corner
//! (paper 3.5), a triangle with a void corner is absent, the map's border is a wall for a proxy that
//! is on the map, and a hole is left only upwards.

mod depth;
mod descent;
mod flight;
mod minimum;
mod patch;
mod proxy;
pub mod terrain;
mod workspace;

pub use depth::depth_below_surface;
pub use minimum::{Fault, fault_of_minimum};
pub use proxy::Oracle;
