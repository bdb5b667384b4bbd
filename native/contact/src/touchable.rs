//! What can be touched: today a grid of heights, and open for others.

use crate::proxy::Proxy;
use surface::{Grid, GridPoint, Metric};

/// A kind of surface, by the words in which its contact models speak of places on it.
///
/// A heightfield has integer cells and fractions; a triangle mesh would have vertex and face numbers.
pub trait Touchable {
    /// A place in space.
    type Point: Copy;
    /// What makes workspace metres of the differences between two points.
    type Metric;
    /// A proxy's whole state, handed from one model to another.
    type Proxy;

    /// The state of a proxy out of contact; `None` for a point that is not finite.
    fn in_space(at: Self::Point) -> Option<Self::Proxy>;
}

impl Touchable for Grid {
    type Point = GridPoint;
    type Metric = Metric;
    type Proxy = Proxy;

    fn in_space(at: GridPoint) -> Option<Proxy> {
        at.is_finite().then(|| Proxy::in_space(at))
    }
}
