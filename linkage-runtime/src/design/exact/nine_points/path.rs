//! Following a solution while the points are changed into others.
//!
//! As the project's other homotopies do: every step predicts by the polynomial through the last points and their tangents
//! and corrects by two Newton steps; their lengths rule the length of the next step.

use super::super::complex::{Complex, ONE, ZERO};
use super::cognates::{cognate, exchanged};
use super::equations::{ALL, Shifts, Unknowns, newton};

/// The way from some points to others: not straight, but along an arc of complex points, which for almost every `arc` keeps
/// away from points with double solutions.
pub(super) struct Way<'a> {
    pub(super) from: &'a Shifts<Complex>,
    pub(super) to: &'a Shifts<Complex>,
    pub(super) arc: Complex,
}

impl Way<'_> {
    /// Points and their derivatives at `t`, from 1 to 0.
    fn at(&self, t: f64) -> (Shifts<Complex>, Shifts<Complex>) {
        let rest = (ONE + (self.arc - ONE).scaled(t)).inverse();
        let part = self.arc.scaled(t) * rest;
        let slope = self.arc * rest * rest;
        let pairs = |factor: Complex, start: f64| {
            core::array::from_fn(|j| {
                core::array::from_fn(|h| {
                    let (from, to) = (self.from[j][h], self.to[j][h]);
                    to.scaled(start) + factor * (from - to)
                })
            })
        };
        (pairs(part, 1.0), pairs(slope, 0.0))
    }
}

/// How carefully paths are followed.
#[derive(Clone, Copy)]
pub(super) struct Pace {
    /// First correction that steps aim at.
    correction: f64,
    /// Second correction as a part of the first one that they aim at.
    contraction: f64,
    /// Second corrections that are rounding, of which nothing is learned: more of it where equations are nearly singular.
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
struct Knot {
    t: f64,
    place: Unknowns<Complex>,
    tangent: Unknowns<Complex>,
}

const FIRST_STEP: f64 = 0.01;
const MOST_STEPS: usize = 4000;
/// Steps in `t` below this are nothing: the path sticks.
const SHORT: f64 = 1e-11;
/// A step is at least and at most this part of the one before: where it was refused, and where it was made.
const SHORTER: [f64; 2] = [0.1, 0.6];
const LONGER: [f64; 2] = [0.2, 3.0];
/// By how much corrections may be longer than what is aimed at.
const TOO_MUCH: f64 = 4.0;
/// Lengths below this part of the points' are measured as if they were of it.
const SMALL: f64 = 0.1;
/// Steps are shorter than what would be just good enough.
const CAREFUL: f64 = 0.7;

/// How often another cognate may be followed.
const MOST_CHANGES: usize = 12;

/// Where the path of a solution ends, as one of its cognates; `None` if it sticks or takes too many steps.
///
/// Where the equations of one cognate are nearly singular, those of another one can be plain.
pub(super) fn follow(
    start: &Unknowns<Complex>,
    way: &Way<'_>,
    pace: Pace,
) -> Option<Unknowns<Complex>> {
    let mut part = Part::new(way, pace, 1.0, *start);
    for change in 0..MOST_CHANGES {
        if part.run() {
            return Some(part.now().place);
        }
        let Knot { t, place, .. } = *part.now();
        let (shifts, _) = way.at(t);
        // Each of the two others in turn.
        let other = if change % 2 == 0 {
            place
        } else {
            exchanged(&place)
        };
        part = Part::new(way, pace, t, cognate(&other, &shifts));
    }
    None
}

/// A part of a path on which one cognate is followed.
struct Part<'a> {
    way: &'a Way<'a>,
    pace: Pace,
    knots: Knots,
}

impl<'a> Part<'a> {
    fn new(way: &'a Way<'a>, pace: Pace, t: f64, start: Unknowns<Complex>) -> Self {
        let (shifts, drift) = way.at(t);
        let mut place = start;
        // Stored solutions have few digits.
        for _ in 0..4 {
            place = newton(&place, &shifts, &drift).to;
        }
        let tangent = newton(&place, &shifts, &drift).tangent;
        let first = Knot { t, place, tangent };
        let knots = Knots {
            knots: [first; 3],
            count: 1,
        };
        Self { way, pace, knots }
    }

    fn now(&self) -> &Knot {
        &self.knots.knots[0]
    }

    /// Whether the end is reached.
    fn run(&mut self) -> bool {
        let mut step = FIRST_STEP;
        for _ in 0..MOST_STEPS {
            let now = self.now().t;
            if now == 0.0 {
                return true;
            }
            let next = if now - step < SHORT { 0.0 } else { now - step };
            let (knot, excess) = self.knots.corrected(self.way, self.pace, next);
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
struct Knots {
    knots: [Knot; 3],
    count: usize,
}

impl Knots {
    fn add(&mut self, knot: Knot) {
        self.knots = [knot, self.knots[0], self.knots[1]];
        self.count = (self.count + 1).min(3);
    }

    /// The polynomial (Hermite's) that has the points and tangents.
    fn predict(&self, t: f64) -> Unknowns<Complex> {
        let knots = &self.knots[..self.count];
        let mut place = [ZERO; ALL];
        for (i, knot) in knots.iter().enumerate() {
            let others = knots.iter().enumerate().filter(|&(j, _)| j != i);
            let (mut value, mut slope) = (1.0, 0.0);
            for (_, other) in others {
                value *= (t - other.t) / (knot.t - other.t);
                slope += 1.0 / (knot.t - other.t);
            }
            let ahead = t - knot.t;
            let square = value * value;
            let (of_place, of_tangent) = (square * (1.0 - 2.0 * slope * ahead), square * ahead);
            for ((place, &at), &tangent) in place.iter_mut().zip(&knot.place).zip(&knot.tangent) {
                *place = *place + at.scaled(of_place) + tangent.scaled(of_tangent);
            }
        }
        place
    }

    /// The point at `t`, if the prediction is good enough, and how good it is: 1 is what is aimed at.
    fn corrected(&self, way: &Way<'_>, pace: Pace, t: f64) -> (Option<Knot>, f64) {
        let guess = self.predict(t);
        let (shifts, drift) = way.at(t);
        let first = newton(&guess, &shifts, &drift);
        let length = distance(&guess, &first.to);
        let excess = length / pace.correction;
        if first.singular || excess.is_nan() || excess > TOO_MUCH {
            return (None, excess);
        }
        let second = newton(&first.to, &shifts, &drift);
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
            place: second.to,
            tangent: second.tangent,
        };
        (Some(knot), excess)
    }
}

/// The largest difference as a part of the number.
fn distance(a: &Unknowns<Complex>, b: &Unknowns<Complex>) -> f64 {
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
