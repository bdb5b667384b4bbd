//! What a model does along a path, untimed.

use crate::path::Course;
use crate::scene::Scene;
use contact::{Contact, ContactModel};

/// The outcome of every update along a course.
pub fn trace(model: &mut dyn ContactModel, scene: &Scene, course: &Course) -> Vec<Contact> {
    let metric = scene.metric();
    let update = |(update, goal)| {
        if let Some(start) = course.start_at(update) {
            model.take_over(start);
        }
        model.update(scene.grid, &metric, goal)
    };
    course.goals.iter().enumerate().map(update).collect()
}
