//! Rules of functions, and of all operations of numbers.

use super::rule::{Assumes, Changes, RewriteRule, rule};
use crate::operation::{Binary, Ternary, Unary};

// Folding: there is no constant -0.

pub(super) const FOLD_ONE: RewriteRule<Unary, 1> = rule("f(k) is a number", |g, op: Unary, [a]| {
    let value = op.apply([g.constant_value(a)?]);
    Some(g.constant(value))
})
.changes(Changes::SignOfZero);

pub(super) const FOLD_TWO: RewriteRule<Binary, 2> =
    rule("f(k, m) is a number", |g, op: Binary, [a, b]| {
        let value = op.apply([g.constant_value(a)?, g.constant_value(b)?]);
        Some(g.constant(value))
    })
    .changes(Changes::SignOfZero);

pub(super) const FOLD_THREE: RewriteRule<Ternary, 3> =
    rule("f(k, m, k) is a number", |g, op: Ternary, operands| {
        let [Some(a), Some(b), Some(c)] = operands.map(|x| g.constant_value(x)) else {
            return None;
        };
        Some(g.constant(op.apply([a, b, c])))
    })
    .changes(Changes::SignOfZero);

pub(super) static OF_ONE: &[RewriteRule<Unary, 1>] = &[FOLD_ONE];

pub(super) static OF_TWO: &[RewriteRule<Binary, 2>] = &[FOLD_TWO];

pub(super) static OF_THREE: &[RewriteRule<Ternary, 3>] = &[FOLD_THREE];

pub(super) static ODD: &[RewriteRule<Unary, 1>] = &[
    FOLD_ONE,
    rule("f(-x) = -f(x)", |g, op, [a]| {
        let x = g.negated(a)?;
        let value = g.unary(op, x);
        Some(g.neg(value))
    }),
];

pub(super) static EVEN: &[RewriteRule<Unary, 1>] = &[
    FOLD_ONE,
    rule("f(-x) = f(x)", |g, op, [a]| {
        let x = g.negated(a)?;
        Some(g.unary(op, x))
    }),
];

pub(super) static ROOT: &[RewriteRule<Unary, 1>] = &[
    FOLD_ONE,
    // The root of a rounded square is rounded to where it came from.
    rule("sqrt(x x) = abs(x)", |g, _, [a]| {
        let (x, y) = g.product(a)?;
        (x == y).then(|| g.abs(x))
    })
    .assumes(Assumes::Range),
];

pub(super) static HYPOT: &[RewriteRule<Binary, 2>] = &[
    rule("hypot(0, x) = abs(x)", |g, _, [a, b]| {
        g.is_zero(a).then(|| g.abs(b))
    }),
    rule("hypot(x, 0) = abs(x)", |g, _, [a, b]| {
        g.is_zero(b).then(|| g.abs(a))
    }),
    rule("hypot(-x, y) = hypot(x, y)", |g, op, [a, b]| {
        match (g.negated(a), g.negated(b)) {
            (None, None) => None,
            (x, y) => Some(g.binary(op, x.unwrap_or(a), y.unwrap_or(b))),
        }
    })
    .also(&[
        "hypot(x, -y) = hypot(x, y)",
        "hypot(-x, -y) = hypot(x, y)",
        "hypot(x, -k) = hypot(x, k)",
    ]),
    FOLD_TWO,
];

pub(super) static SELECT: &[RewriteRule<Ternary, 3>] = &[
    FOLD_THREE,
    rule("select(1, x, y) = x", |g, _, [a, b, c]| {
        let s = g.constant_value(a)?;
        Some(match s {
            _ if s.is_nan() => a,
            _ if s >= 0.0 => b,
            _ => c,
        })
    })
    .also(&[
        "select(0, x, y) = x",
        "select(-1, x, y) = y",
        "select(nan, x, y) = nan",
    ]),
    // Both sides fail where a position does: it is their own values that say so.
    rule("select(x, y, y) = y", |_, _, [_, b, c]| {
        (b == c).then_some(b)
    })
    .assumes(Assumes::Number),
];
