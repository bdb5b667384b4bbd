//! The force of the spring.

use devices::Force;

/// A spring of `stiffness` N/m stretched by `displacement` metres.
pub(crate) fn spring(stiffness: f64, displacement: [f64; 3]) -> Force {
    Force { newtons: displacement.map(|metres| stiffness * metres) }
}
