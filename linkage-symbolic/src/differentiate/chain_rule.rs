//! The chain rule for each operation, forwards and backwards.

use crate::expression::Ex;
use crate::graph::{Node, NodeId};
use crate::operation::{Binary, Ternary, Unary};

/// Applies the chain rule backwards. From the derivative `weight` of a result with respect to an
/// operation it returns, for each operand, the contribution to the derivative with respect to this
/// operand.
pub fn pull_back<'g>(value: Ex<'g>, weight: Ex<'g>) -> Vec<(NodeId, Ex<'g>)> {
    let operands: Vec<NodeId> = value.node().operands().collect();
    let zero = value.number(0.0);
    (0..operands.len())
        .map(|k| {
            let mut rates = vec![zero; operands.len()];
            rates[k] = weight;
            (operands[k], chain_rule(value, &rates))
        })
        .collect()
}

/// The rate of an operation's result from those of its operands.
pub(super) fn chain_rule<'g>(value: Ex<'g>, rates: &[Ex<'g>]) -> Ex<'g> {
    let zero = value.number(0.0);
    if rates.iter().all(|rate| rate.is_zero()) {
        return zero;
    }
    let ex = |id| value.graph().ex(id);
    match value.node() {
        Node::Constant(_) | Node::Symbol(_) => zero,
        Node::Unary(op, a) => unary_rule(op, value, ex(a), rates[0]),
        Node::Binary(op, a, b) => binary_rule(op, value, [a, b].map(ex), [rates[0], rates[1]]),
        Node::Ternary(op, a, b, c) => {
            let rates = [rates[0], rates[1], rates[2]];
            ternary_rule(op, value, [a, b, c].map(ex), rates)
        }
    }
}

/// `y' = f'(a) a'` for `y = f(a)`.
fn unary_rule<'g>(op: Unary, y: Ex<'g>, a: Ex<'g>, da: Ex<'g>) -> Ex<'g> {
    match op {
        Unary::Neg => -da,
        Unary::Abs => a.unary(Unary::Sign) * da,
        Unary::Sqrt => 0.5 * da / y,
        Unary::Sin => a.unary(Unary::Cos) * da,
        Unary::Cos => -(a.unary(Unary::Sin) * da),
        Unary::Tan => (1.0 + y.square()) * da,
        Unary::Asin => arc_rule(a, da),
        Unary::Acos => -arc_rule(a, da),
        Unary::Atan => da / (1.0 + a.square()),
        Unary::Sign | Unary::Round | Unary::Slack | Unary::InverseScale => a.number(0.0),
    }
}

/// `a' / sqrt((1 - a)(1 + a))`
fn arc_rule<'g>(a: Ex<'g>, da: Ex<'g>) -> Ex<'g> {
    let product = (1.0 - a) * (1.0 + a);
    da / product.sqrt()
}

/// The rate of `y`, an operation of `a` and `b`.
fn binary_rule<'g>(op: Binary, y: Ex<'g>, [a, b]: [Ex<'g>; 2], [da, db]: [Ex<'g>; 2]) -> Ex<'g> {
    match op {
        Binary::Add | Binary::Sub => of_rates(op, da, db),
        Binary::Mul => of_rates(op, b, da) + of_rates(op, a, db),
        Binary::Div | Binary::Quotient => (da - y * db) / b,
        Binary::Atan2 => argument_rule([a, b], [da, db]),
        Binary::Hypot => (a * da + b * db) / y,
        Binary::Min => (b - a).select(da, db),
        Binary::Max => (a - b).select(da, db),
    }
}

fn ternary_rule<'g>(
    op: Ternary,
    y: Ex<'g>,
    [a, b, _]: [Ex<'g>; 3],
    [da, db, dc]: [Ex<'g>; 3],
) -> Ex<'g> {
    match op {
        // The number of turns does not change where there is a derivative.
        Ternary::AngleNear => argument_rule([a, b], [da, db]),
        Ternary::Select => a.select(db, dc),
        Ternary::GuardedSqrt => unary_rule(Unary::Sqrt, y, a, da),
    }
}

/// The rate of the argument of `x + i y`.
fn argument_rule<'g>([y, x]: [Ex<'g>; 2], [dy, dx]: [Ex<'g>; 2]) -> Ex<'g> {
    let numerator = x * dy - y * dx;
    numerator / (x.square() + y.square())
}

/// A sum or product with rates: see [`crate::rules::of_rates`].
fn of_rates<'g>(op: Binary, a: Ex<'g>, b: Ex<'g>) -> Ex<'g> {
    let graph = a.graph();
    let value = graph.store_mut().of_rates(op, a.id(), b.id());
    graph.ex(value)
}
