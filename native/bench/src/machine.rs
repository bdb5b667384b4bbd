//! What the figures were measured on.

use crate::figures::Figures;

/// What is built into this program, and what it runs on.
pub struct Machine {
    /// The processor's own name.
    pub processor: String,
    /// Cores that this process may use.
    pub cores: usize,
}

impl Machine {
    /// This one.
    pub fn found() -> Self {
        let described = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let named = described.lines().find_map(|line| {
            let (field, name) = line.split_once(':')?;
            (field.trim() == "model name").then(|| name.trim().to_owned())
        });
        let processor = named.unwrap_or_else(|| std::env::consts::ARCH.to_owned());
        let cores = std::thread::available_parallelism().map_or(0, usize::from);
        Self { processor, cores }
    }

    /// In one line.
    pub fn line(&self) -> String {
        let Self { processor, cores } = self;
        let system = std::env::consts::OS;
        format!("{processor}, {cores} cores, {system}; clock: {}", crate::clock::NAME)
    }

    /// Keeps them.
    pub fn note(&self, figures: &mut Figures) {
        figures.set("cpu", self.processor.clone());
        figures.set("cores", self.cores);
        figures.set("clock", crate::clock::NAME);
    }
}

/// Whether the compiler was allowed more than every x86-64 processor has: then this is not the code
/// that the wheel ships.
pub const IS_TUNED: bool = cfg!(all(target_arch = "x86_64", target_feature = "sse3"));
