//! Counterweights that make the shaking force of a cycle small, and with it the shaking moment if
//! that is asked for.
//!
//! Unit masses at chosen points of the links add fixed *effects* `E` to the shaking force `f` of
//! each position, so that masses `z` leave `f + E z`. [`Balance`] finds the masses with the least
//! mean square ([`Balance::mean_square`]) or the least peak ([`Balance::peak`]) of its length;
//! [`StaticMoment`] and [`Counterweight`] are means to realise them.

mod basis;
mod counterweight;
mod error;
mod peak;
mod rows;
mod solution;

use alloc::vec;
use alloc::vec::Vec;

pub use crate::components::Components;
use basis::Basis;
pub use counterweight::{Counterweight, StaticMoment};
pub use error::BalanceError;
use rows::Rows;
pub use solution::{Figures, Solution};

/// Forces over a cycle and the effects of `N` unknown masses on them.
///
/// ```
/// use linkage_analysis::balancing::{Balance, StaticMoment};
/// use std::f64::consts::TAU;
///
/// // A reciprocating mass of 0.5 kg: 500 N at the ends of its stroke. A mass on the crank, 1 kg at
/// // 50 mm and 100 rad/s, has a centrifugal force of 500 N.
/// let angles: Vec<f64> = (0..360).map(|i| TAU * f64::from(i) / 360.0).collect();
/// let forces: Vec<_> = angles.iter().map(|phi| [500.0 * phi.cos(), 0.0]).collect();
/// let effects: Vec<_> = angles
///     .iter()
///     .map(|phi| [phi.cos() * 500.0, phi.sin() * 500.0])
///     .map(|[x, y]| [[x, y], [-y, x]])
///     .collect();
///
/// // The best counterweight takes half of the peak away, and leaves a force that turns backwards.
/// let best = Balance::new(&forces, &effects)?.peak()?;
/// assert!((best.before.peak - 500.0).abs() < 1e-9 && (best.after.peak - 250.0).abs() < 1e-6);
/// assert!(best.after.peak - best.bound < 1e-6);
///
/// // 0.5 kg opposite the crank pin at 50 mm, or at half the radius 1 kg.
/// let weight = StaticMoment::of_masses(best.values, 50.0).at_radius(25.0)?;
/// assert!((weight.mass - 1.0).abs() < 1e-6 && (weight.x + 25.0).abs() < 1e-6);
/// # Ok::<(), linkage_analysis::balancing::BalanceError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Balance<const N: usize> {
    groups: Vec<Group<N>>,
}

/// Rows of one quantity, and the length that they are divided by.
#[derive(Clone, Debug, PartialEq)]
struct Group<const N: usize> {
    rows: Rows<N>,
    length: f64,
}

impl<const N: usize> Balance<N> {
    /// Forces, one for each position, and there the effects of each of the masses at 1: numbers,
    /// vectors, or arrays of up to three components. Positions should be evenly spaced over the
    /// cycle, and dense enough for its peak.
    ///
    /// # Errors
    ///
    /// `Nothing` without positions or masses, `Count` if there are not as many effects as forces,
    /// `NotFinite` for a number that is NaN or infinite.
    pub fn new<V, const K: usize>(forces: &[V], effects: &[[V; N]]) -> Result<Self, BalanceError>
    where
        V: Components<K>,
    {
        let nothing = Self { groups: Vec::new() };
        nothing.and(forces, effects, 1.0)
    }

    /// A second quantity of the same masses, such as moments beside forces: it counts after
    /// division by `length`. With a length of 200 mm, a moment of 200 N mm is as bad as a force of
    /// 1 N. Its positions may be others.
    ///
    /// The mean squares of all quantities are added; the peak is the largest of theirs.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), and `Length` for one that is not positive and finite.
    pub fn and<V, const K: usize>(
        mut self,
        moments: &[V],
        effects: &[[V; N]],
        length: f64,
    ) -> Result<Self, BalanceError>
    where
        V: Components<K>,
    {
        if !(length > 0.0 && length.is_finite()) {
            return Err(BalanceError::Length { length });
        }
        let rows = rows::rows(self.groups.len(), moments, effects)?;
        self.groups.push(Group { rows, length });
        Ok(self)
    }

    /// The masses with the least mean square, by orthogonal projection.
    ///
    /// # Errors
    ///
    /// `NoEffect` for a mass that changes nothing, `Dependent` for one whose effects are, to 12
    /// digits, a combination of those before it, `OutOfRange` if a result overflows.
    pub fn mean_square(&self) -> Result<Solution<N>, BalanceError> {
        let rows = self.scaled(|group| {
            group.length * linkage_core::math::double::sqrt(group.rows.len() as f64)
        });
        let basis = Basis::new(&rows)?;
        let (coordinates, _) = basis.project(&rows);
        self.solution(basis.values(&coordinates), |after| after.rms)
    }

    /// The masses with the least peak: the length that is not exceeded at any position.
    ///
    /// An interior point method. Its result is as a rule within 1e-9 of the least possible peak,
    /// and `bound` tells how near it is.
    ///
    /// # Errors
    ///
    /// As [`mean_square`](Self::mean_square).
    pub fn peak(&self) -> Result<Solution<N>, BalanceError> {
        let rows = self.scaled(|group| group.length);
        let basis = Basis::new(&rows)?;
        let (start, rest) = basis.project(&rows);
        let found = peak::least_peak(&rest, basis.columns());
        let values = basis.values(&core::array::from_fn(|j| start[j] + found.coordinates[j]));
        // The values under the bound are known to rounding only.
        let bound = found.bound - rows::rounding(&rows, &values);
        self.solution(values, |after| bound.clamp(0.0, after.peak))
    }

    /// Builds the solution for masses, with the bound that belongs to it.
    fn solution(
        &self,
        values: [f64; N],
        bound: impl FnOnce(&Figures) -> f64,
    ) -> Result<Solution<N>, BalanceError> {
        let (before, after) = (self.figures(&[0.0; N]), self.figures(&values));
        let figures = [before.rms, before.peak, after.rms, after.peak];
        if !figures.iter().chain(&values).all(|x| x.is_finite()) {
            return Err(BalanceError::OutOfRange);
        }
        Ok(Solution {
            values,
            before,
            after,
            bound: bound(&after),
        })
    }

    /// Root mean square and peak with these masses: of several quantities together, as they are
    /// minimised.
    #[must_use]
    pub fn figures(&self, values: &[f64; N]) -> Figures {
        let figures = self.groups.iter().map(|group| {
            let figures = rows::figures(&group.rows, values);
            figures.divided_by(group.length)
        });
        figures.fold(Figures::default(), Figures::and)
    }

    /// Root mean square and peak with these masses for each quantity, in its own unit: forces
    /// first, then the added ones.
    #[must_use]
    pub fn figures_of_each(&self, values: &[f64; N]) -> Vec<Figures> {
        let groups = self.groups.iter();
        groups
            .map(|group| rows::figures(&group.rows, values))
            .collect()
    }

    /// All rows, those of each group divided by its number.
    fn scaled(&self, divisor: impl Fn(&Group<N>) -> f64) -> Rows<N> {
        let mut rows = vec![];
        for group in &self.groups {
            let factor = 1.0 / divisor(group);
            rows.extend(group.rows.iter().map(|row| row.times(factor)));
        }
        rows
    }
}
