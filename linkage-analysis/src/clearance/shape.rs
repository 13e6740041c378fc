//! Points and segments with their derivatives by the angle of the shaft.

use crate::components::Components;

/// A point with its first and second derivative.
pub(super) type Jet<const K: usize> = [[f64; K]; 3];

/// Two shapes: one point, or the two ends of a segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<const K: usize, const A: usize, const B: usize> {
    pub(super) first: [Jet<K>; A],
    pub(super) second: [Jet<K>; B],
}

/// A shape as plain numbers.
pub(super) fn plain<V: Components<K>, const K: usize, const A: usize>(
    shape: [[V; 3]; A],
) -> [Jet<K>; A] {
    shape.map(|point| point.map(V::components))
}

/// The part of a shape that is nearest to the other one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feature {
    /// The point, or an end of the segment.
    Vertex(usize),
    /// A place between the ends.
    Edge,
}

/// All parts of a shape.
pub(super) const fn parts(vertices: usize) -> &'static [Feature] {
    match vertices {
        1 => &[Feature::Vertex(0)],
        _ => &[Feature::Vertex(0), Feature::Vertex(1), Feature::Edge],
    }
}

/// The vector from the first to the second end of a segment, with its derivatives; zeros for a
/// point.
pub(super) fn edge<const K: usize>(shape: &[Jet<K>]) -> Jet<K> {
    match shape {
        [a, b] => core::array::from_fn(|k| difference(&b[k], &a[k])),
        _ => [[0.0; K]; 3],
    }
}

/// The value at the position `foot`, 0 at the first end and 1 at the second one.
pub(super) fn between<const K: usize>(ends: [&[f64; K]; 2], foot: f64) -> [f64; K] {
    core::array::from_fn(|k| ends[0][k] + foot * (ends[1][k] - ends[0][k]))
}

pub(super) fn difference<const K: usize>(a: &[f64; K], b: &[f64; K]) -> [f64; K] {
    core::array::from_fn(|k| a[k] - b[k])
}
