//! The conditions: at each position a force, and the effects of the masses.

use alloc::vec::Vec;

use super::{BalanceError, Figures};
use crate::components::{Components, in_space, norm};
use linkage_core::math::double::sqrt;

/// A position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ForceRow<const N: usize> {
    pub(super) force: [f64; 3],
    pub(super) effects: [[f64; 3]; N],
}

pub(super) type Rows<const N: usize> = Vec<ForceRow<N>>;

impl<const N: usize> ForceRow<N> {
    pub(super) fn times(&self, factor: f64) -> Self {
        let times = |v: [f64; 3]| v.map(|x| factor * x);
        Self {
            force: times(self.force),
            effects: self.effects.map(times),
        }
    }

    /// The force that masses leave.
    pub(super) fn with(&self, values: &[f64; N]) -> [f64; 3] {
        let mut sum = self.force;
        add(&mut sum, 1.0, &self.change(values));
        sum
    }

    /// Returns the effect of masses on the force.
    pub(super) fn change(&self, values: &[f64; N]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (effect, value) in self.effects.iter().zip(values) {
            add(&mut sum, *value, effect);
        }
        sum
    }
}

/// `sum += factor * v`.
pub(super) fn add(sum: &mut [f64; 3], factor: f64, v: &[f64; 3]) {
    for (to, x) in sum.iter_mut().zip(v) {
        *to += factor * x;
    }
}

pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The rows of a group, all of them finite.
pub(super) fn rows<V, const N: usize, const K: usize>(
    group: usize,
    forces: &[V],
    effects: &[[V; N]],
) -> Result<Rows<N>, BalanceError>
where
    V: Components<K>,
{
    if N == 0 {
        return Err(BalanceError::Nothing { what: "no masses" });
    }
    if forces.is_empty() {
        return Err(BalanceError::Nothing {
            what: "no positions",
        });
    }
    if effects.len() != forces.len() {
        return Err(BalanceError::Count {
            group,
            forces: forces.len(),
            effects: effects.len(),
        });
    }
    let finite = |v: V| v.components().iter().all(|x| x.is_finite());
    for (position, (force, effects)) in forces.iter().zip(effects).enumerate() {
        let effect = effects.iter().position(|&effect| !finite(effect));
        if effect.is_some() || !finite(*force) {
            return Err(BalanceError::NotFinite {
                group,
                position,
                effect,
            });
        }
    }
    let space = |v: V| in_space(&v.components());
    let row = |(force, effects): (&V, &[V; N])| ForceRow {
        force: space(*force),
        effects: effects.map(space),
    };
    Ok(forces.iter().zip(effects).map(row).collect())
}

/// Returns root mean square and peak of a group with these masses.
pub(super) fn figures<const N: usize>(rows: &[ForceRow<N>], values: &[f64; N]) -> Figures {
    let lengths: Vec<f64> = rows.iter().map(|row| norm(&row.with(values))).collect();
    Figures {
        rms: norm(&lengths) / sqrt(lengths.len() as f64),
        peak: lengths.into_iter().fold(0.0, larger),
    }
}

/// Returns a bound of the rounding error of the forces with masses, and of sums over them.
pub(super) fn rounding<const N: usize>(rows: &[ForceRow<N>], values: &[f64; N]) -> f64 {
    let terms = |row: &ForceRow<N>| {
        let effects = row.effects.iter().zip(values);
        let sum: f64 = effects
            .map(|(effect, value)| norm(effect) * value.abs())
            .sum();
        norm(&row.force) + sum
    };
    let roundings = 8.0 + sqrt(rows.len() as f64);
    roundings * f64::EPSILON * rows.iter().map(terms).fold(0.0, larger)
}

/// The larger of two numbers; NaN if either is NaN.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}
