//! Right-hand sides of second and further derivatives from the loops as they were written.
//!
//! With some values in place of those derivatives of a group's unknowns, what remains of a loop's derivative is what the linear system must make up
//! for. It says the same as the columns differentiated term by term, but a link is differentiated as the square of its vector, `V.V'' + V'.V'`, where
//! columns of directions have four factors in a term.

use std::mem;

use linkage_symbolic::{Ex, SymbolId};

use super::Algebra;
use super::implicit::{Implicit, Rates};

impl<'m> Algebra<'m> {
    /// What the derivatives by these variables leave of the right-hand side where those of the unknowns are `held`.
    pub(super) fn right_of_rows(
        &mut self,
        group: usize,
        by: &[SymbolId],
        held: Vec<Ex<'m>>,
    ) -> Vec<Ex<'m>> {
        let key = (group, by.to_vec());
        let rows = self.solutions.groups[group].rows.clone();
        let held = Rates {
            right: Vec::new(),
            rates: held,
        };
        // What is made of them must not be found again.
        let memo = mem::take(&mut self.derivatives.memo);
        self.derivatives.rates.insert(key.clone(), held);
        let right = rows.into_iter().map(|row| {
            let slope = by.iter().fold(row, |x, &variable| self.slope(x, variable));
            -slope
        });
        let right = right.collect();
        self.derivatives.rates.remove(&key);
        self.derivatives.memo = memo;
        right
    }
}
