//! Proxy contact models: where the proxy goes when the goal moves.
//!
//! The *goal* is the haptic interface point, the hand laid over the terrain. The *proxy* follows it
//! and stays on the surface; the spring between the two is what the hand feels (paper 2.2). One file
//! for each model, behind [`ContactModel`]:
//!
//! * [`SurfaceWalk`]: exact steepest descent, the default;
//! * [`ProxyGraph`]: the paper's model (section 3);
//! * [`GodObject`] and [`GodObjectRelease`]: constraint planes, kept or released (section 2.3);
//! * [`VirtualProxy`]: a sphere (section 2.2).
//!
//! This crate knows no device, clock, thread or Python.

mod choice;
mod contact;
mod distance;
mod god_object;
mod god_object_release;
mod planes;
mod proxy;
mod proxy_graph;
mod surface_walk;
mod touchable;
mod virtual_proxy;
mod way;
mod weights;

pub use choice::Model;
pub use contact::{Contact, ContactModel, Counters, Feature, MIN_STEP_BUDGET};
pub use god_object::GodObject;
pub use god_object_release::GodObjectRelease;
pub use proxy::{Place, Proxy};
pub use proxy_graph::ProxyGraph;
pub use surface_walk::{MIN_SUB_STEP, SurfaceWalk};
pub use touchable::Touchable;
pub use virtual_proxy::VirtualProxy;
