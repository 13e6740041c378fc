//! The linear systems of coupled groups: private unknowns are eliminated, the core is solved by cofactors.
//!
//! In a loop with a private unknown, whose column is `c`, a multiplier `m` across `c` gives one equation without it: `m . column`
//! for every other unknown. What remains is a small square matrix, the same for every right-hand side. Cofactors need no choice
//! of pivots, which would be a branch, and no division but the last.

use std::collections::HashMap;

use linkage_symbolic::NodeId;

use super::Algebra;

/// How a group's Jacobian is brought down to its core.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// One for each equation of the core.
    pub(crate) rows: Vec<CoreRow>,
    /// Scaled, by row and unknown.
    pub(crate) matrix: Vec<Vec<NodeId>>,
    /// An unknown is its scaled value times this: 1 for an angle, a length for a slide.
    pub(crate) units: Vec<NodeId>,
    /// In the order of the columns after those of the core.
    pub(crate) privates: Vec<PrivateColumn>,
}

/// An equation of the core: a combination of the rows of one loop.
#[derive(Clone, Debug)]
pub(crate) struct CoreRow {
    /// The loop's first row.
    pub(crate) first: usize,
    /// One factor for each of its rows, or for one of them.
    pub(crate) factors: Vec<NodeId>,
}

/// The column of a private unknown: two rows.
#[derive(Clone, Debug)]
pub(crate) struct PrivateColumn {
    pub(crate) first: usize,
    /// The square of its length.
    pub(crate) square: NodeId,
}

impl Algebra<'_> {
    /// The unknowns of `J r = right`, the core first. `determinant` is that of the matrix.
    pub(super) fn eliminate(
        &mut self,
        group: usize,
        right: &[NodeId],
        name: &mut dyn FnMut(&mut Self, usize, NodeId) -> NodeId,
    ) -> Vec<NodeId> {
        let solution = self.solutions[group].clone();
        let Some(elimination) = &solution.elimination else {
            unreachable!("closed forms are solved by Cramer's rule");
        };
        let core: Vec<NodeId> = elimination
            .rows
            .iter()
            .map(|row| self.dot(&row.factors, &right[row.first..]))
            .collect();
        let quotients = self.solve_core(&elimination.matrix, &core, solution.determinant);
        let mut rates = Vec::new();
        for (position, quotient) in quotients.into_iter().enumerate() {
            let rate = self.graph.mul(elimination.units[position], quotient);
            rates.push(name(self, position, rate));
        }
        let count = rates.len();
        for (k, private) in elimination.privates.iter().enumerate() {
            let rows = [private.first, private.first + 1];
            let left = rows.map(|row| {
                let columns = solution.jacobian[..count].iter().zip(&rates);
                columns.fold(right[row], |sum, (column, &rate)| {
                    let product = self.graph.mul(column[row], rate);
                    self.graph.sub(sum, product)
                })
            });
            let own = rows.map(|row| solution.jacobian[count + k][row]);
            let along = self.dot(&own, &left);
            let rate = self.graph.div(along, private.square);
            rates.push(name(self, count + k, rate));
        }
        rates
    }

    /// The multipliers of `J^T l = weights`.
    pub(super) fn eliminate_transposed(&mut self, group: usize, weights: &[NodeId]) -> Vec<NodeId> {
        let solution = self.solutions[group].clone();
        let Some(elimination) = &solution.elimination else {
            unreachable!("closed forms are solved by Cramer's rule");
        };
        let count = elimination.units.len();
        let zero = self.graph.zero();
        let mut multipliers = vec![zero; solution.jacobian[0].len()];
        for (k, private) in elimination.privates.iter().enumerate() {
            let factor = self.graph.div(weights[count + k], private.square);
            for row in [private.first, private.first + 1] {
                let own = solution.jacobian[count + k][row];
                multipliers[row] = self.graph.mul(factor, own);
            }
        }
        let core: Vec<NodeId> = (0..count)
            .map(|position| {
                let known = self.dot(&multipliers, &solution.jacobian[position]);
                let rest = self.graph.sub(weights[position], known);
                self.graph.mul(elimination.units[position], rest)
            })
            .collect();
        let transposed: Vec<Vec<NodeId>> = (0..count)
            .map(|column| elimination.matrix.iter().map(|row| row[column]).collect())
            .collect();
        let numerators = self.cofactor_products(&transposed, &core);
        for (row, numerator) in elimination.rows.iter().zip(numerators) {
            let factor = self.graph.div(numerator, solution.determinant);
            for (k, &own) in row.factors.iter().enumerate() {
                let product = self.graph.mul(factor, own);
                let multiplier = multipliers[row.first + k];
                multipliers[row.first + k] = self.graph.add(multiplier, product);
            }
        }
        multipliers
    }

    /// The solution of a linear system. What is divided by the determinant is the right-hand side where that is mostly 0.
    fn solve_core(
        &mut self,
        matrix: &[Vec<NodeId>],
        right: &[NodeId],
        determinant: NodeId,
    ) -> Vec<NodeId> {
        let entries = right.iter().filter(|&&x| !self.graph.is_zero(x)).count();
        if entries < right.len() {
            let right: Vec<NodeId> = right
                .iter()
                .map(|&x| self.graph.div(x, determinant))
                .collect();
            return self.cofactor_products(matrix, &right);
        }
        let numerators = self.cofactor_products(matrix, right).into_iter();
        numerators
            .map(|numerator| self.graph.div(numerator, determinant))
            .collect()
    }

    /// The adjugate of a matrix times a vector: the solution of the linear system times the determinant.
    pub(crate) fn cofactor_products(
        &mut self,
        matrix: &[Vec<NodeId>],
        right: &[NodeId],
    ) -> Vec<NodeId> {
        let size = matrix.len();
        let all = (1_u32 << size) - 1;
        let mut minors = HashMap::new();
        let zero = self.graph.zero();
        (0..size)
            .map(|column| {
                (0..size).fold(zero, |sum, row| {
                    let minor =
                        self.minor(matrix, all & !(1 << row), all & !(1 << column), &mut minors);
                    let product = self.graph.mul(minor, right[row]);
                    match (row + column) % 2 {
                        0 => self.graph.add(sum, product),
                        _ => self.graph.sub(sum, product),
                    }
                })
            })
            .collect()
    }

    pub(crate) fn determinant(&mut self, matrix: &[Vec<NodeId>]) -> NodeId {
        let all = (1_u32 << matrix.len()) - 1;
        self.minor(matrix, all, all, &mut HashMap::new())
    }

    /// The determinant of the rows and columns in two sets, by its first row.
    fn minor(
        &mut self,
        matrix: &[Vec<NodeId>],
        rows: u32,
        columns: u32,
        known: &mut HashMap<(u32, u32), NodeId>,
    ) -> NodeId {
        if rows == 0 {
            return self.graph.one();
        }
        if let Some(&minor) = known.get(&(rows, columns)) {
            return minor;
        }
        let row = rows.trailing_zeros() as usize;
        let mut sum = self.graph.zero();
        let among = (0..matrix.len()).filter(|&column| columns >> column & 1 == 1);
        for (place, column) in among.enumerate() {
            let below = self.minor(matrix, rows & !(1 << row), columns & !(1 << column), known);
            let product = self.graph.mul(matrix[row][column], below);
            sum = match place % 2 {
                0 => self.graph.add(sum, product),
                _ => self.graph.sub(sum, product),
            };
        }
        known.insert((rows, columns), sum);
        sum
    }
}
