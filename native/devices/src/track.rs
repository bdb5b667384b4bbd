//! Moments in their order, and what lies between them.

use crate::ParameterError;

/// A moment of a path.
pub(crate) trait Moment {
    /// Seconds.
    fn time(&self) -> f64;

    /// Whether every number in it is finite.
    fn is_finite(&self) -> bool;
}

/// Why a path cannot be played.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PathError {
    /// There is nowhere to be.
    #[error("a path needs at least one point")]
    Empty,
    /// A time or coordinate is NaN or infinite.
    #[error("point {index} of the path has a number that is not finite")]
    NotFinite {
        /// Which point, from 0.
        index: usize,
    },
    /// A point does not lie after the one before it.
    #[error("point {index} of the path is at {time} s, expected a time after {previous} s")]
    NotRising {
        /// Which point, from 0.
        index: usize,
        /// Its time, seconds.
        time: f64,
        /// The time of the point before it, seconds.
        previous: f64,
    },
    /// The workspace has no extent.
    #[error(transparent)]
    Workspace(#[from] ParameterError),
}

/// Moments in order.
#[derive(Clone, Debug)]
pub(crate) struct Track<P> {
    points: Vec<P>,
    /// The point that was last passed; only a hint where to look first.
    passed: usize,
}

impl<P: Moment> Track<P> {
    pub(crate) fn new(points: Vec<P>) -> Result<Self, PathError> {
        if let Some(index) = points.iter().position(|point| !point.is_finite()) {
            return Err(PathError::NotFinite { index });
        }
        for (before, pair) in points.windows(2).enumerate() {
            let (previous, time) = (pair[0].time(), pair[1].time());
            if time <= previous {
                return Err(PathError::NotRising { index: before + 1, time, previous });
            }
        }
        Ok(Track { points, passed: 0 })
    }

    /// The first and the last one.
    pub(crate) fn ends(&self) -> Option<(&P, &P)> {
        self.points.first().zip(self.points.last())
    }

    /// The last point at or before `time`, and the one after it; the first one twice before that.
    pub(crate) fn around(&mut self, time: f64) -> Option<(&P, Option<&P>)> {
        let first = self.points.first()?;
        if time.is_nan() || time < first.time() {
            return Some((first, None));
        }
        self.passed = self.last_point_passed(time);
        Some((&self.points[self.passed], self.points.get(self.passed + 1)))
    }

    /// The last point at or before `time`, which is not before the first point. Time usually moves
    /// on by a tick, so the point found last and the one after it are tried before searching.
    fn last_point_passed(&self, time: f64) -> usize {
        for guess in [self.passed, self.passed + 1] {
            if self.is_last_passed(guess, time) {
                return guess;
            }
        }
        self.points.partition_point(|point| point.time() <= time) - 1
    }

    fn is_last_passed(&self, index: usize, time: f64) -> bool {
        let passed = self.points.get(index).is_some_and(|point| point.time() <= time);
        passed && self.points.get(index + 1).is_none_or(|next| time < next.time())
    }
}

/// Of the way from one moment to another.
pub(crate) fn share(from: f64, to: f64, time: f64) -> f64 {
    let share = (time - from) / (to - from);
    // Times near the largest number overflow to infinity over infinity.
    if share.is_nan() { 0.0 } else { share }
}

/// That share of the way from `start` to `end`.
pub(crate) fn between(start: f64, end: f64, share: f64) -> f64 {
    if start == end {
        // A hand that is held still is still to the last bit.
        return start;
    }
    // Unlike start + (end - start) * share this cannot overflow.
    start * (1.0 - share) + end * share
}
