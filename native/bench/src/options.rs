//! What the program is asked to do.

use std::path::PathBuf;

/// From the command line.
pub struct Options {
    /// Only what a larger planet costs, up to 10 thousand million triangles.
    pub large: bool,
    /// Where files and figures go.
    pub output: PathBuf,
    /// MOLA's topography at 4 pixels per degree: label or data.
    pub mola: Option<PathBuf>,
    /// Whether large grids stay on the disk afterwards.
    pub keep: bool,
}

/// How the program is called.
pub const USAGE: &str = "contact_bench [--large] [--keep] [--mola FILE] --output FOLDER
  --large          only what a larger planet costs, up to 10 thousand million triangles
  --keep           leave its grids on the disk afterwards
  --mola FILE      MOLA's topography at 4 pixels per degree, measured too
  --output FOLDER  where grids and figures go";

impl Options {
    /// Reads the arguments; the text says what is wrong with them.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self { large: false, output: PathBuf::new(), mola: None, keep: false };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--large" => options.large = true,
                "--keep" => options.keep = true,
                "--mola" => options.mola = Some(value()?.into()),
                "--output" => options.output = value()?.into(),
                _ => return Err(format!("{argument} is unknown")),
            }
        }
        if options.output.as_os_str().is_empty() {
            return Err("--output is missing".to_owned());
        }
        Ok(options)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_is_named() {
        let read = |text: &str| Options::read(text.split_whitespace().map(str::to_owned));
        assert!(read("--output here --large").is_ok_and(|options| options.large));
        assert_eq!(read("--output here --fast").err().unwrap(), "--fast is unknown");
        assert_eq!(read("--mola").err().unwrap(), "--mola needs a value");
        assert_eq!(read("--keep").err().unwrap(), "--output is missing");
    }
}
