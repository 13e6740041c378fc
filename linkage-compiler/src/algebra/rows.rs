//! Right-hand sides of derivatives from the loops as they were written.
//!
//! With some values in place of those derivatives of a group's unknowns, what remains of a loop's derivative is what the linear system must make up
//! for. It says the same as the columns differentiated term by term, but a link is differentiated as the square of its vector, `V.V'' + V'.V'`, where
//! columns of directions have four factors in a term.
//!
//! A body that turns by `s` and by `t` moves an arm `r` by `t x r`, and that by `s x (t x r)`, if it turns no further. So the second derivative of
//! half of the square of a link that ends on it contains `V.(s x (t x r)) = (V.t)(s.r) - (V.r)(s.t)`: five scalar products, most of which several
//! variables share.

use std::mem;

use linkage_symbolic::{Ex, SymbolId, V3};

use super::Algebra;
use super::implicit::{Implicit, Rates};
use super::turns::Turns;

/// An equation as it was written.
#[derive(Clone, Debug)]
pub(crate) struct Written<'m> {
    pub(crate) row: Ex<'m>,
    /// If it says how long a link is, or by how much its square differs from that of another one.
    pub(crate) links: Option<Links<'m>>,
}

/// Half of what the first square of a distance is off by, less the same of another one, over the first length.
#[derive(Clone, Debug)]
pub(crate) struct Links<'m> {
    pub(crate) first: Distance<'m>,
    pub(crate) less: Option<Distance<'m>>,
}

/// A vector and the length that it should have.
#[derive(Clone, Debug)]
pub(crate) struct Distance<'m> {
    pub(crate) vector: V3<'m>,
    pub(crate) length: Ex<'m>,
    pub(crate) carried: Option<Carried<'m>>,
}

/// What a body carries of a vector as it is.
#[derive(Clone, Debug)]
pub(crate) struct Carried<'m> {
    pub(crate) body: usize,
    pub(crate) arm: V3<'m>,
    pub(crate) rest: V3<'m>,
    /// What the coordinates of the arm are made of.
    pub(crate) dimensions: Vec<SymbolId>,
}

/// What the derivatives by these variables leave of the right-hand side where those of the unknowns are `held`: bodies turn by `turns`, if that is
/// known, and no further.
pub(super) fn right_of_rows<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    by: &[SymbolId],
    held: Vec<Ex<'m>>,
    turns: Option<&Turns<'m>>,
) -> Vec<Ex<'m>> {
    with_rates(algebra, (group, by.to_vec()), held, |algebra, own| {
        let by_turns = own.links.zip(turns);
        let by_turns = by_turns.and_then(|(links, turns)| of_links(algebra, &links, turns));
        let slope = by_turns.unwrap_or_else(|| {
            by.iter()
                .fold(own.row, |x, &variable| algebra.slope(x, variable))
        });
        -slope
    })
}

/// The right-hand sides of the first derivatives by a variable, of equations about links.
pub(super) fn right_of_links<'m>(
    algebra: &mut Algebra<'m>,
    group: usize,
    variable: SymbolId,
) -> Vec<Option<Ex<'m>>> {
    let nothing = vec![algebra.zero(); algebra.solutions.groups[group].jacobian.len()];
    with_rates(algebra, (group, vec![variable]), nothing, |algebra, own| {
        let links = own.links?;
        Some(-slope_of_squares(algebra, &links, &mut |algebra, x| {
            algebra.slope(x, variable)
        }))
    })
}

/// The first derivative of an equation about links, by what `slope` finds: `(V.V' - l l')/l`. As a polynomial it has a multiple of the equation
/// itself besides, in all of its terms. Where loops close both are equal, so derivatives along solutions are, too.
pub(super) fn slope_of_squares<'m>(
    algebra: &mut Algebra<'m>,
    links: &Links<'m>,
    slope: &mut dyn FnMut(&mut Algebra<'m>, Ex<'m>) -> Ex<'m>,
) -> Ex<'m> {
    let mut of = |own: &Distance<'m>| {
        let moved = own.vector.dot(own.vector.map(|x| slope(algebra, x)));
        moved - own.length * slope(algebra, own.length)
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
    mut of: impl FnMut(&mut Algebra<'m>, Written<'m>) -> R,
) -> Vec<R> {
    let rows = algebra.solutions.groups[key.0].rows.clone();
    let rates = Rates {
        right: Vec::new(),
        rates,
    };
    // What is made of them must not be found again.
    let memo = mem::take(&mut algebra.derivatives.memo);
    algebra.derivatives.held += 1;
    algebra.derivatives.rates.insert(key.clone(), rates);
    let all = rows.into_iter().map(|own| of(algebra, own)).collect();
    algebra.derivatives.rates.remove(&key);
    algebra.derivatives.held -= 1;
    algebra.derivatives.memo = memo;
    all
}

/// The second derivative, if lengths and arms are not changed by the variables.
fn of_links<'m>(algebra: &mut Algebra<'m>, links: &Links<'m>, turns: &Turns<'m>) -> Option<Ex<'m>> {
    let graph = algebra.graph;
    let both = [Some(&links.first), links.less.as_ref()];
    let given = both.into_iter().flatten().flat_map(|own| {
        let dimensions = own.carried.iter().flat_map(|own| &own.dimensions);
        let dimensions = dimensions.map(|&symbol| graph.ex(graph.symbol_node(symbol)));
        dimensions.chain([own.length])
    });
    let given: Vec<Ex> = given.collect();
    let mut is_fixed = |own: Ex<'m>| turns.by.iter().all(|&v| algebra.slope(own, v).is_zero());
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
fn bend<'m>(algebra: &mut Algebra<'m>, own: &Distance<'m>, turns: &Turns<'m>) -> Ex<'m> {
    let vector = own.vector;
    let rest = own.carried.as_ref().map_or(vector, |carried| carried.rest);
    let [mut first, mut second] = turns
        .by
        .map(|variable| rest.map(|c| algebra.slope(c, variable)));
    let mut bend = vector.dot(first.map(|c| algebra.slope(c, turns.by[1])));
    if let Some(carried) = &own.carried {
        let arm = carried.arm;
        let [s, t] = [0, 1].map(|k| turns.of_bodies[k][carried.body]);
        first = first + s.cross(arm);
        second = second + t.cross(arm);
        bend += vector.dot(t) * s.dot(arm) - vector.dot(arm) * s.dot(t);
    }
    bend + first.dot(second)
}
