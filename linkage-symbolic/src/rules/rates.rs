//! Rules of rates: vectors that turn with a link have the link's rate as a factor.

use super::rule::{Assumes, Changes, RewriteRule, rule};
use crate::graph::{Binding, Node, NodeId, Store};
use crate::operation::{Binary, Unary};

pub(super) static PRODUCT: &[RewriteRule<Binary, 2>] = &[
    // Only where `p y` is known already: the vector of a link, whose direction `y` is.
    rule("p (x y) = x (p y)", |g, _, [p, rate]| {
        let mut factors = factors(g, rate);
        let known = factors.iter().enumerate();
        let mut known = known.filter_map(|(index, &x)| Some((index, g.known_product(p, x)?)));
        let (index, vector) = known.next()?;
        if factors.len() == 1 {
            return None;
        }
        factors[index] = vector;
        Some(product(g, &factors))
    })
    .also(&["p (x (y z)) = x (y (p z))", "p (-(x y)) = -(x (p y))"])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range),
];

// Where vectors turn with one angle, `y + z` is mostly a component of their sum that is known
// already.

pub(super) static SUM: &[RewriteRule<Binary, 2>] = &[rule("x y + x z = x (y + z)", common_rate)
    .also(&["(p x) y + x z = x (p y + z)"])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range)];

pub(super) static DIFFERENCE: &[RewriteRule<Binary, 2>] =
    &[rule("x y - x z = x (y - z)", common_rate)
        .changes(Changes::Roundings(0))
        .assumes(Assumes::Range)];

/// `x (a + b)` from the factors of `x a` and of `x b`.
fn common_rate(g: &mut Store, op: Binary, [a, b]: [NodeId; 2]) -> Option<NodeId> {
    let (mut left, mut right) = (factors(g, a), factors(g, b));
    let is_common = |x: &&NodeId| g.binding(**x) == Binding::Call && right.contains(x);
    let rate = *left.iter().find(is_common)?;
    for list in [&mut left, &mut right] {
        let index = list.iter().position(|&x| x == rate);
        index.map(|index| list.remove(index));
    }
    let [left, right] = [left, right].map(|factors| product(g, &factors));
    let sum = g.of_rates(op, left, right);
    Some(g.mul(rate, sum))
}

fn product(g: &mut Store, factors: &[NodeId]) -> NodeId {
    let one = g.one();
    let factors = factors.iter().rev();
    factors.fold(one, |product, &x| g.mul(x, product))
}

/// The factors of nested products, signs as -1.
fn factors(g: &mut Store, x: NodeId) -> Vec<NodeId> {
    match g.node(x) {
        Node::Unary(Unary::Neg, inner) => {
            let sign = g.constant(-1.0);
            let mut factors = factors(g, inner);
            factors.push(sign);
            factors
        }
        Node::Binary(Binary::Mul, a, b) => {
            let mut factors = factors(g, a);
            factors.extend(self::factors(g, b));
            factors
        }
        _ => vec![x],
    }
}
