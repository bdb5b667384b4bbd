//! The thread that keeps the ring from overflowing, so that neither the servo nor the host needs to.

use std::io;
use std::sync::Arc;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

use crate::collector::Collector;

/// Between two looks at the ring: an end of the program takes no more from a take.
const PERIOD: Duration = Duration::from_millis(50);

/// The thread's name, as debuggers and task lists show it (Linux shows 15 letters).
const THREAD_NAME: &str = "haptic-recorder";

/// Collects and spools for as long as it is there.
pub(crate) struct Helper {
    /// A fork leaves threads behind.
    process: u32,
    /// Hanging up ends the thread.
    line: Option<mpsc::Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Helper {
    pub(crate) fn start(collector: Arc<Collector>) -> io::Result<Helper> {
        let (line, end) = mpsc::channel::<()>();
        let thread = Builder::new().name(THREAD_NAME.to_owned()).spawn(move || {
            while let Err(RecvTimeoutError::Timeout) = end.recv_timeout(PERIOD) {
                collector.collect();
                collector.spool_all();
            }
        })?;
        Ok(Helper { process: std::process::id(), line: Some(line), thread: Some(thread) })
    }

    /// Whether the thread is this process's.
    pub(crate) fn is_here(&self) -> bool {
        self.process == std::process::id()
    }
}

impl Drop for Helper {
    fn drop(&mut self) {
        let (line, thread) = (self.line.take(), self.thread.take());
        if !self.is_here() {
            // There is nothing to end in this process, and what the thread held is held for ever.
            std::mem::forget((line, thread));
            return;
        }
        drop(line);
        // A thread that broke down has nothing to tell that its take does not.
        let _ = thread.map(JoinHandle::join);
    }
}
