//! The exact proxy.

use crate::descent::{is_open, steepest};
use crate::flight::{Flight, Side, fly, take_off};
use crate::patch::patches_at;
use crate::workspace::{is_on_map, length, nearest_on_map, normalized, way};
use surface::{Grid, GridPoint, Metric};

/// Pieces in a row that do not lower the distance by more than rounding, before the descent ends.
const MOST_STALLED: u32 = 16;

/// Where the exact proxy is (of the continuous motion), by brute force.
#[derive(Clone, Copy, Debug)]
pub struct Oracle {
    position: GridPoint,
    place: Place,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Space(Side),
    Surface,
}

impl Oracle {
    /// Out of contact. The place must be above the surface, in a hole or off the map.
    pub fn in_space(at: GridPoint) -> Self {
        Self { position: normalized(&at), place: Place::Space(Side::Above) }
    }

    /// In contact at a point of the surface.
    pub fn on_surface(at: GridPoint) -> Self {
        Self { position: normalized(&at), place: Place::Surface }
    }

    /// Where it is.
    pub fn position(&self) -> GridPoint {
        self.position
    }

    /// Whether it is in contact.
    pub fn touches(&self) -> bool {
        self.place == Place::Surface
    }

    /// Moves the goal from where it was (`from`) to `to` in `sub_steps` equal steps (at least 1),
    /// the proxy following each. All numbers must be finite and the metric valid.
    ///
    /// Takes time in proportion to the cells that the goal and the proxy move over.
    pub fn follow(
        &mut self,
        grid: &Grid,
        metric: &Metric,
        from: &GridPoint,
        to: &GridPoint,
        sub_steps: u32,
    ) {
        let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
        let motion = [columns - from.u, rows - from.v, up];
        for step in 1..sub_steps {
            let share = f64::from(step) / f64::from(sub_steps);
            let [u, v, up] = motion.map(|part| share * part);
            let (u, v, elevation) = (from.u + u, from.v + v, from.elevation + up);
            let goal = GridPoint::from_sample(from.column, from.row, u, v, elevation);
            self.settle(grid, metric, &goal);
        }
        self.settle(grid, metric, &normalized(to));
    }

    /// Follows a goal that stays where it is, until no way leads nearer to it.
    fn settle(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) {
        let (mut least, mut stalled) = (f64::INFINITY, 0);
        while stalled < MOST_STALLED {
            let target = target(grid, &self.position, goal);
            let is_settled = match self.place {
                Place::Space(side) => self.land(fly(grid, &self.position, side, &target), goal),
                Place::Surface => self.slide(grid, metric, &target, goal),
            };
            if is_settled {
                return;
            }
            let distance = length(way(metric, &self.position, &target));
            let is_lower = distance < least * (1.0 - 4.0 * f64::EPSILON);
            (least, stalled) = if is_lower { (distance, 0) } else { (least, stalled + 1) };
        }
    }

    /// Takes one step from a place on the surface; whether it was the last.
    fn slide(
        &mut self,
        grid: &Grid,
        metric: &Metric,
        target: &GridPoint,
        goal: &GridPoint,
    ) -> bool {
        let patches = patches_at(grid, &self.position);
        if is_open(&patches, metric, &self.position, target) {
            return self.land(take_off(grid, &self.position, target), goal);
        }
        match steepest(&patches, metric, &self.position, target) {
            Some(point) => self.position = point,
            None => return true,
        }
        false
    }

    /// Ends a flight; whether it was the last step.
    fn land(&mut self, flight: Flight, goal: &GridPoint) -> bool {
        (self.position, self.place) = match flight {
            Flight::Met(point) => (point, Place::Surface),
            Flight::Reached(side) => (*goal, Place::Space(side)),
        };
        !self.touches()
    }
}

/// What a proxy moves toward: on the map, the nearest place on the map.
fn target(grid: &Grid, proxy: &GridPoint, goal: &GridPoint) -> GridPoint {
    if is_on_map(grid, proxy) { nearest_on_map(grid, goal) } else { *goal }
}
