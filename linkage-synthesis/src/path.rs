//! Following a solution while its equations are changed.
//!
//! As the project's other homotopies do: every step predicts by the polynomial through the last
//! points and their tangents and corrects by two Newton steps; their lengths rule the length of the
//! next step.

use linkage_core::numeric::complex::{Complex, ZERO};

/// Equations that change with a parameter `t`, from 1 to 0.
pub(super) trait Moving<const N: usize> {
    /// The data of the equations.
    type Data;

    /// Returns the data at `t`, with their derivatives there.
    fn evaluate(&self, t: f64) -> Self::Data;

    /// A Newton step.
    fn newton(&self, point: &[Complex; N], data: &Self::Data) -> Step<N>;
}

/// A Newton step.
pub(super) struct Step<const N: usize> {
    pub(super) to: [Complex; N],
    /// Derivative by the parameter of the path, before the step.
    pub(super) tangent: [Complex; N],
    /// True if the equations were singular.
    pub(super) singular: bool,
}

/// The limits of corrections along a path.
#[derive(Clone, Copy)]
pub(super) struct Pace {
    /// First correction that steps aim at.
    correction: f64,
    /// Second correction as a part of the first one that they aim at.
    contraction: f64,
    /// Second corrections that are rounding, of which nothing is learned: more of it where
    /// equations are nearly singular.
    noise: f64,
}

impl Pace {
    /// Smaller corrections at every attempt, and more rounding borne.
    pub(super) fn of_attempt(attempt: usize) -> Self {
        let (correction, contraction, noise) = match attempt {
            0 => (1e-4, 0.05, 1e-11),
            1 => (1e-5, 0.02, 1e-8),
            _ => (1e-5, 0.02, 1e-6),
        };
        Self {
            correction,
            contraction,
            noise,
        }
    }
}

#[derive(Clone, Copy)]
struct Knot<const N: usize> {
    t: f64,
    point: [Complex; N],
    tangent: [Complex; N],
}

const FIRST_STEP: f64 = 0.01;
const MOST_STEPS: usize = 4000;
/// Steps in `t` below this are nothing: the path sticks.
const SHORT: f64 = 1e-11;
/// A step is at least and at most this part of the one before: where it was refused, and where it
/// was made.
const SHORTER: [f64; 2] = [0.1, 0.6];
const LONGER: [f64; 2] = [0.2, 3.0];
/// The largest allowed ratio of a correction to its target.
const TOO_MUCH: f64 = 4.0;
/// Lengths below this part of the points' are measured as if they were of it.
const SMALL: f64 = 0.1;
/// The ratio of a step to the longest sufficient one.
const CAREFUL: f64 = 0.7;

/// The last point of a path that cannot be followed any further.
pub(super) struct Stuck<const N: usize> {
    pub(super) t: f64,
    pub(super) point: [Complex; N],
}

/// Returns the end of the path from `start` at `t`; an error if it sticks or takes too many steps.
pub(super) fn follow<const N: usize, M: Moving<N>>(
    moving: &M,
    pace: Pace,
    t: f64,
    start: &[Complex; N],
) -> Result<[Complex; N], Stuck<N>> {
    let mut path = Path::new(moving, pace, t, *start);
    let reached = path.run();
    let Knot { t, point, .. } = *path.now();
    match reached {
        true => Ok(point),
        false => Err(Stuck { t, point }),
    }
}

struct Path<'a, const N: usize, M> {
    moving: &'a M,
    pace: Pace,
    knots: Knots<N>,
}

impl<'a, const N: usize, M: Moving<N>> Path<'a, N, M> {
    fn new(moving: &'a M, pace: Pace, t: f64, start: [Complex; N]) -> Self {
        let data = moving.evaluate(t);
        let mut point = start;
        // Stored solutions have few digits.
        for _ in 0..4 {
            point = moving.newton(&point, &data).to;
        }
        let tangent = moving.newton(&point, &data).tangent;
        let first = Knot { t, point, tangent };
        let knots = Knots {
            knots: [first; 3],
            count: 1,
        };
        Self {
            moving,
            pace,
            knots,
        }
    }

    fn now(&self) -> &Knot<N> {
        &self.knots.knots[0]
    }

    /// Returns whether the end is reached.
    fn run(&mut self) -> bool {
        let mut step = FIRST_STEP;
        for _ in 0..MOST_STEPS {
            let now = self.now().t;
            if now == 0.0 {
                return true;
            }
            let next = if now - step < SHORT { 0.0 } else { now - step };
            let (knot, excess) = self.knots.corrected(self.moving, self.pace, next);
            // Errors of the prediction grow with this power of the step.
            let order = 2.0 * self.knots.count as f64;
            let factor = CAREFUL * excess.max(f64::EPSILON).powf(-1.0 / order);
            let [least, most] = if knot.is_some() { LONGER } else { SHORTER };
            step = (now - next) * factor.max(least).min(most);
            match knot {
                Some(knot) => self.knots.add(knot),
                None if step < SHORT => return false,
                None => {}
            }
        }
        false
    }
}

/// The last points of a path, the latest one first.
struct Knots<const N: usize> {
    knots: [Knot<N>; 3],
    count: usize,
}

impl<const N: usize> Knots<N> {
    fn add(&mut self, knot: Knot<N>) {
        self.knots = [knot, self.knots[0], self.knots[1]];
        self.count = (self.count + 1).min(3);
    }

    /// The polynomial (Hermite's) that has the points and tangents.
    fn predict(&self, t: f64) -> [Complex; N] {
        let knots = &self.knots[..self.count];
        let mut point = [ZERO; N];
        for (i, knot) in knots.iter().enumerate() {
            let others = knots.iter().enumerate().filter(|&(j, _)| j != i);
            let (mut value, mut slope) = (1.0, 0.0);
            for (_, other) in others {
                value *= (t - other.t) / (knot.t - other.t);
                slope += 1.0 / (knot.t - other.t);
            }
            let ahead = t - knot.t;
            let square = value * value;
            let (of_point, of_tangent) = (square * (1.0 - 2.0 * slope * ahead), square * ahead);
            for ((number, &at), &tangent) in point.iter_mut().zip(&knot.point).zip(&knot.tangent) {
                *number = *number + at.scaled(of_point) + tangent.scaled(of_tangent);
            }
        }
        point
    }

    /// Returns the point at `t`, if the prediction is good enough, and the ratio of its error to
    /// the target.
    fn corrected<M: Moving<N>>(&self, moving: &M, pace: Pace, t: f64) -> (Option<Knot<N>>, f64) {
        let guess = self.predict(t);
        let data = moving.evaluate(t);
        let first = moving.newton(&guess, &data);
        let length = distance(&guess, &first.to);
        let excess = length / pace.correction;
        if first.singular || excess.is_nan() || excess > TOO_MUCH {
            return (None, excess);
        }
        let second = moving.newton(&first.to, &data);
        let rest = distance(&first.to, &second.to);
        let contraction = if rest < pace.noise {
            0.0
        } else {
            rest / length / pace.contraction
        };
        let excess = excess.max(contraction * contraction);
        if second.singular || excess.is_nan() || excess > TOO_MUCH {
            return (None, excess);
        }
        let knot = Knot {
            t,
            point: second.to,
            tangent: second.tangent,
        };
        (Some(knot), excess)
    }
}

/// The largest difference as a part of the number.
fn distance<const N: usize>(a: &[Complex; N], b: &[Complex; N]) -> f64 {
    let parts = a
        .iter()
        .zip(b)
        .map(|(&a, &b)| (a - b).square() / (b.square() + SMALL * SMALL));
    // Not a number stays so.
    let largest = parts.fold(
        0.0,
        |largest, part| if part <= largest { largest } else { part },
    );
    largest.sqrt()
}
