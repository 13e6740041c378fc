//! Derivatives by scalar products that are known: of a link with itself, and with the other unknown's column of the Jacobian.
//!
//! They stand for components of right-hand sides and of links. Whether that is shorter is a matter of the function.

use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use super::Algebra;
use super::adjoint::Multiplier;
use super::derivatives::Derivatives;
use super::implicit::Implicit;

/// A vector that turns with an unknown: its derivative by that is the unknown's column of the Jacobian.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link<'m> {
    /// `z u`
    pub(crate) vector: V2<'m>,
    pub(crate) z: V2<'m>,
    pub(crate) unit: V2<'m>,
    /// Of its length.
    pub(crate) square: Ex<'m>,
    /// `vector x column` of the other unknown.
    pub(crate) across: Ex<'m>,
}

impl<'m> Link<'m> {
    /// Its derivative where its unknown is held.
    fn stretched(&self, slope: V2<'m>) -> V2<'m> {
        slope.turned(self.unit)
    }
}

impl<'m> Algebra<'m> {
    /// Says whether derivatives use the products from here on. If that is new, all that is known of derivatives is forgotten: true then, for those who remember
    /// some themselves.
    #[must_use]
    pub(crate) fn use_products(&mut self, by_products: bool) -> bool {
        let is_new = self.solutions.by_products != by_products;
        if is_new {
            self.solutions.by_products = by_products;
            self.derivatives = Derivatives::default();
        }
        is_new
    }

    /// Whether that changes a derivative that has been asked for.
    pub(crate) fn has_products(&self) -> bool {
        self.derivatives.has_products
    }

    /// Second and further derivatives of two links that turn: the part of the right-hand side that turning makes lies along the links, which it meets in products.
    pub(super) fn rates_by_products(
        &mut self,
        group: usize,
        by: &[SymbolId],
    ) -> Option<Vec<Ex<'m>>> {
        let (&last, before) = by.split_last()?;
        let solution = &self.solutions.groups[group];
        let [Some(first), Some(second)] = solution.links else {
            return None;
        };
        if before.is_empty() {
            return None;
        }
        self.derivatives.has_products = true;
        if !self.solutions.by_products {
            return None;
        }
        let determinant = solution.determinant;
        let lower = self.rates(group, before.to_vec());
        let own = self.rates(group, vec![last]).rates;
        let mut right = Vector([0, 1].map(|row| self.slope(lower.right[row], last)));
        for (link, &rate) in [first, second].iter().zip(&lower.rates) {
            let slope = link.z.map(|x| self.slope(x, last));
            right = right - rate * link.stretched(slope).perp();
        }
        let [turned1, turned2] = [0, 1].map(|k| lower.rates[k] * own[k]);
        let along1 = right.dot(first.vector) + turned1 * first.square + turned2 * first.across;
        let along2 = right.dot(second.vector) + turned1 * second.across + turned2 * second.square;
        let numerators = [along2, -along1].into_iter().enumerate();
        let rates = numerators.map(|(position, numerator)| {
            self.rate_symbol(group, position, by, numerator / determinant)
        });
        Some(rates.collect())
    }

    /// The multipliers of a group's loop times the derivatives of its links by something else than its unknowns, where the products are used. For the first link
    /// with column `a`, and `b` the other one, `J^T l = w` makes `l . link = (w1 link x b - w2 link . link)/(a x b)`.
    pub(super) fn slope_of_links(&mut self, own: &Multiplier<'m>, variable: SymbolId) -> Ex<'m> {
        let mut sum = self.zero();
        if !own.system.by.is_empty() {
            return sum;
        }
        let solution = self.solutions.groups[own.system.group].clone();
        for (position, link) in solution.links.iter().enumerate() {
            let Some(link) = link else {
                continue;
            };
            let slope = link.z.map(|x| self.partial(x, variable));
            if slope.is_zero() {
                continue;
            }
            self.derivatives.has_products = true;
            if !self.solutions.by_products {
                return sum;
            }
            // By how much it becomes longer, and turns.
            let change = slope.turned_back(link.z);
            let [w1, w2] = [0, 1].map(|k| own.weights[k] / solution.determinant);
            let [across, square] = [link.across, link.square].map(|x| change[0] * x);
            sum += match position {
                0 => w1 * across - w2 * square,
                _ => w1 * square - w2 * across,
            };
            if !self.vanishes(change[1]) {
                // The weight itself would do, but would not be NaN where the loop does not close.
                let factors = Vector([own.factors[0], own.factors[1]]);
                sum += change[1] * factors.dot(link.vector.perp());
            }
        }
        sum
    }

    /// How many of a group's terms belong to its links: those that [`Self::slope_of_links`] is about.
    pub(super) fn terms_of_links(&self, group: usize) -> usize {
        let links = self.solutions.groups[group].links.iter().flatten();
        match self.solutions.by_products {
            true => 2 * links.count(),
            false => 0,
        }
    }
}
