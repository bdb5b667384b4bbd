//! Longer steps where a sphere turns slowly around an edge or a corner.
//!
//! A tangent plane knows nothing of how the obstacle behind it curves. Around a sample the obstacle is
//! a sphere of the proxy's radius r; a goal near that sample, at a distance d, has its foot on the
//! tangent plane so near that a step turns the proxy by d / r of the angle that is left: where d is a
//! thousandth of r, that takes thousands of steps, each 1 - d / r as long as the one before. The sum
//! of such a series is known after two of them (Aitken 1926): the sphere tries the whole of it at once
//! (along the planes, so that it is as safe as any other step), takes one step from there to lie
//! against the ground again, and goes back if the two together brought it no nearer.

use crate::planes::{dot, length};

/// A step is stretched to so many times itself at least, or not at all: it costs looks around more.
pub(super) const LEAST_STRETCH: f64 = 2.0;

/// Where a stretched step brought the sphere no nearer, the next one is so much shorter.
const SHORTER: f64 = 0.25;

/// The step that led to a place, and how far what follows from it may be trusted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stride {
    /// Cell widths; `None` where the next step is the first.
    last: Option<[f64; 3]>,
    /// The longest way to be tried, cell widths.
    longest: f64,
    /// What was tried last, cell widths.
    tried: f64,
}

impl Stride {
    pub(super) fn new() -> Self {
        Self { last: None, longest: f64::INFINITY, tried: 0.0 }
    }

    /// Takes note of a step that led to a nearer place.
    pub(super) fn follow(&mut self, step: [f64; 3]) {
        self.last = Some(step);
        self.longest *= 2.0;
    }

    /// The whole way that steps like this next one would lead to, if that is much longer; cell widths.
    /// No way is longer than the `radius`, that of the curve.
    pub(super) fn whole_way(&mut self, step: [f64; 3], radius: f64) -> Option<[f64; 3]> {
        let last = self.last?;
        let size = length(step);
        let goes_on = dot(step, last) > 0.0;
        let rest = 1.0 - size / length(last);
        let sum = if rest > 0.0 { size / rest } else { f64::INFINITY };
        self.tried = sum.min(radius).min(self.longest);
        let stretch = self.tried / size;
        // False for NaN too.
        (goes_on && stretch >= LEAST_STRETCH).then(|| step.map(|part| part * stretch))
    }

    /// The way that was tried led to a nearer place.
    pub(super) fn succeed(&mut self) {
        (self.last, self.longest) = (None, self.tried / SHORTER);
    }

    /// It did not, or nobody knows yet.
    pub(super) fn fail(&mut self) {
        (self.last, self.longest) = (None, self.tried * SHORTER);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(size: f64) -> [f64; 3] {
        [0.6 * size, 0.0, 0.8 * size]
    }

    #[test]
    fn steps_that_shrink_slowly_are_summed_up() {
        let mut stride = Stride::new();
        assert_eq!(stride.whole_way(step(1.0), 1e3), None);
        stride.follow(step(1.0));
        let [x, _, z] = stride.whole_way(step(0.99), 1e3).expect("a long way is left");
        // 0.99 + 0.99^2 + ...
        assert!((x - 0.6 * 99.0).abs() < 1e-9 && (z - 0.8 * 99.0).abs() < 1e-9, "{x} {z}");
        assert_eq!(stride.whole_way(step(0.3), 1e3), None, "it is nearly there");
    }

    #[test]
    fn no_way_is_longer_than_the_radius_and_none_turns_back() {
        let mut stride = Stride::new();
        stride.follow([0.125, 0.0, 0.0]);
        assert_eq!(stride.whole_way([0.125, 0.0, 0.0], 0.5), Some([0.5, 0.0, 0.0]));
        assert_eq!(stride.whole_way([-0.125, 0.0, 0.0], 0.5), None);
    }

    #[test]
    fn what_failed_is_tried_shorter_and_again_longer_later() {
        let mut stride = Stride::new();
        let mut tries = Vec::new();
        for _ in 0..4 {
            stride.follow([0.03125, 0.0, 0.0]);
            tries.push(stride.whole_way([0.03125, 0.0, 0.0], 1.0).map(|way| way[0]));
            stride.fail();
        }
        assert_eq!(tries, [Some(1.0), Some(0.5), Some(0.25), Some(0.125)]);
        stride.succeed();
        stride.follow([0.03125, 0.0, 0.0]);
        assert_eq!(stride.whole_way([0.03125, 0.0, 0.0], 1.0), Some([1.0, 0.0, 0.0]));
    }
}
