//! Derivatives by scalar products that are known: of a link with itself, and with the other
//! unknown's column of the Jacobian.
//!
//! They stand for components of right-hand sides and of links. Whether that is shorter is a matter
//! of the function.

use linkage_symbolic::{Ex, SymbolId, V3, Vector};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::{GroupRates, RuleCalculus};
use crate::algebra::derivatives::{by_rule, partial};
use crate::algebra::memo::{DerivativeMemos, Multiplier};
use crate::algebra::solutions::{Shortcuts, Solutions};

/// Sets the shortcuts of derivatives from here on. A new choice forgets all derivatives and returns
/// true, for callers that remember some themselves.
#[must_use]
pub(crate) fn use_shortcuts(
    solutions: &mut Solutions,
    derivatives: &mut DerivativeMemos,
    shortcuts: Shortcuts,
) -> bool {
    let is_new = solutions.shortcuts != shortcuts;
    if is_new {
        solutions.shortcuts = shortcuts;
        *derivatives = DerivativeMemos::default();
    }
    is_new
}

/// Returns second derivatives of a rod's unknown: with `V'` the rod's first derivative, `V . V'' +
/// V' . V' = 0`, where `V` meets the turning vector in a product that is known.
fn rates_of_rod<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
) -> Option<Vec<Ex<'m>>> {
    let rod = algebra.solutions.groups[group].rod?;
    let &[x, y] = by else {
        return None;
    };
    let fixed = |algebra: &mut Algebra<'m>, v: V3<'m>| {
        v.map(|c| algebra.slope(c, x) + algebra.slope(c, y))
            .is_zero()
    };
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
    let [rate_x, rate_y] = [x, y].map(|v| algebra.rates(group, vec![v]).rates[0]);
    let known_x = rod.known.map(|c| algebra.slope(c, x));
    let known_y = rod.known.map(|c| algebra.slope(c, y));
    let known_xy = known_x.map(|c| algebra.slope(c, y));
    let first = known_x + rate_x * rod.slope;
    let second = known_y + rate_y * rod.slope;
    let right = (rate_x * rate_y) * rod.across - rod.vector.dot(known_xy) - first.dot(second);
    Some(vec![by_rule::rate_symbol(
        algebra.graph,
        &mut algebra.solutions,
        group,
        0,
        by,
        right / determinant,
    )])
}

/// Second and further derivatives of two links that turn: the part of the right-hand side that
/// turning makes lies along the links, which it meets in products.
pub(crate) fn rates_by_products<'m>(
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
    let lower = algebra.rates(group, before.to_vec());
    let rates = algebra.rates(group, vec![last]).rates;
    let mut right = Vector([0, 1].map(|row| algebra.slope(lower.right[row], last)));
    for (link, &rate) in [first, second].iter().zip(&lower.rates) {
        let slope = link.z.map(|x| algebra.slope(x, last));
        right = right - rate * link.stretched(slope).perp();
    }
    let [turned1, turned2] = [0, 1].map(|k| lower.rates[k] * rates[k]);
    let along1 = right.dot(first.vector) + turned1 * first.square + turned2 * first.across;
    let along2 = right.dot(second.vector) + turned1 * second.across + turned2 * second.square;
    let numerators = [along2, -along1].into_iter().enumerate();
    let rates = numerators.map(|(position, numerator)| {
        by_rule::rate_symbol(
            algebra.graph,
            &mut algebra.solutions,
            group,
            position,
            by,
            numerator / determinant,
        )
    });
    Some(rates.collect())
}

/// The multipliers of a group's loop times the derivatives of its links by something else than its
/// unknowns, where the products are used. For the first link with column `a`, and `b` the other
/// one, `J^T l = w` makes `l . link = (w1 link x b - w2 link . link)/(a x b)`.
pub(crate) fn slope_of_links<'m>(
    algebra: &mut Algebra<'m>,
    multiplier: &Multiplier<'m>,
    variable: SymbolId,
) -> Ex<'m> {
    let mut sum = algebra.zero();
    if !multiplier.system.by.is_empty() {
        return sum;
    }
    let solution = algebra.solutions.groups[multiplier.system.group].clone();
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
        // The relative change of its length, and its turn.
        let change = slope.turned_back(link.z);
        let [w1, w2] = [0, 1].map(|k| multiplier.weights[k] / solution.determinant);
        let [across, square] = [link.across, link.square].map(|x| change[0] * x);
        sum += match position {
            0 => w1 * across - w2 * square,
            _ => w1 * square - w2 * across,
        };
        if !algebra.vanishes(change[1]) {
            // The weight itself would do, but would not be NaN where the loop does not close.
            let factors = Vector([multiplier.factors[0], multiplier.factors[1]]);
            sum += change[1] * factors.dot(link.vector.perp());
        }
    }
    sum
}

/// Returns the number of a group's terms that belong to its links: those that [`slope_of_links`]
/// covers.
pub(crate) fn terms_of_links(solutions: &Solutions, group: usize) -> usize {
    let links = solutions.groups[group].links.iter().flatten();
    if solutions.shortcuts.products {
        2 * links.count()
    } else {
        0
    }
}
