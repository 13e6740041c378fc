//! Rules of sums and differences.

use super::functions::FOLD_TWO;
use super::rule::{Assumes, Changes, RewriteRule, rule};
use crate::graph::{Node, NodeId, Store};
use crate::operation::{Binary, Unary};

pub(super) static SUM: &[RewriteRule<Binary, 2>] = &[
    // -0 + 0 is 0.
    rule("0 + x = x", |g, _, [a, b]| g.is_zero(a).then_some(b)).changes(Changes::SignOfZero),
    rule("x + 0 = x", |g, _, [a, b]| g.is_zero(b).then_some(a)).changes(Changes::SignOfZero),
    rule("k x + (-k) x = 0", |g, _, [a, b]| {
        let (p, q, _) = g.like_terms(a, b)?;
        (p + q == 0.0).then(|| g.zero())
    })
    .also(&["x + (-x) = 0", "-(x y) + x y = 0"])
    .assumes(Assumes::Range),
    rule("k x + m x = (k + m) x", |g, _, [a, b]| {
        let (p, q, x) = g.like_terms(a, b)?;
        Some(multiple(g, p + q, x))
    })
    .also(&[
        "x + x = 2 x",
        "x + k x = (1 + k) x",
        "k x + (-x) = (k - 1) x",
    ])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range),
    rule("x + (-y) = x - y", |g, _, [a, b]| {
        let y = g.negative_term(b)?;
        Some(g.sub(a, y))
    })
    .also(&["x + (-k) = x - k", "x + (-p) y = x - p y"]),
    rule("(-y) + x = x - y", |g, _, [a, b]| {
        let x = g.negative_term(a)?;
        Some(g.sub(b, x))
    })
    .also(&["(-k) + x = x - k", "(-p) y + x = x - p y"]),
    rule("sin(x) sin(x) + cos(x) cos(x) = 1", |g, _, [a, b]| {
        is_unit(g, a, b).then(|| g.one())
    })
    .also(&["cos(x) cos(x) + sin(x) sin(x) = 1"])
    .changes(Changes::Roundings(-4))
    .assumes(Assumes::Finite),
    rule("(x - y) + y = x", |g, _, [a, b]| {
        minuend(g, a, b).or_else(|| minuend(g, b, a))
    })
    .also(&["y + (x - y) = x"])
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Range),
    FOLD_TWO,
];

pub(super) static DIFFERENCE: &[RewriteRule<Binary, 2>] = &[
    rule("x - 0 = x", |g, _, [a, b]| g.is_zero(b).then_some(a)),
    // 0 - 0 is 0.
    rule("0 - x = -x", |g, _, [a, b]| g.is_zero(a).then(|| g.neg(b))).changes(Changes::SignOfZero),
    rule("k x - k x = 0", |g, _, [a, b]| {
        let (p, q, _) = g.like_terms(a, b)?;
        (p - q == 0.0).then(|| g.zero())
    })
    .also(&["x - x = 0", "p x - p x = 0"])
    .assumes(Assumes::Range),
    rule("k x - m x = (k - m) x", |g, _, [a, b]| {
        let (p, q, x) = g.like_terms(a, b)?;
        Some(multiple(g, p - q, x))
    })
    .also(&["x - (-x) = 2 x", "k x - x = (k - 1) x"])
    .changes(Changes::Roundings(0))
    .assumes(Assumes::Range),
    FOLD_TWO,
    rule("x - (-y) = x + y", |g, _, [a, b]| {
        let y = g.negative_term(b)?;
        Some(g.add(a, y))
    })
    .also(&["x - (-k) = x + k", "x - (-p) y = x + p y"]),
    // -0 + 0 is 0.
    rule("(-x) - y = -(x + y)", |g, _, [a, b]| {
        let x = g.negative_term(a)?;
        let sum = g.add(x, b);
        Some(g.neg(sum))
    })
    .also(&["(-k) - x = -(k + x)", "(-p) x - y = -(p x + y)"])
    .changes(Changes::SignOfZero),
    rule("(x + y) - x = y", |g, _, [a, b]| match g.node(a) {
        Node::Binary(Binary::Add, p, q) => other(p, q, b),
        _ => None,
    })
    .also(&["(x + y) - y = x"])
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Range),
    rule("(x - y) - x = -y", |g, _, [a, b]| match g.node(a) {
        Node::Binary(Binary::Sub, p, q) if p == b => Some(g.neg(q)),
        _ => None,
    })
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Range),
    rule("x - (x + y) = -y", |g, _, [a, b]| match g.node(b) {
        Node::Binary(Binary::Add, p, q) => other(p, q, a).map(|rest| g.neg(rest)),
        _ => None,
    })
    .also(&["y - (x + y) = -x"])
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Range),
    rule("x - (x - y) = y", |g, _, [a, b]| match g.node(b) {
        Node::Binary(Binary::Sub, p, q) if p == a => Some(q),
        _ => None,
    })
    .changes(Changes::Roundings(-2))
    .assumes(Assumes::Range),
    // A difference and its negative are one node and a sign, which the next sum or product absorbs.
    // The older operand stands first.
    rule("y - x = -(x - y)", |g, op, [a, b]| {
        (b < a).then(|| {
            let difference = g.intern(Node::Binary(op, b, a));
            g.intern(Node::Unary(Unary::Neg, difference))
        })
    })
    .changes(Changes::SignOfZero),
];

fn multiple(g: &mut Store, factor: f64, x: NodeId) -> NodeId {
    let factor = g.constant(factor);
    g.mul(factor, x)
}

/// Returns true if two terms are the squares of an angle's sine and cosine.
fn is_unit(g: &Store, a: NodeId, b: NodeId) -> bool {
    let squared = |term| {
        let (x, y) = g.product(term)?;
        (x == y).then(|| g.node(x))
    };
    let (Some(a), Some(b)) = (squared(a), squared(b)) else {
        return false;
    };
    match (a, b) {
        (Node::Unary(Unary::Sin, x), Node::Unary(Unary::Cos, y))
        | (Node::Unary(Unary::Cos, x), Node::Unary(Unary::Sin, y)) => x == y,
        _ => false,
    }
}

/// `x` of a difference `x - y`.
fn minuend(g: &Store, difference: NodeId, y: NodeId) -> Option<NodeId> {
    match g.node(difference) {
        Node::Binary(Binary::Sub, p, q) if q == y => Some(p),
        _ => None,
    }
}

/// Returns the other one of two operands.
pub(super) fn other(p: NodeId, q: NodeId, x: NodeId) -> Option<NodeId> {
    match x {
        _ if x == p => Some(q),
        _ if x == q => Some(p),
        _ => None,
    }
}
