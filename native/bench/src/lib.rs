//! What benches share: the synthetic planet, random numbers, the machine's name, named figures.

pub mod clock;
pub mod figures;
pub mod machine;
pub mod random;
pub mod statistics;
pub mod terrain;
pub mod tile;
