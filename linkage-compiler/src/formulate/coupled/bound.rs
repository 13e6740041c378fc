//! How large the determinant of a coupled group can become: what its margin is measured by.

use linkage_symbolic::{NodeId, SymbolId};

use crate::structure::{Block, Core, Coupled, Private};

use crate::formulate::Solver;

use super::equations::Equations;

impl Solver<'_, '_> {
    /// The sum of all products of the sizes of entries: no position with these lengths has a larger determinant.
    pub(super) fn largest_core_determinant(
        &mut self,
        form: &Coupled,
        equations: &Equations,
    ) -> NodeId {
        let mut matrix: Vec<Vec<NodeId>> = Vec::new();
        for block in &form.blocks {
            let sizes: Vec<NodeId> = form
                .core
                .iter()
                .map(|core| {
                    let size = self.column_size(block, *core);
                    match core {
                        Core::Angle(_) if block.is_length() => {
                            self.algebra.graph.mul(equations.scale, size)
                        }
                        Core::Length { .. } if !block.is_length() => {
                            self.algebra.graph.mul(equations.unit, size)
                        }
                        _ => size,
                    }
                })
                .collect();
            let weight = match &block.private {
                Some(Private::Rotor(rotor)) => {
                    let length = self.algebra.length(&rotor.z);
                    self.algebra.graph.mul(equations.scale, length)
                }
                Some(Private::Slide { guide, .. }) => self.algebra.length_and_unit(*guide).0,
                None => self.algebra.graph.one(),
            };
            let rows = if block.private.is_some() {
                1
            } else {
                block.rows.len()
            };
            for _ in 0..rows {
                let graph = &mut self.algebra.graph;
                matrix.push(sizes.iter().map(|&size| graph.mul(weight, size)).collect());
            }
        }
        self.permanent(&matrix, (1 << form.core.len()) - 1)
    }

    /// The size of the derivative of a loop by an unknown of the core.
    fn column_size(&mut self, block: &Block, core: Core) -> NodeId {
        let own: Vec<SymbolId> = match core {
            Core::Angle(angle) => {
                let angle = &self.algebra.angles[angle];
                vec![angle.cos, angle.sin]
            }
            Core::Length { symbol, .. } => vec![symbol],
        };
        let mut sum = self.algebra.graph.zero();
        for product in &block.terms {
            let power: u8 = product
                .powers
                .iter()
                .filter(|(symbol, _)| own.contains(symbol))
                .map(|(_, power)| power)
                .sum();
            if power == 0 || self.is_counted(block, &product.powers, &product.coefficient) {
                continue;
            }
            let mut size = match product.coefficient[..] {
                [single] => self.abs(single),
                _ => self.algebra.length(&product.coefficient),
            };
            for &(symbol, exponent) in &product.powers {
                let is_direction = |a: &crate::algebra::Angle| a.cos == symbol || a.sin == symbol;
                let held = exponent - u8::from(own == [symbol]);
                if self.algebra.angles.iter().any(is_direction) {
                    continue;
                }
                for _ in 0..held {
                    let length = self.algebra.graph.symbol_node(symbol);
                    let length = self.abs(length);
                    size = self.algebra.graph.mul(size, length);
                }
            }
            let graph = &mut self.algebra.graph;
            let times = graph.constant(f64::from(power));
            let size = graph.mul(times, size);
            sum = graph.add(sum, size);
        }
        sum
    }

    /// True for the sine's share of a vector that turns: the cosine's share is as long.
    fn is_counted(
        &mut self,
        block: &Block,
        powers: &[(SymbolId, u8)],
        coefficient: &[NodeId],
    ) -> bool {
        if coefficient.len() == 1 {
            return false;
        }
        let angles = self.algebra.angles.iter();
        let partners: Vec<Vec<(SymbolId, u8)>> = angles
            .filter_map(|angle| {
                let sine = |power: &(SymbolId, u8)| *power == (angle.sin, 1);
                let place = powers.iter().position(sine)?;
                let mut partner = powers.to_vec();
                partner[place].0 = angle.cos;
                partner.sort_unstable();
                Some(partner)
            })
            .collect();
        block.terms.iter().any(|other| {
            let mut own = other.powers.clone();
            own.sort_unstable();
            partners.contains(&own) && self.algebra.is_turned(coefficient, &other.coefficient)
        })
    }

    /// The determinant without its signs, of the last rows and the columns in a set.
    fn permanent(&mut self, matrix: &[Vec<NodeId>], columns: u32) -> NodeId {
        let mut sum = self.algebra.graph.zero();
        let [row, below @ ..] = matrix else {
            return self.algebra.graph.one();
        };
        for (column, &entry) in row.iter().enumerate() {
            if columns >> column & 1 == 0 || self.algebra.graph.is_zero(entry) {
                continue;
            }
            let rest = self.permanent(below, columns & !(1 << column));
            let graph = &mut self.algebra.graph;
            let product = graph.mul(entry, rest);
            sum = graph.add(sum, product);
        }
        sum
    }
}
