//! The verification of results: loops are closed with the dimensions that are returned, whatever
//! they were found by.

use std::vec::Vec;

use super::guides::{Dyad, Pivots};
use super::{FourBar, Pose};

/// Numbers that differ by less than this part of the size of their coordinates are equal.
const EQUAL: f64 = 1e-9;

/// Returns whether the joints of a link keep their distance in all poses.
pub(super) fn keeps_length(link: &Pivots, poses: &[Pose]) -> bool {
    let lengths = poses.iter().map(|pose| link.length(pose));
    let places = poses
        .iter()
        .flat_map(|pose| [pose.point, pose.place(link.moving)]);
    are_equal(lengths, places.chain([link.fixed, link.moving]))
}

/// Returns whether both links keep their lengths in all poses.
pub(super) fn closes(four_bar: &FourBar, poses: &[Pose]) -> bool {
    let mut joints = four_bar.fixed.into_iter().zip(four_bar.moving);
    joints.all(|(fixed, moving)| keeps_length(&Pivots { fixed, moving }, poses))
}

/// Returns whether a dyad leads a body through all poses.
pub(super) fn leads(dyad: &Dyad, poses: &[Pose]) -> bool {
    // The distances of points from a line through the origin at this angle.
    let off = |angle: f64, points: Vec<[f64; 2]>| {
        let (sin, cos) = angle.sin_cos();
        let distances: Vec<f64> = points.iter().map(|[x, y]| cos * y - sin * x).collect();
        are_equal(distances.into_iter(), points.into_iter())
    };
    match *dyad {
        Dyad::Link(pivots) => keeps_length(&pivots, poses),
        Dyad::PointOnLine { moving, angle } => {
            let places = poses.iter().map(|pose| pose.place(moving));
            off(angle, places.collect())
        }
        Dyad::LineThroughPoint { fixed, angle } => {
            let points = poses.iter().map(|pose| pose.point_at(fixed));
            off(angle, points.collect())
        }
    }
}

/// Returns whether a distance is zero beside these lengths.
pub(super) fn is_nothing(distance: f64, lengths: &[f64]) -> bool {
    let size = lengths.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    distance.abs() <= EQUAL * size
}

fn are_equal(
    values: impl Iterator<Item = f64>,
    coordinates: impl Iterator<Item = [f64; 2]>,
) -> bool {
    let size = coordinates
        .flatten()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values {
        if !value.is_finite() {
            return false;
        }
        (low, high) = (low.min(value), high.max(value));
    }
    high - low <= EQUAL * size
}
