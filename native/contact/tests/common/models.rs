//! The models that are put on trial, and what each one promises.

use contact::{ContactModel, Model};
use surface::Metric;

/// Every model, with the settings of its knobs that are tried. The sphere's radius is a quarter of
/// the shorter side of a cell.
pub fn all_models(metric: &Metric) -> [Model; 7] {
    let radius = 0.25 * metric.column.min(metric.row);
    [
        Model::SurfaceWalk { sub_step: None },
        Model::SurfaceWalk { sub_step: Some(1.0) },
        Model::SurfaceWalk { sub_step: Some(0.25) },
        Model::ProxyGraph,
        Model::GodObject,
        Model::GodObjectRelease,
        Model::VirtualProxy { radius },
    ]
}

/// Whether it promises the exact proxy's properties: it ends at local minima, the distance never
/// grows faster than the goal moves, and a still hand is not moved.
pub fn is_exact(model: &dyn ContactModel) -> bool {
    model.name() == "surface_walk"
}

/// Whether the proxy is a point, and not the centre of a sphere.
pub fn is_point(model: &dyn ContactModel) -> bool {
    model.name() != "virtual_proxy"
}
