//! Updates timed one by one, the contenders shuffled in blocks.
//!
//! In a fixed order one contender would always pay for what the one before did to the caches.

use crate::cache::{Lines, Sweep, Warmth};
use crate::clock;
use crate::limits::Loads;
use crate::path::Course;
use crate::random::Random;
use crate::statistics::Spread;
use contact::ContactModel;
use std::hint::black_box;
use std::ops::Range;
use surface::{Grid, Metric};

/// Updates in a block.
pub const BLOCK: usize = 16;

/// Something that is timed.
pub enum Runner<'a> {
    /// A contact model, called as the servo calls it.
    Model(Box<dyn ContactModel>),
    /// The loads of a model that reads one sample a step: each after the one before, or freely.
    Single { loads: &'a Loads<1>, chained: bool },
    /// The same for a model that reads three rows a step.
    Triple { loads: &'a Loads<3>, chained: bool },
}

/// Where something is run.
pub struct Track<'a> {
    /// The ground.
    pub grid: &'a Grid,
    /// Of the workspace.
    pub metric: Metric,
    /// The hand's path.
    pub course: &'a Course,
    /// What may be read; needed unless the caches are left as they are.
    pub lines: Option<&'a Lines>,
}

/// Something that is timed, and where.
pub struct Entry<'a> {
    /// What.
    pub runner: Runner<'a>,
    /// Where.
    pub track: &'a Track<'a>,
}

/// What times them.
pub struct Stopwatch {
    sweep: Sweep,
    ticks_per_nanosecond: f64,
}

impl Stopwatch {
    /// Sets the clock against the system's.
    pub fn new() -> std::io::Result<Self> {
        let ticks_per_nanosecond = clock::ticks_per_nanosecond();
        Ok(Self { sweep: Sweep::new()?, ticks_per_nanosecond })
    }

    /// Times every update of every entry, blocks shuffled; nanoseconds for each entry, less what the
    /// clock takes itself. All courses must have as many updates.
    pub fn race(&self, entries: &mut [Entry], warmth: Warmth) -> Vec<Spread> {
        let updates = entries[0].track.course.goals.len();
        let mut order: Vec<Option<usize>> = (0..entries.len()).map(Some).chain([None]).collect();
        let mut ticks: Vec<Vec<u64>> = order.iter().map(|_| Vec::with_capacity(updates)).collect();
        let mut random = Random::new(0x7261_6365);
        for first in (0..updates).step_by(BLOCK) {
            let block = first..(first + BLOCK).min(updates);
            random.shuffle(&mut order);
            for turn in &order {
                let Some(turn) = *turn else {
                    time(block.clone(), &mut ticks[entries.len()], |update| {
                        black_box(update);
                    });
                    continue;
                };
                let Entry { runner, track } = &mut entries[turn];
                self.prepare(track, first / BLOCK, warmth);
                runner.set_down(track.course, first);
                runner.run(track, block.clone(), &mut ticks[turn]);
            }
        }
        let empty = ticks.pop().map_or(0.0, |ticks| median(&ticks));
        let nanoseconds = |ticks: u64| (ticks as f64 - empty) / self.ticks_per_nanosecond;
        let spread = |ticks: Vec<u64>| Spread::of(ticks.into_iter().map(nanoseconds).collect());
        ticks.into_iter().map(spread).collect()
    }

    /// The time of the first try and the least of all for something that begins the same each time,
    /// nanoseconds.
    pub fn first_and_least_of<T>(
        &self,
        tries: usize,
        mut begin: impl FnMut(),
        mut run: impl FnMut() -> T,
    ) -> (f64, f64, T) {
        let mut once = || {
            begin();
            let began = clock::start();
            let outcome = run();
            ((clock::stop() - began) as f64 / self.ticks_per_nanosecond, outcome)
        };
        let (first, mut outcome) = once();
        let mut least = first;
        for _ in 1..tries {
            let next = once();
            if next.0 < least {
                (least, outcome) = next;
            }
        }
        (first, least, outcome)
    }

    fn prepare(&self, track: &Track, block: usize, warmth: Warmth) {
        let Some(lines) = track.lines else { return };
        // SAFETY: the lines are of the track's own grid, which it borrows.
        unsafe {
            match warmth {
                Warmth::Hot => lines.warm(block),
                Warmth::Cold => {
                    lines.flush(block);
                    self.sweep.run();
                }
                Warmth::Untouched => {}
            }
        }
    }
}

fn median(ticks: &[u64]) -> f64 {
    Spread::of(ticks.iter().map(|ticks| *ticks as f64).collect()).median
}

impl Runner<'_> {
    fn set_down(&mut self, course: &Course, update: usize) {
        if let (Self::Model(model), Some(start)) = (self, course.start_at(update)) {
            model.take_over(start);
        }
    }

    /// Runs a block of updates, each timed on its own.
    fn run(&mut self, track: &Track, block: Range<usize>, ticks: &mut Vec<u64>) {
        let Track { grid, metric, course, .. } = track;
        black_box(&course.goals[block.clone()]);
        let zero = black_box(0usize);
        match self {
            Self::Model(model) => time(block, ticks, |update| {
                black_box(model.update(grid, metric, &course.goals[update]));
            }),
            Self::Single { loads, chained } => {
                loads.warm(block.clone());
                // SAFETY: the loads are of the track's own grid.
                time(block, ticks, |update| unsafe {
                    if *chained {
                        loads.load_chained(update, zero)
                    } else {
                        loads.load_freely(update)
                    }
                });
            }
            Self::Triple { loads, chained } => {
                loads.warm(block.clone());
                // SAFETY: the loads are of the track's own grid.
                time(block, ticks, |update| unsafe {
                    if *chained {
                        loads.load_chained(update, zero)
                    } else {
                        loads.load_freely(update)
                    }
                });
            }
        }
    }
}

#[inline(always)]
fn time(block: Range<usize>, ticks: &mut Vec<u64>, mut run: impl FnMut(usize)) {
    for update in block {
        let began = clock::start();
        run(update);
        ticks.push(clock::stop().saturating_sub(began));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Hand;
    use crate::scene::{Field, Mode, Scene};
    use contact::{Contact, Model, Proxy};
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use surface::{ByteOrder, GridLayout, GridPoint, SampleType};

    /// Counts what it is asked for, and does it.
    struct Counted {
        inner: Box<dyn ContactModel>,
        updates: Arc<AtomicUsize>,
        starts: Arc<AtomicUsize>,
    }

    impl ContactModel for Counted {
        fn name(&self) -> &'static str {
            self.inner.name()
        }

        fn proxy(&self) -> Proxy {
            self.inner.proxy()
        }

        fn take_over(&mut self, proxy: Proxy) {
            self.starts.fetch_add(1, Ordering::Relaxed);
            self.inner.take_over(proxy);
        }

        fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
            self.updates.fetch_add(1, Ordering::Relaxed);
            self.inner.update(grid, metric, goal)
        }
    }

    #[test]
    fn every_contender_does_every_update_once_and_begins_every_leg() {
        let layout = GridLayout::packed(64, 64, 1.0, 1.0, SampleType::I16, ByteOrder::Big);
        let grid = Grid::from_vec(vec![0; 64 * 64 * 2], layout.unwrap()).unwrap();
        let scene = Scene {
            key: "flat",
            title: String::new(),
            grid: &grid,
            exaggeration: 1.0,
            mode: Mode::Swipe,
            field: Field::Part(10.0, 50.0, 10.0, 50.0),
        };
        let course = Hand { leg: 2 * BLOCK, ..Hand::new(0.5, 1) }.over(&scene, 7 * BLOCK + 3);
        let lines = Lines::around(&scene, &course, &[], &[], BLOCK);
        let track =
            Track { grid: &grid, metric: scene.metric(), course: &course, lines: Some(&lines) };
        for warmth in [Warmth::Hot, Warmth::Cold, Warmth::Untouched] {
            let counts: Vec<_> = (0..3).map(|_| <[Arc<AtomicUsize>; 2]>::default()).collect();
            let mut entries: Vec<_> = counts
                .iter()
                .map(|[updates, starts]| {
                    let inner = Model::ProxyGraph.build(1000);
                    let (updates, starts) = (updates.clone(), starts.clone());
                    let runner = Runner::Model(Box::new(Counted { inner, updates, starts }));
                    Entry { runner, track: &track }
                })
                .collect();
            let times = Stopwatch::new().unwrap().race(&mut entries, warmth);
            assert_eq!(times.len(), 3);
            for [updates, starts] in &counts {
                assert_eq!(updates.load(Ordering::Relaxed), 7 * BLOCK + 3);
                assert_eq!(starts.load(Ordering::Relaxed), 4);
            }
        }
    }
}
