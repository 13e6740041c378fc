//! A path of solutions from the start system towards the given one.
//!
//! Every step predicts by the polynomial through the last three points and their tangents and
//! corrects by two Newton steps. How long the first correction is, and how much shorter the second
//! one, tells how near the path is to others and rules the length of the next step.

use super::homotopy::Homotopy;
use super::path_samples::{PathSample, PathSamples};
use super::rough_root::rough_root;
use super::system::Variable;
use crate::numeric::complex_matrix::{Vector, size, solve, sum};

/// The limits of corrections along a path.
#[derive(Clone, Copy)]
pub(super) struct Pace {
    /// First correction that steps aim at.
    correction: f64,
    /// Second correction as a part of the first one that they aim at.
    contraction: f64,
}

/// A path and how far it has been followed.
pub(super) struct PathTracker<'a, const N: usize> {
    pub(super) homotopy: &'a mut Homotopy<N>,
    pub(super) variables: &'a [Variable],
    pace: Pace,
    past: PathSamples<N>,
    /// Length of the next step.
    step: f64,
    /// Smallest pivot at the last point.
    pub(super) pivot: f64,
}

const FIRST_STEP: f64 = 0.02;
/// A step is at least and at most this part of the one before: where it was refused, and where it
/// was made.
const SHORTER: [f64; 2] = [0.1, 0.6];
const LONGER: [f64; 2] = [0.2, 3.0];
/// Less of the correction aimed at (its square) makes a step no longer: `LONGER` limits it before.
const LEAST_EXCESS: f64 = 1e-8;
/// Coordinates with a larger square are followed as their inverses. Above 1, so that they do not
/// change to and fro.
const LARGE: f64 = 2.0;
/// The largest allowed ratio of a correction to its target.
const TOO_MUCH: f64 = 4.0;
/// Rounding errors of an equation, amply.
const NOISE: f64 = 1e-14;

/// The result of a Newton step.
struct Correction<const N: usize> {
    x: Vector<N>,
    /// Square of the correction.
    length: f64,
    /// Derivative with respect to `t`, before the correction.
    tangent: Vector<N>,
    /// Square of the smallest pivot.
    pivot: f64,
}

impl<'a, const N: usize> PathTracker<'a, N> {
    pub(super) fn new(
        homotopy: &'a mut Homotopy<N>,
        variables: &'a [Variable],
        pace: Pace,
        start: &Vector<N>,
    ) -> Option<Self> {
        let evaluation = homotopy.evaluate(start, 1.0);
        let mut matrix = evaluation.matrix;
        let mut right = [evaluation.drift.map(|d| -d)];
        let pivot = solve(&mut matrix, &mut right);
        let first = PathSample {
            t: 1.0,
            x: *start,
            tangent: right[0],
        };
        (pivot > 0.0).then(|| Self {
            homotopy,
            variables,
            pace,
            past: PathSamples::new(first),
            step: FIRST_STEP,
            pivot: rough_root(pivot),
        })
    }

    /// The last point.
    pub(super) fn now(&self) -> &PathSample<N> {
        self.past.now()
    }

    /// Length of the next step.
    pub(super) fn step(&self) -> f64 {
        self.step
    }

    pub(super) fn predict(&self, t: f64) -> Vector<N> {
        self.past.predict(t)
    }

    /// One step that is not longer than `longest`, or a shorter length for the next one.
    #[inline(never)]
    pub(super) fn advance(&mut self, longest: f64) {
        let wanted = self.step;
        let length = wanted.min(longest);
        let t = self.now().t - length;
        let (next, excess) = self.corrected(t);
        // Errors of the prediction grow with the square of the span; this one would give half of
        // the correction that is aimed at.
        let factor = rough_root(rough_root(0.25 / excess.max(LEAST_EXCESS)));
        let span = factor * self.past.span(t);
        let Some((knot, pivot)) = next else {
            let shorter = self.past.length_of_span(span, length);
            self.step = shorter.max(SHORTER[0] * length).min(SHORTER[1] * length);
            return;
        };
        self.past.add(knot);
        self.pivot = pivot;
        let longer = self.past.length_of_span(span, length);
        self.step = longer.max(LONGER[0] * length).min(LONGER[1] * length);
        if length < wanted {
            self.step = self.step.max(wanted);
        }
        self.keep_small();
    }

    /// Returns the point of the path at `t` with its smallest pivot, unless it is too far from the
    /// predicted one, and the square of the ratio of the corrections to their targets.
    #[inline(always)]
    fn corrected(&mut self, t: f64) -> (Option<(PathSample<N>, f64)>, f64) {
        const MOST: f64 = TOO_MUCH * TOO_MUCH;
        let square = |value: f64| value * value;
        let predicted = self.past.predict(t);
        let first = self.correct(&predicted, t);
        let excess = first.length / square(self.pace.correction);
        if first.pivot == 0.0 || excess > MOST || excess.is_nan() {
            return (None, excess);
        }
        let second = self.correct(&first.x, t);
        let noise = square(NOISE) / second.pivot;
        let contraction = if second.length <= noise {
            0.0
        } else {
            second.length / first.length
        };
        let excess = excess.max(contraction / square(self.pace.contraction));
        if second.pivot == 0.0 || excess > MOST || excess.is_nan() {
            return (None, excess);
        }
        let Correction { x, tangent, .. } = second;
        let pivot = rough_root(second.pivot);
        (Some((PathSample { t, x, tangent }, pivot)), excess)
    }

    /// One Newton step.
    #[inline(never)]
    fn correct(&mut self, x: &Vector<N>, t: f64) -> Correction<N> {
        let mut evaluation = self.homotopy.evaluate(x, t);
        let mut right = [
            evaluation.values.map(|value| -value),
            evaluation.drift.map(|drift| -drift),
        ];
        let pivot = solve(&mut evaluation.matrix, &mut right);
        let [correction, tangent] = right;
        Correction {
            x: sum(x, &correction),
            length: size(&correction),
            tangent,
            pivot,
        }
    }

    /// Takes the inverses of coordinates that have grown.
    #[inline(always)]
    fn keep_small(&mut self) {
        for j in 0..N {
            if self.now().x[j].square() > LARGE {
                self.homotopy.flip(j);
                self.past.flip(j);
            }
        }
    }
}

impl Pace {
    /// Smaller corrections at every attempt.
    pub(super) fn of_attempt(attempt: usize) -> Self {
        let (correction, contraction) = match attempt {
            0 => (4e-4, 0.03),
            1 => (8e-5, 0.02),
            2 => (1.6e-5, 0.015),
            _ => (4e-6, 0.01),
        };
        Self {
            correction,
            contraction,
        }
    }
}
