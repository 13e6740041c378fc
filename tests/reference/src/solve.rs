//! Newton's method for a [`System`].

use crate::matrix::{Factors, largest};
use crate::{BITS, Big, Kind, Plane, Position, System};

/// Steps of the differences that make the Jacobian: its error, and so the rate of convergence, is
/// of this size.
const JACOBIAN_STEP: i32 = -180;
/// A Newton correction below this leaves an error below the precision.
const CONVERGED: i32 = -340;

/// A solved position.
pub struct Solution {
    /// The value of every unknown, as in [`Position`].
    pub unknowns: Vec<Plane>,
    /// Determinant of the equations by angles and slides over the product of its columns' lengths:
    /// between -1 and 1.
    pub determinant: Big,
    /// For every unknown the length of its column: by how much its change opens the loops.
    pub levers: Vec<Big>,
    scale: Big,
    factors: Factors,
}

/// Solves the system from a guess (angles in radians, slides in the unit of the data).
///
/// `None` if the iteration does not converge.
pub fn solve(system: &System, data: &[Big], guess: &[f64]) -> Option<Solution> {
    let scale = length_scale(system, data);
    let mut state = start(system, guess, &scale);
    let small = Big::power_of_two(CONVERGED);
    for _ in 0..80 {
        let equations = evaluate(system, data, &scale, &state);
        let jacobian = jacobian(system, data, &scale, &state, &equations);
        let factors = Factors::new(jacobian.clone())?;
        let correction = factors.solve(&equations);
        subtract(&mut state, &correction);
        let moved = largest(&correction);
        if moved.is_invalid() {
            return None;
        }
        if moved < small {
            let (determinant, levers) = normalised_determinant(system, &jacobian, &state);
            let levers = levers
                .into_iter()
                .zip(system.unknowns)
                .map(|(lever, unknown)| {
                    // A slide and the residuals are scaled alike.
                    if unknown.kind == Kind::Length {
                        lever
                    } else {
                        lever * &scale
                    }
                });
            let levers = levers.collect();
            let unknowns = unknowns(system, &scale, &state);
            return Some(Solution {
                unknowns,
                determinant,
                levers,
                scale,
                factors,
            });
        }
    }
    None
}

/// The determinant as in [`Solution`], but at values of the unknowns that need not be a solution;
/// that of one equation not divided by its length.
pub(crate) fn determinant_at(system: &System, data: &[Big], values: &[f64]) -> Big {
    let scale = length_scale(system, data);
    let state = start(system, values, &scale);
    let equations = evaluate(system, data, &scale, &state);
    let jacobian = jacobian(system, data, &scale, &state, &equations);
    let (determinant, levers) = normalised_determinant(system, &jacobian, &state);
    match &levers[..] {
        [lever] => determinant * lever,
        _ => determinant,
    }
}

impl Solution {
    /// The unknowns as they are iterated: cosine and sine of an angle, a slide over the length
    /// scale.
    pub(crate) fn state(&self, system: &System) -> Vec<Big> {
        let mut state = Vec::new();
        for (unknown, value) in system.unknowns.iter().zip(&self.unknowns) {
            match unknown.kind {
                Kind::Angle => state.extend([value.x.clone(), value.y.clone()]),
                Kind::Ratio => state.push(value.x.clone()),
                Kind::Length => state.push(&value.x / &self.scale),
            }
        }
        state
    }

    /// The unknowns in a state.
    pub(crate) fn unknowns_in(&self, system: &System, state: &[Big]) -> Vec<Plane> {
        unknowns(system, &self.scale, state)
    }

    /// The solution for data that differ by very little, from a state near it, by iteration with
    /// the Jacobian of this solution.
    pub(crate) fn moved(&self, system: &System, data: &[Big], mut state: Vec<Big>) -> Vec<Big> {
        let size = largest(&state).max(&Big::one());
        let rounding = Big::power_of_two(6 - BITS as i32) * size / self.determinant.abs();
        let rounding = rounding / self.least_lever(system);
        let mut before = Big::one();
        for _ in 0..40 {
            let correction = self
                .factors
                .solve(&evaluate(system, data, &self.scale, &state));
            subtract(&mut state, &correction);
            let moved = largest(&correction);
            // Convergence is linear: the next correction is smaller by the same factor as this one
            // was.
            if &moved * &moved < &rounding * &before || moved < rounding {
                return state;
            }
            before = moved;
        }
        panic!(
            "{}: the differences of the reference do not converge",
            system.name
        );
    }

    /// The unknowns, to first order, where one equation is not zero but `step` in units of the
    /// length scale; and that length.
    pub(crate) fn missed(&self, system: &System, equation: usize, step: &Big) -> (Vec<Plane>, Big) {
        let mut state = self.state(system);
        let mut residual = vec![Big::zero(); state.len()];
        residual[equation] = step.clone();
        subtract(&mut state, &self.factors.solve(&residual));
        (self.unknowns_in(system, &state), step * &self.scale)
    }

    /// The shortest lever of an angle over the length scale, at most 1: the residuals are rounded by
    /// the scale, and the angles of short links so much more.
    fn least_lever(&self, system: &System) -> Big {
        let levers = self.levers.iter().zip(system.unknowns);
        let angles = levers.filter(|(_, unknown)| unknown.kind == Kind::Angle);
        angles.fold(Big::one(), |least, (lever, _)| {
            let lever = lever / &self.scale;
            if lever < least { lever } else { least }
        })
    }

    /// The determinant for data that differ by very little.
    pub(crate) fn moved_determinant(&self, system: &System, data: &[Big]) -> Big {
        let state = self.moved(system, data, self.state(system));
        let equations = evaluate(system, data, &self.scale, &state);
        let jacobian = jacobian(system, data, &self.scale, &state, &equations);
        normalised_determinant(system, &jacobian, &state).0
    }
}

/// A power of two near the longest length, by which slides are scaled.
fn length_scale(system: &System, data: &[Big]) -> Big {
    let data: Vec<f64> = data.iter().map(Big::to_f64).collect();
    Big::power_of_two(system.size(&data).log2().round() as i32)
}

fn start(system: &System, guess: &[f64], scale: &Big) -> Vec<Big> {
    let mut state = Vec::new();
    for (unknown, &value) in system.unknowns.iter().zip(guess) {
        match unknown.kind {
            Kind::Angle => state.extend([value.cos(), value.sin()].map(Big::from)),
            Kind::Ratio => state.push(Big::from(value)),
            Kind::Length => state.push(Big::from(value) / scale),
        }
    }
    state
}

fn unknowns(system: &System, scale: &Big, state: &[Big]) -> Vec<Plane> {
    let mut rest = state.iter();
    let mut next = || rest.next().expect("a number for every unknown");
    let one = |kind| match kind {
        Kind::Angle => Plane {
            x: next().clone(),
            y: next().clone(),
        },
        Kind::Ratio => Plane {
            x: next().clone(),
            y: Big::zero(),
        },
        Kind::Length => Plane {
            x: next() * scale,
            y: Big::zero(),
        },
    };
    system
        .unknowns
        .iter()
        .map(|unknown| unknown.kind)
        .map(one)
        .collect()
}

/// The residuals over the length scale, then `c^2 + s^2 - 1` for every angle.
fn evaluate(system: &System, data: &[Big], scale: &Big, state: &[Big]) -> Vec<Big> {
    let unknowns = unknowns(system, scale, state);
    let inverse = Big::one() / scale;
    let mut equations = (system.residual)(&Position {
        system,
        data,
        unknowns: &unknowns,
    });
    equations
        .iter_mut()
        .for_each(|residual| *residual = &*residual * &inverse);
    for (unknown, value) in system.unknowns.iter().zip(&unknowns) {
        if unknown.kind == Kind::Angle {
            equations.push(value.dot(value) - 1.0);
        }
    }
    equations
}

fn jacobian(
    system: &System,
    data: &[Big],
    scale: &Big,
    state: &[Big],
    equations: &[Big],
) -> Vec<Vec<Big>> {
    let step = Big::power_of_two(JACOBIAN_STEP);
    let mut rows = vec![Vec::with_capacity(state.len()); equations.len()];
    for column in 0..state.len() {
        let mut moved = state.to_vec();
        moved[column] = &moved[column] + &step;
        let changed = evaluate(system, data, scale, &moved);
        for (row, (after, before)) in rows.iter_mut().zip(changed.iter().zip(equations)) {
            row.push((after - before) / &step);
        }
    }
    rows
}

/// The determinant by angles and slides, each column divided by its length; and these lengths.
fn normalised_determinant(
    system: &System,
    jacobian: &[Vec<Big>],
    state: &[Big],
) -> (Big, Vec<Big>) {
    let n = system.unknowns.len();
    let mut rows = vec![Vec::with_capacity(n); n];
    let mut levers = Vec::with_capacity(n);
    let mut column = 0;
    for unknown in system.unknowns {
        let entry = |row: &[Big]| match unknown.kind {
            Kind::Angle => &row[column + 1] * &state[column] - &row[column] * &state[column + 1],
            _ => row[column].clone(),
        };
        let entries: Vec<Big> = jacobian[..n].iter().map(|row| entry(row)).collect();
        let length = entries
            .iter()
            .fold(Big::zero(), |sum, e| sum + e * e)
            .sqrt();
        rows.iter_mut()
            .zip(entries)
            .for_each(|(row, e)| row.push(e / &length));
        levers.push(length);
        column += if unknown.kind == Kind::Angle { 2 } else { 1 };
    }
    let determinant = Factors::new(rows).map_or_else(Big::zero, |factors| factors.determinant());
    (determinant, levers)
}

fn subtract(state: &mut [Big], correction: &[Big]) {
    state
        .iter_mut()
        .zip(correction)
        .for_each(|(x, dx)| *x = &*x - dx);
}
