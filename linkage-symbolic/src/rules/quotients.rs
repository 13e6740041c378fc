//! Rules of quotients.

use super::functions::FOLD_TWO;
use super::rule::{Assumes, Changes, RewriteRule, rule};
use super::sums::other;
use crate::graph::{Node, NodeId, Store};
use crate::operation::{Binary, Unary};

pub(super) static QUOTIENT: &[RewriteRule<Binary, 2>] = &[
    // 0 over a negative number is -0.
    rule("0 / x = 0", |g, _, [a, b]| {
        (g.is_zero(a) && !g.is_zero(b)).then_some(a)
    })
    .changes(Changes::SignOfZero)
    .assumes(Assumes::Nonzero),
    rule("x / 1 = x", |g, _, [a, b]| g.is_one(b).then_some(a)),
    FOLD_TWO,
    rule("x / x = 1", |g, _, [a, b]| (a == b).then(|| g.one())).assumes(Assumes::Nonzero),
    rule("x / (-y) = (-x) / y", |g, _, [a, b]| {
        let y = g.negated(b)?;
        let a = g.neg(a);
        Some(g.div(a, y))
    })
    .also(&["p / (-k) = (-p) / k"]),
    rule("(-x) / y = -(x / y)", |g, _, [a, b]| match g.node(a) {
        Node::Unary(Unary::Neg, x) => {
            let value = g.div(x, b);
            Some(g.neg(value))
        }
        _ => None,
    }),
    rule("(x y) / y = x", |g, _, [a, b]| {
        let (x, y) = g.product(a)?;
        other(x, y, b)
    })
    .also(&["(x y) / x = y", "(p x) / p = x"])
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Nonzero),
    rule("x / (x y) = 1 / y", |g, _, [a, b]| {
        let (x, y) = g.product(b)?;
        let rest = other(x, y, a)?;
        let one = g.one();
        Some(g.div(one, rest))
    })
    .also(&["y / (x y) = 1 / x", "p / (p x) = 1 / x"])
    .changes(Changes::Roundings(-1))
    .assumes(Assumes::Nonzero),
    // One division for all dividends, and it does not wait for a product.
    rule("p / (q x) = (p (1 / q)) / x", |g, _, [a, b]| {
        let (p, x) = g.early_factor(b)?;
        g.is_early(a).then(|| {
            let inverse = inverse(g, p);
            let factor = g.mul(a, inverse);
            g.div(factor, x)
        })
    })
    .also(&["1 / (p x) = (1 / p) / x", "p / (k x) = (p (1 / k)) / x"])
    .changes(Changes::Roundings(1))
    .assumes(Assumes::Range),
    rule("x / (p y) = x ((1 / p) / y)", |g, _, [a, b]| {
        let (p, y) = g.early_factor(b)?;
        let factor = inverse(g, p);
        let inverse = g.div(factor, y);
        Some(g.mul(a, inverse))
    })
    .also(&["x / (k y) = x ((1 / k) / y)"])
    .changes(Changes::Roundings(1))
    .assumes(Assumes::Range),
    rule("x / 2 = 0.5 x", |g, _, [a, b]| {
        let divisor = g.constant_value(b)?;
        is_power_of_two(divisor).then(|| {
            let inverse = g.constant(1.0 / divisor);
            g.mul(inverse, a)
        })
    })
    .also(&["p / 0.25 = 4 p", "x / 1024 = 0.0009765625 x"]),
    // A divisor known in assemble() costs one division there and a product here.
    rule("x / p = (1 / p) x", |g, op, [a, b]| {
        (g.is_early(b) && !g.is_early(a)).then(|| {
            let one = g.one();
            let inverse = match g.constant_value(b) {
                Some(divisor) => g.constant(1.0 / divisor),
                None => g.intern(Node::Binary(op, one, b)),
            };
            g.mul(inverse, a)
        })
    })
    .also(&["x / k = (1 / k) x", "x / (p q) = (1 / (p q)) x"])
    .changes(Changes::Roundings(1))
    .assumes(Assumes::Range),
];

fn inverse(g: &mut Store, x: NodeId) -> NodeId {
    let one = g.one();
    g.binary(Binary::Div, one, x)
}

fn is_power_of_two(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0 && (1.0 / x).is_normal()
}
