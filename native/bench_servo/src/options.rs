//! What the program is asked to do.

use std::path::PathBuf;

/// From the command line.
pub struct Options {
    /// Where figures go.
    pub output: PathBuf,
}

/// How the program is called.
pub const USAGE: &str = "servo_bench --output FOLDER";

impl Options {
    /// Reads the arguments; the text says what is wrong with them.
    pub fn read(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut output = None;
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--output" => {
                    output = Some(arguments.next().ok_or("--output needs a value")?.into())
                }
                _ => return Err(format!("{argument} is unknown")),
            }
        }
        Ok(Self { output: output.ok_or("--output is missing")? })
    }
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
        assert_eq!(read("").err().unwrap(), "--output is missing");
    }
}
