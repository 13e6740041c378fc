//! Points and lines on paper.

use std::vec::Vec;

/// Twice the area, in square millimetres, of three points that are on one line except for rounding.
const STRAIGHT: f64 = 1e-9;

/// The point at a distance along a direction.
pub(super) fn along(origin: [f64; 3], direction: [f64; 3], distance: f64) -> [f64; 3] {
    core::array::from_fn(|k| origin[k] + distance * direction[k])
}

/// A point moved along a direction of length one and across it, to its left as seen on paper.
pub(super) fn moved(at: [f64; 2], direction: [f64; 2], along: f64, left: f64) -> [f64; 2] {
    let [c, s] = direction;
    [at[0] + along * c + left * s, at[1] + along * s - left * c]
}

/// The corners of the smallest convex polygon around points, in order. Points on one line give its
/// two ends.
pub(super) fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = Vec::from(points);
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let mut lower = half(sorted.iter().copied());
    let mut upper = half(sorted.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.extend(upper);
    lower
}

/// The corners of the hull as places in the list of points: those of a body stay the same while it
/// moves in the plane.
pub(super) fn hull_places(points: &[[f64; 2]]) -> Vec<usize> {
    let corners = hull(points).into_iter();
    let places = corners.filter_map(|corner| points.iter().position(|point| *point == corner));
    places.collect()
}

fn half(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for point in points {
        while let [.., a, b] = corners.as_slice()
            && turn(*a, *b, point) <= STRAIGHT
        {
            corners.pop();
        }
        corners.push(point);
    }
    corners
}

/// Twice the area of a triangle, positive if its corners turn left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The distance of a point from a stretch of a line.
pub(super) fn distance(point: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let part = match square > 0.0 {
        true => ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / square,
        false => 0.0,
    };
    let part = part.clamp(0.0, 1.0);
    (point[0] - a[0] - part * dx).hypot(point[1] - a[1] - part * dy)
}

/// The same angle between minus and plus half a turn.
pub(super) fn wrapped(angle: f64) -> f64 {
    let turn = core::f64::consts::TAU;
    angle - turn * (angle / turn).round()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_leaves_inner_points_out() {
        let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(
            hull(&square),
            [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
        );
        let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
        assert_eq!(hull(&line), [[0.0, 0.0], [2.0, 2.0]]);
    }

    #[test]
    fn distances_are_from_the_stretch_and_not_the_line() {
        let stretch = [[0.0, 0.0], [2.0, 0.0]];
        assert_eq!(distance([1.0, 3.0], stretch), 3.0);
        assert_eq!(distance([5.0, 4.0], stretch), 5.0);
        assert_eq!(distance([3.0, 4.0], [[0.0, 0.0]; 2]), 5.0);
    }

    #[test]
    fn left_is_left_on_paper() {
        assert_eq!(moved([0.0, 0.0], [1.0, 0.0], 2.0, 1.0), [2.0, -1.0]);
    }
}
