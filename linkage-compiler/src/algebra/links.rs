//! Derivatives by scalar products that are known: of a link with itself, and with the other unknown's column of the Jacobian.
//!
//! They stand for components of right-hand sides and of links. Whether that is shorter is a matter of the function.

use crate::algebra::implicit;
use crate::algebra::partial;
use linkage_symbolic::{Ex, SymbolId, V2, V3, Vector};

use super::Algebra;
use super::adjoint::Multiplier;
use super::derivatives::Derivatives;
use super::implicit::Implicit;
use super::solutions::Shortcuts;

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

/// A rod in space between a known point and one that the unknown of its group moves: the equation says that its length is given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rod<'m> {
    /// `known` and a vector that the unknown moves.
    pub(crate) vector: V3<'m>,
    pub(crate) known: V3<'m>,
    pub(crate) length: Ex<'m>,
    /// What the unknown moves its end by, and what that is made of.
    pub(crate) slope: V3<'m>,
    pub(crate) arms: [V3<'m>; 2],
    /// The scalar product of the rod and the vector that the unknown turns, 0 for one that it only moves.
    pub(crate) across: Ex<'m>,
}

impl<'m> Link<'m> {
    /// Its derivative where its unknown is held.
    fn stretched(&self, slope: V2<'m>) -> V2<'m> {
        slope.turned(self.unit)
    }
}

/// Says what derivatives make use of from here on. If that is new, all that is known of derivatives is forgotten: true then, for those who remember
/// some themselves.
#[must_use]
pub(crate) fn use_shortcuts(algebra: &mut Algebra<'_>, shortcuts: Shortcuts) -> bool {
    let is_new = algebra.solutions.shortcuts != shortcuts;
    if is_new {
        algebra.solutions.shortcuts = shortcuts;
        algebra.derivatives = Derivatives::default();
    }
    is_new
}

/// What would change a derivative that has been asked for.
pub(crate) fn offered_shortcuts(algebra: &Algebra<'_>) -> Shortcuts {
    algebra.derivatives.offered
}

/// Second derivatives of a rod's unknown: with `V'` the rod's first derivative, `V . V'' + V' . V' = 0`, where `V` meets what turns in a product that is known.
fn rates_of_rod<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
) -> Option<Vec<Ex<'m>>> {
    let rod = algebra.solutions.groups[group].rod?;
    let &[x, y] = by else {
        return None;
    };
    let fixed =
        |own: &mut Algebra<'m>, v: V3<'m>| v.map(|c| own.slope(c, x) + own.slope(c, y)).is_zero();
    if !rod.arms.into_iter().all(|arm| fixed(algebra, arm))
        || !algebra.slope(rod.length, x).is_zero()
        || !algebra.slope(rod.length, y).is_zero()
    {
        return None;
    }
    algebra.derivatives.offered.products = true;
    if !algebra.solutions.shortcuts.products {
        return None;
    }
    let determinant = algebra.solutions.groups[group].determinant;
    let [rate_x, rate_y] = [x, y].map(|v| implicit::rates(algebra, group, vec![v]).rates[0]);
    let known_x = rod.known.map(|c| algebra.slope(c, x));
    let known_y = rod.known.map(|c| algebra.slope(c, y));
    let known_xy = known_x.map(|c| algebra.slope(c, y));
    let first = known_x + rate_x * rod.slope;
    let second = known_y + rate_y * rod.slope;
    let right = (rate_x * rate_y) * rod.across - rod.vector.dot(known_xy) - first.dot(second);
    Some(vec![implicit::rate_symbol(
        algebra,
        group,
        0,
        by,
        right / determinant,
    )])
}

/// Second and further derivatives of two links that turn: the part of the right-hand side that turning makes lies along the links, which it meets in products.
pub(super) fn rates_by_products<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
) -> Option<Vec<Ex<'m>>> {
    if let Some(rates) = rates_of_rod(algebra, group, by) {
        return Some(rates);
    }
    let (&last, before) = by.split_last()?;
    let solution = &algebra.solutions.groups[group];
    let [Some(first), Some(second)] = solution.links else {
        return None;
    };
    if before.is_empty() {
        return None;
    }
    algebra.derivatives.offered.products = true;
    if !algebra.solutions.shortcuts.products {
        return None;
    }
    let determinant = solution.determinant;
    let lower = implicit::rates(algebra, group, before.to_vec());
    let own = implicit::rates(algebra, group, vec![last]).rates;
    let mut right = Vector([0, 1].map(|row| algebra.slope(lower.right[row], last)));
    for (link, &rate) in [first, second].iter().zip(&lower.rates) {
        let slope = link.z.map(|x| algebra.slope(x, last));
        right = right - rate * link.stretched(slope).perp();
    }
    let [turned1, turned2] = [0, 1].map(|k| lower.rates[k] * own[k]);
    let along1 = right.dot(first.vector) + turned1 * first.square + turned2 * first.across;
    let along2 = right.dot(second.vector) + turned1 * second.across + turned2 * second.square;
    let numerators = [along2, -along1].into_iter().enumerate();
    let rates = numerators.map(|(position, numerator)| {
        implicit::rate_symbol(algebra, group, position, by, numerator / determinant)
    });
    Some(rates.collect())
}

/// The multipliers of a group's loop times the derivatives of its links by something else than its unknowns, where the products are used. For the first link
/// with column `a`, and `b` the other one, `J^T l = w` makes `l . link = (w1 link x b - w2 link . link)/(a x b)`.
pub(super) fn slope_of_links<'m>(
    algebra: &mut Algebra<'m>,
    own: &Multiplier<'m>,
    variable: SymbolId,
) -> Ex<'m> {
    let mut sum = algebra.zero();
    if !own.system.by.is_empty() {
        return sum;
    }
    let solution = algebra.solutions.groups[own.system.group].clone();
    for (position, link) in solution.links.iter().enumerate() {
        let Some(link) = link else {
            continue;
        };
        let slope = link.z.map(|x| partial::partial(algebra, x, variable));
        if slope.is_zero() {
            continue;
        }
        algebra.derivatives.offered.products = true;
        if !algebra.solutions.shortcuts.products {
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
        if !algebra.vanishes(change[1]) {
            // The weight itself would do, but would not be NaN where the loop does not close.
            let factors = Vector([own.factors[0], own.factors[1]]);
            sum += change[1] * factors.dot(link.vector.perp());
        }
    }
    sum
}

/// How many of a group's terms belong to its links: those that [`Self::slope_of_links`] is about.
pub(super) fn terms_of_links(algebra: &Algebra<'_>, group: usize) -> usize {
    let links = algebra.solutions.groups[group].links.iter().flatten();
    match algebra.solutions.shortcuts.products {
        true => 2 * links.count(),
        false => 0,
    }
}
