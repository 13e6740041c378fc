//! A path that is followed to its end in steps that are parts of the remaining `t`: as a function
//! of the logarithm of `t` a path is smooth down to its end, whatever powers of `t` it falls with.
//!
//! A point has 32 digits, and so have the errors of the equations there. Its derivatives and
//! corrections have 16. They are of use as long as matrices, and ends, are not singular to
//! rounding.

use super::super::homotopy::Homotopy;
use super::super::projective::ProjectivePoint;
use super::super::rough_root::rough_root;
use super::wide_equations::{Equations, Point};
use crate::numeric::complex::Complex;
use crate::numeric::complex_matrix::{Vector, size, solve};

/// The smallest `t`: below it, a rounding of the coefficients changes more than the rest of the
/// path.
const LAST: f64 = 1e-18;
/// The value of `t` from which the end of a path is seen at the latest.
const NEAR: f64 = 1e-12;
const MOST_STEPS: usize = 200;
/// The longest first correction, that after which the next step is longer, and the part of a
/// correction that the next one may be.
const LONGEST: f64 = 2e-3;
const SHORT: f64 = 1e-4;
const CONTRACTION: f64 = 0.1;
/// After shorter corrections a point is near enough for the next step, and an end is as good as its
/// equations.
const SETTLED: [f64; 2] = [1e-10, 1e-16];
/// Parts of `t` that a step takes away: powers of 1/2, from the first to this one. With the third a
/// path is taken up.
const FINEST: i32 = 14;
const FIRST: i32 = 3;
/// The end is looked for whenever `t` has become smaller by this.
const BETWEEN_LOOKS: f64 = 0.125;
/// The largest distance between the results of two looks in succession that are the same, as a part
/// of the path there.
const SAME: f64 = 1e-3;
/// Coordinates with a larger square are followed as their inverses.
const LARGE: f64 = 2.0;

/// The progress along a path.
pub(super) enum Reached<const N: usize> {
    /// To its end, which roundings of coefficients move by about so much.
    End(ProjectivePoint<N>, f64),
    /// To here, or to an end that roundings of coefficients move nobody knows where.
    Here(ProjectivePoint<N>),
}

/// A point of a path, and its derivative with respect to the logarithm of `t`.
struct PathSample<const N: usize> {
    x: Point<N>,
    slope: Vector<N>,
}

/// Follows the path on that is at a place at `t`; `None` if it cannot be followed near its end.
pub(super) fn follow<const N: usize>(
    homotopy: &mut Homotopy<N>,
    equations: &mut Equations<N>,
    t: f64,
    point: &ProjectivePoint<N>,
) -> Option<Reached<N>> {
    homotopy.turn(point.flipped);
    equations.flipped = point.flipped;
    let (begin, _) = corrected(homotopy, equations, &point.x.map(Complex::wide), t)?;
    let (x, left) = arrive(homotopy, equations, begin, t);
    if left > NEAR {
        return None;
    }
    let end = placed(homotopy, &x);
    let mut beside = |sign: f64| {
        let (beside, _) = corrected(homotopy, &equations.changed(sign), &x, 0.0)?;
        Some(end.distance(&placed(homotopy, &beside.x)))
    };
    let moved = (left == 0.0).then(|| Some(f64::max(beside(1.0)?, beside(-1.0)?)));
    Some(match moved.flatten() {
        Some(moved) => Reached::End(end, rough_root(moved)),
        None => Reached::Here(end),
    })
}

/// The solution to which a path leads, at `t` = 0, or how far it could be followed.
fn arrive<const N: usize>(
    homotopy: &mut Homotopy<N>,
    equations: &mut Equations<N>,
    mut now: PathSample<N>,
    mut t: f64,
) -> (Point<N>, f64) {
    let mut step = FIRST;
    let mut before: Option<(PathSample<N>, f64)> = None;
    let (mut look, mut seen) = (t, None);
    for _ in 0..MOST_STEPS {
        if t <= look {
            look = BETWEEN_LOOKS * t;
            let straight = moved(&now.x, |j| -now.slope[j]);
            let end = corrected(homotopy, equations, &straight, 0.0).map(|(end, _)| end.x);
            if let (Some(end), Some(seen)) = (&end, &seen) {
                let [way, apart] = [&now.x, seen].map(|from| size(&difference(end, from)));
                if apart < SAME * SAME * way {
                    return (*end, 0.0);
                }
            }
            seen = end;
        }
        if t < LAST || step > FINEST {
            break;
        }
        let (factor, length) = part(step);
        let predicted = predict(&now, before.as_ref(), length);
        let Some((next, first)) = corrected(homotopy, equations, &predicted, factor * t) else {
            step += 1;
            continue;
        };
        t *= factor;
        if first < SHORT {
            step = (step - 1).max(1);
        }
        before = Some((core::mem::replace(&mut now, next), length));
        for j in 0..N {
            if now.x[j].narrow().square() > LARGE {
                homotopy.flip(j);
                equations.flipped[j] = !equations.flipped[j];
                now.flip(j);
                if let Some((before, _)) = &mut before {
                    before.flip(j);
                }
                // It has been seen in other coordinates.
                seen = None;
            }
        }
    }
    (now.x, t)
}

/// Returns the rest of `t` after a step, and its logarithm.
fn part(step: i32) -> (f64, f64) {
    const TERMS: i32 = 40;
    let gone = 1.0 / f64::from(1 << step);
    let (mut power, mut logarithm) = (1.0, 0.0);
    for term in 1..=TERMS {
        power *= gone;
        logarithm -= power / f64::from(term);
    }
    (1.0 - gone, logarithm)
}

impl<const N: usize> PathSample<N> {
    /// Takes the inverse of a coordinate as a coordinate.
    fn flip(&mut self, j: usize) {
        self.x[j] = self.x[j].inverse();
        let inverse = self.x[j].narrow();
        self.slope[j] = -(self.slope[j] * inverse * inverse);
    }
}

/// The point `length` ahead: by the polynomial (Hermite's) through the last two points and their
/// slopes, where there are two.
fn predict<const N: usize>(
    now: &PathSample<N>,
    before: Option<&(PathSample<N>, f64)>,
    length: f64,
) -> Point<N> {
    let Some((before, width)) = before else {
        return moved(&now.x, |j| now.slope[j].scaled(length));
    };
    let at = 1.0 + length / width;
    let (square, cube) = (at * at, at * at * at);
    let of_before = 2.0 * cube - 3.0 * square + 1.0;
    let of_slopes = [(cube - 2.0 * square + at) * width, (cube - square) * width];
    let back = difference(&before.x, &now.x);
    moved(&now.x, |j| {
        let [before, now] = [before.slope[j], now.slope[j]];
        back[j].scaled(of_before) + before.scaled(of_slopes[0]) + now.scaled(of_slopes[1])
    })
}

/// The point of the path at `t`, unless it is far from this one, and the length of the first
/// correction.
fn corrected<const N: usize>(
    homotopy: &mut Homotopy<N>,
    equations: &Equations<N>,
    x: &Point<N>,
    t: f64,
) -> Option<(PathSample<N>, f64)> {
    const MOST: usize = 12;
    let mut x = *x;
    let (mut first, mut last) = (None, LONGEST / CONTRACTION);
    for _ in 0..MOST {
        let evaluation = homotopy.evaluate(&x.map(Complex::narrow), t);
        let values = equations.values(&x, t);
        let mut matrix = evaluation.matrix;
        let mut right = [values.map(|value| -value), evaluation.drift.map(|d| -d)];
        let pivot = solve(&mut matrix, &mut right);
        let [correction, tangent] = right;
        let length = rough_root(size(&correction));
        let settled = length < SETTLED[usize::from(t == 0.0)];
        let shrinks = length < CONTRACTION * last;
        if pivot == 0.0 || !(settled || shrinks) {
            return None;
        }
        x = moved(&x, |j| correction[j]);
        let first = *first.get_or_insert(length);
        if settled {
            let slope = tangent.map(|slope| slope.scaled(t));
            return Some((PathSample { x, slope }, first));
        }
        last = length;
    }
    None
}

fn moved<const N: usize>(x: &Point<N>, way: impl Fn(usize) -> Complex) -> Point<N> {
    core::array::from_fn(|j| x[j] + way(j).wide())
}

fn difference<const N: usize>(a: &Point<N>, b: &Point<N>) -> Vector<N> {
    core::array::from_fn(|j| (a[j] - b[j]).narrow())
}

fn placed<const N: usize>(homotopy: &Homotopy<N>, x: &Point<N>) -> ProjectivePoint<N> {
    homotopy.projective_point(x.map(Complex::narrow))
}
