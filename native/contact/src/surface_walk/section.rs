//! The long way: along the straight section of the surface toward the goal.
//!
//! As long as the distance to the goal falls along every piece of the section (see
//! [`surface::section`]), the proxy may go there. From the last joint that it reaches so, steepest
//! descent goes on.

use super::Walk;
use super::face::LatticeEdge;
use crate::contact::Counters;
use surface::Sample;
use surface::section::Section;

/// A shorter way, in cells along the longer axis, is walked from face to face: setting up a section
/// costs as much as that.
const SHORTEST: f64 = 3.0;

/// The steepest piece, as rise for run in the workspace, that is followed. On gentle ground the section
/// and steepest descent come to the same place; on steep ground they part, and the section strays
/// from where the exact proxy goes.
const STEEPEST: f64 = 0.25;

/// Joints in a column of cells.
const MOST_JOINTS: u32 = 4;

impl<S: Sample> Walk<'_, '_, S> {
    /// Moves the proxy along the section as far as the distance falls all the way.
    #[inline(always)]
    pub(super) fn follow_section(&mut self, counters: &mut Counters) {
        let from = &self.proxy.position;
        let [east, south] = self.search.way_from(from);
        if !(east.abs().max(south.abs()) >= SHORTEST) {
            return;
        }
        let section = Section::new(self.search.field, from, &self.search.target);
        // Half of the budget is left for what follows, or a section that leads nowhere would use up
        // every update.
        let affordable = self.step_budget.saturating_sub(counters.steps()) / 2 / MOST_JOINTS;
        if affordable == 0 {
            return;
        }
        let length = section.length();
        let way = self.search.weights.squared([east, south, 0.0]);
        // Squared lengths of a column of the way, against those of a metre of height.
        let ahead = way / (length * length) / self.search.up;
        let gentle = STEEPEST * STEEPEST * ahead;
        let goal_elevation = self.search.target.elevation;

        let start = (0.0, from.elevation);
        let (last, shown) =
            section.follow(affordable, start, |(at, height), next_at, next_height| {
                // The scalar product of the piece with the way from its end to the goal.
                let (run, rise) = (next_at - at, next_height - height);
                let level = (length - next_at) * run * ahead;
                let falls = level + rise * (goal_elevation - next_height) >= 0.0;
                let is_gentle = rise * rise <= gentle * (run * run);
                (falls && is_gentle).then_some((next_at, next_height))
            });
        counters.faces += shown;
        if let Some((joint, (_, height))) = last
            && (height >= goal_elevation || self.goal_is_under_ground())
        {
            let place = section.place(joint);
            let edge = LatticeEdge { column: place.column, row: place.row, k: place.k };
            self.stand_on_edge(edge, place.along);
        }
    }

    /// Whether there is ground over the goal: else the proxy shall take off as soon as it can.
    #[cold]
    fn goal_is_under_ground(&self) -> bool {
        let target = &self.search.target;
        target.elevation <= self.search.field.surface_elevation(target)
    }
}
