//! How long it takes only to load the samples that an update needs.
//!
//! A model cannot know which sample it needs next before it has seen the last one: its limit is a
//! chain in which every address depends on the value before. The same loads without that dependence
//! show what a model could gain that knew its way beforehand.

use crate::crossings::corners_entered;
use crate::path::Course;
use crate::scene::{Scene, between, length};
use contact::{Contact, ContactModel, Model, Place, Proxy, ProxyGraph};
use std::hint::black_box;
use surface::{Grid, GridPoint, Half, Metric, Triangle};

/// Longer ways of the proxy graph are cut here.
const MOST_STEPS: usize = 512;

/// For each update of a course, the addresses of samples in the order they are needed, `GROUP` at a
/// time that do not depend on each other.
pub struct Loads<const GROUP: usize> {
    addresses: Vec<[usize; GROUP]>,
    /// Where each update's addresses begin, and where the last ones end.
    begins: Vec<usize>,
}

impl<const GROUP: usize> Loads<GROUP> {
    fn new() -> Self {
        Self { addresses: Vec::new(), begins: vec![0] }
    }

    /// Groups of loads in an update, mean.
    pub fn mean(&self) -> f64 {
        self.addresses.len() as f64 / (self.begins.len() - 1).max(1) as f64
    }

    /// Reads the lists of addresses of these updates, so that they are not what is waited for.
    pub fn warm(&self, updates: std::ops::Range<usize>) {
        black_box(&self.begins[updates.start..=updates.end]);
        let listed = &self.addresses[self.begins[updates.start]..self.begins[updates.end]];
        black_box(listed.iter().flatten().fold(0, |all, address| all ^ address));
    }

    /// Loads what one update needs, each group after the one before: the address of every load is
    /// computed from what was read last. `zero` must be 0, and unknown to the compiler.
    ///
    /// # Safety
    /// The grid that the addresses were taken from must still be there.
    #[inline(always)]
    pub unsafe fn load_chained(&self, update: usize, zero: usize) {
        let mut seen = 0;
        for group in self.of(update) {
            let nothing = seen & zero;
            seen = 0;
            for address in group {
                // SAFETY: `nothing` is 0; the caller keeps the grid.
                seen ^= unsafe { read(address + nothing) };
            }
        }
        black_box(seen);
    }

    /// Loads what one update needs, as fast as the processor can.
    ///
    /// # Safety
    /// The grid that the addresses were taken from must still be there.
    #[inline(always)]
    pub unsafe fn load_freely(&self, update: usize) {
        let mut seen = 0;
        for address in self.of(update).iter().flatten() {
            // SAFETY: the caller keeps the grid.
            seen ^= unsafe { read(*address) };
        }
        black_box(seen);
    }

    fn of(&self, update: usize) -> &[[usize; GROUP]] {
        &self.addresses[self.begins[update]..self.begins[update + 1]]
    }

    fn end_update(&mut self) {
        self.begins.push(self.addresses.len());
    }
}

/// Reads two bytes, which every sample has.
#[inline(always)]
unsafe fn read(address: usize) -> usize {
    // SAFETY: the caller knows that a sample is there; byte pairs need no alignment.
    let bytes = unsafe { (address as *const [u8; 2]).read_volatile() };
    usize::from(u16::from_ne_bytes(bytes))
}

/// The walk's limit: the new corner of every triangle under the straight line from each proxy to
/// the next.
pub fn walk_loads(scene: &Scene, course: &Course, contacts: &[Contact]) -> Loads<1> {
    let mut loads = Loads::new();
    for (update, contact) in contacts.iter().enumerate() {
        let from = match course.start_at(update) {
            Some(start) => start.position,
            None => contacts[update - 1].proxy,
        };
        for (column, row) in corners_entered(&from, &contact.proxy) {
            loads.addresses.extend(scene.grid.sample_address(column, row).map(|at| [at as usize]));
        }
        loads.end_update();
    }
    loads
}

/// The graph's limit: for every vertex that it visits, the samples above, of and below it. Also
/// gives the vertices.
pub fn graph_loads(scene: &Scene, course: &Course) -> (Loads<3>, Vec<Vec<(i64, i64)>>) {
    let metric = scene.metric();
    let mut graph = Model::ProxyGraph.build(Model::ProxyGraph.default_step_budget());
    let mut steppers = Steppers(Vec::new());
    let (mut loads, mut visited) = (Loads::new(), Vec::new());
    for (update, goal) in course.goals.iter().enumerate() {
        if let Some(start) = course.start_at(update) {
            graph.take_over(start);
        }
        let vertices = steppers.visited(scene.grid, &metric, graph.proxy(), goal);
        for &(column, row) in &vertices {
            let address = |south: i64| scene.grid.sample_address(column, row + south);
            if let (Some(north), Some(here), Some(south)) = (address(-1), address(0), address(1)) {
                loads.addresses.push([north as usize, here as usize, south as usize]);
            }
        }
        loads.end_update();
        visited.push(vertices);
        graph.update(scene.grid, &metric, goal);
    }
    (loads, visited)
}

/// Proxy graphs with step budgets of 1, 2, 3 and so on: the k-th stops on the (k + 1)-th vertex.
///
/// One graph that takes one step in each of many updates would not do: it begins every update at the
/// nearest corner of the triangle that blocks it, and so skips vertices.
struct Steppers(Vec<Box<dyn ContactModel>>);

impl Steppers {
    /// The vertices that the proxy graph visits on its way from a proxy to a goal, in order.
    fn visited(
        &mut self,
        grid: &Grid,
        metric: &Metric,
        from: Proxy,
        goal: &GridPoint,
    ) -> Vec<(i64, i64)> {
        let mut visited: Vec<_> = first_vertex(grid, metric, &from, goal).into_iter().collect();
        for budget in 1..=MOST_STEPS {
            if self.0.len() < budget {
                self.0.push(Box::new(ProxyGraph::stopping_after(budget as u32)));
            }
            let stepper = &mut self.0[budget - 1];
            stepper.take_over(from);
            let contact = stepper.update(grid, metric, goal);
            if budget == 1 && contact.counters.cells > 0 {
                // It went through the air first, and begins in the triangle that it meets.
                visited.clear();
            }
            if let Place::Vertex { column, row } = stepper.proxy().place
                && visited.last() != Some(&(column, row))
            {
                visited.push((column, row));
            }
            if contact.counters.steps_left == 0 {
                break;
            }
        }
        visited
    }
}

/// Where constrained minimisation begins where no ray goes first: the corner closest to the goal of
/// the triangle that the way to it leads over.
fn first_vertex(
    grid: &Grid,
    metric: &Metric,
    from: &Proxy,
    goal: &GridPoint,
) -> Option<(i64, i64)> {
    let triangle = match from.place {
        Place::Space(_) => return None,
        Place::Face(triangle) => triangle,
        Place::Edge { .. } | Place::Vertex { .. } => triangle_ahead(&from.position, goal),
    };
    let distance = |&(column, row): &(i64, i64)| {
        let elevation = grid.elevation(column, row).unwrap_or(f64::NAN);
        let corner = GridPoint::from_sample(column, row, 0.0, 0.0, elevation);
        length(between(&corner, goal, metric))
    };
    triangle.corners().into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// The triangle a little way from a point on the straight way to a goal.
fn triangle_ahead(from: &GridPoint, goal: &GridPoint) -> Triangle {
    let [columns, rows, _] = goal.relative_to(from.column, from.row, 0.0);
    let (east, south) = (columns - from.u, rows - from.v);
    let little = 1e-9 / east.hypot(south).max(1e-9);
    let (u, v) = (from.u + little * east, from.v + little * south);
    let ahead = GridPoint::from_sample(from.column, from.row, u, v, 0.0);
    let half = if ahead.u >= ahead.v { Half::NorthEast } else { Half::SouthWest };
    Triangle { column: ahead.column, row: ahead.row, half }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Hand;
    use crate::random::Random;
    use crate::scene::{Field, Mode};
    use crate::trace::trace;
    use surface::{ByteOrder, GridLayout, SampleType};

    fn bumpy() -> Grid {
        let layout = GridLayout::packed(300, 300, 100.0, 100.0, SampleType::I16, ByteOrder::Big);
        let mut random = Random::new(9);
        let bytes = (0..300 * 300).flat_map(|_| (random.below(8) as i16).to_be_bytes());
        Grid::from_vec(bytes.collect(), layout.unwrap().with_wrap(true)).unwrap()
    }

    fn scene(grid: &Grid) -> Scene<'_> {
        Scene {
            key: "bumpy",
            title: String::new(),
            grid,
            exaggeration: 1.0,
            mode: Mode::Swipe,
            field: Field::Rows(50.0, 250.0),
        }
    }

    #[test]
    fn the_graphs_loads_are_the_vertices_that_it_says_it_visits() {
        let grid = bumpy();
        let scene = scene(&grid);
        let course = Hand::new(13.4, 1).over(&scene, 600);
        let (loads, visited) = graph_loads(&scene, &course);
        let contacts = trace(&mut *Model::ProxyGraph.build(4096), &scene, &course);
        let mut compared = 0;
        for (vertices, contact) in visited.iter().zip(&contacts).skip(1) {
            // Where it goes through the air in between, a vertex may be left and met again.
            if contact.counters.collision_tests == 1 && contact.counters.vertices > 0 {
                assert_eq!(vertices.len(), contact.counters.vertices as usize);
                compared += 1;
            }
        }
        assert!(compared > 400, "{compared}");
        let all: usize = visited.iter().map(Vec::len).sum();
        assert_eq!(loads.mean() * 600.0, all as f64);
    }

    #[test]
    fn the_walks_loads_are_one_for_each_border_under_its_way() {
        let grid = bumpy();
        let scene = scene(&grid);
        let course = Hand::new(3.0, 1).over(&scene, 200);
        let contacts = trace(&mut *Model::default().build(4096), &scene, &course);
        let loads = walk_loads(&scene, &course, &contacts);
        // A way of 3 cells crosses 3 (|cos| + |sin| + |cos - sin|) borders.
        assert!((5.0..8.5).contains(&loads.mean()), "{}", loads.mean());
        assert_eq!(loads.begins.len(), 201);
        // SAFETY: the grid is still there.
        unsafe { (0..200).for_each(|update| loads.load_chained(update, 0)) };
    }
}
