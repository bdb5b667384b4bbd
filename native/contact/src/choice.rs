//! Choosing a contact model by name.

use crate::contact::{ContactModel, MIN_STEP_BUDGET};
use crate::god_object::GodObject;
use crate::god_object_release::GodObjectRelease;
use crate::proxy_graph::ProxyGraph;
use crate::surface_walk::SurfaceWalk;
use crate::virtual_proxy::VirtualProxy;
use surface::Metric;

/// A contact model with its knobs, before it is built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    /// The exact walk over the surface: the default.
    SurfaceWalk {
        /// The goal moves no further than this many cells at a time; `None` for one step an update.
        sub_step: Option<f64>,
    },
    /// The paper's model (section 3).
    ProxyGraph,
    /// The god-object without constraint release (paper 2.3), for comparison.
    GodObject,
    /// The god-object with constraint release (paper 2.3).
    GodObjectRelease,
    /// A sphere (paper 2.2).
    VirtualProxy {
        /// Of the sphere, workspace metres.
        radius: f64,
    },
}

impl Default for Model {
    fn default() -> Self {
        Self::SurfaceWalk { sub_step: None }
    }
}

impl Model {
    /// The name that people choose it by.
    pub fn name(&self) -> &'static str {
        match self {
            Self::SurfaceWalk { .. } => "surface_walk",
            Self::ProxyGraph => "proxy_graph",
            Self::GodObject => "god_object",
            Self::GodObjectRelease => "god_object_release",
            Self::VirtualProxy { .. } => "virtual_proxy",
        }
    }

    /// Steps that one update may take where nothing else is asked: each model's worst update then
    /// stays near a tenth of a millisecond.
    pub fn default_step_budget(&self) -> u32 {
        match self {
            // A step of the god-object is a cell of a ray, mostly in the air.
            Self::SurfaceWalk { .. } | Self::ProxyGraph | Self::GodObject => 4096,
            // A step in three is a triangle's projection, the others are cells of short rays.
            Self::GodObjectRelease => 2048,
            // A step is two triangles, held against a sphere; where many of them touch, each against the others
            // too: with 1024 one update in a hundred took up to 150 microseconds.
            Self::VirtualProxy { .. } => 640,
        }
    }

    /// The least step budget of this model: a smaller one is raised to it.
    pub fn min_step_budget(&self) -> u32 {
        match self {
            Self::VirtualProxy { .. } => VirtualProxy::MIN_STEP_BUDGET,
            _ => MIN_STEP_BUDGET,
        }
    }

    /// The radius of a sphere under this metric, workspace metres: as it was chosen, or the largest whose
    /// shadow the step budget can look at. `None` for a point.
    pub fn radius_in_force(&self, step_budget: u32, metric: &Metric) -> Option<f64> {
        match *self {
            Self::VirtualProxy { radius } => {
                Some(VirtualProxy::new(radius, step_budget).radius(metric))
            }
            _ => None,
        }
    }

    /// The model, with a proxy at sample (0, 0) out of contact, that may take `step_budget` steps
    /// in one update (fewer than [`min_step_budget`](Self::min_step_budget) are raised to that).
    ///
    /// # Panics
    /// Where the radius of a sphere is not positive and finite, or a sub-step is not finite or shorter than
    /// [`MIN_SUB_STEP`](crate::MIN_SUB_STEP).
    pub fn build(&self, step_budget: u32) -> Box<dyn ContactModel> {
        match *self {
            Self::SurfaceWalk { sub_step } => Box::new(SurfaceWalk::new(step_budget, sub_step)),
            Self::ProxyGraph => Box::new(ProxyGraph::new(step_budget)),
            Self::GodObject => Box::new(GodObject::new(step_budget)),
            Self::GodObjectRelease => Box::new(GodObjectRelease::new(step_budget)),
            Self::VirtualProxy { radius } => Box::new(VirtualProxy::new(radius, step_budget)),
        }
    }
}
