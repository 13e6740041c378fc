//! Right-hand sides of derivatives from the loops as they were written.
//!
//! The derivatives of a group's unknowns are replaced by given values: the rest of a loop's
//! derivative is the right-hand side of the linear system. It equals the columns differentiated
//! term by term, but a link is differentiated as the square of its vector, `V.V'' + V'.V'`, where
//! columns of directions have four factors in a term.
//!
//! A body that turns by `s` and by `t` moves an arm `r` by `t x r`, and that by `s x (t x r)`, if
//! it turns no further. So the second derivative of half of the square of a link that ends on it
//! contains `V.(s x (t x r)) = (V.t)(s.r) - (V.r)(s.t)`: five scalar products, most of which
//! several variables share.

use std::mem;

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::RuleCalculus;
use crate::algebra::derivatives::rotation_variation::BodyRotations;
use crate::algebra::equations::{Distance, Links, WrittenRow};
use crate::algebra::memo::Rates;

/// Returns the rest of the right-hand side of the derivatives by these variables where those of the
/// unknowns are `held`: bodies turn by `turns`, if that is known, and no further.
pub(crate) fn right_of_rows<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
    held: Vec<Ex<'m>>,
    turns: Option<&BodyRotations<'m>>,
) -> Vec<Ex<'m>> {
    with_rates(algebra, (group, by.to_vec()), held, |algebra, equation| {
        let by_turns = equation.links.zip(turns);
        let by_turns = by_turns.and_then(|(links, turns)| of_links(algebra, &links, turns));
        let slope = by_turns.unwrap_or_else(|| {
            by.iter()
                .fold(equation.row, |x, &variable| algebra.slope(x, variable))
        });
        -slope
    })
}

/// The right-hand sides of the first derivatives by a variable, of equations about links.
pub(crate) fn right_of_links<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    variable: SymbolId,
) -> Vec<Option<Ex<'m>>> {
    let nothing = vec![algebra.zero(); algebra.solutions.groups[group].jacobian.len()];
    with_rates(
        algebra,
        (group, vec![variable]),
        nothing,
        |algebra, equation| {
            let links = equation.links?;
            Some(-slope_of_squares(&links, &mut |x| {
                algebra.slope(x, variable)
            }))
        },
    )
}

/// Returns the first derivative of an equation about links, with derivatives by `slope`: `(V.V' - l
/// l')/l`. The polynomial has a multiple of the equation itself besides, in all of its terms. Both
/// are equal where loops close, so derivatives along solutions are, too.
pub(crate) fn slope_of_squares<'m>(
    links: &Links<'m>,
    slope: &mut dyn FnMut(Ex<'m>) -> Ex<'m>,
) -> Ex<'m> {
    let mut of = |distance: &Distance<'m>| {
        let moved = distance.vector.dot(distance.vector.map(&mut *slope));
        moved - distance.length * slope(distance.length)
    };
    let first = of(&links.first);
    let less = links.less.as_ref().map(of);
    less.map_or(first, |less| first - less) / links.first.length
}

/// Something of each equation of a group where some of its derivatives are given.
fn with_rates<'m, R>(
    algebra: &mut Algebra<'m>,
    key: (usize, Vec<SymbolId>),
    rates: Vec<Ex<'m>>,
    mut of: impl FnMut(&mut Algebra<'m>, WrittenRow<'m>) -> R,
) -> Vec<R> {
    let rows = algebra.solutions.groups[key.0].rows.clone();
    let rates = Rates {
        right: Vec::new(),
        rates,
    };
    // Derivatives made of them must not be found again.
    let memo = mem::take(&mut algebra.derivatives.memo);
    algebra.derivatives.held += 1;
    algebra.derivatives.rates.insert(key.clone(), rates);
    let all = rows.into_iter().map(|row| of(algebra, row)).collect();
    algebra.derivatives.rates.remove(&key);
    algebra.derivatives.held -= 1;
    algebra.derivatives.memo = memo;
    all
}

/// The second derivative, if lengths and arms are not changed by the variables.
fn of_links<'m>(
    algebra: &mut Algebra<'m>,
    links: &Links<'m>,
    turns: &BodyRotations<'m>,
) -> Option<Ex<'m>> {
    let graph = algebra.graph;
    let both = [Some(&links.first), links.less.as_ref()];
    let given = both.into_iter().flatten().flat_map(|distance| {
        let dimensions = distance.carried.iter().flat_map(|arm| &arm.dimensions);
        let dimensions = dimensions.map(|&symbol| graph.ex(graph.symbol_node(symbol)));
        dimensions.chain([distance.length])
    });
    let given: Vec<Ex> = given.collect();
    let mut is_fixed = |x: Ex<'m>| turns.by.iter().all(|&v| algebra.slope(x, v).is_zero());
    if !given.into_iter().all(&mut is_fixed) {
        return None;
    }
    let mut bent = bend(algebra, &links.first, turns);
    if let Some(less) = &links.less {
        bent -= bend(algebra, less, turns);
    }
    Some(bent / links.first.length)
}

/// The second derivative of half of the square of a vector.
fn bend<'m>(
    algebra: &mut Algebra<'m>,
    distance: &Distance<'m>,
    turns: &BodyRotations<'m>,
) -> Ex<'m> {
    let vector = distance.vector;
    let rest = distance
        .carried
        .as_ref()
        .map_or(vector, |carried| carried.rest);
    let [mut first, mut second] = turns
        .by
        .map(|variable| rest.map(|c| algebra.slope(c, variable)));
    let mut bend = vector.dot(first.map(|c| algebra.slope(c, turns.by[1])));
    if let Some(carried) = &distance.carried {
        let arm = carried.arm;
        let [s, t] = [0, 1].map(|k| turns.of_bodies[k][carried.body]);
        first = first + s.cross(arm);
        second = second + t.cross(arm);
        bend += vector.dot(t) * s.dot(arm) - vector.dot(arm) * s.dot(t);
    }
    bend + first.dot(second)
}
