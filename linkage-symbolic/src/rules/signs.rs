//! Rules of signs and absolute values.

use super::functions::FOLD_ONE;
use super::{Changes, Rule, rule};
use crate::graph::Node;
use crate::operation::{Binary, Unary};

pub(super) static NEGATIVE: &[Rule<Unary, 1>] = &[
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

pub(super) static ABSOLUTE: &[Rule<Unary, 1>] = &[
    FOLD_ONE,
    rule("abs(-x) = abs(x)", |g, _, [a]| {
        let x = g.negative_term(a)?;
        Some(g.abs(x))
    })
    .also(&["abs((-p) x) = abs(p x)", "abs((-k) p) = abs(k p)"]),
    // The root of -0 is -0.
    rule("abs(sqrt(x)) = sqrt(x)", |g, _, [a]| {
        let never_negative = matches!(
            g.node(a),
            Node::Unary(Unary::Abs | Unary::Sqrt | Unary::InverseScale, _)
                | Node::Binary(Binary::Hypot | Binary::Root, ..)
        );
        never_negative.then_some(a)
    })
    .also(&[
        "abs(abs(x)) = abs(x)",
        "abs(inverse_scale(x)) = inverse_scale(x)",
        "abs(hypot(x, y)) = hypot(x, y)",
        "abs(root(x, y)) = root(x, y)",
    ])
    .changes(Changes::SignOfZero),
];
