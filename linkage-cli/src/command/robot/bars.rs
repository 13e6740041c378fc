//! Bars that draw a body: from its origin to the joints on it.

use super::skeleton::Skeleton;
use super::space_vectors::{Vector, difference, length};

/// The radius of bars, as a part of the size.
const RADIUS: f64 = 0.02;

/// The radius of all bars.
pub(super) fn bar_radius(skeleton: &Skeleton) -> f64 {
    RADIUS * skeleton.size()
}

/// The ends of a body's bars, from its origin.
pub(super) fn bars(skeleton: &Skeleton, index: usize) -> Vec<Vector> {
    let origin = skeleton.links[index].origin;
    let children = skeleton.links.iter();
    let children = children.filter(|link| link.parent == Some(index));
    let closures = skeleton.closures.iter();
    let closures = closures.filter(|closure| closure.bodies.contains(&Some(index)));
    let points = children
        .map(|link| link.origin)
        .chain(closures.map(|closure| closure.at));
    let mut ends: Vec<Vector> = Vec::new();
    for point in points {
        let end = difference(point, origin);
        if length(end) > bar_radius(skeleton) && !ends.contains(&end) {
            ends.push(end);
        }
    }
    ends
}
