//! Nearest approach of equations to a solution: the least sum of squares of their errors.

use super::cholesky;
use crate::math::double::sqrt;
use alloc::vec::Vec;

/// Steps of Levenberg's and Marquardt's method: near a dead point it converges linearly.
const STEPS: usize = 400;

/// The longest step, in units like radians: a longer one may leave the neighbourhood.
const LONGEST: f64 = 0.1;

/// A slope below this part of the misses is none: differences know no more.
const LEVEL: f64 = 1e-8;

/// The step of differences that serve as derivatives: their error is about its square, and rounding
/// is as much.
pub const STEP: f64 = 1e-5;

/// Smaller misses are none, where lengths are about 1.
pub const CLOSED: f64 = 1e-9;

/// Damping as a part of the largest diagonal: where it begins, by how much it changes, and where no
/// step is worth more.
const DAMPING: f64 = 1e-3;
const LESS: f64 = 0.3;
const MORE: f64 = 5.0;
const MOST: f64 = 1e9;
const LEAST: f64 = 1e-13;

/// Equations about a place, to first order.
pub trait Rows {
    /// Returns the error of each equation.
    fn missed(&self) -> &[f64];

    /// Returns the derivatives of each equation with respect to all that can change.
    fn matrix(&self) -> &[Vec<f64>];
}

/// Equations that may not hold anywhere; a place has values for all that can change.
pub trait Equations<Place> {
    /// The equations about a place.
    type Rows: Rows;

    /// The equations about a place; nothing where they have no value.
    fn rows(&mut self, at: &Place) -> Option<Self::Rows>;

    /// Returns the errors of the equations of `rows` at a place.
    fn misses(&mut self, at: &Place, rows: &Self::Rows) -> Vec<f64>;

    /// A place after changes, where `rows` are the equations.
    fn after(&mut self, at: &Place, rows: &Self::Rows, changes: &[f64]) -> Place;
}

/// The place near `from` with the least sum of squares; nothing if it is not found.
pub fn minimise<Place, E: Equations<Place>>(
    equations: &mut E,
    from: Place,
) -> Option<(Place, E::Rows)> {
    let mut here = from;
    let mut damping = DAMPING;
    for _ in 0..STEPS {
        let rows = equations.rows(&here)?;
        let slope = slope(&rows);
        let size = sqrt(square(rows.missed()));
        let steepest = rows.matrix().iter().map(|row| largest(row));
        let steepest = steepest.fold(0.0, f64::max);
        if size <= CLOSED || largest(&slope) <= LEVEL * size * steepest {
            return Some((here, rows));
        }
        loop {
            let next = step(&rows, &slope, damping).map(|step| {
                let shorter = (LONGEST / largest(&step)).min(1.0);
                let changes: Vec<f64> = step.iter().map(|x| -shorter * x).collect();
                equations.after(&here, &rows, &changes)
            });
            let less = next.filter(|next| square(&equations.misses(next, &rows)) < size * size);
            if let Some(next) = less {
                here = next;
                damping = (LESS * damping).max(LEAST);
                break;
            }
            damping *= MORE;
            if damping > MOST {
                // Nothing but rounding is left to gain.
                return Some((here, rows));
            }
        }
    }
    None
}

fn slope(rows: &impl Rows) -> Vec<f64> {
    let (matrix, missed) = (rows.matrix(), rows.missed());
    let width = matrix.first().map_or(0, Vec::len);
    let along = |k: usize| matrix.iter().zip(missed).map(|(row, x)| row[k] * x).sum();
    (0..width).map(along).collect()
}

/// Returns the damped step, for all that can change.
fn step(rows: &impl Rows, slope: &[f64], damping: f64) -> Option<Vec<f64>> {
    let product = |i: usize, j: usize| rows.matrix().iter().map(|row| row[i] * row[j]).sum();
    let mut matrix: Vec<Vec<f64>> = (0..slope.len())
        .map(|i| (0..=i).map(|j| product(i, j)).collect())
        .collect();
    let most = (0..slope.len()).fold(0.0, |most: f64, i| most.max(matrix[i][i]));
    (0..slope.len()).for_each(|i| matrix[i][i] += damping * most);
    cholesky::solve(&matrix, slope)
}

fn largest(all: &[f64]) -> f64 {
    all.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

fn square(all: &[f64]) -> f64 {
    all.iter().map(|x| x * x).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    /// A joint in the plane on two links, from the origin and from `(distance, 0)`.
    struct Links {
        distance: f64,
        lengths: [f64; 2],
    }

    struct LinkRows {
        missed: Vec<f64>,
        matrix: Vec<Vec<f64>>,
    }

    impl Rows for LinkRows {
        fn missed(&self) -> &[f64] {
            &self.missed
        }

        fn matrix(&self) -> &[Vec<f64>] {
            &self.matrix
        }
    }

    impl Equations<[f64; 2]> for Links {
        type Rows = LinkRows;

        fn rows(&mut self, at: &[f64; 2]) -> Option<LinkRows> {
            let mut found = LinkRows {
                missed: Vec::new(),
                matrix: Vec::new(),
            };
            for (base, length) in [0.0, self.distance].into_iter().zip(self.lengths) {
                let (x, y) = (at[0] - base, at[1]);
                let size = x.hypot(y);
                found.missed.push(size - length);
                found.matrix.push(vec![x / size, y / size]);
            }
            let mut missed = found.missed.iter();
            missed.all(|x| x.is_finite()).then_some(found)
        }

        fn misses(&mut self, at: &[f64; 2], _: &LinkRows) -> Vec<f64> {
            self.rows(at).map_or_else(Vec::new, |found| found.missed)
        }

        fn after(&mut self, at: &[f64; 2], _: &LinkRows, changes: &[f64]) -> [f64; 2] {
            [at[0] + changes[0], at[1] + changes[1]]
        }
    }

    #[test]
    fn links_that_are_too_short_share_what_they_miss_by() {
        let mut links = Links {
            distance: 2.1,
            lengths: [1.2, 0.6],
        };
        let (at, rows) = minimise(&mut links, [0.9, 0.8]).expect("it is found");
        // 0.3 in all, the same of each link.
        for missed in &rows.missed {
            assert!((missed - 0.15).abs() < 1e-9, "{missed}");
        }
        assert!((at[0] - 1.35).abs() < 1e-9 && at[1].abs() < 1e-4, "{at:?}");
    }

    #[test]
    fn links_that_reach_each_other_miss_by_nothing() {
        let mut links = Links {
            distance: 1.4,
            lengths: [1.3, 1.5],
        };
        let (at, rows) = minimise(&mut links, [2.5, -0.2]).expect("it is found");
        assert!(square(&rows.missed) <= CLOSED * CLOSED);
        // x^2 + y^2 = 1.69 and (x - 1.4)^2 + y^2 = 2.25; on the side on which it began.
        assert!((at[0] - 0.5).abs() < 1e-8 && (at[1] + 1.2).abs() < 1e-8);
    }

    #[test]
    fn what_has_no_value_is_not_found() {
        let mut links = Links {
            distance: f64::NAN,
            lengths: [1.0; 2],
        };
        assert!(minimise(&mut links, [0.5, 0.5]).is_none());
    }
}
