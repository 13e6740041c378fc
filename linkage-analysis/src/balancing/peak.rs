//! Least peak: the point that makes the longest of the vectors `f_i + Q_i y` as short as possible.
//!
//! A primal-dual interior point method on: the least `tau` with `|f_i + Q_i y|^2 <= tau` at each
//! position `i`. Its multipliers give a lower bound that does not depend on how well it has
//! converged: with vectors `u_i` for which `sum Q_i^T u_i = 0`, any `y` has
//! `sum u_i . f_i = sum u_i . (f_i + Q_i y) <= sum |u_i| * peak`.

mod step;

use alloc::vec;
use alloc::vec::Vec;

use super::rows::{ForceRow, add, dot, larger};
use crate::components::norm;
use linkage_core::math::double::sqrt;
use linkage_core::numeric::cholesky::Cholesky;
use step::{LEAST_PIVOT, State};

/// A point, and a lower bound of the peak of all points.
pub(super) struct PeakSolution<const N: usize> {
    pub(super) coordinates: [f64; N],
    pub(super) bound: f64,
}

/// Rounds of the method at most, rounds without progress that end it, and the gap between peak and
/// bound, as part of the peak, that is small enough.
const ROUNDS: usize = 100;
const PATIENCE: usize = 5;
const GAP: f64 = 1e-13;

/// The coordinates of the least peak. The columns are of length 1 and perpendicular to each other
/// and to the forces.
pub(super) fn least_peak<const N: usize>(
    forces: &[[f64; 3]],
    columns: &[[[f64; 3]; N]],
) -> PeakSolution<N> {
    let scale = forces.iter().map(|v| norm(v)).fold(0.0, larger);
    if scale == 0.0 {
        return PeakSolution {
            coordinates: [0.0; N],
            bound: 0.0,
        };
    }
    let problem = Problem::new(forces, columns, scale);
    let mut state = State::start(&problem.rows);
    let (mut point, mut peak, mut bound) = (state.point, 1.0, 0.0);
    let mut patience = PATIENCE;
    for _ in 0..ROUNDS {
        let (new_peak, new_bound) = (
            problem.peak(&state.point),
            problem.bound(&state.point, &state.multipliers),
        );
        patience -= 1;
        if new_peak < peak || new_bound > bound {
            patience = PATIENCE;
        }
        if new_peak < peak {
            (point, peak) = (state.point, new_peak);
        }
        bound = f64::max(bound, new_bound);
        if peak - bound <= GAP * peak || patience == 0 {
            break;
        }
        state = state.next(&problem.rows);
    }
    PeakSolution {
        coordinates: point.map(|y| scale * problem.unit * y),
        bound: scale * bound,
    }
}

/// Forces of size 1 and columns with entries of size 1.
struct Problem<const N: usize> {
    rows: Vec<ForceRow<N>>,
    /// The length of a column.
    unit: f64,
}

impl<const N: usize> Problem<N> {
    fn new(forces: &[[f64; 3]], columns: &[[[f64; 3]; N]], scale: f64) -> Self {
        let unit = sqrt(forces.len() as f64);
        let row = |(force, column): (&[f64; 3], &[[f64; 3]; N])| ForceRow {
            force: force.map(|x| x / scale),
            effects: column.map(|v| v.map(|x| x * unit)),
        };
        Self {
            rows: forces.iter().zip(columns).map(row).collect(),
            unit,
        }
    }

    fn peak(&self, point: &[f64; N]) -> f64 {
        let lengths = self.rows.iter().map(|row| norm(&row.with(point)));
        lengths.fold(0.0, larger)
    }

    /// Returns the bound that the multipliers prove: with `u_i` the forces that remain times their
    /// multipliers, less their part along the columns.
    fn bound(&self, point: &[f64; N], multipliers: &[f64]) -> f64 {
        let weighted = self.rows.iter().zip(multipliers);
        let mut u: Vec<[f64; 3]> = weighted
            .map(|(row, multiplier)| row.with(point).map(|x| multiplier * x))
            .collect();
        // First where the multipliers are, which changes work and sizes alike; then the little that
        // is left, anywhere.
        let sizes: Vec<f64> = u.iter().map(|u| norm(u)).collect();
        self.make_perpendicular(&mut u, &sizes);
        self.make_perpendicular(&mut u, &vec![1.0; sizes.len()]);
        let pairs = self.rows.iter().zip(&u);
        let work: f64 = pairs.map(|(row, u)| dot(&row.force, u)).sum();
        let size: f64 = u.iter().map(|u| norm(u)).sum();
        if size > 0.0 { work / size } else { 0.0 }
    }

    /// Makes vectors perpendicular to the columns by changes in proportion to weights.
    fn make_perpendicular(&self, u: &mut [[f64; 3]], weights: &[f64]) {
        let mut along = [0.0; N];
        let mut matrix = [[0.0; N]; N];
        for ((row, u), weight) in self.rows.iter().zip(&*u).zip(weights) {
            for j in 0..N {
                along[j] -= dot(&row.effects[j], u);
                for (sum, effect) in matrix[j][..=j].iter_mut().zip(&row.effects) {
                    *sum += weight * dot(&row.effects[j], effect);
                }
            }
        }
        let shares = Cholesky::with_least_pivot(matrix, LEAST_PIVOT).solve(along);
        for ((row, u), weight) in self.rows.iter().zip(u).zip(weights) {
            add(u, *weight, &row.change(&shares));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between -1 and 1 without a pattern.
    fn number(i: usize) -> f64 {
        let x = (i as f64 * 12.9898).sin() * 43_758.545_3;
        2.0 * (x - x.floor()) - 1.0
    }

    fn problem(first: usize) -> Problem<2> {
        let vector = |i: usize| [number(i), number(i + 1), number(i + 2)];
        let row = |i: usize| ForceRow {
            force: vector(first + 9 * i).map(|x| 0.5 * x),
            effects: [vector(first + 9 * i + 3), vector(first + 9 * i + 6)],
        };
        Problem {
            rows: (0..12).map(row).collect(),
            unit: 1.0,
        }
    }

    /// Whatever the point and the multipliers are, the bound is one, and it is only met at the
    /// optimum.
    #[test]
    fn the_bound_holds_wherever_the_method_is() {
        let mut nearest = 0.0_f64;
        for first in (0..2000).step_by(200) {
            let problem = problem(first);
            let mut state = State::start(&problem.rows);
            let (mut least, mut reached) = (1.0_f64, 0.0_f64);
            for _ in 0..30 {
                least = least.min(problem.peak(&state.point));
                reached = reached.max(problem.bound(&state.point, &state.multipliers));
                state = state.next(&problem.rows);
            }
            assert!((least - reached).abs() < 1e-9 * least, "{least} {reached}");
            for i in 0..200 {
                let at = 5000 + 20 * i;
                let point = [3.0 * number(at), 3.0 * number(at + 1)];
                let multipliers: Vec<f64> =
                    (2..14).map(|j| number(at + j) * number(at + j)).collect();
                let bound = problem.bound(&point, &multipliers);
                assert!(bound <= least * (1.0 + 1e-12), "{bound} above {least}");
                nearest = nearest.max(bound / least);
            }
        }
        assert!(nearest > 0.5 && nearest < 1.0, "{nearest}");
    }
}
