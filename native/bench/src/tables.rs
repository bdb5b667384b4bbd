//! Tables as people read them.

use crate::cell::{Cell, LIMITS};
use crate::contenders::CONTENDERS;
use crate::statistics::Spread;

/// Width of the first column, and of the others.
const FIRST: usize = 24;
const OTHER: usize = 20;

/// A scene's name and all of its cells.
pub struct SceneCells {
    /// In names of figures.
    pub key: &'static str,
    /// In tables.
    pub title: String,
    /// One for each speed.
    pub cells: Vec<Cell>,
}

impl SceneCells {
    /// The cell at a speed.
    pub fn at(&self, speed: f64) -> Option<&Cell> {
        self.cells.iter().find(|cell| cell.speed == speed)
    }

    /// A line for each model, a column for each speed; `show` gives the text of model number
    /// `index` in a cell.
    pub fn print_models(&self, heading: &str, show: impl Fn(&Cell, usize) -> String) {
        self.print_head(heading);
        for (index, contender) in CONTENDERS.iter().enumerate() {
            self.print_line(contender.key, |cell| show(cell, index));
        }
    }

    /// Times of all models and limits, median, 99th and 99.9th percentile.
    pub fn print_times(&self, heading: &str, times: impl Fn(&Cell) -> &[Spread]) {
        if times(&self.cells[0]).is_empty() {
            return;
        }
        self.print_head(heading);
        let keys = CONTENDERS.iter().map(|contender| contender.key).chain(LIMITS);
        for (index, key) in keys.enumerate() {
            self.print_line(key, |cell| nanoseconds(&times(cell)[index]));
        }
    }

    fn print_head(&self, heading: &str) {
        println!("\n{}: {heading}", self.title);
        self.print_line("cells per update", |cell| cell.speed.to_string());
    }

    /// One line of a table with a column for each speed.
    pub fn print_line(&self, name: &str, show: impl Fn(&Cell) -> String) {
        let columns = self.cells.iter().map(|cell| format!("{:>OTHER$}", show(cell)));
        println!("{name:<FIRST$}{}", columns.collect::<String>());
    }
}

/// Median/p99/p99.9.
pub fn nanoseconds(spread: &Spread) -> String {
    let parts = [spread.median, spread.p99, spread.p999].map(short);
    parts.join("/")
}

/// A share as percent, with as many digits as it takes.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        0.0 => "0".to_owned(),
        _ if percent < 0.1 => format!("{percent:.3}"),
        _ if percent < 10.0 => format!("{percent:.2}"),
        _ => format!("{percent:.1}"),
    }
}

/// A number in three digits.
pub fn short(number: f64) -> String {
    let size = number.abs();
    let (scaled, unit) = match size {
        _ if size >= 1e6 => (number / 1e6, "M"),
        _ if size >= 1e3 => (number / 1e3, "k"),
        _ => (number, ""),
    };
    match scaled.abs() {
        size if size >= 100.0 => format!("{scaled:.0}{unit}"),
        size if size >= 10.0 => format!("{scaled:.1}{unit}"),
        size if size >= 1.0 => format!("{scaled:.2}{unit}"),
        0.0 => "0".to_owned(),
        size if size >= 1e-3 => format!("{scaled:.3}"),
        _ => format!("{scaled:.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_not_wrong() {
        assert_eq!(short(1234.5), "1.23k");
        assert_eq!(short(12_345.0), "12.3k");
        assert_eq!(short(4_100_000.0), "4.10M");
        assert_eq!(short(999.0), "999");
        assert_eq!(short(0.012_34), "0.012");
        assert_eq!(short(-1.6e-9), "-2e-9");
        assert_eq!(percent(0.000_12), "0.012");
        assert_eq!(percent(0.0), "0");
    }
}
