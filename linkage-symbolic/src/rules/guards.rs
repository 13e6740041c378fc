//! Rules of guards: of roots, and of choices that guard nothing.

use super::functions::FOLD_THREE;
use super::rule::{Assumes, RewriteRule, rule};
use crate::graph::{Binding, Node};
use crate::operation::{Ternary, Unary};

// Nothing is folded: how much rounding takes depends on the numbers that a program runs on.
pub(super) static SLACK: &[RewriteRule<Unary, 1>] = &[
    rule("slack(-x) = slack(x)", |g, _, [a]| {
        let x = g.negated(a)?;
        Some(g.unary(Unary::Slack, x))
    }),
    rule("slack(abs(x)) = slack(x)", |g, _, [a]| match g.node(a) {
        Node::Unary(Unary::Abs, x) => Some(g.unary(Unary::Slack, x)),
        _ => None,
    }),
];

pub(super) static ROOT: &[RewriteRule<Ternary, 3>] = &[
    FOLD_THREE,
    rule(
        "root(k, slack(x), abs(y)) = sqrt(k)",
        |g, _, [q, slack, size]| {
            let forgives = [slack, size].iter().all(|&item| g.is_never_negative(item));
            let q = g.constant_value(q).filter(|&q| q > 0.0 && forgives)?;
            Some(g.constant(q.sqrt()))
        },
    )
    .assumes(Assumes::Finite),
    // What is known before a call is multiplied there, once and for all; of the rest the sign may
    // be known.
    rule(
        "root(x, slack(k), abs(p y)) = root(x, slack(k p), abs(y))",
        |g, op, [q, slack, size]| {
            let Node::Unary(Unary::Slack, unit) = g.node(slack) else {
                return None;
            };
            let product = match g.node(size) {
                Node::Unary(Unary::Abs, product) => product,
                _ => size,
            };
            let (p, y) = match g.product(product) {
                Some(factors) => factors,
                None => (product, g.one()),
            };
            let fits = product != y && g.binding(p) < Binding::Call && g.is_never_negative(size);
            fits.then(|| {
                let unit = g.mul(unit, p);
                let slack = g.unary(Unary::Slack, unit);
                let size = g.abs(y);
                g.ternary(op, q, slack, size)
            })
        },
    )
    .also(&[
        "root(x, slack(k), abs(p) sqrt(y)) = root(x, slack(k abs(p)), sqrt(y))",
        "root(x, slack(k), abs(p)) = root(x, slack(k p), 1)",
    ])
    .assumes(Assumes::Range),
];

pub(super) static GUARD: &[RewriteRule<Ternary, 3>] = &[
    // A root is never negative, so the guard only makes its value NaN where the root is. A value
    // that is computed from the root is that by itself, unless a choice within it passes the root
    // by: formulas that choose have the root on both sides.
    rule(
        "select(root(x, y, y), root(x, y, y) z, root(x, y, y)) = root(x, y, y) z",
        |g, _, [root, value, otherwise]| {
            let idle = root == otherwise
                && matches!(g.node(root), Node::Ternary(Ternary::GuardedSqrt, ..))
                && g.contains(value, root);
            idle.then_some(value)
        },
    )
    .also(&["select(root(p, y, y), root(p, y, y) - x, root(p, y, y)) = root(p, y, y) - x"]),
];
