//! Ascent from phases to the nearest optimum.
//!
//! Each minimum is a parabola of the difference of its two phases. Where the smallest of such
//! parabolas is largest, some of them are equal, and a mean of their slopes is zero: Newton's
//! method finds that for every choice of equal ones, and the choice that is best by the parabolas
//! is where the next phases are looked at.

use super::PhaseError;
use super::probe::Line;
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::numeric::vector::dot;

/// All minima at some phases.
#[derive(Clone, Debug)]
pub(super) struct Crest<const N: usize> {
    pub(super) phases: [f64; N],
    /// Half the square of the least distance.
    pub(super) q: f64,
    slopes: Vec<(Line, [f64; N])>,
}

/// The number of nearest minima that are compared with each other. A step does not reach the
/// others.
const NEAREST: usize = 8;

/// Steps of Newton's method on parabolas: it doubles the digits, and there are no more than 53.
const NEWTON: usize = 8;

/// More than enough steps.
const STEPS: usize = 80;

/// Rounding error of a square, as a share of it.
const NOISE: f64 = 1e-13;

/// A pivot below this share of the largest one is rounding, and its unknown does not matter.
const PIVOT: f64 = 1e-11;

impl<const N: usize> Crest<N> {
    pub(super) fn new(phases: [f64; N]) -> Self {
        Self {
            phases,
            q: f64::INFINITY,
            slopes: Vec::new(),
        }
    }

    /// Minima of a pair that these phases turn, the first against them.
    pub(super) fn add(&mut self, lines: &[Line], ends: [Option<usize>; 2]) {
        let mut way = [0.0; N];
        for (end, sign) in ends.into_iter().zip([-1.0, 1.0]) {
            if let Some(phase) = end {
                way[phase] += sign;
            }
        }
        for line in lines {
            self.q = self.q.min(line.q);
            self.slopes.push((*line, way));
        }
        self.slopes.sort_by(|a, b| a.0.q.total_cmp(&b.0.q));
    }

    /// Half the square of the least distance nearby, by the parabolas.
    fn beside(&self, step: &[f64; N]) -> f64 {
        let values = self.slopes.iter().map(|(line, way)| {
            let x = dot(way, step);
            line.q + x * (line.slope + 0.5 * line.bend * x)
        });
        values.fold(f64::INFINITY, f64::min)
    }

    /// The step within these limits that is best by the parabolas.
    fn step(&self, limits: &[(f64, f64); N]) -> [f64; N] {
        let count = self.slopes.len().min(NEAREST);
        let mut best = ([0.0; N], self.q);
        for choice in 1..1_usize << count {
            let equal: Vec<usize> = (0..count).filter(|k| choice >> k & 1 == 1).collect();
            if equal.len() > N + 1 {
                continue;
            }
            let mut held = [None; N];
            // Each time round one phase more may have come to its limit.
            for _ in 0..=N {
                let mut step = self.stationary(&equal, &held);
                let mut is_inside = true;
                for (k, change) in step.iter_mut().enumerate() {
                    let (low, high) = limits[k];
                    let within = change.max(low).min(high);
                    if within != *change {
                        is_inside = false;
                        held[k] = Some(within);
                        *change = within;
                    }
                }
                let height = self.beside(&step);
                if height > best.1 {
                    best = (step, height);
                }
                if is_inside {
                    break;
                }
            }
        }
        best.0
    }

    /// The point where these parabolas are equal and a mean of their slopes is zero, with some
    /// phases fixed.
    fn stationary(&self, equal: &[usize], held: &[Option<f64>; N]) -> [f64; N] {
        let count = equal.len();
        let mut step = held.map(|change| change.unwrap_or(0.0));
        let mut shares = vec![1.0 / count as f64; count];
        let mut level = self.q;
        for _ in 0..NEWTON {
            let size = N + count + 1;
            let mut rows = vec![vec![0.0; size + 1]; size];
            for (c, &number) in equal.iter().enumerate() {
                let (line, way) = &self.slopes[number];
                let x = dot(way, &step);
                let slope = line.slope + line.bend * x;
                for k in (0..N).filter(|&k| held[k].is_none()) {
                    for j in 0..N {
                        rows[k][j] += shares[c] * line.bend * way[k] * way[j];
                    }
                    rows[k][N + c] = slope * way[k];
                    rows[k][size] -= shares[c] * slope * way[k];
                }
                for k in 0..N {
                    rows[N + c][k] = slope * way[k];
                }
                rows[N + c][size - 1] = -1.0;
                rows[N + c][size] = level - (line.q + x * (line.slope + 0.5 * line.bend * x));
                rows[size - 1][N + c] = 1.0;
            }
            rows[size - 1][size] = 1.0 - shares.iter().sum::<f64>();
            for k in (0..N).filter(|&k| held[k].is_some()) {
                rows[k][k] = 1.0;
            }
            let change = solved(rows);
            step.iter_mut().zip(&change).for_each(|(x, d)| *x += d);
            shares
                .iter_mut()
                .zip(&change[N..])
                .for_each(|(x, d)| *x += d);
            level += change[size - 1];
        }
        if step.iter().all(|x| x.is_finite()) {
            step
        } else {
            [0.0; N]
        }
    }
}

/// The optimum next to `start`, searched with this length of the first steps.
pub(super) fn climbed<const N: usize>(
    start: [f64; N],
    length: f64,
    ranges: &[(f64, f64); N],
    mut look: impl FnMut([f64; N]) -> Result<Crest<N>, PhaseError>,
) -> Result<Crest<N>, PhaseError> {
    let mut best = look(start)?;
    let ends = ranges
        .iter()
        .flat_map(|(low, high)| [low.abs(), high.abs()]);
    let digit = f64::EPSILON * ends.fold(0.0, f64::max);
    let (mut reach, mut before) = (length, f64::INFINITY);
    for _ in 0..STEPS {
        let limits = core::array::from_fn(|k| {
            let (low, high) = ranges[k];
            let phase = best.phases[k];
            ((low - phase).max(-reach), (high - phase).min(reach))
        });
        let step = best.step(&limits);
        let size = step.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        if size <= digit {
            break;
        }
        let there = core::array::from_fn(|k| {
            let (low, high) = ranges[k];
            (best.phases[k] + step[k]).max(low).min(high)
        });
        let found = look(there)?;
        // At the top of a parabola the square is stationary long before the phase does.
        let is_nearer = size < 0.5 * before && found.q >= best.q * (1.0 - NOISE);
        if found.q > best.q || is_nearer {
            best = found;
            before = size;
            reach = reach.max(2.0 * size);
        } else {
            reach = 0.25 * size;
        }
    }
    Ok(best)
}

/// The solution of a system whose rows end with the right-hand sides. Undetermined unknowns are 0.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let size = rows.len();
    let mut columns: Vec<usize> = (0..size).collect();
    let mut rank = size;
    let mut largest: f64 = 0.0;
    for step in 0..size {
        let entries = (step..size).flat_map(|row| (step..size).map(move |column| (row, column)));
        let size_at = |&(row, column): &(usize, usize)| f64::abs(rows[row][columns[column]]);
        let pivot = entries.max_by(|a, b| size_at(a).total_cmp(&size_at(b)));
        let Some((row, column)) = pivot else { break };
        let pivot_size = size_at(&(row, column));
        largest = largest.max(pivot_size);
        if pivot_size <= PIVOT * largest {
            rank = step;
            break;
        }
        rows.swap(step, row);
        columns.swap(step, column);
        let (above, below) = rows.split_at_mut(step + 1);
        let pivot = &above[step];
        for row in below {
            let factor = row[columns[step]] / pivot[columns[step]];
            row.iter_mut()
                .zip(pivot)
                .for_each(|(x, pivot)| *x -= factor * pivot);
        }
    }
    let mut solution = vec![0.0; size];
    for step in (0..rank).rev() {
        let row = &rows[step];
        let known: f64 = (step + 1..rank)
            .map(|k| row[columns[k]] * solution[columns[k]])
            .sum();
        solution[columns[step]] = (row[size] - known) / row[columns[step]];
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::{Crest, climbed, solved};
    use crate::clearance::probe::Line;
    use alloc::vec;

    #[test]
    fn systems_are_solved_and_what_is_open_is_zero() {
        let found = solved(vec![vec![0.0, 2.0, 4.0], vec![3.0, 1.0, 5.0]]);
        assert_eq!(found, [1.0, 2.0]);
        let open = solved(vec![vec![2.0, 0.0, 4.0], vec![4.0, 0.0, 8.0]]);
        assert_eq!(open, [2.0, 0.0]);
    }

    /// Two slopes that cross, and a hill on the way between:
    /// `min(1 + x, 2 - x, 1.2 - (y - x - 0.25)^2)`.
    #[test]
    fn equal_slopes_and_hills_are_found() {
        let look = |[x, y]: [f64; 2]| {
            let mut crest = Crest::new([x, y]);
            let line = |q: f64, slope: f64, bend: f64| Line { q, slope, bend };
            crest.add(
                &[line(1.0 + x, 1.0, 0.0), line(2.0 - x, -1.0, 0.0)],
                [None, Some(0)],
            );
            let z = y - x - 0.25;
            crest.add(&[line(1.2 - z * z, -2.0 * z, -2.0)], [Some(0), Some(1)]);
            Ok(crest)
        };
        let found = climbed([-0.9, -0.9], 0.1, &[(-1.0, 1.0); 2], look).expect("no course");
        // The hill is lower than where the slopes cross: only its top counts.
        assert!(
            (found.phases[1] - found.phases[0] - 0.25).abs() < 1e-12,
            "{found:?}"
        );
        assert!((found.q - 1.2).abs() < 1e-15);
    }
}
