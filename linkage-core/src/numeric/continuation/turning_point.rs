//! The end of a solution: beside a turning point input and state are smooth functions of the
//! determinant, and the turning point is where it vanishes.

use super::cell::{Cell, Frame};
use super::follow::Follower;
use alloc::vec;
use alloc::vec::Vec;

/// Positions that the functions of the determinant are interpolated from.
const POINTS: usize = 4;

/// Approaches.
const APPROACHES: usize = 24;

/// The part of the determinant that each approach aims at, and where that leads nowhere, a more
/// careful one.
const SHARES: [f64; 2] = [0.5, 0.8];

/// An approach that leaves more of the determinant than this has not come nearer.
const NEARER: f64 = 0.95;

/// Estimates of the place that agree so well are taken, and not worse than this when the approach
/// has to end.
const AGREEMENT: (f64, f64) = (1e-13, 1e-10);

/// A position near the turning point.
struct Point {
    determinant: f64,
    position: f64,
    state: Vec<f64>,
}

/// The place of the turning point behind the end of `cell`, in the direction `side` (1 or -1).
/// `None` if there is none within `reach`.
pub(super) fn locate(
    follower: &mut Follower<'_>,
    frame: &Frame,
    cell: &Cell,
    width: usize,
    side: f64,
    reach: f64,
) -> Option<f64> {
    let mut points = begin(follower, frame, cell, width, side)?;
    let end = points[POINTS - 1].position;
    let mut estimate = at_determinant(&points, 0.0, |point| point.position);
    let mut agreement = f64::INFINITY;
    for _ in 0..APPROACHES {
        let Some(next) = SHARES
            .into_iter()
            .find_map(|share| approach(follower, frame, &points, share))
        else {
            break;
        };
        points.rotate_left(1);
        points[POINTS - 1] = next;
        let better = at_determinant(&points, 0.0, |point| point.position);
        agreement = (better - estimate).abs();
        estimate = better;
        if agreement <= AGREEMENT.0 {
            break;
        }
    }
    let beyond = (estimate - end) * side;
    let found = agreement <= AGREEMENT.1 && beyond >= -AGREEMENT.1 && beyond <= reach;
    found.then_some(estimate)
}

/// Positions along the cell, towards its end.
fn begin(
    follower: &mut Follower<'_>,
    frame: &Frame,
    cell: &Cell,
    width: usize,
    side: f64,
) -> Option<[Point; POINTS]> {
    let mut point = |t: f64| {
        let position = cell.position(t * side);
        let mut state = vec![0.0; width];
        cell.state(position, &mut state);
        let determinant = settle(follower, &[frame.x(position)], &mut state)?;
        Some(Point {
            determinant,
            position,
            state,
        })
    };
    Some([point(-1.0)?, point(-0.3)?, point(0.4)?, point(1.0)?])
}

/// The position where the determinant is about `share` of the last one.
fn approach(
    follower: &mut Follower<'_>,
    frame: &Frame,
    points: &[Point; POINTS],
    share: f64,
) -> Option<Point> {
    let last = &points[POINTS - 1];
    let target = share * last.determinant;
    let position = at_determinant(points, target, |point| point.position);
    let mut state = vec![0.0; last.state.len()];
    for (index, number) in state.iter_mut().enumerate() {
        *number = at_determinant(points, target, |point| point.state[index]);
    }
    let determinant = settle(follower, &[frame.x(position)], &mut state)?;
    let nearer = determinant.abs() < NEARER * last.determinant.abs();
    nearer.then_some(Point {
        determinant,
        position,
        state,
    })
}

/// The determinant where a state solves the equations, not a step before.
fn settle(follower: &mut Follower<'_>, x: &[f64], state: &mut [f64]) -> Option<f64> {
    follower.settle(x, state)?;
    Some(follower.correct(x, state)?.determinant)
}

/// A number of the points as a function of the determinant: Lagrange's polynomial.
fn at_determinant(points: &[Point; POINTS], target: f64, number: impl Fn(&Point) -> f64) -> f64 {
    let mut sum = 0.0;
    for one in points {
        let weight = points
            .iter()
            .filter(|other| other.determinant != one.determinant)
            .map(|other| (target - other.determinant) / (one.determinant - other.determinant))
            .product::<f64>();
        sum += weight * number(one);
    }
    sum
}
