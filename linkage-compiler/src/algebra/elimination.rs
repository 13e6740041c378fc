//! The linear systems of coupled groups: private unknowns are eliminated, the core is solved by cofactors.
//!
//! In a loop with a private unknown, whose column is `c`, a multiplier `m` across `c` gives one equation without it: `m . column`
//! for every other unknown. What remains is a small square matrix, the same for every right-hand side. Cofactors need no choice
//! of pivots, which would be a branch, and no division but the last. They grow with the factorial of the size: larger matrices are
//! eliminated in an order that is known before (`pivots`).

use crate::algebra::bodies;
use crate::algebra::rows;
use crate::algebra::turns;
use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Ex, Graph, SymbolId};

use super::turns::Turns;
use super::{Algebra, Scheme};

/// How a group's Jacobian is brought down to its core.
#[derive(Clone, Debug)]
pub(crate) struct Elimination<'m> {
    /// One for each equation of the core.
    pub(crate) rows: Vec<CoreRow<'m>>,
    /// Scaled, by row and unknown.
    pub(crate) matrix: Vec<Vec<Ex<'m>>>,
    /// An unknown is its scaled value times this: 1 for an angle, a length for a slide.
    pub(crate) units: Vec<Ex<'m>>,
    /// In the order of the columns after those of the core.
    pub(crate) privates: Vec<PrivateColumn<'m>>,
    /// How the matrix is solved if it is too large for cofactors.
    pub(crate) scheme: Option<Scheme<'m>>,
}

/// An equation of the core: a combination of the rows of one loop.
#[derive(Clone, Debug)]
pub(crate) struct CoreRow<'m> {
    /// The loop's first row.
    pub(crate) first: usize,
    /// One factor for each of its rows, or for one of them.
    pub(crate) factors: Vec<Ex<'m>>,
}

/// The column of a private unknown: two rows.
#[derive(Clone, Debug)]
pub(crate) struct PrivateColumn<'m> {
    pub(crate) first: usize,
    /// The square of its length.
    pub(crate) square: Ex<'m>,
}

/// The unknowns of `J r = right`, the core first: derivatives by some variables.
pub(super) fn eliminate<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    right: &[Ex<'m>],
    by: &[SymbolId],
    name: &mut dyn FnMut(&mut Algebra<'m>, usize, Ex<'m>) -> Ex<'m>,
) -> Vec<Ex<'m>> {
    let solution = algebra.solutions.groups[group].clone();
    let Some(elimination) = &solution.elimination else {
        unreachable!("closed forms are solved by Cramer's rule");
    };
    let of_core = |algebra: &Algebra<'m>, right: &[Ex<'m>]| -> Vec<Ex<'m>> {
        let rows = elimination.rows.iter();
        rows.map(|row| product_sum(algebra, &row.factors, &right[row.first..]))
            .collect()
    };
    let core = of_core(algebra, right);
    let quotients = match &elimination.scheme {
        Some(scheme) if by.len() > 1 && elimination.privates.is_empty() => {
            let turns = turns::turns_by_both(algebra, group, by);
            let bodies = &scheme.bodies;
            let shifts = match &turns {
                Some(turns) => turns::shifts_by_turns(algebra, bodies, group, turns),
                None => bodies.shifts(&core),
            };
            // What that leaves in the other equations is a derivative like others: by the entries of the matrix it takes more.
            let nothing = vec![algebra.zero(); scheme.freedoms.len()];
            let held = bodies.unknowns(&nothing, &shifts);
            let pairs = elimination.units.iter().zip(&held);
            let held = pairs.map(|(&unit, &shift)| unit * shift).collect();
            let left = rows::right_of_rows(algebra, group, by, held, turns.as_ref());
            let left = of_core(algebra, &left);
            let solved = bodies::solve_left_by_scheme(algebra, scheme, &shifts, &left);
            if let Some(Turns { by, .. }) = turns {
                let second = &mut algebra.derivatives.second_turns;
                second.insert((group, by), solved.turns);
            }
            solved.solution
        }
        Some(scheme) => {
            let solved = bodies::solve_by_scheme(algebra, scheme, &elimination.matrix, &core);
            if let (&[variable], Some(turns)) = (by, solved.turns) {
                algebra.derivatives.turns.insert((group, variable), turns);
            }
            solved.solution
        }
        None => solve_core(algebra, &elimination.matrix, &core, solution.determinant),
    };
    let mut rates = Vec::new();
    for (position, quotient) in quotients.into_iter().enumerate() {
        let rate = elimination.units[position] * quotient;
        rates.push(name(algebra, position, rate));
    }
    let count = rates.len();
    for (k, private) in elimination.privates.iter().enumerate() {
        let rows = [private.first, private.first + 1];
        let left = rows.map(|row| {
            let columns = solution.jacobian[..count].iter().zip(&rates);
            columns.fold(right[row], |sum, (column, &rate)| sum - column[row] * rate)
        });
        let own = rows.map(|row| solution.jacobian[count + k][row]);
        let rate = product_sum(algebra, &own, &left) / private.square;
        rates.push(name(algebra, count + k, rate));
    }
    rates
}

/// The multipliers of `J^T l = weights`.
pub(super) fn eliminate_transposed<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    weights: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let solution = algebra.solutions.groups[group].clone();
    let Some(elimination) = &solution.elimination else {
        unreachable!("closed forms are solved by Cramer's rule");
    };
    let count = elimination.units.len();
    let zero = algebra.zero();
    let mut multipliers = vec![zero; solution.jacobian[0].len()];
    for (k, private) in elimination.privates.iter().enumerate() {
        let factor = weights[count + k] / private.square;
        for row in [private.first, private.first + 1] {
            multipliers[row] = factor * solution.jacobian[count + k][row];
        }
    }
    let core: Vec<Ex> = (0..count)
        .map(|position| {
            let known = product_sum(algebra, &multipliers, &solution.jacobian[position]);
            elimination.units[position] * (weights[position] - known)
        })
        .collect();
    let factors: Vec<Ex> = match &elimination.scheme {
        Some(scheme) => {
            bodies::solve_transposed_by_scheme(algebra, scheme, &elimination.matrix, &core)
        }
        None => {
            let transposed: Vec<Vec<Ex>> = (0..count)
                .map(|column| elimination.matrix.iter().map(|row| row[column]).collect())
                .collect();
            let numerators = cofactor_products(algebra, &transposed, &core).into_iter();
            numerators.map(|own| own / solution.determinant).collect()
        }
    };
    for (row, factor) in elimination.rows.iter().zip(factors) {
        for (k, &own) in row.factors.iter().enumerate() {
            multipliers[row.first + k] += factor * own;
        }
    }
    multipliers
}

/// The sum of products, of any number.
pub(crate) fn product_sum<'m>(algebra: &Algebra<'m>, a: &[Ex<'m>], b: &[Ex<'m>]) -> Ex<'m> {
    let pairs = a.iter().zip(b);
    pairs.fold(algebra.zero(), |sum, (&x, &y)| sum + x * y)
}

/// The solution of a linear system. What is divided by the determinant is the right-hand side where that is mostly 0.
fn solve_core<'m>(
    algebra: &mut Algebra<'m>,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
    determinant: Ex<'m>,
) -> Vec<Ex<'m>> {
    let entries = right.iter().filter(|x| !x.is_zero()).count();
    if entries < right.len() {
        let right: Vec<Ex> = right.iter().map(|&x| x / determinant).collect();
        return cofactor_products(algebra, matrix, &right);
    }
    let numerators = cofactor_products(algebra, matrix, right).into_iter();
    numerators
        .map(|numerator| numerator / determinant)
        .collect()
}

/// The adjugate of a matrix times a vector: the solution of the linear system times the determinant.
pub(crate) fn cofactor_products<'m>(
    algebra: &Algebra<'m>,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let size = matrix.len();
    let all = (1_u32 << size) - 1;
    let mut minors = Minors::of(algebra.graph, matrix);
    let zero = algebra.zero();
    (0..size)
        .map(|column| {
            (0..size).fold(zero, |sum, row| {
                let minor = minors.minor(all & !(1 << row), all & !(1 << column));
                let product = minor * right[row];
                match (row + column) % 2 {
                    0 => sum + product,
                    _ => sum - product,
                }
            })
        })
        .collect()
}

/// Cramer's rule for one right-hand side: what the solution is times the determinant, and that. The right-hand side is a further column, so that
/// fewer minors are needed than for several.
pub(crate) fn cramer<'m>(
    algebra: &Algebra<'m>,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> (Vec<Ex<'m>>, Ex<'m>) {
    let size = matrix.len();
    if size < 3 {
        // There is nothing to save.
        let numerators = cofactor_products(algebra, matrix, right);
        return (numerators, determinant(algebra, matrix));
    }
    let pairs = matrix.iter().zip(right);
    let wide: Vec<Vec<Ex>> = pairs
        .map(|(row, &own)| [&row[..], &[own]].concat())
        .collect();
    let mut minors = Minors::of(algebra.graph, &wide);
    let (rows, all) = ((1_u32 << size) - 1, (1_u32 << (size + 1)) - 1);
    let numerators = (0..size).map(|column| {
        // The last column instead of this one: behind those that it passes.
        let minor = minors.minor(rows, all & !(1 << column));
        match (size - 1 - column) % 2 {
            0 => minor,
            _ => -minor,
        }
    });
    let numerators = numerators.collect();
    (numerators, minors.minor(rows, rows))
}

pub(crate) fn determinant<'m>(algebra: &Algebra<'m>, matrix: &[Vec<Ex<'m>>]) -> Ex<'m> {
    let all = (1_u32 << matrix.len()) - 1;
    Minors::of(algebra.graph, matrix).minor(all, all)
}

/// The minors of a matrix that are known already.
struct Minors<'a, 'm> {
    graph: &'m Graph,
    matrix: &'a [Vec<Ex<'m>>],
    /// By the sets of rows and of columns, as bits.
    known: Map<(u32, u32), Ex<'m>>,
}

impl<'a, 'm> Minors<'a, 'm> {
    fn of(graph: &'m Graph, matrix: &'a [Vec<Ex<'m>>]) -> Self {
        Self {
            graph,
            matrix,
            known: Map::new(),
        }
    }

    /// The determinant of the rows and columns in two sets, by its first row.
    fn minor(&mut self, rows: u32, columns: u32) -> Ex<'m> {
        if rows == 0 {
            return self.graph.number(1.0);
        }
        if let Some(&minor) = self.known.get(&(rows, columns)) {
            return minor;
        }
        let row = rows.trailing_zeros() as usize;
        let mut sum = self.graph.number(0.0);
        let among = (0..self.matrix[row].len()).filter(|&column| columns >> column & 1 == 1);
        for (place, column) in among.enumerate() {
            let below = self.minor(rows & !(1 << row), columns & !(1 << column));
            let product = self.matrix[row][column] * below;
            sum = match place % 2 {
                0 => sum + product,
                _ => sum - product,
            };
        }
        self.known.insert((rows, columns), sum);
        sum
    }
}
