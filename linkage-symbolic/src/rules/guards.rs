//! The rule of guards that guard nothing.

use super::{Rule, rule};
use crate::graph::Node;
use crate::operation::{Binary, Ternary};

pub(super) static GUARD: &[Rule<Ternary, 3>] = &[
    // A root is never negative, so the guard only makes its value NaN where the root is. A value that is computed from the root is
    // that by itself, unless a choice within it passes the root by: formulas that choose have the root on both sides.
    rule(
        "select(root(x, y), root(x, y) z, root(x, y)) = root(x, y) z",
        |g, _, [root, value, otherwise]| {
            let idle = root == otherwise
                && matches!(g.node(root), Node::Binary(Binary::Root, ..))
                && g.contains(value, root);
            idle.then_some(value)
        },
    )
    .also(&["select(root(p, y), root(p, y) - x, root(p, y)) = root(p, y) - x"]),
];
