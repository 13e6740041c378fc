//! How large the determinant of a coupled group can become: what its margin is measured by.

use linkage_symbolic::{Ex, SymbolId};

use crate::formulate::Solver;
use crate::structure::{Block, Core, Private, Product};

use super::equations::Equations;
use super::vector;

impl<'m> Solver<'_, 'm> {
    /// The sum of all products of the sizes of entries: no position with these lengths has a larger determinant.
    pub(super) fn largest_core_determinant(&self, equations: &Equations<'_, 'm>) -> Ex<'m> {
        let core = &equations.form.core;
        let mut matrix: Vec<Vec<Ex>> = Vec::new();
        for block in &equations.form.blocks {
            let sizes: Vec<Ex> = core
                .iter()
                .map(|&core| equations.column_scale(block, core) * self.column_size(block, core))
                .collect();
            let (weight, rows) = match &block.private {
                Some(Private::Rotor(rotor)) => (equations.scale * rotor.z.length(), 1),
                Some(Private::Slide { guide, .. }) => (guide.length_and_unit().0, 1),
                None => (self.algebra.one(), block.rows.len()),
            };
            for _ in 0..rows {
                matrix.push(sizes.iter().map(|&size| weight * size).collect());
            }
        }
        self.permanent(&matrix, (1 << core.len()) - 1)
    }

    /// The size of the derivative of a loop by an unknown of the core.
    fn column_size(&self, block: &Block<'m>, core: Core) -> Ex<'m> {
        let graph = self.algebra.graph;
        let own: Vec<SymbolId> = match core {
            Core::Angle(angle) => {
                let angle = &self.algebra.names.angles[angle];
                vec![angle.cos, angle.sin]
            }
            Core::Length { symbol, .. } => vec![symbol],
        };
        let mut sum = self.algebra.zero();
        for product in &block.terms {
            let powers = product.powers.iter();
            let power: u8 = powers
                .filter(|(symbol, _)| own.contains(symbol))
                .map(|(_, power)| power)
                .sum();
            if power == 0 || self.is_counted(block, product) {
                continue;
            }
            let mut size = match product.coefficient[..] {
                [single] => single.abs(),
                _ => vector(&product.coefficient).length(),
            };
            for &(symbol, exponent) in &product.powers {
                if self.is_component(symbol) {
                    continue;
                }
                let held = exponent - u8::from(own == [symbol]);
                for _ in 0..held {
                    size = size * graph.ex(graph.symbol_node(symbol)).abs();
                }
            }
            sum += f64::from(power) * size;
        }
        sum
    }

    /// True for a cosine or sine, which is at most 1.
    fn is_component(&self, symbol: SymbolId) -> bool {
        let mut angles = self.algebra.names.angles.iter();
        angles.any(|angle| angle.cos == symbol || angle.sin == symbol)
    }

    /// True for the sine's share of a vector that turns: the cosine's share is as long.
    fn is_counted(&self, block: &Block<'m>, product: &Product<'m>) -> bool {
        if product.coefficient.len() == 1 {
            return false;
        }
        let angles = self.algebra.names.angles.iter();
        let partners: Vec<Vec<(SymbolId, u8)>> = angles
            .filter_map(|angle| {
                let mut partner = product.powers.clone();
                let sine = partner.iter().position(|&power| power == (angle.sin, 1))?;
                partner[sine].0 = angle.cos;
                partner.sort_unstable();
                Some(partner)
            })
            .collect();
        block.terms.iter().any(|other| {
            let mut own = other.powers.clone();
            own.sort_unstable();
            let [sine, cosine] = [product, other].map(|p| vector(&p.coefficient));
            partners.contains(&own) && sine.is_turned(cosine)
        })
    }

    /// The determinant without its signs, of the last rows and the columns in a set.
    fn permanent(&self, matrix: &[Vec<Ex<'m>>], columns: u32) -> Ex<'m> {
        let [row, below @ ..] = matrix else {
            return self.algebra.one();
        };
        let mut sum = self.algebra.zero();
        for (column, &entry) in row.iter().enumerate() {
            if columns >> column & 1 == 1 && !entry.is_zero() {
                sum += entry * self.permanent(below, columns & !(1 << column));
            }
        }
        sum
    }
}
