//! A path that is led around its end.
//!
//! Near its end a path is a power series in a root of `t`. Led around `t = 0` as often as the order
//! of that root says, its winding number, it is where it was, and its mean on that way is the end
//! (Cauchy's integral), although the equations are singular there. Where the end is near others,
//! the paths to all of them are run through, and the mean is the middle of them.

use super::homotopy::Homotopy;
use super::rough_root::rough_root;
use crate::numeric::complex::{Complex, ONE, ZERO};
use crate::numeric::complex_matrix::{Vector, size, solve, sum};
use alloc::vec::Vec;

/// A closed way around the end of a path.
pub(super) struct Cycle<const N: usize> {
    /// The mean of the way.
    pub(super) middle: Vector<N>,
    /// The largest distance of the path from there, by coordinate.
    pub(super) extent: [f64; N],
}

/// Paths that are not closed after so many turns are given up: the mean of a longer one would be
/// blurred by the paths beside it.
const MOST_TURNS: usize = 12;
/// Points of a turn of which the mean is taken; `STEP` leads from one to the next.
const POINTS: usize = 16;
const STEP: Complex = Complex::new(0.923_879_532_511_286_7, 0.382_683_432_365_089_8);
/// The number of times that the path between two points is halved where corrections are too long.
const HALVINGS: u32 = 5;
/// The longest first correction, and the part of it that the second one may be: those of a careful
/// follower, since another path may be near.
const LONGEST: f64 = 2e-3;
const CONTRACTION: f64 = 0.03;
/// Corrections that are rounding.
const ROUNDING: f64 = 1e-9;
/// A path that is nearer than this to where it was is closed. Others are as far as a path moves in
/// a turn.
const CLOSED: f64 = 1e-6;

/// A point beside the path, and its derivative with respect to `t`.
#[derive(Clone, Copy)]
struct Point<const N: usize> {
    x: Vector<N>,
    t: Complex,
    tangent: Vector<N>,
}

/// Leads the path from `x` at `t` around 0 until it is closed; `None` if it cannot be followed so
/// far.
pub(super) fn around<const N: usize>(
    homotopy: &mut Homotopy<N>,
    x: &Vector<N>,
    t: f64,
) -> Option<Cycle<N>> {
    let mut point = corrected(homotopy, x, Complex::new(t, 0.0))?;
    let begin = point.x;
    let mut way = Vec::with_capacity(POINTS);
    for _ in 0..MOST_TURNS {
        let mut direction = ONE;
        for step in 1..=POINTS {
            way.push(point.x);
            direction = if step < POINTS { direction * STEP } else { ONE };
            point = led(homotopy, &point, direction.scaled(t), HALVINGS)?;
        }
        let apart: Vector<N> = core::array::from_fn(|j| point.x[j] - begin[j]);
        if size(&apart) < CLOSED * CLOSED {
            return Some(Cycle::through(&way));
        }
    }
    None
}

impl<const N: usize> Cycle<N> {
    fn through(way: &[Vector<N>]) -> Self {
        let share = 1.0 / way.len() as f64;
        let total = way.iter().fold([ZERO; N], |total, x| sum(&total, x));
        let middle = total.map(|component| component.scaled(share));
        let extent = core::array::from_fn(|j| {
            let squares = way.iter().map(|x| (x[j] - middle[j]).square());
            // Two digits are enough of it.
            rough_root(squares.fold(0.0, f64::max))
        });
        Self { middle, extent }
    }
}

/// The point of the path at `t`, by a straight way.
fn led<const N: usize>(
    homotopy: &mut Homotopy<N>,
    from: &Point<N>,
    t: Complex,
    halvings: u32,
) -> Option<Point<N>> {
    let way = t - from.t;
    let predicted = core::array::from_fn(|j| from.x[j] + from.tangent[j] * way);
    if let Some(point) = corrected(homotopy, &predicted, t) {
        return Some(point);
    }
    let halvings = halvings.checked_sub(1)?;
    let middle = led(homotopy, from, from.t + way.scaled(0.5), halvings)?;
    led(homotopy, &middle, t, halvings)
}

/// Two Newton steps, unless the first one is long or the second one not much shorter.
fn corrected<const N: usize>(
    homotopy: &mut Homotopy<N>,
    x: &Vector<N>,
    t: Complex,
) -> Option<Point<N>> {
    let (first, _) = correction(homotopy, x, t)?;
    let long = size(&first);
    let x = sum(x, &first);
    let (second, tangent) = correction(homotopy, &x, t)?;
    let short = size(&second);
    let shrinks = short < CONTRACTION * CONTRACTION * long || short < ROUNDING * ROUNDING;
    let x = sum(&x, &second);
    (long < LONGEST * LONGEST && shrinks).then_some(Point { x, t, tangent })
}

/// The Newton step, and the derivative with respect to `t`.
fn correction<const N: usize>(
    homotopy: &mut Homotopy<N>,
    x: &Vector<N>,
    t: Complex,
) -> Option<(Vector<N>, Vector<N>)> {
    let mut evaluation = homotopy.evaluate_beside(x, t);
    let mut right = [
        evaluation.values.map(|value| -value),
        evaluation.drift.map(|drift| -drift),
    ];
    let pivot = solve(&mut evaluation.matrix, &mut right);
    let [correction, tangent] = right;
    (pivot > 0.0).then_some((correction, tangent))
}
