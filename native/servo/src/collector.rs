//! Where ticks go after the ring: to whoever drains them, to the pre-roll, to a take and its file.
//!
//! The servo only fills the ring. The [`Collector`] has the ring's other end, and everything that
//! takes time: memory for a take, the disk for its spool. A live session has a helper thread for it
//! ([`Helper`](crate::helper::Helper)) while a take is recorded or a pre-roll is kept; a stepped one
//! collects between its steps, so that a take is the same however fast it goes. Without either,
//! nobody empties the ring but [`Session::drain`](crate::Session::drain).
//!
//! Two locks, so that a slow disk holds up nobody: the spool's is held while the disk is waited for,
//! the ticks' only while ticks are moved. Whoever wants both takes the spool's first.

use std::collections::VecDeque;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};

use rtrb::Consumer;
use takes::{Header, MOST_IN_BLOCK, Spool, Take, Tick, WriteError};

use crate::{Recorded, Recording, TickRecord};

/// Ticks of the stepped session after which they are spooled: what a crash may lose.
const STEPS_IN_BLOCK: usize = 1000;

pub(crate) struct Collector {
    spool: Mutex<Option<Spool>>,
    collected: Mutex<Collected>,
}

struct Collected {
    ring: Consumer<TickRecord>,
    /// How many ticks the ring takes.
    ring_capacity: usize,
    /// The newest ticks: for the pre-roll, and for drains while something else empties the ring.
    recent: VecDeque<TickRecord>,
    /// How many ticks before a recording belong to it.
    pre_roll: usize,
    /// The newest tick that came out of the ring.
    newest: u64,
    /// The newest tick that a drain gave.
    drained: u64,
    /// Whether anybody drains.
    is_drained: bool,
    recording: Option<InTheMaking>,
}

struct InTheMaking {
    take: Take,
    /// Where it is spooled to.
    path: Option<PathBuf>,
    /// How many of its ticks were written.
    spooled: usize,
    /// Why no more are.
    failure: Option<String>,
}

impl Collector {
    pub(crate) fn new(ring: Consumer<TickRecord>, ring_capacity: usize) -> Collector {
        Collector {
            spool: Mutex::new(None),
            collected: Mutex::new(Collected {
                ring,
                ring_capacity,
                recent: VecDeque::new(),
                pre_roll: 0,
                newest: 0,
                drained: 0,
                is_drained: false,
                recording: None,
            }),
        }
    }

    /// Whether ticks are wanted by more than a drain.
    pub(crate) fn is_busy(&self) -> bool {
        let collected = self.collected();
        collected.pre_roll > 0 || collected.recording.is_some()
    }

    /// How many ticks may be done between two times of [`collect`](Self::collect).
    pub(crate) fn ring_capacity(&self) -> usize {
        self.collected().ring_capacity
    }

    /// Whether anybody has ever drained.
    pub(crate) fn is_drained(&self) -> bool {
        self.collected().is_drained
    }

    /// From now on so many ticks are kept for a recording to begin with.
    pub(crate) fn set_pre_roll(&self, ticks: usize) {
        let mut collected = self.collected();
        collected.collect();
        collected.pre_roll = ticks;
        collected.forget_old();
    }

    /// Empties the ring.
    pub(crate) fn collect(&self) {
        self.collected().collect();
    }

    /// Every tick since the last time, as far as they were kept.
    pub(crate) fn drain(&self) -> Vec<TickRecord> {
        let mut collected = self.collected();
        collected.is_drained = true;
        collected.collect();
        let given = collected.recent.partition_point(|record| record.tick <= collected.drained);
        let drained = collected.recent.range(given..).copied().collect();
        collected.drained = collected.newest;
        collected.forget_old();
        drained
    }

    /// Begins a take at the tick after `done`; false where there is one already.
    pub(crate) fn begin(
        &self,
        mut header: Header,
        path: Option<&Path>,
        done: u64,
    ) -> Result<bool, WriteError> {
        let mut spool = self.spool();
        let mut collected = self.collected();
        if collected.recording.is_some() {
            return Ok(false);
        }
        collected.collect();
        let before = collected.recent.len().min(collected.pre_roll);
        header.pre_roll = before as u64;
        *spool = path.map(|path| Spool::create(path, &header)).transpose()?;
        let next = done.max(collected.newest) + 1;
        let mut take = Take::new(header, (before == 0).then_some(next));
        let first = collected.recent.len() - before;
        collected.recent.range(first..).for_each(|record| take.push(Tick::from(record)));
        let path = path.map(Path::to_owned);
        collected.recording = Some(InTheMaking { take, path, spooled: 0, failure: None });
        Ok(true)
    }

    /// What there is of the take.
    pub(crate) fn recording(&self) -> Option<Recording> {
        let collected = self.collected();
        let recording = collected.recording.as_ref()?;
        Some(Recording {
            ticks: recording.take.ticks.len(),
            seconds: recording.take.seconds(),
            dropped: recording.take.dropped,
            spool: recording.path.clone(),
            spooled: recording.spooled,
            failure: recording.failure.clone(),
        })
    }

    /// The take so far; `None` where there is none.
    pub(crate) fn so_far(&self) -> Option<Take> {
        let mut collected = self.collected();
        collected.collect();
        collected.recording.as_ref().map(|recording| recording.take.clone())
    }

    /// Ends the take, whose last tick is `done`, and finishes its spool; `None` where there is none.
    pub(crate) fn end(&self, done: u64) -> Option<Recorded> {
        let mut spool = self.spool();
        let mut collected = self.collected();
        collected.collect();
        let InTheMaking { mut take, mut failure, .. } = collected.recording.take()?;
        collected.forget_old();
        // The disk is waited for without them.
        drop(collected);
        take.miss_until(done + 1);
        let mut spool = spool.take();
        if let Some(spool) = spool.as_mut().filter(|_| failure.is_none()) {
            failure = finish(spool, &take).err().map(|error| error.to_string());
        }
        Some(Recorded { take, spool, failure })
    }

    /// Writes to the disk what it has not got yet.
    pub(crate) fn spool_all(&self) {
        self.spool_ticks(1);
    }

    /// The same between steps, a block at a time.
    pub(crate) fn spool_steps(&self) {
        self.spool_ticks(STEPS_IN_BLOCK);
    }

    /// Writes while there are at least so many ticks to write, and until the disk fails: then the file
    /// stays as it is, and memory goes on.
    fn spool_ticks(&self, least: usize) {
        let mut spool = self.spool();
        let Some(spool) = &mut *spool else { return };
        while let Some((ticks, dropped)) = self.unwritten(least) {
            let written = spool.write(&ticks, dropped).and_then(|()| spool.sync_in_time());
            if let Some(recording) = &mut self.collected().recording {
                recording.spooled = spool.ticks() as usize;
                recording.failure = written.err().map(|error| error.to_string());
            }
            if ticks.len() < MOST_IN_BLOCK {
                return;
            }
        }
    }

    /// Ticks of the take that were not written, up to a block of them, or none where there are not so
    /// many as `least`; and how many were lost by then. `None` where no more can be written.
    fn unwritten(&self, least: usize) -> Option<(Vec<Tick>, u64)> {
        let collected = self.collected();
        let recording = collected.recording.as_ref().filter(|take| take.failure.is_none())?;
        let (ticks, first) = (&recording.take.ticks, recording.spooled);
        let are_enough = ticks.len() - first >= least;
        let ticks = if are_enough { ticks.part(first, MOST_IN_BLOCK) } else { Vec::new() };
        Some((ticks, recording.take.dropped))
    }

    fn spool(&self) -> MutexGuard<'_, Option<Spool>> {
        self.spool.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    fn collected(&self) -> MutexGuard<'_, Collected> {
        self.collected.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

/// Writes what is missing, and marks the file as whole.
fn finish(spool: &mut Spool, take: &Take) -> io::Result<()> {
    loop {
        let ticks = take.ticks.part(spool.ticks() as usize, MOST_IN_BLOCK);
        if ticks.is_empty() {
            return spool.finish(take.dropped);
        }
        spool.write(&ticks, take.dropped)?;
    }
}

impl Collected {
    fn collect(&mut self) {
        // Asked once: ticks done meanwhile are left for the next time.
        for _ in 0..self.ring.slots() {
            let Ok(record) = self.ring.pop() else { return };
            self.newest = record.tick;
            if let Some(recording) = &mut self.recording {
                recording.take.push(Tick::from(&record));
            }
            if self.recent.len() >= self.most_recent() {
                self.recent.pop_front();
            }
            self.recent.push_back(record);
        }
    }

    fn most_recent(&self) -> usize {
        self.pre_roll.max(self.ring_capacity)
    }

    /// Drops what neither a drain nor a recording can want any more.
    fn forget_old(&mut self) {
        let drained = self.recent.partition_point(|record| record.tick <= self.drained);
        let for_pre_roll = self.recent.len().saturating_sub(self.pre_roll);
        self.recent.drain(..drained.min(for_pre_roll));
        if self.pre_roll == 0 && self.recent.is_empty() {
            self.recent.shrink_to_fit();
        }
    }
}
