//! The ends of paths: isolated solutions, multiple ones, or points where variables vanish or become
//! infinite.

use super::cauchy_endgame;
use super::homotopy::Homotopy;
use super::path_samples::PathSample;
use super::path_tracker::PathTracker;
use super::projective::ProjectivePoint;
use super::rough_root::rough_root;
use crate::numeric::choose_assembly::MEETING;
use crate::numeric::complex::Complex;
use crate::numeric::complex_matrix::{Matrix, Vector, size, solve, sum};
use alloc::vec::Vec;

/// The end of a path.
pub(super) enum PathEnd<const N: usize> {
    /// An isolated solution; variables may be infinite.
    Regular(Root<N>),
    /// A variable tends to infinity or a unit vector to zero, other than in an isolated solution.
    Outside,
    /// A multiple solution, or one of a continuum.
    Multiple(ProjectivePoint<N>),
    /// Nothing real, as far as known; the coefficients do not decide more.
    Blurred,
    Lost,
}

/// An isolated solution.
#[derive(Clone, Copy)]
pub(super) struct Root<const N: usize> {
    pub(super) point: ProjectivePoint<N>,
    /// Newton's method converges to this solution from everywhere nearer than this.
    pub(super) reach: f64,
}

/// The value of `t` at which the given system equals that of a path to rounding.
const LAST: f64 = 1e-13;
/// Rounding errors of an equation.
const NOISE: f64 = 1e-15;
/// A number of roundings of an equation that is amply more than it can have: below it, the end of a
/// path is unknown.
const BLURRED: f64 = 10.0 * NOISE;
/// Pivots below this may be those of a singular matrix, except for rounding errors.
const UNCERTAIN: f64 = 100.0 * NOISE;
/// Shorter steps, as a part of `t`, lead nowhere.
const SHORT: f64 = 1e-6;
/// The last correction at a solution is shorter than this part of how far Newton's method may start
/// from it.
const SETTLED: f64 = 0.01;
/// A path ends in a singular solution if its end is nearer than [`MEETING`], and Newton's method
/// would have to start nearer than so many times the way.
const SINGULAR_REACH: f64 = 1000.0;
/// A coordinate that vanishes is smaller than this and falls with a higher power of `t`. The powers
/// are fractions with small denominators.
const VANISHED: f64 = 0.01;
const LEAST_RATE: f64 = 0.05;
/// Exponents that differ by less than this part are the same.
const SAME_RATE: f64 = 0.01;
/// Paths that cannot be followed any further earlier than this are lost.
const LATE: f64 = 1e-4;
/// The ratio of `t` between two notes of the position of a path.
const BETWEEN_MARKS: f64 = 0.125;
/// The precision of multiple solutions of up to four paths; a larger distance may mean several
/// solutions.
const PRECISE: f64 = 1e-3;
/// Within a circle, sums of powers of the paths that run around it are no larger than on it. So no
/// path is farther from their middle than twice its distance on the circle. The same distance again
/// is next to its reflection.
const CONFINED: f64 = 4.0;

/// The end of a path that has come near it; `marks` are where it has been on its way there.
pub(super) fn find<const N: usize>(
    tracker: &mut PathTracker<'_, N>,
    most_steps: usize,
    marks: &mut Vec<(f64, ProjectivePoint<N>)>,
) -> PathEnd<N> {
    let mut next_try = f64::INFINITY;
    let mut rates = Rates::new();
    for _ in 0..most_steps {
        let t = tracker.now().t;
        if tracker.step() >= t && t <= next_try {
            if let Some(root) = arrive(tracker) {
                return PathEnd::Regular(root);
            }
            next_try = 0.2 * t;
        }
        if marks
            .last()
            .is_none_or(|(last, _)| t < BETWEEN_MARKS * last)
        {
            marks.push((t, tracker.homotopy.projective_point(tracker.now().x)));
        }
        let precise = tracker.pivot * way_left(tracker) > BLURRED;
        if t < LAST || !precise || tracker.step() < SHORT * t {
            return conclude(tracker, marks);
        }
        if rates.are_settled(tracker) {
            return PathEnd::Outside;
        }
        tracker.advance(0.6 * t);
    }
    PathEnd::Lost
}

/// Returns the distance of the end, approximately.
fn way_left<const N: usize>(tracker: &PathTracker<'_, N>) -> f64 {
    let PathSample { t, tangent, .. } = tracker.now();
    t * rough_root(size(tangent))
}

/// The isolated solution right ahead, if there is one.
fn arrive<const N: usize>(tracker: &mut PathTracker<'_, N>) -> Option<Root<N>> {
    let predicted = tracker.predict(0.0);
    let (x, last) = polish(tracker.homotopy, &predicted)?;
    let reach = reach(tracker.homotopy, &x)?;
    let way: Vector<N> = core::array::from_fn(|j| x[j] - predicted[j]);
    let near = size(&way) < reach * reach;
    (near && last < SETTLED * reach).then(|| Root {
        point: tracker.homotopy.projective_point(x),
        reach,
    })
}

/// Newton's method for the given system, until corrections get no smaller: the place and the
/// length of the last correction.
pub(super) fn polish<const N: usize>(
    homotopy: &mut Homotopy<N>,
    start: &Vector<N>,
) -> Option<(Vector<N>, f64)> {
    const MOST: usize = 10;
    /// Squares of corrections: the first one is not longer, no more are made after the shortest.
    const LONGEST: f64 = 0.01;
    const SHORTEST: f64 = 1e-28;
    let mut x = *start;
    let mut last = 4.0 * LONGEST;
    for _ in 0..MOST {
        let (values, mut matrix) = homotopy.target(&x);
        let mut right = [values.map(|value| -value)];
        let pivot = solve(&mut matrix, &mut right);
        let length = size(&right[0]);
        if pivot == 0.0 || !length.is_finite() {
            return None;
        }
        if length > 0.25 * last {
            break;
        }
        x = sum(&x, &right[0]);
        last = length;
        if length <= SHORTEST {
            break;
        }
    }
    (last <= LONGEST).then(|| (x, rough_root(last)))
}

/// Returns the largest distance from a solution at which Newton's method may start: a part of the
/// inverse of the second derivatives, measured by the first ones.
fn reach<const N: usize>(homotopy: &mut Homotopy<N>, x: &Vector<N>) -> Option<f64> {
    const PART: f64 = 0.3;
    const LONGEST: f64 = 0.1;
    const DIFFERENCE: f64 = 1e-3;
    let (_, matrix) = homotopy.target(x);
    let mut bend = 0.0;
    for k in 0..N {
        let mut beside = *x;
        beside[k] += Complex::new(DIFFERENCE, 0.0);
        let (_, shifted) = homotopy.target(&beside);
        let mut columns: Matrix<N> = core::array::from_fn(|column| {
            core::array::from_fn(|row| shifted[row][column] - matrix[row][column])
        });
        // Derivatives of a matrix that is singular, apart from rounding errors, prove nothing.
        if solve(&mut matrix.clone(), &mut columns) < UNCERTAIN * UNCERTAIN {
            return None;
        }
        bend += columns
            .as_flattened()
            .iter()
            .map(|c| c.square())
            .sum::<f64>();
    }
    let reach = PART * DIFFERENCE / rough_root(bend);
    reach.is_finite().then(|| reach.min(LONGEST))
}

/// The end of a path that cannot be followed further, which has been at these places.
fn conclude<const N: usize>(
    tracker: &mut PathTracker<'_, N>,
    marks: &[(f64, ProjectivePoint<N>)],
) -> PathEnd<N> {
    if let Some(root) = arrive(tracker) {
        return PathEnd::Regular(root);
    }
    let point = tracker.homotopy.projective_point(tracker.now().x);
    let t = tracker.now().t;
    if t > LATE {
        return PathEnd::Lost;
    }
    let vanishes = |j: usize| {
        point.is_outer(j, tracker.variables)
            && point.x[j].square() < VANISHED * VANISHED
            && rate(tracker, j) > LEAST_RATE
    };
    if (0..N).any(vanishes) {
        return PathEnd::Outside;
    }
    // Newton's method cannot reach the end because it is singular, not because it is far.
    let left = way_left(tracker);
    let x = tracker.now().x;
    let singular = reach(tracker.homotopy, &x).is_none_or(|reach| reach < SINGULAR_REACH * left);
    let multiple = singular && left < MEETING && point.is_inside(tracker.variables);
    if multiple && left < PRECISE {
        return PathEnd::Multiple(point);
    }
    match led_around(tracker, marks) {
        Some(Led::PathSamples) => PathEnd::Blurred,
        Some(Led::Onto(middle)) if multiple => PathEnd::Multiple(middle),
        _ => PathEnd::Lost,
    }
}

/// The contents of a circle around the end of a path.
enum Led<const N: usize> {
    /// Nothing real.
    PathSamples,
    /// The middle, which may be real.
    Onto(ProjectivePoint<N>),
}

/// Leads the path around its end: it ends within that way, so in nothing real if the way is
/// narrower than its middle is away from its reflection. That holds unless the path meets another
/// one within the way, which is found out where it is followed with more digits.
fn led_around<const N: usize>(
    tracker: &mut PathTracker<'_, N>,
    marks: &[(f64, ProjectivePoint<N>)],
) -> Option<Led<N>> {
    let mut onto = None;
    for (t, point) in marks.iter().filter(|(t, _)| *t < LATE) {
        tracker.homotopy.turn(point.flipped);
        let Some(cycle) = cauchy_endgame::around(tracker.homotopy, &point.x, *t) else {
            continue;
        };
        let middle = tracker.homotopy.projective_point(cycle.middle);
        let gaps = middle.gaps(tracker.variables);
        if (0..N).any(|j| gaps[j] > CONFINED * cycle.extent[j]) {
            return Some(Led::PathSamples);
        }
        // Earlier ways are more precise.
        onto.get_or_insert(Led::Onto(middle));
    }
    onto
}

/// The exponent `w` if a coordinate tends to zero like `t^w`.
fn rate<const N: usize>(tracker: &PathTracker<'_, N>, j: usize) -> f64 {
    let (x, tangent) = (tracker.now().x[j], tracker.now().tangent[j]);
    tracker.now().t * (tangent * x.conjugate()).re / x.square()
}

/// The exponents some steps ago.
struct Rates<const N: usize> {
    t: f64,
    rates: [f64; N],
    /// The number of times in succession that each of them has been the same as before.
    same: [u8; N],
}

impl<const N: usize> Rates<N> {
    fn new() -> Self {
        Self {
            t: 1.0,
            rates: [0.0; N],
            same: [0; N],
        }
    }

    /// Returns whether a coordinate that would be outside if it vanished tends to zero by a law
    /// that has been the same for some time. Then its end is a hundred times smaller at least,
    /// which is too small for a real solution.
    fn are_settled(&mut self, tracker: &PathTracker<'_, N>) -> bool {
        /// Part of `t` after which the exponents are looked at again.
        const AFTER: f64 = 0.125;
        const SMALL: f64 = 2e-3;
        if tracker.now().t > AFTER * self.t {
            return false;
        }
        let point = tracker.homotopy.projective_point(tracker.now().x);
        for j in 0..N {
            let rate = rate(tracker, j);
            let same = rate > LEAST_RATE && (rate - self.rates[j]).abs() < SAME_RATE * rate;
            self.same[j] = if same { self.same[j] + 1 } else { 0 };
            self.rates[j] = rate;
        }
        self.t = tracker.now().t;
        (0..N).any(|j| {
            let outer = point.is_outer(j, tracker.variables);
            outer && point.x[j].square() < SMALL * SMALL && self.same[j] >= 2
        })
    }
}
