//! What the program is asked to do.

use std::path::PathBuf;

/// From the command line.
pub struct Options {
    /// Where figures go.
    pub output: PathBuf,
    /// A program that builds meshes in Blender, and its arguments.
    pub mesh: Option<String>,
    /// Seconds that lateness is measured for, in each condition and of each kind.
    pub seconds: u64,
}

/// How the program is called.
pub const USAGE: &str = "servo_bench [--mesh PROGRAM] [--seconds N] --output FOLDER
  --mesh PROGRAM   builds meshes in Blender beside the servo; left out, that condition is not measured
  --seconds N      of lateness in each condition and of each kind; 30 where it is left out
  --output FOLDER  where figures go";

/// Seconds that percentiles of lateness settle in.
const SECONDS: u64 = 30;

impl Options {
    /// Reads the arguments; the text says what is wrong with them.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self { output: PathBuf::new(), mesh: None, seconds: SECONDS };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--output" => options.output = value()?.into(),
                "--mesh" => options.mesh = Some(value()?),
                "--seconds" => options.seconds = seconds(&value()?)?,
                _ => return Err(format!("{argument} is unknown")),
            }
        }
        if options.output.as_os_str().is_empty() {
            return Err("--output is missing".to_owned());
        }
        Ok(options)
    }
}

fn seconds(text: &str) -> Result<u64, String> {
    let seconds = text.parse().ok().filter(|seconds| *seconds > 0);
    seconds.ok_or(format!("--seconds is {text:?}, expected a whole number above 0"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_is_named() {
        let read = |text: &str| Options::read(text.split_whitespace().map(str::to_owned));
        assert!(read("--output here").is_ok_and(|options| options.output.as_os_str() == "here"));
        assert_eq!(read("--output").err().unwrap(), "--output needs a value");
        assert_eq!(read("--fast").err().unwrap(), "--fast is unknown");
        assert_eq!(
            read("--seconds 0").err().unwrap(),
            "--seconds is \"0\", expected a whole number above 0"
        );
        assert_eq!(read("").err().unwrap(), "--output is missing");
    }
}
