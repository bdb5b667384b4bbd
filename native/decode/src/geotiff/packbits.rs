//! Runs of bytes, undone (TIFF 6.0, section 9).

use super::codec::Step;

/// Where the decoder stands between two calls.
#[derive(Debug, Default)]
pub struct PackBits {
    run: Run,
}

#[derive(Debug, Default)]
enum Run {
    /// The next byte is the head of a run.
    #[default]
    Head,
    /// So many bytes are copied.
    Literal(usize),
    /// The next byte is repeated so often.
    Repeat(usize),
    /// This byte is repeated so often.
    Repeating(u8, usize),
}

impl PackBits {
    /// Undoes as much as there is input and room for.
    pub fn step(&mut self, input: &[u8], output: &mut [u8]) -> Step {
        let (mut consumed, mut produced) = (0, 0);
        while produced < output.len() {
            if let Run::Repeating(byte, left) = self.run {
                let count = left.min(output.len() - produced);
                output[produced..][..count].fill(byte);
                produced += count;
                self.run =
                    if left > count { Run::Repeating(byte, left - count) } else { Run::Head };
                continue;
            }
            let Some(&byte) = input.get(consumed) else { break };
            match self.run {
                Run::Head => {
                    consumed += 1;
                    self.run = match byte as i8 {
                        -128 => Run::Head,
                        count @ 0.. => Run::Literal(count as usize + 1),
                        count => Run::Repeat(1 + usize::from(count.unsigned_abs())),
                    };
                }
                Run::Repeat(count) => {
                    consumed += 1;
                    self.run = Run::Repeating(byte, count);
                }
                Run::Literal(left) => {
                    let count = left.min(output.len() - produced).min(input.len() - consumed);
                    output[produced..][..count].copy_from_slice(&input[consumed..][..count]);
                    consumed += count;
                    produced += count;
                    self.run = if left > count { Run::Literal(left - count) } else { Run::Head };
                }
                Run::Repeating(..) => {}
            }
        }
        Step { consumed, produced }
    }
}
