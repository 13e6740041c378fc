//! Linear systems that are too large for cofactors: elimination in an order of pivots that is chosen once, from numbers at the reference.
//!
//! No pivot is looked for where the system is solved, so there is no branch. What was a good pivot at the reference may vanish elsewhere
//! although the matrix is regular: then it is NaN, and so is the solution. The last unknowns are solved by cofactors, which need no pivot.

#[cfg(test)]
pub(super) mod tests;

use crate::algebra::elimination;
use linkage_symbolic::Ex;

use super::Algebra;

/// So many unknowns are left to cofactors: their determinant takes as many products as elimination, and no division but one.
const REST: usize = 3;

/// Systems of no more unknowns have no pivot that could vanish: those of one body on rods whose travel is given. Beyond, minors are too many.
const WHOLE: usize = 5;

/// A pivot may be this part of the largest entry that could be one, if that keeps more zeros: multipliers stay small.
const THRESHOLD: f64 = 0.25;

/// A pivot that falls below this part of what it is at the reference, or changes its sign, is NaN: some three digits of the solution are lost
/// there.
const LEAST: f64 = 1.0 / 1024.0;

/// An order of pivots.
#[derive(Clone, Debug)]
pub(crate) struct Order {
    pivots: Vec<Pivot>,
    /// What cofactors solve.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// The sign of the permutations of rows and columns together.
    sign: f64,
}

/// An entry by which a row is eliminated.
#[derive(Clone, Copy, Debug)]
struct Pivot {
    row: usize,
    column: usize,
    /// The least value, with the sign.
    least: f64,
}

/// The solution of a linear system.
pub(crate) struct InOrder<'m> {
    pub(crate) solution: Vec<Ex<'m>>,
    pub(crate) determinant: Ex<'m>,
}

impl Order {
    /// The order for a matrix with these values at the reference; what vanishes everywhere is `zero`. Rows may be of any size.
    pub(crate) fn new(values: &[Vec<f64>], zero: &[Vec<bool>]) -> Self {
        let size = values.len();
        let largest = |row: &[f64]| row.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let scaled = |row: &Vec<f64>| {
            let most = largest(row);
            row.iter().map(|x| x / most).collect()
        };
        let mut left = Left {
            values: values.iter().map(scaled).collect(),
            zero: zero.to_vec(),
            rows: (0..size).collect(),
            columns: (0..size).collect(),
        };
        let mut pivots = Vec::new();
        let rest = if size <= WHOLE { size } else { REST };
        while left.rows.len() > rest {
            let (row, column) = left.best();
            pivots.push(Pivot {
                row,
                column,
                least: LEAST * left.values[row][column] * largest(&values[row]),
            });
            left.eliminate(row, column);
        }
        let rows = pivots
            .iter()
            .map(|pivot| pivot.row)
            .chain(left.rows.clone());
        let columns = pivots.iter().map(|pivot| pivot.column);
        let columns = columns.chain(left.columns.clone());
        let sign = parity(&rows.collect::<Vec<_>>()) * parity(&columns.collect::<Vec<_>>());
        Self {
            pivots,
            rows: left.rows,
            columns: left.columns,
            sign,
        }
    }

    /// The order for the transposed matrix.
    pub(crate) fn transposed(&self) -> Self {
        let pivots = self.pivots.iter().map(|pivot| Pivot {
            row: pivot.column,
            column: pivot.row,
            ..*pivot
        });
        Self {
            pivots: pivots.collect(),
            rows: self.columns.clone(),
            columns: self.rows.clone(),
            sign: self.sign,
        }
    }
}

/// What is left of a matrix of numbers.
struct Left {
    values: Vec<Vec<f64>>,
    zero: Vec<Vec<bool>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
}

impl Left {
    /// The entry that keeps most zeros among those that are large enough; of those the largest.
    fn best(&self) -> (usize, usize) {
        let size = |row: usize, column: usize| match self.zero[row][column] {
            true => 0.0,
            false => self.values[row][column].abs(),
        };
        let all = || {
            let rows = self.rows.iter();
            rows.flat_map(|&row| self.columns.iter().map(move |&column| (row, column)))
        };
        let largest_in_row = |row: usize| {
            let sizes = self.columns.iter().map(|&column| size(row, column));
            sizes.fold(0.0, f64::max)
        };
        let largest_in_column = |column: usize| {
            let sizes = self.rows.iter().map(|&row| size(row, column));
            sizes.fold(0.0, f64::max)
        };
        let large = |&(row, column): &(usize, usize)| {
            let largest = largest_in_row(row).max(largest_in_column(column));
            size(row, column) > 0.0 && size(row, column) >= THRESHOLD * largest
        };
        let filled = |(row, column): (usize, usize)| {
            let in_row = self.columns.iter().filter(|&&k| !self.zero[row][k]);
            let in_column = self.rows.iter().filter(|&&k| !self.zero[k][column]);
            (in_row.count() - 1) * (in_column.count() - 1)
        };
        let order = |a: &(usize, usize), b: &(usize, usize)| {
            let by_size = size(b.0, b.1).total_cmp(&size(a.0, a.1));
            filled(*a).cmp(&filled(*b)).then(by_size)
        };
        // Where all is 0 the reference is singular, and that is said of it.
        let best = all().filter(large).min_by(order);
        best.unwrap_or((self.rows[0], self.columns[0]))
    }

    fn eliminate(&mut self, row: usize, column: usize) {
        self.rows.retain(|&own| own != row);
        self.columns.retain(|&own| own != column);
        let pivot = self.values[row][column];
        for &i in &self.rows {
            if self.zero[i][column] {
                continue;
            }
            let factor = self.values[i][column] / pivot;
            for &j in &self.columns {
                if !self.zero[row][j] {
                    self.values[i][j] -= factor * self.values[row][j];
                    self.zero[i][j] = false;
                }
            }
        }
    }
}

/// 1 for an even permutation, -1 for an odd one.
pub(super) fn parity(permutation: &[usize]) -> f64 {
    let pairs = permutation.iter().enumerate();
    let inversions = pairs.flat_map(|(k, a)| permutation[..k].iter().filter(move |&b| b > a));
    if inversions.count() % 2 == 0 {
        1.0
    } else {
        -1.0
    }
}

/// The solution of a linear system times its determinant, and that.
type Numerators<'m> = (Vec<Ex<'m>>, Ex<'m>);

/// Solves a linear system in an order, for one of several right-hand sides: they share the cofactors.
pub(crate) fn solve_in_order<'m>(
    algebra: &Algebra<'m>,
    order: &Order,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> InOrder<'m> {
    eliminate_in_order(algebra, order, matrix, right, |rest, known| {
        let determinant = elimination::determinant(algebra, rest);
        (
            elimination::cofactor_products(algebra, rest, known),
            determinant,
        )
    })
}

/// The same for a right-hand side that is the only one. Of the three unknowns that are left behind pivots all minors are few.
pub(crate) fn solve_once_in_order<'m>(
    algebra: &Algebra<'m>,
    order: &Order,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> InOrder<'m> {
    match order.pivots.is_empty() {
        true => eliminate_in_order(algebra, order, matrix, right, |rest, own| {
            elimination::cramer(algebra, rest, own)
        }),
        false => solve_in_order(algebra, order, matrix, right),
    }
}

fn eliminate_in_order<'m>(
    algebra: &Algebra<'m>,
    order: &Order,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
    solve: impl Fn(&[Vec<Ex<'m>>], &[Ex<'m>]) -> Numerators<'m>,
) -> InOrder<'m> {
    let mut matrix = matrix.to_vec();
    let mut right = right.to_vec();
    let mut determinant = algebra.graph.number(order.sign);
    let mut open: Vec<usize> = (0..right.len()).collect();
    let mut inverses = Vec::new();
    for &Pivot { row, column, least } in &order.pivots {
        open.retain(|&own| own != row);
        let pivot = guarded(matrix[row][column], least);
        determinant = determinant * pivot;
        let inverse = algebra.one() / pivot;
        inverses.push(inverse);
        let (own, known) = (matrix[row].clone(), right[row]);
        for &i in &open {
            let factor = matrix[i][column] * inverse;
            if factor.is_zero() {
                continue;
            }
            for (entry, &above) in matrix[i].iter_mut().zip(&own) {
                *entry -= factor * above;
            }
            matrix[i][column] = algebra.zero();
            right[i] -= factor * known;
        }
    }
    let rest: Vec<Vec<Ex>> = order
        .rows
        .iter()
        .map(|&row| order.columns.iter().map(|&k| matrix[row][k]).collect())
        .collect();
    let known: Vec<Ex> = order.rows.iter().map(|&row| right[row]).collect();
    let (numerators, of_rest) = solve(&rest, &known);
    let mut solution = vec![algebra.zero(); right.len()];
    for (&column, own) in order.columns.iter().zip(numerators) {
        solution[column] = own / of_rest;
    }
    for (pivot, &inverse) in order.pivots.iter().zip(&inverses).rev() {
        let row = pivot.row;
        // Columns of earlier pivots are not solved yet, and 0 in this row.
        let known = elimination::product_sum(algebra, &matrix[row], &solution);
        solution[pivot.column] = (right[row] - known) * inverse;
    }
    InOrder {
        solution,
        determinant: determinant * of_rest,
    }
}

/// A pivot, NaN where it is less than it may be.
fn guarded(pivot: Ex<'_>, least: f64) -> Ex<'_> {
    let enough = match least < 0.0 {
        true => pivot.number(least) - pivot,
        false => pivot - least,
    };
    enough.select(pivot, pivot.number(f64::NAN))
}
