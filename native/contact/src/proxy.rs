//! Where a proxy is, precisely enough to go on from there.

use crate::contact::Feature;
use surface::ray::Side;
use surface::{GridPoint, Triangle};

/// A proxy's whole state: what one model hands to another when they are switched in touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proxy {
    /// Where it is.
    pub position: GridPoint,
    /// What it lies on.
    pub place: Place,
}

/// What a proxy lies on, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Nothing; it is on this side of the surface.
    Space(Side),
    /// The inside of a triangle.
    Face(Triangle),
    /// Edge `k` of a vertex (see [`surface::lattice`]).
    Edge {
        /// Of the vertex.
        column: i64,
        /// Of the vertex.
        row: i64,
        /// Which of its edges.
        k: usize,
    },
    /// A sample of the grid.
    Vertex {
        /// Of the sample.
        column: i64,
        /// Of the sample.
        row: i64,
    },
}

impl Proxy {
    /// A proxy out of contact; the first triangle on its way says on which side it is.
    pub fn in_space(position: GridPoint) -> Self {
        Self { position, place: Place::Space(Side::Unknown) }
    }
}

impl Place {
    /// Whether it is in contact.
    pub fn is_on_surface(&self) -> bool {
        !matches!(self, Self::Space(_))
    }

    /// Triangles that are looked at to find the way from there: what a look costs of a step budget.
    #[inline(always)]
    pub(crate) fn planes(&self) -> u32 {
        match self {
            Self::Space(_) | Self::Face(_) => 1,
            Self::Edge { .. } => 2,
            Self::Vertex { .. } => 6,
        }
    }

    /// The kind of place.
    pub fn feature(&self) -> Feature {
        match self {
            Self::Space(_) => Feature::Free,
            Self::Face(_) => Feature::Face,
            Self::Edge { .. } => Feature::Edge,
            Self::Vertex { .. } => Feature::Vertex,
        }
    }
}
