//! From an estimate to the solution that is meant by it.

use super::isolation::isolation;
use super::{Residuals, Step};
use crate::math::double;
use crate::numeric::roots::Variable;
use alloc::vec::Vec;

/// The longest step, in radians or on the scale of the state: far less than the distance of another solution.
const LONGEST: f64 = 0.1;

/// What the next correction may differ from the one that was foreseen, as a part of the correction: where Newton's method is certain to find
/// the nearest solution, a full step leaves a quarter.
const FORESEEN: f64 = 0.25;

/// A step that is a smaller part of a correction leads nowhere.
const SHORTEST: f64 = 1e-6;

/// Corrections, at most: an estimate that is off by a radian in every unknown takes less than a hundred.
const CORRECTIONS: usize = 1000;

/// Corrections of this size leave nothing but rounding.
const SETTLED: f64 = 1e-9;

/// What is not proven to be isolated is singular, or one of many: a state that is off by this leads back to it, but for a thousandth, or not.
const ASIDE: f64 = 1e-6;
const BACK: f64 = 1e-3 * ASIDE;
const STEPS_BACK: usize = 4;

/// Where an estimate leads to no solution.
#[derive(Clone, Debug, PartialEq)]
pub enum Astray {
    /// The equations, or a correction, have no value at the estimate.
    NoValue,
    /// The way ends at a dead point.
    DeadPoint {
        /// The part of what the equations miss by at the estimate that is left there: 1 if it is the estimate.
        left: f64,
        /// The state where the way ends.
        at: Vec<f64>,
    },
    /// It leads to a solution beside which there are others: these states, both of which solve the equations.
    Movable([Vec<f64>; 2]),
}

/// Follows a state from where the unknowns are estimated to a solution at the inputs `x`.
///
/// At the estimate the equations miss by something, as if the links had other lengths. All of that is taken back in the same ratio, in steps
/// that are short enough to stay on the way: after each step the next correction must be the one before, less the step, but for a quarter,
/// and the determinant must keep its sign. So what is found is the assembly that the estimate becomes while its links
/// grow to their lengths, or nothing. It is proven to be a solution, and the only one in a box about it.
///
/// # Errors
///
/// Where the way ends at a dead point, or in a solution that is not isolated.
pub fn from_estimate(
    correction: &mut dyn Residuals,
    variables: &[Variable],
    x: &[f64],
    estimate: &[f64],
) -> Result<Vec<f64>, Astray> {
    let mut way = Way {
        correction,
        variables,
        x,
    };
    let mut here = way.at(estimate.to_vec());
    let sign = here.step.determinant.signum();
    let mut left = 1.0;
    if !here.step.size.is_finite() || here.step.determinant == 0.0 {
        return Err(Astray::NoValue);
    }
    for _ in 0..CORRECTIONS {
        if here.step.size <= SETTLED {
            let state = here.corrected;
            return match isolation(way.correction, variables, x, &state) {
                Some(_) => Ok(state),
                None => Err(way.not_isolated(state)),
            };
        }
        let mut part = (LONGEST / here.step.size).min(1.0);
        let next = loop {
            let next = way.at(here.turned(variables, part));
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

struct Way<'w> {
    correction: &'w mut dyn Residuals,
    variables: &'w [Variable],
    x: &'w [f64],
}

/// A place on the way, and the correction there.
struct Place {
    state: Vec<f64>,
    corrected: Vec<f64>,
    /// By unknown.
    correction: Vec<f64>,
    step: Step,
}

impl Way<'_> {
    fn at(&mut self, state: Vec<f64>) -> Place {
        let mut corrected = state.clone();
        let step = self.correction.correct(self.x, &mut corrected);
        Place {
            correction: difference(self.variables, &state, &corrected),
            state,
            corrected,
            step,
        }
    }

    /// What a state is that solves the equations and is not proven to be alone.
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
        Astray::DeadPoint {
            left: 0.0,
            at: state,
        }
    }
}

impl Place {
    /// The state after a part of the correction.
    fn turned(&self, variables: &[Variable], part: f64) -> Vec<f64> {
        let way: Vec<f64> = self.correction.iter().map(|own| part * own).collect();
        turned(variables, &self.state, &way)
    }

    /// Whether the correction at the next place is what is left of the one here.
    fn foresees(&self, next: &Self, part: f64) -> bool {
        let pairs = self.correction.iter().zip(&next.correction);
        let off = pairs.map(|(own, next)| next - (1.0 - part) * own);
        let off = double::sqrt(off.map(|x| x * x).sum());
        let size = double::sqrt(self.correction.iter().map(|x| x * x).sum());
        off <= (FORESEEN * size).max(SETTLED)
    }
}

/// A state after changes by unknown.
#[must_use]
pub fn turned(variables: &[Variable], state: &[f64], way: &[f64]) -> Vec<f64> {
    let mut turned = state.to_vec();
    let mut place = 0;
    for (variable, way) in variables.iter().zip(way) {
        match variable {
            Variable::Unit => {
                let [cos, sin] = [state[place], state[place + 1]];
                // Half of the angle by its tangent: no length changes.
                let half = 0.5 * way;
                let (real, turn) = (1.0 - half * half, 2.0 * half);
                let scale = 1.0 / (1.0 + half * half);
                turned[place] = scale * (cos * real - sin * turn);
                turned[place + 1] = scale * (cos * turn + sin * real);
                place += 2;
            }
            _ => {
                turned[place] += way;
                place += 1;
            }
        }
    }
    turned
}

/// From one state to another, by unknown.
fn difference(variables: &[Variable], from: &[f64], to: &[f64]) -> Vec<f64> {
    let mut place = 0;
    let all = variables.iter().map(|variable| match variable {
        Variable::Unit => {
            let [cos, sin] = [from[place], from[place + 1]];
            let way = [to[place] - cos, to[place + 1] - sin];
            place += 2;
            cos * way[1] - sin * way[0]
        }
        _ => {
            place += 1;
            to[place - 1] - from[place - 1]
        }
    });
    all.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Enclosure;
    use crate::numeric::continuation::Correction;

    /// A correction, and what is missed over boxes.
    struct Group<C, R>(C, R);

    impl<C: FnMut(&[f64], &mut [f64]) -> Step, R> Correction for Group<C, R> {
        fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
            (self.0)(x, state)
        }
    }

    impl<C, R> Residuals for Group<C, R>
    where
        C: FnMut(&[f64], &mut [f64]) -> Step,
        R: FnMut(&[f64], &[Enclosure]) -> Vec<Enclosure>,
    {
        fn residuals(&mut self, x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
            (self.1)(x, state)
        }
    }

    fn number(x: f64) -> Enclosure {
        Enclosure::between(x, x)
    }

    /// Two links of length 1 from `(0, 0)` and `(d, 0)` meet: the angle of the first, and how far up they meet.
    fn triangle(x: &[f64], state: &mut [f64]) -> Step {
        let d = x[0];
        let length = (state[0] * state[0] + state[1] * state[1]).sqrt();
        let [cos, sin] = [state[0] / length, state[1] / length];
        // (cos - d)^2 + sin^2 = 1 and h = sin
        let miss = (cos - d).powi(2) + sin * sin - 1.0;
        let slope = 2.0 * d * sin;
        let turn = -miss / slope;
        let rise = sin + cos * turn - state[2];
        // To second order, as generated code turns.
        let versine = 0.5 * turn * turn;
        state[0] = cos - sin * turn - cos * versine;
        state[1] = sin + cos * turn - sin * versine;
        state[2] += rise;
        Step {
            size: (turn * turn + rise * rise).sqrt(),
            determinant: slope,
        }
    }

    /// What it misses by.
    fn missed(x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
        let [cos, sin, height] = [state[0], state[1], state[2]];
        let away = cos - number(x[0]);
        Vec::from([away * away + sin * sin - number(1.0), height - sin])
    }

    const VARIABLES: [Variable; 2] = [Variable::Unit, Variable::Length];

    fn found(d: f64, angle: f64) -> Result<f64, Astray> {
        let (sin, cos) = angle.sin_cos();
        let mut group = Group(triangle, missed);
        let state = from_estimate(&mut group, &VARIABLES, &[d], &[cos, sin, 0.0])?;
        assert!((state[2] - state[1]).abs() < 1e-12);
        Ok(state[1].atan2(state[0]))
    }

    #[test]
    fn a_rough_estimate_leads_to_the_assembly_on_its_side() {
        for angle in [0.1, 0.5, 1.0, 1.5, 2.5] {
            let above = found(1.2, angle).expect("it is found");
            assert!((above - 0.6_f64.acos()).abs() < 1e-12, "{angle}: {above}");
            let below = found(1.2, -angle).expect("it is found");
            assert!((below + 0.6_f64.acos()).abs() < 1e-12, "{angle}: {below}");
        }
    }

    #[test]
    fn links_that_do_not_reach_each_other_end_at_a_dead_point() {
        let astray = found(2.1, 1.0).expect_err("nothing is there");
        let Astray::DeadPoint { left, at } = astray else {
            panic!("{astray:?}")
        };
        // At the estimate both links end at one place for d = 2 cos 1, and the dead point is met at d = 2.
        let missed = |d: f64| 1.0 + d * d - 2.0 * d * 1.0_f64.cos() - 1.0;
        let ends = (missed(2.1) - (2.1_f64 * 2.1 - 2.0 * 2.1)) / missed(2.1);
        assert!((1.0 - left - ends).abs() < 0.02, "{left} {ends}");
        // Both links lie along the base.
        assert!(at[1].atan2(at[0]).abs() < 0.1, "{at:?}");
    }

    #[test]
    fn an_estimate_without_a_value_is_no_dead_point() {
        let astray = found(f64::NAN, 1.0).expect_err("nothing is there");
        assert_eq!(astray, Astray::NoValue);
    }

    #[test]
    fn a_solution_on_a_curve_of_solutions_is_refused_with_another_one() {
        // x^2 + y^2 = 1 twice, a little apart: the correction goes to the circle and stays where it meets it.
        let circle = |_: &[f64], state: &mut [f64]| {
            let square = state[0] * state[0] + state[1] * state[1];
            let share = 0.5 * (1.0 - square) / square;
            let correction = [share * state[0], share * state[1]];
            state[0] += correction[0];
            state[1] += correction[1];
            Step {
                size: correction[0].hypot(correction[1]),
                determinant: 1e-17,
            }
        };
        let twice = |_: &[f64], state: &[Enclosure]| {
            let square = state[0] * state[0] + state[1] * state[1] - number(1.0);
            Vec::from([square, square])
        };
        let variables = [Variable::Length; 2];
        let astray = from_estimate(&mut Group(circle, twice), &variables, &[], &[0.6, 0.9]);
        let Err(Astray::Movable([a, b])) = astray else {
            panic!("{astray:?}")
        };
        for state in [&a, &b] {
            assert!((state[0].hypot(state[1]) - 1.0).abs() < 1e-12);
        }
        assert!((a[0] - b[0]).abs() > 1e-8);
    }
}
