//! Every figure by name, as JSON.

use crate::statistics::Spread;
use serde_json::{Map, Value};
use std::io;
use std::path::Path;

/// Named figures.
#[derive(Default)]
pub struct Figures(Map<String, Value>);

impl Figures {
    /// Keeps a figure.
    pub fn set(&mut self, name: impl Into<String>, value: impl Into<Value>) {
        let value = value.into();
        let value = value
            .as_f64()
            .filter(|_| value.is_f64())
            .map_or(value, |number| rounded(number).into());
        self.0.insert(name.into(), value);
    }

    /// Keeps median and tail of times in nanoseconds.
    pub fn set_times(&mut self, name: &str, times: &Spread) {
        self.set(format!("{name}_ns"), times.median);
        self.set(format!("{name}_p99_ns"), times.p99);
        self.set(format!("{name}_p999_ns"), times.p999);
    }

    /// A figure that was kept.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.0.get(name)
    }

    /// Writes them all.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        std::fs::write(path, format!("{:#}\n", Value::Object(self.0.clone())))
    }
}

/// A speed as part of a name.
pub fn spoken(speed: f64) -> String {
    speed.to_string().replace('.', "_")
}

/// To six significant digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_digits_are_short() {
        assert_eq!(spoken(13.4), "13_4");
        assert_eq!(spoken(50.0), "50");
        assert_eq!(rounded(0.123_456_789), 0.123_457);
        let mut figures = Figures::default();
        figures.set("share", 2.0 / 3.0);
        figures.set("count", 1_234_567_890u64);
        assert_eq!(figures.0["share"], 0.666_667);
        assert_eq!(figures.0["count"], 1_234_567_890u64);
    }
}
