//! How a model behaves along a path, judged without an oracle: what it visits, whether the hand
//! could ever gain energy from it, whether it stays out of the ground.

use crate::path::Course;
use crate::scene::{Scene, between, length};
use crate::statistics::{Spread, share};
use contact::{Contact, ContactModel, Feature};
use oracle::depth_below_surface;
use surface::{GridPoint, Metric};

/// Rounding that is let pass: of distances, as a share of the distance, the goal's motion and a
/// cell's width together; of heights, as a share of the relief around.
pub const ROUNDING: f64 = 1e-9;

/// The hand is held still after every so many updates.
const HOLD_EVERY: usize = 8;

/// Updates that a held hand waits for what was left over.
const LONGEST_REST: usize = 100;

/// Counts over one path. Counts of what a model visits are of updates in contact only.
#[derive(Clone, Debug, Default)]
pub struct Conduct {
    /// All updates, those with the hand held still included.
    pub updates: u64,
    /// Those that ended in contact, the hand moving.
    pub in_contact: u64,
    /// Vertices visited.
    pub vertices: u64,
    /// Triangles looked at.
    pub faces: u64,
    /// Collision tests.
    pub collision_tests: u64,
    /// Updates that went over a far edge.
    pub far_edge_updates: u64,
    /// Crossings of far edges.
    pub far_edges: u64,
    /// Those of them that came round in a loop.
    pub far_edge_loops: u64,
    /// Free space entered again from the same vertex.
    pub cycles: u64,
    /// Updates that the step budget ended.
    pub unfinished: u64,
    /// Updates in which the distance grew faster than the goal moved.
    pub grew: u64,
    /// Held hands with nothing left to walk that felt another force.
    pub restless: u64,
    /// Held hands looked at.
    pub held: u64,
    /// Updates that ended under the surface.
    pub under_surface: u64,
    /// Change of the force per motion of the goal, in springs.
    pub jump: Spread,
}

impl Conduct {
    /// Follows a course, holding the hand still now and then.
    pub fn along(model: &mut dyn ContactModel, scene: &Scene, course: &Course) -> Self {
        let mut observer = Observer::new(scene);
        for (update, goal) in course.goals.iter().enumerate() {
            if let Some(start) = course.start_at(update) {
                model.take_over(start);
                observer.before = None;
            }
            let contact = model.update(scene.grid, &observer.metric, goal);
            observer.moved(goal, &contact);
            if update % HOLD_EVERY == 0 {
                observer.hold(model, goal, contact);
            }
        }
        observer.conduct.jump = Spread::of(observer.jumps);
        observer.conduct
    }

    /// Counts of two paths together; jumps are those of the first.
    pub fn add(&mut self, other: &Self) {
        let sums = [
            (&mut self.updates, other.updates),
            (&mut self.in_contact, other.in_contact),
            (&mut self.vertices, other.vertices),
            (&mut self.faces, other.faces),
            (&mut self.collision_tests, other.collision_tests),
            (&mut self.far_edge_updates, other.far_edge_updates),
            (&mut self.far_edges, other.far_edges),
            (&mut self.far_edge_loops, other.far_edge_loops),
            (&mut self.cycles, other.cycles),
            (&mut self.unfinished, other.unfinished),
            (&mut self.grew, other.grew),
            (&mut self.restless, other.restless),
            (&mut self.held, other.held),
            (&mut self.under_surface, other.under_surface),
        ];
        for (sum, part) in sums {
            *sum += part;
        }
    }

    /// A count for each update in contact.
    pub fn per_update(&self, count: u64) -> f64 {
        share(count, self.in_contact)
    }
}

struct Observer<'a> {
    scene: &'a Scene<'a>,
    metric: Metric,
    conduct: Conduct,
    before: Option<(GridPoint, Contact)>,
    jumps: Vec<f64>,
}

impl<'a> Observer<'a> {
    fn new(scene: &'a Scene) -> Self {
        let metric = scene.metric();
        Self { scene, metric, conduct: Conduct::default(), before: None, jumps: Vec::new() }
    }

    /// The goal moved, and this came of it.
    fn moved(&mut self, goal: &GridPoint, contact: &Contact) {
        self.judge(goal, contact);
        let counts = &mut self.conduct;
        counts.unfinished += u64::from(contact.counters.steps_left > 0);
        if contact.feature == Feature::Free {
            return;
        }
        counts.in_contact += 1;
        counts.vertices += u64::from(contact.counters.vertices);
        counts.faces += u64::from(contact.counters.faces);
        counts.collision_tests += u64::from(contact.counters.collision_tests);
        counts.far_edge_updates += u64::from(contact.counters.far_edge_crossings > 0);
        counts.far_edges += u64::from(contact.counters.far_edge_crossings);
        counts.far_edge_loops += u64::from(contact.counters.far_edge_loops);
        counts.cycles += u64::from(contact.counters.cycles_ended);
    }

    /// Holds the hand still: once nothing is left over, not a bit may change.
    fn hold(&mut self, model: &mut dyn ContactModel, goal: &GridPoint, mut last: Contact) {
        for _ in 0..LONGEST_REST {
            let contact = model.update(self.scene.grid, &self.metric, goal);
            self.judge(goal, &contact);
            if last.counters.steps_left == 0 {
                self.conduct.held += 1;
                self.conduct.restless += u64::from(bits(&last) != bits(&contact));
                return;
            }
            last = contact;
        }
    }

    /// What holds for every update.
    fn judge(&mut self, goal: &GridPoint, contact: &Contact) {
        self.conduct.updates += 1;
        let depth = depth_below_surface(self.scene.grid, &contact.proxy);
        self.conduct.under_surface += u64::from(depth > ROUNDING);
        if let Some((goal_before, before)) = self.before {
            let motion = length(between(&goal_before, goal, &self.metric));
            let [was, is] =
                [&before, contact].map(|contact| cells(contact.distance(), &self.metric));
            let grew = is - was - motion;
            self.conduct.grew += u64::from(grew > ROUNDING * (was + motion + 1.0));
            if motion > 0.0 {
                let [from, to] = [&before, contact].map(|contact| force(contact, &self.metric));
                let change = [0, 1, 2].map(|axis| to[axis] - from[axis]);
                self.jumps.push(length(change) / motion);
            }
        }
        self.before = Some((*goal, *contact));
    }
}

/// Workspace metres as widths of a cell.
pub fn cells(metres: f64, metric: &Metric) -> f64 {
    metres / metric.column
}

/// The force of a spring of stiffness 1 between goal and proxy, widths of a cell.
pub fn force(contact: &Contact, metric: &Metric) -> [f64; 3] {
    contact.displacement.map(|part| cells(part, metric))
}

/// All that a person could feel of a contact, to the last bit.
fn bits(contact: &Contact) -> [u64; 8] {
    let [x, y, z] = contact.displacement.map(f64::to_bits);
    let proxy = contact.proxy;
    let [u, v, elevation] = [proxy.u, proxy.v, proxy.elevation].map(f64::to_bits);
    [x, y, z, u, v, elevation, proxy.column as u64, proxy.row as u64]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Hand;
    use crate::scene::{Field, Mode};
    use contact::{Counters, Model, Proxy};
    use surface::{ByteOrder, Grid, GridLayout, SampleType};

    fn flat() -> Grid {
        let layout = GridLayout::packed(64, 64, 1.0, 1.0, SampleType::I16, ByteOrder::Big);
        Grid::from_vec(vec![0; 64 * 64 * 2], layout.unwrap()).unwrap()
    }

    fn scene(grid: &Grid) -> Scene<'_> {
        Scene {
            key: "flat",
            title: String::new(),
            grid,
            exaggeration: 1.0,
            mode: Mode::Swipe,
            field: Field::Part(10.0, 50.0, 10.0, 50.0),
        }
    }

    /// Right above the goal, but for what is wrong with it.
    struct Wrong {
        /// Added to the height in every update.
        climbs: f64,
        height: f64,
    }

    impl ContactModel for Wrong {
        fn name(&self) -> &'static str {
            "wrong"
        }

        fn proxy(&self) -> Proxy {
            Proxy::in_space(GridPoint::new(0.0, 0.0, self.height))
        }

        fn take_over(&mut self, _proxy: Proxy) {}

        fn update(&mut self, _grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
            self.height += self.climbs;
            let proxy = GridPoint { elevation: self.height, ..*goal };
            Contact {
                proxy,
                feature: Feature::Face,
                displacement: [0.0, 0.0, (self.height - goal.elevation) * metric.up],
                counters: Counters::default(),
            }
        }
    }

    fn judged(model: &mut dyn ContactModel) -> Conduct {
        let grid = flat();
        let scene = scene(&grid);
        Conduct::along(model, &scene, &Hand::new(0.1, 1).over(&scene, 800))
    }

    #[test]
    fn a_model_without_fault_has_none() {
        let conduct = judged(&mut *Model::ProxyGraph.build(1000));
        assert_eq!((conduct.grew, conduct.restless, conduct.under_surface), (0, 0, 0));
        assert_eq!((conduct.updates, conduct.held), (900, 100));
        assert!(conduct.jump.worst <= 1.0 + 1e-9, "{:?}", conduct.jump);
    }

    #[test]
    fn a_proxy_that_moves_by_itself_is_seen() {
        let conduct = judged(&mut Wrong { climbs: 0.5, height: 0.0 });
        assert!(conduct.grew > 800 && conduct.held == conduct.restless);
        let conduct = judged(&mut Wrong { climbs: 1e-15, height: 0.0 });
        assert_eq!(conduct.grew, 0, "rounding");
        assert_eq!(conduct.restless, 100, "but not one bit of a held hand may change");
    }

    #[test]
    fn a_proxy_in_the_ground_is_seen() {
        assert_eq!(judged(&mut Wrong { climbs: 0.0, height: -1e-6 }).under_surface, 900);
        assert_eq!(judged(&mut Wrong { climbs: 0.0, height: 0.0 }).under_surface, 0);
    }
}
