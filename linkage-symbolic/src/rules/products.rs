//! Rules of products. The first factor is never known later than the second.

use super::functions::FOLD_TWO;
use super::rule::{Assumes, Changes, RewriteRule, rule};
use crate::graph::{Node, NodeId, Store};
use crate::operation::{Binary, Unary};

pub(super) static PRODUCT: &[RewriteRule<Binary, 2>] = &[
    // 0 times a negative number is -0.
    rule("0 x = 0", |g, _, [a, b]| {
        (g.is_zero(a) || g.is_zero(b)).then(|| g.zero())
    })
    .also(&["0 p = 0", "k (0) = 0"])
    .changes(Changes::SignOfZero)
    .assumes(Assumes::Finite),
    rule("1 x = x", |g, _, [a, b]| g.is_one(a).then_some(b)),
    FOLD_TWO,
    rule("(-1) x = -x", |g, _, [a, b]| {
        (g.constant_value(a) == Some(-1.0)).then(|| g.neg(b))
    }),
    rule("(-x) y = -(x y)", |g, _, [a, b]| {
        if g.binding(a) != g.binding(b) {
            return None;
        }
        let product = match g.negative_term(a) {
            Some(x) => g.mul(x, b),
            None => {
                let y = g.negative_term(b)?;
                g.mul(a, y)
            }
        };
        Some(g.neg(product))
    })
    .also(&[
        "x (-y) = -(x y)",
        "(-p) q = -(p q)",
        "((-p) x) y = -((p x) y)",
    ]),
    rule("p (-x) = (-p) x", |g, _, [a, b]| match g.node(b) {
        Node::Unary(Unary::Neg, x) if g.binding(a) != g.binding(b) => {
            let a = g.neg(a);
            Some(g.mul(a, x))
        }
        _ => None,
    })
    .also(&["k (-x) = (-k) x"]),
    rule("x (y / x) = y", |g, _, [a, b]| {
        dividend(g, a, b).or_else(|| dividend(g, b, a))
    })
    .also(&["(y / x) x = y", "p (1 / p) = 1"])
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Nonzero),
    // Factors gather in front of what is known later.
    rule("p (q x) = (p q) x", |g, _, [a, b]| {
        let (q, x) = g.product(b)?;
        (g.is_early(a) && g.binding(q) < g.binding(x)).then(|| {
            let factor = g.mul(a, q);
            g.mul(factor, x)
        })
    })
    .also(&[
        "k (p x) = (k p) x",
        "k (m x) = (k m) x",
        "p (k q) = (p k) q",
    ])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range),
    // A link's point needs no product of its own.
    rule("p (q x + r y) = (p q) x + (p r) y", |g, _, [a, b]| {
        if !g.is_early(a) {
            return None;
        }
        match g.node(b) {
            Node::Binary(op @ (Binary::Add | Binary::Sub), first, second) => {
                distribute(g, a, op, [first, second])
            }
            _ => None,
        }
    })
    .also(&[
        "p (q x - r y) = (p q) x - (p r) y",
        "k (m x + p y) = (k m) x + (k p) y",
    ])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range),
];

/// `x` of a quotient `x / y`.
fn dividend(g: &Store, quotient: NodeId, y: NodeId) -> Option<NodeId> {
    let (p, q) = g.quotient(quotient)?;
    (q == y).then_some(p)
}

fn distribute(g: &mut Store, a: NodeId, op: Binary, terms: [NodeId; 2]) -> Option<NodeId> {
    let (p, x) = g.early_factor(terms[0])?;
    let (q, y) = g.early_factor(terms[1])?;
    let (ap, aq) = (g.mul(a, p), g.mul(a, q));
    let (left, right) = (g.mul(ap, x), g.mul(aq, y));
    Some(g.binary(op, left, right))
}
