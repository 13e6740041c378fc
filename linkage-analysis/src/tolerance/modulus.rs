//! The longest sum of vectors whose signs are free.
//!
//! All sums `+-v1 +- .. +- vn` lie in a zonotope, and the longest one is at a corner of it. A
//! corner is the sum that reaches farthest in some direction `d`: each sign is that of `v . d`.
//! Turning `d` around changes one sign after the other, so that a plane zonotope has `2 n` corners,
//! in the order of the directions of the vectors, and one in space not more than about `n^2`.

use alloc::vec;
use alloc::vec::Vec;
use linkage_core::numeric::vector::dot;

/// Directions that differ by less, as sine of the angle, count as one.
const PARALLEL: f64 = 1e-12;

/// A corner of a zonotope.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Corner {
    /// The signs of the vectors; 0 for a vector of no length.
    pub(super) signs: Vec<f64>,
    /// The sum of the vectors with these signs.
    pub(super) sum: [f64; 3],
}

/// The corner that is farthest from the middle; none if a vector is not finite.
pub(super) fn farthest(vectors: &[[f64; 3]]) -> Option<Corner> {
    if vectors.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let scale = vectors
        .iter()
        .flatten()
        .fold(0.0, |max: f64, x| max.max(x.abs()));
    let mut best = (-1.0, vec![0.0; vectors.len()]);
    corners(vectors, &mut |signs, sum| {
        let size = dot(&sum.map(|x| x / scale), &sum.map(|x| x / scale));
        if size > best.0 {
            best = (size, signs.to_vec());
        }
    });
    let sum = signed_sum(vectors, &best.1);
    Some(Corner { signs: best.1, sum })
}

/// Visits the corners with their signs, one of each opposite pair at least.
pub fn corners(vectors: &[[f64; 3]], visit: &mut dyn FnMut(&[f64], [f64; 3])) {
    let units: Vec<[f64; 3]> = vectors.iter().map(unit).collect();
    let long: Vec<usize> = (0..units.len()).filter(|&i| units[i] != [0.0; 3]).collect();
    let mut signs = vec![0.0; vectors.len()];
    if vectors.iter().all(|v| v[2] == 0.0) {
        let plane: Vec<_> = long
            .iter()
            .map(|&i| (i, [units[i][0], units[i][1]]))
            .collect();
        turn(vectors, &plane, &mut signs, visit);
        return;
    }
    let mut crossing = false;
    for (index, &i) in long.iter().enumerate() {
        for &j in &long[index + 1..] {
            let Some(axis) = crossing_of(&units[i], &units[j]) else {
                continue;
            };
            crossing = true;
            around(vectors, &units, &long, axis, &units[i], &mut signs, visit);
        }
    }
    if let (false, Some(&first)) = (crossing, long.first()) {
        for &i in &long {
            signs[i] = 1.0_f64.copysign(dot(&units[first], &units[i]));
        }
        visit(&signs, signed_sum(vectors, &signs));
    }
}

/// The corners whose directions `d` are next to `axis`: vectors across the axis have all signs that
/// a direction can give them, the others have the sign that the axis gives them.
fn around(
    vectors: &[[f64; 3]],
    units: &[[f64; 3]],
    long: &[usize],
    axis: [f64; 3],
    first: &[f64; 3],
    signs: &mut [f64],
    visit: &mut dyn FnMut(&[f64], [f64; 3]),
) {
    let second = cross(&axis, first);
    let mut across = Vec::new();
    for &i in long {
        let along = dot(&units[i], &axis);
        if along.abs() <= PARALLEL {
            across.push((i, [dot(&units[i], first), dot(&units[i], &second)]));
        } else {
            signs[i] = 1.0_f64.copysign(along);
        }
    }
    turn(vectors, &across, signs, &mut |signs, sum| {
        visit(signs, sum);
        let mut opposite = signs.to_vec();
        for &(i, _) in &across {
            opposite[i] = -opposite[i];
        }
        visit(&opposite, signed_sum(vectors, &opposite));
    });
}

/// Turns a direction of the plane by half a turn and visits the sums on the way. `plane` names the
/// vectors whose signs depend on it and gives their directions in the plane.
fn turn(
    vectors: &[[f64; 3]],
    plane: &[(usize, [f64; 2])],
    signs: &mut [f64],
    visit: &mut dyn FnMut(&[f64], [f64; 3]),
) {
    let mut order: Vec<(f64, usize)> = Vec::with_capacity(plane.len());
    for &(i, [x, y]) in plane {
        let up = y > 0.0 || (y == 0.0 && x > 0.0);
        signs[i] = if up { 1.0 } else { -1.0 };
        // Grows with the angle from 0 to half a turn, without trigonometry.
        order.push((-x * signs[i] / (x.abs() + y.abs()), i));
    }
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut sum = signed_sum(vectors, signs);
    visit(signs, sum);
    for &(_, i) in order.iter().take(order.len().saturating_sub(1)) {
        signs[i] = -signs[i];
        for (total, x) in sum.iter_mut().zip(vectors[i]) {
            *total += 2.0 * signs[i] * x;
        }
        visit(signs, sum);
    }
}

/// The direction across two directions, if they are not parallel.
fn crossing_of(a: &[f64; 3], b: &[f64; 3]) -> Option<[f64; 3]> {
    let axis = cross(a, b);
    (dot(&axis, &axis).sqrt() > PARALLEL).then(|| unit(&axis))
}

pub(super) fn signed_sum(vectors: &[[f64; 3]], signs: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (vector, sign) in vectors.iter().zip(signs) {
        for (total, x) in sum.iter_mut().zip(vector) {
            *total += sign * x;
        }
    }
    sum
}

fn unit(v: &[f64; 3]) -> [f64; 3] {
    let length = crate::components::norm(v);
    if length > 0.0 {
        v.map(|x| x / length)
    } else {
        [0.0; 3]
    }
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
