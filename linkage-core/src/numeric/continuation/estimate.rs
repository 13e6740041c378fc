//! Continuation from an estimate to the solution that it means.

#[cfg(test)]
mod tests;

use super::isolation::isolation;
use super::{Residuals, Step};
use crate::math::double;
use crate::numeric::roots::Variable;
use alloc::vec::Vec;

/// The longest step, in radians or on the scale of the state: far less than the distance of another
/// solution.
const LONGEST: f64 = 0.1;

/// The largest difference between the next correction and the predicted one, as a part of the
/// correction. Where Newton's method is certain to find the nearest solution, a full step leaves a
/// quarter.
const FORESEEN: f64 = 0.25;

/// A step that is a smaller part of a correction leads nowhere.
const SHORTEST: f64 = 1e-6;

/// Corrections, at most: an estimate that is off by a radian in every unknown takes less than a
/// hundred.
const CORRECTIONS: usize = 1000;

/// Corrections of this size leave nothing but rounding.
const SETTLED: f64 = 1e-9;

/// A state that is not proven to be isolated is singular, or one of many. Moved aside by this, it
/// returns with an error of a thousandth, or it does not.
const ASIDE: f64 = 1e-6;
const BACK: f64 = 1e-3 * ASIDE;
const STEPS_BACK: usize = 4;

/// The failure of an estimate that leads to no solution.
#[derive(Clone, Debug, PartialEq)]
pub enum Astray {
    /// The equations, or a correction, have no value at the estimate.
    NoValue,
    /// The way ends at a dead point.
    DeadPoint {
        /// The part of the closure error of the estimate that is left there: 1 if the estimate
        /// itself is the dead point.
        left: f64,
        /// The state where the way ends.
        at: Vec<f64>,
    },
    /// It leads to a solution beside which there are others: these states, both of which solve the
    /// equations.
    Movable([Vec<f64>; 2]),
    /// It leads to a state that is not proven to be the only solution near it: a dead point, or too
    /// near to one.
    Singular(Vec<f64>),
}

/// Follows a state from the estimated unknowns to a solution at the inputs `x`.
///
/// The equations have a closure error at the estimate, as if the links had other lengths. All of
/// its components are reduced in the same ratio, in steps that are short enough to stay on the
/// path. After each step the next correction must be within 25 % of the predicted one, and the
/// determinant must keep its sign. The result is the assembly that the estimate becomes while its
/// links grow to their lengths, or nothing. It is proven to be a solution, and the only one in a
/// box about it.
///
/// # Errors
///
/// Where the way ends at a dead point, or in a solution that is not proven to be isolated.
pub fn from_estimate(
    correction: &mut dyn Residuals,
    variables: &[Variable],
    x: &[f64],
    estimate: &[f64],
) -> Result<Vec<f64>, Astray> {
    let mut path = EstimatePath {
        correction,
        variables,
        x,
    };
    let mut here = path.evaluate(estimate.to_vec());
    let sign = here.step.determinant.signum();
    let mut left = 1.0;
    if !here.step.size.is_finite() || here.step.determinant == 0.0 {
        return Err(Astray::NoValue);
    }
    for _ in 0..CORRECTIONS {
        if here.step.size <= SETTLED {
            let state = here.corrected;
            return match isolation(path.correction, variables, x, &state) {
                Some(_) => Ok(state),
                None => Err(path.not_isolated(state)),
            };
        }
        let mut part = (LONGEST / here.step.size).min(1.0);
        let next = loop {
            let next = path.evaluate(here.turned(variables, part));
            if next.step.determinant * sign > 0.0 && here.foresees(&next, part) {
                break Some(next);
            }
            part *= 0.5;
            if part < SHORTEST {
                break None;
            }
        };
        let Some(next) = next else { break };
        left *= 1.0 - part;
        here = next;
    }
    Err(Astray::DeadPoint {
        left,
        at: here.state,
    })
}

struct EstimatePath<'w> {
    correction: &'w mut dyn Residuals,
    variables: &'w [Variable],
    x: &'w [f64],
}

/// A index on the way, and the correction there.
struct StateOnPath {
    state: Vec<f64>,
    corrected: Vec<f64>,
    /// The correction of each unknown.
    correction: Vec<f64>,
    step: Step,
}

impl EstimatePath<'_> {
    fn evaluate(&mut self, state: Vec<f64>) -> StateOnPath {
        let mut corrected = state.clone();
        let step = self.correction.correct(self.x, &mut corrected);
        StateOnPath {
            correction: difference(self.variables, &state, &corrected),
            state,
            corrected,
            step,
        }
    }

    /// Classifies a state that solves the equations and is not proven to be isolated.
    fn not_isolated(&mut self, state: Vec<f64>) -> Astray {
        let count = self.variables.len();
        // No direction in which a mechanism moves is at right angles to all of these but by chance.
        let signs = |k: usize| [1.0, if k.is_multiple_of(2) { 1.0 } else { -1.0 }];
        for pattern in 0..2 {
            let aside =
                (0..count).map(|k| ASIDE * signs(k)[pattern] * (1.0 - 0.37 * (k % 3) as f64));
            let mut beside = turned(self.variables, &state, &aside.collect::<Vec<f64>>());
            let mut size = f64::NAN;
            for _ in 0..STEPS_BACK {
                size = self.correction.correct(self.x, &mut beside).size;
            }
            let off = difference(self.variables, &state, &beside);
            let largest = off.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            if size <= BACK && largest > BACK {
                return Astray::Movable([state, beside]);
            }
        }
        Astray::Singular(state)
    }
}

impl StateOnPath {
    /// The state after a part of the correction.
    fn turned(&self, variables: &[Variable], part: f64) -> Vec<f64> {
        let way: Vec<f64> = self.correction.iter().map(|x| part * x).collect();
        turned(variables, &self.state, &way)
    }

    /// Returns whether the correction at the next state is the rest of the one here.
    fn foresees(&self, next: &Self, part: f64) -> bool {
        let pairs = self.correction.iter().zip(&next.correction);
        let off = pairs.map(|(here, next)| next - (1.0 - part) * here);
        let off = double::sqrt(off.map(|x| x * x).sum());
        let size = double::sqrt(self.correction.iter().map(|x| x * x).sum());
        off <= (FORESEEN * size).max(SETTLED)
    }
}

/// A state after changes by unknown.
#[must_use]
pub fn turned(variables: &[Variable], state: &[f64], way: &[f64]) -> Vec<f64> {
    let mut turned = state.to_vec();
    let mut index = 0;
    for (variable, way) in variables.iter().zip(way) {
        match variable {
            Variable::Unit => {
                let [cos, sin] = [state[index], state[index + 1]];
                // Half of the angle by its tangent: no length changes.
                let half = 0.5 * way;
                let (real, turn) = (1.0 - half * half, 2.0 * half);
                let scale = 1.0 / (1.0 + half * half);
                turned[index] = scale * (cos * real - sin * turn);
                turned[index + 1] = scale * (cos * turn + sin * real);
                index += 2;
            }
            _ => {
                turned[index] += way;
                index += 1;
            }
        }
    }
    turned
}

/// Returns the difference between two states for each unknown.
fn difference(variables: &[Variable], from: &[f64], to: &[f64]) -> Vec<f64> {
    let mut index = 0;
    let differences = variables.iter().map(|variable| match variable {
        Variable::Unit => {
            let [cos, sin] = [from[index], from[index + 1]];
            let way = [to[index] - cos, to[index + 1] - sin];
            index += 2;
            cos * way[1] - sin * way[0]
        }
        _ => {
            index += 1;
            to[index - 1] - from[index - 1]
        }
    });
    differences.collect()
}
