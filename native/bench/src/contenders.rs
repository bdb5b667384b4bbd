//! The models that are measured, with the knobs they are measured with.

use crate::scene::CELL;
use contact::{ContactModel, Model};

/// Radius of the virtual proxy's sphere, widths of a cell.
pub const RADIUS: f64 = 0.5;

/// A model and its name in tables and figures.
#[derive(Clone, Copy)]
pub struct Contender {
    /// In names of figures.
    pub key: &'static str,
    /// What it is.
    pub model: Model,
}

/// All of them. The first is the default model.
pub const CONTENDERS: [Contender; 7] = [
    Contender { key: WALK, model: Model::SurfaceWalk { sub_step: None } },
    Contender { key: WALK_BY_ONE, model: Model::SurfaceWalk { sub_step: Some(1.0) } },
    Contender { key: WALK_BY_QUARTER, model: Model::SurfaceWalk { sub_step: Some(0.25) } },
    Contender { key: GRAPH, model: Model::ProxyGraph },
    Contender { key: GOD, model: Model::GodObject },
    Contender { key: RELEASE, model: Model::GodObjectRelease },
    Contender { key: SPHERE, model: Model::VirtualProxy { radius: RADIUS * CELL } },
];

/// The surface walk, the goal in one step.
pub const WALK: &str = "surface_walk";
/// The surface walk, the goal in steps of a cell at most.
pub const WALK_BY_ONE: &str = "surface_walk_sub_1";
/// The surface walk, the goal in steps of a quarter of a cell at most.
pub const WALK_BY_QUARTER: &str = "surface_walk_sub_0_25";
/// The paper's model.
pub const GRAPH: &str = "proxy_graph";
/// The god-object that never lets go of a constraint.
pub const GOD: &str = "god_object";
/// The god-object that does.
pub const RELEASE: &str = "god_object_release";
/// The sphere.
pub const SPHERE: &str = "virtual_proxy";

impl Contender {
    /// The model with the step budget that it ships with.
    pub fn build(&self) -> Box<dyn ContactModel> {
        self.model.build(self.model.default_step_budget())
    }
}
