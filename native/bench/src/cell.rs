//! One scene at one speed: times, conduct and errors of every model on the same path.

use crate::cache::{CAN_FLUSH, Lines, Warmth};
use crate::conduct::Conduct;
use crate::contenders::CONTENDERS;
use crate::errors::{Errors, Reference};
use crate::limits::{graph_loads, walk_loads};
use crate::path::{Course, Hand};
use crate::scene::Scene;
use crate::statistics::Spread;
use crate::timing::{BLOCK, Entry, Runner, Stopwatch, Track};
use crate::trace::trace;

/// The limits, in the order in which they are timed after the models.
pub const LIMITS: [&str; 4] =
    ["limit_walk_chained", "limit_walk_free", "limit_graph_chained", "limit_graph_free"];

/// Of [`LIMITS`]: one sample a triangle, each after the one before.
pub const WALK_CHAINED: &str = LIMITS[0];
/// Of [`LIMITS`]: the same samples, all at once.
pub const WALK_FREE: &str = LIMITS[1];
/// Of [`LIMITS`]: three samples a vertex, each vertex after the one before.
pub const GRAPH_CHAINED: &str = LIMITS[2];

/// How many updates each part of a cell gets.
#[derive(Clone, Copy)]
pub struct Updates {
    /// Timed, in each state of the caches.
    pub timed: usize,
    /// How often they are timed; the quietest time counts.
    pub repeats: usize,
    /// Judged without an oracle.
    pub judged: usize,
    /// Compared with the oracle.
    pub compared: usize,
}

/// Everything measured in a scene at a speed, for every model in the order of [`CONTENDERS`].
pub struct Cell {
    /// Cells over the ground in each update.
    pub speed: f64,
    /// Nanoseconds, models and then limits.
    pub times: Times,
    /// What they do.
    pub conducts: Vec<Conduct>,
    /// Where they end.
    pub errors: Vec<Errors>,
    /// Share of updates in which the oracle itself is not at a local minimum.
    pub oracle_not_minimal: f64,
}

/// Nanoseconds of an update of every model, then of every limit.
pub struct Times {
    /// Everything in the caches.
    pub hot: Vec<Spread>,
    /// Nothing in the caches; empty where it cannot be taken out of them.
    pub cold: Vec<Spread>,
    /// Groups of samples that the walk's and the graph's limit load in an update.
    pub loads: [f64; 2],
    /// Cache lines in an update, of all models together.
    pub lines: f64,
}

impl Cell {
    /// Measures it.
    pub fn measure(scene: &Scene, speed: f64, updates: Updates, stopwatch: &Stopwatch) -> Self {
        let hand = |seed| Hand::new(speed, seed);
        let course = hand(1).over(scene, updates.timed);
        let times = Times::measure(scene, &course, updates.repeats, stopwatch);
        let course = hand(2).over(scene, updates.judged);
        let conducts = CONTENDERS
            .iter()
            .map(|contender| Conduct::along(&mut *contender.build(), scene, &course))
            .collect();
        let course = hand(3).over(scene, updates.compared);
        let reference = Reference::along(scene, &course);
        let errors = CONTENDERS
            .iter()
            .map(|contender| Errors::measure(contender, scene, &course, &reference))
            .collect();
        let oracle_not_minimal = reference.not_minimal(scene, &course);
        Self { speed, times, conducts, errors, oracle_not_minimal }
    }
}

impl Times {
    /// Times every model and every limit on a course. Of several `repeats` the one counts in which
    /// all together were fastest: what other programs add is not the models'.
    fn measure(scene: &Scene, course: &Course, repeats: usize, stopwatch: &Stopwatch) -> Self {
        let traces: Vec<_> = CONTENDERS
            .iter()
            .map(|contender| trace(&mut *contender.build(), scene, course))
            .collect();
        let single = walk_loads(scene, course, &traces[0]);
        let (triple, vertices) = graph_loads(scene, course);
        let lines = Lines::around(scene, course, &traces, &vertices, BLOCK);
        let track = Track { grid: scene.grid, metric: scene.metric(), course, lines: Some(&lines) };

        let models = CONTENDERS.iter().map(|contender| Runner::Model(contender.build()));
        let limits = [
            Runner::Single { loads: &single, chained: true },
            Runner::Single { loads: &single, chained: false },
            Runner::Triple { loads: &triple, chained: true },
            Runner::Triple { loads: &triple, chained: false },
        ];
        let mut entries: Vec<_> =
            models.chain(limits).map(|runner| Entry { runner, track: &track }).collect();
        let mut quietest = |warmth| {
            let races = (0..repeats).map(|_| stopwatch.race(&mut entries, warmth));
            races.min_by(|a, b| together(a).total_cmp(&together(b))).unwrap_or_default()
        };
        let hot = quietest(Warmth::Hot);
        let cold = if CAN_FLUSH { quietest(Warmth::Cold) } else { Vec::new() };
        Self { hot, cold, loads: [single.mean(), triple.mean()], lines: lines.mean() }
    }
}

/// How long all medians are: as their product, so that every contender counts the same.
fn together(times: &[Spread]) -> f64 {
    times.iter().map(|spread| spread.median.max(1.0).ln()).sum()
}

/// A model's or limit's place in [`Times::hot`] and [`Times::cold`].
pub fn index_of(key: &str) -> usize {
    let mut keys = CONTENDERS.iter().map(|contender| contender.key).chain(LIMITS);
    keys.position(|known| known == key).expect("a contender or a limit")
}
