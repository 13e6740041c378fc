//! What differentiation needs of a coupled group: private unknowns, terms, columns and how they are eliminated.

use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Elimination, PrivateColumn, Solution, Term};
use crate::formulate::Solver;
use crate::formulate::vector::Vector;
use crate::structure::{Block, Core, Coupled, Private};

use super::equations::Equations;

impl Solver<'_, '_> {
    /// Defines the private unknowns and records what differentiation needs.
    pub(super) fn push_coupled(
        &mut self,
        form: &Coupled,
        variables: &[SymbolId],
        equations: &Equations,
        determinant: NodeId,
    ) {
        let rows: usize = form.blocks.iter().map(|block| block.rows.len()).sum();
        let zero = self.algebra.graph.zero();
        let mut jacobian = vec![vec![zero; rows]; variables.len()];
        let mut privates = Vec::new();
        let mut terms = Vec::new();
        let mut first = 0;
        for block in &form.blocks {
            let position = jacobian.len();
            if let Some(private) = &block.private {
                let own = self.define_private(private, [block.rest[0], block.rest[1]], position);
                let square = match private {
                    Private::Rotor(rotor) => self.square(rotor.z),
                    Private::Slide { guide, .. } => self.square_of_guide(*guide),
                };
                let mut column = vec![zero; rows];
                column[first..first + 2].copy_from_slice(&own);
                jacobian.push(column);
                privates.push(PrivateColumn { first, square });
            }
            for (position, &variable) in variables.iter().enumerate() {
                for (row, &node) in block.rows.iter().enumerate() {
                    jacobian[position][first + row] = self.algebra.partial(node, variable);
                }
            }
            terms.extend(self.block_terms(block, first, rows));
            first += block.rows.len();
        }
        let one = self.algebra.graph.one();
        let units = form.core.iter().map(|core| match core {
            Core::Angle(_) => one,
            Core::Length { .. } => equations.unit,
        });
        let elimination = Elimination {
            rows: equations.rows.clone(),
            matrix: equations.matrix.clone(),
            units: units.collect(),
            privates,
        };
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: Some(elimination),
        });
    }

    /// Defines a private unknown; returns its column.
    fn define_private(&mut self, private: &Private, rest: Vector, position: usize) -> Vector {
        match private {
            Private::Rotor(rotor) => {
                let unit = self.unit_of(rotor);
                let value = self.negative(rest);
                let vector = self.turning(value, rotor.z, unit, position);
                let quotient = self.complex_quotient(vector, rotor.z);
                self.define_angle(rotor.angle, rotor.sense, quotient, position);
                self.perp(vector)
            }
            Private::Slide { slide, guide } => {
                let along = self.algebra.dot(guide, &rest);
                let square = self.square_of_guide(*guide);
                let graph = &mut self.algebra.graph;
                let quotient = graph.div(along, square);
                let value = graph.neg(quotient);
                self.define_length(*slide, value, position);
                *guide
            }
        }
    }

    fn square_of_guide(&mut self, guide: Vector) -> NodeId {
        match self.algebra.is_unit(&guide) {
            true => self.algebra.graph.one(),
            false => self.square(guide),
        }
    }

    /// The terms of one loop among all rows.
    fn block_terms(&mut self, block: &Block, first: usize, rows: usize) -> Vec<Term> {
        let graph = &mut self.algebra.graph;
        let zero = graph.zero();
        let terms = block.terms.iter().map(|product| {
            let mut coefficient = vec![zero; rows];
            coefficient[first..first + block.rows.len()].copy_from_slice(&product.coefficient);
            let mut factor = graph.one();
            for &(symbol, power) in &product.powers {
                for _ in 0..power {
                    let own = graph.symbol_node(symbol);
                    factor = graph.mul(factor, own);
                }
            }
            Term {
                coefficient,
                factor,
            }
        });
        terms.collect()
    }
}
