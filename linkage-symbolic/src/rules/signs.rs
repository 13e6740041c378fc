//! Rules of signs and absolute values.

use super::functions::FOLD_ONE;
use super::rule::{Changes, RewriteRule, rule};
use crate::operation::Unary;

pub(super) static NEGATIVE: &[RewriteRule<Unary, 1>] = &[
    FOLD_ONE,
    rule("-(-x) = x", |g, _, [a]| g.negated(a)),
    // The sign goes where it costs nothing: into what is computed earlier.
    rule("-(p x) = (-p) x", |g, _, [a]| {
        let (p, x) = g.product(a)?;
        (g.binding(p) < g.binding(x)).then(|| {
            let p = g.neg(p);
            g.plain_product(p, x)
        })
    })
    .also(&["-(k x) = (-k) x", "-(k p) = (-k) p"]),
];

pub(super) static ABSOLUTE: &[RewriteRule<Unary, 1>] = &[
    FOLD_ONE,
    rule("abs(-x) = abs(x)", |g, _, [a]| {
        let x = g.negative_term(a)?;
        Some(g.abs(x))
    })
    .also(&["abs((-p) x) = abs(p x)", "abs((-k) p) = abs(k p)"]),
    // The root of -0 is -0.
    rule("abs(sqrt(x)) = sqrt(x)", |g, _, [a]| {
        g.is_never_negative(a).then_some(a)
    })
    .also(&[
        "abs(abs(x)) = abs(x)",
        "abs(slack(x)) = slack(x)",
        "abs(inverse_scale(x)) = inverse_scale(x)",
        "abs(hypot(x, y)) = hypot(x, y)",
        "abs(root(x, y, z)) = root(x, y, z)",
        "abs(x x) = x x",
        "abs(x x + y y) = x x + y y",
        "abs(abs(x) sqrt(y)) = abs(x) sqrt(y)",
    ])
    .changes(Changes::SignOfZero),
];
