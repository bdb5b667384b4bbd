//! The models that are put on trial, and what each one promises.

use contact::{ContactModel, MIN_STEP_BUDGET, Model, VirtualProxy};
use surface::Metric;

/// Every model, with the settings of its knobs that are tried. The sphere's radius is a quarter of
/// the shorter side of a cell. With `CONTACT_MODEL` in the environment, only the models of that name.
pub fn all_models(metric: &Metric) -> Vec<Model> {
    let radius = 0.25 * metric.column.min(metric.row);
    let only = std::env::var("CONTACT_MODEL").ok();
    let mut models = vec![
        Model::SurfaceWalk { sub_step: None },
        Model::SurfaceWalk { sub_step: Some(1.0) },
        Model::SurfaceWalk { sub_step: Some(0.25) },
        Model::ProxyGraph,
        Model::GodObject,
        Model::GodObjectRelease,
        Model::VirtualProxy { radius },
    ];
    models.retain(|model| only.as_deref().is_none_or(|name| name == model.name()));
    models
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

/// Whether a proxy in contact may be over the surface: held up by planes that are not there.
pub fn may_float(model: &dyn ContactModel) -> bool {
    model.name() == "god_object"
}

/// Steps that a model may take though its budget is smaller: its floor.
pub fn fewest_steps(model: &dyn ContactModel) -> u32 {
    if is_point(model) { MIN_STEP_BUDGET } else { VirtualProxy::MIN_STEP_BUDGET }
}
