//! All loops on numbers, closed together: equations may be more than unknowns.

use linkage_core::numeric::cholesky;
use linkage_core::numeric::vector::dot;
use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId, substitute};

use crate::algebra::Nominal;
use crate::structure::equations::{Coordinate, CoordinateKind};

/// Loops that miss by no more than this share of their links close: rounding is thousand times
/// less.
const CLOSED: f64 = 1e-12;

/// Differences for slopes: the error of a central difference is about this squared, its rounding
/// the last place divided by it.
const STEP: f64 = 1e-5;

/// Newton's method from an estimate 60 degrees away takes about ten steps of at most half a radian
/// each.
const STEPS: usize = 40;

const LONGEST_STEP: f64 = 0.5;

/// A step that changes nothing but rounding, in radians or shares of a length.
const SETTLED: f64 = 1e-11;

/// Keeps a matrix regular where unknowns are not determined at all; too small to slow anything
/// down.
const DAMPING: f64 = 1e-14;

/// A column of which less than this share points across those before it is a combination of them:
/// far above the error of differences, and the limit of a dead point.
pub(crate) const ACROSS: f64 = 1e-6;

/// Loops on numbers.
pub(crate) struct SimultaneousLoops<'a, 'm> {
    pub(crate) rows: Vec<Ex<'m>>,
    pub(crate) coordinates: &'a [Coordinate],
    pub(crate) symbols: Vec<Vec<SymbolId>>,
    /// The values at which the search begins.
    pub(crate) estimates: Vec<f64>,
    /// The size that counts like a radian, for each coordinate.
    pub(crate) scales: Vec<f64>,
}

impl<'m> SimultaneousLoops<'_, 'm> {
    /// Returns the error of every row.
    fn missing(&self, x: &[f64], at: &Nominal) -> Vec<f64> {
        at.evaluate(&self.substituted(&self.rows, x))
    }

    /// Returns rows with these coordinates.
    pub(crate) fn substituted(&self, rows: &[Ex<'m>], x: &[f64]) -> Vec<Ex<'m>> {
        let graph = self.rows[0].graph();
        let mut values = Map::new();
        for ((coordinate, symbols), &x) in self.coordinates.iter().zip(&self.symbols).zip(x) {
            let numbers = match coordinate.kind {
                CoordinateKind::Angle(_) => vec![x.cos(), x.sin(), x],
                CoordinateKind::Length(_) => vec![x],
            };
            let numbers = numbers.into_iter().map(|number| graph.number(number));
            values.extend(symbols.iter().copied().zip(numbers));
        }
        substitute(rows, &values)
    }

    /// Returns the change of the rows with each coordinate, measured by its scale.
    pub(crate) fn slopes(&self, x: &[f64], at: &Nominal) -> Vec<Vec<f64>> {
        let slopes = (0..x.len()).map(|k| {
            let side = |sign: f64| {
                let mut x = x.to_vec();
                x[k] += sign * STEP * self.scales[k];
                self.missing(&x, at)
            };
            let (above, below) = (side(1.0), side(-1.0));
            let pairs = above.iter().zip(&below);
            pairs.map(|(a, b)| (a - b) / (2.0 * STEP)).collect()
        });
        slopes.collect()
    }

    /// Returns the coordinates at which the loops miss least, and by how much they do.
    pub(crate) fn nearest(&self, mut x: Vec<f64>, at: &Nominal) -> Option<(Vec<f64>, f64)> {
        for _ in 0..STEPS {
            let missing = self.missing(&x, at);
            let miss = dot(&missing, &missing).sqrt();
            if !miss.is_finite() {
                return None;
            }
            let step = match x.is_empty() {
                true => Vec::new(),
                false => least_squares(&self.slopes(&x, at), &missing)?,
            };
            let size = largest(&step);
            if size <= SETTLED {
                return Some((x, miss));
            }
            let shorter = (LONGEST_STEP / size).min(1.0);
            for ((x, step), scale) in x.iter_mut().zip(step).zip(&self.scales) {
                *x -= shorter * step * scale;
            }
        }
        None
    }

    /// Newton's method in the sense of least squares: more equations than coordinates.
    pub(crate) fn closed(&self, mut x: Vec<f64>, at: &Nominal) -> Option<Vec<f64>> {
        for _ in 0..STEPS {
            let missing = self.missing(&x, at);
            let slopes = self.slopes(&x, at);
            let size = largest(slopes.iter().flatten());
            let miss = largest(&missing);
            if !(size > 0.0 && size.is_finite() && miss.is_finite()) {
                return None;
            }
            if miss <= CLOSED * size {
                return Some(x);
            }
            let step = least_squares(&slopes, &missing)?;
            let shorter = (LONGEST_STEP / largest(&step)).min(1.0);
            for ((x, step), scale) in x.iter_mut().zip(step).zip(&self.scales) {
                *x -= shorter * step * scale;
            }
        }
        None
    }
}

/// Returns the largest size of some numbers; NaN if one of them is.
pub(crate) fn largest<'x>(numbers: impl IntoIterator<Item = &'x f64>) -> f64 {
    let numbers = numbers.into_iter().map(|x| x.abs());
    numbers.fold(0.0, |a, x| if x > a || x.is_nan() { x } else { a })
}

/// The numbers with which `columns` come nearest to `right`, by the normal equations.
fn least_squares(columns: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let trace: f64 = columns.iter().map(|column| dot(column, column)).sum();
    let lower = columns.iter().enumerate().map(|(i, column)| {
        let mut row: Vec<f64> = columns[..=i]
            .iter()
            .map(|other| dot(column, other))
            .collect();
        row[i] += DAMPING * trace;
        row
    });
    let right: Vec<f64> = columns.iter().map(|column| dot(column, right)).collect();
    cholesky::solve(&lower.collect::<Vec<_>>(), &right)
}
