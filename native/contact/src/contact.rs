//! What every contact model takes and gives.

use crate::touchable::Touchable;
use surface::{Grid, GridPoint, Metric};

/// The least step budget of every model: a smaller one is raised to it.
///
/// A step may look all around a vertex, and rounding may lead a proxy around one: what an update begins
/// there it has to be able to end, or the next update begins the same again, for ever.
pub const MIN_STEP_BUDGET: u32 = 64;

/// What the proxy lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// Nothing: it is at the goal, in the air (or inside the ground, where the hand began there).
    Free,
    /// The inside of a triangle.
    Face,
    /// An edge between two triangles.
    Edge,
    /// A sample of the grid.
    Vertex,
}

/// What one update cost, and which of the rare cases it met.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Vertices visited by constrained minimisation (paper 4.4).
    pub vertices: u32,
    /// Triangles that the surface walk looked at to find its way, and constraint changes of the models
    /// that hold planes.
    pub faces: u32,
    /// Collision tests: free-space minimisations begun (paper 4.4), slides that left their triangle
    /// (paper 2.3), looks around a sphere.
    pub collision_tests: u32,
    /// Grid cells that the collision tests went through (paper 3.5).
    pub cells: u32,
    /// Steps over the far edge of a triangle (paper 3.3).
    pub far_edge_crossings: u32,
    /// Far-edge steps that came round to where they began, and were ended (paper 3.3).
    pub far_edge_loops: u32,
    /// Free space re-entered from a vertex already left in the same update, and ended (not in the paper).
    pub cycles_ended: u32,
    /// Cells still between proxy and goal when the step budget ran out, at least 1; 0 where the
    /// update finished.
    pub steps_left: u32,
}

/// The outcome of one update.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<P = GridPoint> {
    /// Where the proxy is now.
    pub proxy: P,
    /// What it lies on.
    pub feature: Feature,
    /// Workspace metres from the goal to the proxy (right, away, up): along this the spring pulls.
    /// Zero where the goal is not finite.
    pub displacement: [f64; 3],
    /// What the update cost.
    pub counters: Counters,
}

/// A contact model: state of one proxy, moved toward a goal once in every update.
///
/// An update never panics, never yields NaN, never allocates, and never visits more than the
/// model's step budget (at least [`MIN_STEP_BUDGET`]) allows: what is left is walked in the next updates. A
/// goal that is not finite leaves the proxy where it is.
///
/// Models of this crate touch grids; a model of another kind of surface says so in `S`.
pub trait ContactModel<S: Touchable = Grid>: Send {
    /// The model's name, as people choose it.
    fn name(&self) -> &'static str;

    /// Where the proxy is.
    fn proxy(&self) -> S::Proxy;

    /// Goes on from where another model's proxy is, in contact where that is.
    fn take_over(&mut self, proxy: S::Proxy);

    /// Puts the proxy there, out of contact. If that is inside the ground, it stays out of contact
    /// until it has come out above. A point that is not finite changes nothing.
    fn place(&mut self, at: S::Point) {
        if let Some(proxy) = S::in_space(at) {
            self.take_over(proxy);
        }
    }

    /// Moves the proxy toward `goal`, as near as the surface lets it, distances being measured by
    /// `metric`.
    fn update(&mut self, surface: &S, metric: &S::Metric, goal: &S::Point) -> Contact<S::Point>;
}

impl Counters {
    /// What counts against the step budget.
    pub(crate) fn steps(&self) -> u32 {
        self.vertices + self.faces + self.cells
    }
}

impl Contact {
    /// The outcome with `proxy` on `feature`, seen from `goal`.
    #[inline(always)]
    pub(crate) fn new(
        proxy: GridPoint,
        feature: Feature,
        goal: &GridPoint,
        metric: &Metric,
        counters: Counters,
    ) -> Self {
        let [columns, rows, up] = proxy.relative_to(goal.column, goal.row, goal.elevation);
        let displacement = [
            (columns - goal.u) * metric.column,
            // Rows run south; the workspace's second axis points away from the hand, north.
            -(rows - goal.v) * metric.row,
            up * metric.up,
        ];
        let is_finite = displacement.iter().sum::<f64>().is_finite();
        let displacement = if is_finite { displacement } else { [0.0; 3] };
        Self { proxy, feature, displacement, counters }
    }
}

impl<P> Contact<P> {
    /// Unit vector from the goal to the proxy in the workspace (right, away, up); (0, 0, 1) where
    /// the two coincide.
    pub fn normal(&self) -> [f64; 3] {
        direction_and_length(self.displacement).0
    }

    /// Workspace metres between proxy and goal.
    pub fn distance(&self) -> f64 {
        direction_and_length(self.displacement).1
    }
}

/// A vector as a unit vector and a length; up where it has no direction.
fn direction_and_length(vector: [f64; 3]) -> ([f64; 3], f64) {
    let length = vector[0].hypot(vector[1]).hypot(vector[2]);
    let direction = vector.map(|part| part / length);
    let has_direction = direction.iter().all(|part| part.is_finite());
    (if has_direction { direction } else { [0.0, 0.0, 1.0] }, length)
}
