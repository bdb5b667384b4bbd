//! What keeps a machine busy while lateness is measured.

use std::error::Error;
use std::hint::black_box;
use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;

/// A thread without end on every core, of normal priority, until it is dropped.
pub struct Busy {
    stop: Arc<AtomicBool>,
    threads: Vec<JoinHandle<()>>,
}

impl Busy {
    /// Sets them going.
    pub fn every_core() -> Self {
        let stop = Arc::new(AtomicBool::new(false));
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let spin = |stop: Arc<AtomicBool>| {
            move || {
                let mut number = 1u64;
                while !stop.load(Ordering::Relaxed) {
                    number = black_box(number.wrapping_mul(6_364_136_223_846_793_005));
                }
            }
        };
        let threads = (0..cores).map(|_| std::thread::spawn(spin(Arc::clone(&stop)))).collect();
        Self { stop, threads }
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        for thread in self.threads.drain(..) {
            let _ = thread.join();
        }
    }
}

/// A program that builds meshes until its input ends: it prints a line when it begins, and how many
/// it has built when it ends.
pub struct Mesh {
    program: Child,
    says: BufReader<ChildStdout>,
}

impl Mesh {
    /// Starts it, and waits until it builds.
    pub fn built_by(command: &str) -> Result<Self, Box<dyn Error>> {
        let mut words = command.split_whitespace();
        let name = words.next().ok_or("--mesh names no program")?;
        let mut program = Command::new(name)
            .args(words)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{name}: {error}"))?;
        let says = program.stdout.take().ok_or("the program has no output")?;
        let mut mesh = Self { program, says: BufReader::new(says) };
        let mut line = String::new();
        if mesh.says.read_line(&mut line)? == 0 {
            return Err(format!("{command}: it ended before it built a mesh").into());
        }
        Ok(mesh)
    }

    /// Ends it; how many meshes it built.
    pub fn stop(mut self) -> Result<u64, Box<dyn Error>> {
        drop(self.program.stdin.take());
        let mut rest = String::new();
        self.says.read_to_string(&mut rest)?;
        self.program.wait()?;
        let last = rest.lines().last().unwrap_or_default();
        last.trim().parse().map_err(|_| format!("expected how many meshes, found {last:?}").into())
    }
}
