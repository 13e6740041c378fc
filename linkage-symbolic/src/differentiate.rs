//! Derivatives of graph nodes.

use std::collections::HashMap;

use crate::graph::{Binding, Graph, Node, NodeId, SymbolId};
use crate::program::{Binary, Ternary, Unary};

/// Derivatives already known: of a node, by a symbol.
pub type DerivativeMemo = HashMap<(NodeId, SymbolId), NodeId>;

/// Who knows the derivatives of symbols: parameters and inputs are independent, the solution of a loop follows the
/// implicit function theorem.
pub trait Calculus {
    /// The graph that derivatives are built in.
    fn graph(&mut self) -> &mut Graph;
    /// Derivatives already known under these rules.
    fn memo(&mut self) -> &mut DerivativeMemo;
    /// The derivative of one symbol by another.
    fn symbol_derivative(&mut self, symbol: SymbolId, variable: SymbolId) -> NodeId;
}

/// The derivative of `root` by `variable`.
pub fn differentiate<C: Calculus + ?Sized>(
    calculus: &mut C,
    root: NodeId,
    variable: SymbolId,
) -> NodeId {
    let mut stack = vec![root];
    while let Some(&id) = stack.last() {
        if calculus.memo().contains_key(&(id, variable)) {
            stack.pop();
            continue;
        }
        let node = calculus.graph().node(id);
        let waiting = stack.len();
        for operand in node.operands() {
            if !calculus.memo().contains_key(&(operand, variable)) {
                stack.push(operand);
            }
        }
        if stack.len() > waiting {
            continue;
        }
        let derivative = match node {
            Node::Constant(_) => calculus.graph().zero(),
            Node::Symbol(symbol) if symbol == variable => calculus.graph().one(),
            Node::Symbol(symbol) => calculus.symbol_derivative(symbol, variable),
            _ => {
                let known = |c: &mut C, x| c.memo()[&(x, variable)];
                let inner: Vec<NodeId> = node.operands().map(|x| known(calculus, x)).collect();
                chain_rule(calculus.graph(), id, node, &inner)
            }
        };
        calculus.memo().insert((id, variable), derivative);
        stack.pop();
    }
    calculus.memo()[&(root, variable)]
}

/// The chain rule backwards: from the derivative `weight` of a result by an operation, what each of the operation's operands contributes
/// to the result's derivatives by them.
pub fn pull_back(graph: &mut Graph, id: NodeId, weight: NodeId) -> Vec<(NodeId, NodeId)> {
    let node = graph.node(id);
    let operands: Vec<NodeId> = node.operands().collect();
    let zero = graph.zero();
    (0..operands.len())
        .map(|k| {
            let mut inner = vec![zero; operands.len()];
            inner[k] = weight;
            (operands[k], chain_rule(graph, id, node, &inner))
        })
        .collect()
}

/// The derivative of an operation from those of its operands.
fn chain_rule(g: &mut Graph, id: NodeId, node: Node, inner: &[NodeId]) -> NodeId {
    if inner.iter().all(|&d| g.is_zero(d)) {
        return g.zero();
    }
    match node {
        Node::Constant(_) | Node::Symbol(_) => g.zero(),
        Node::Unary(op, a) => unary_rule(g, id, op, a, inner[0]),
        Node::Binary(op, a, b) => binary_rule(g, id, op, [a, b], [inner[0], inner[1]]),
        Node::Ternary(Ternary::AngleNear, y, x, _) => argument_rule(g, y, x, inner[0], inner[1]),
        Node::Ternary(Ternary::Select, s, ..) => g.ternary(Ternary::Select, s, inner[1], inner[2]),
    }
}

fn unary_rule(g: &mut Graph, id: NodeId, op: Unary, a: NodeId, da: NodeId) -> NodeId {
    match op {
        Unary::Neg => g.neg(da),
        Unary::Abs => {
            let sign = g.unary(Unary::Sign, a);
            g.mul(sign, da)
        }
        Unary::Sqrt => {
            let half = g.constant(0.5);
            let numerator = g.mul(half, da);
            g.div(numerator, id)
        }
        Unary::Sin => {
            let cos = g.unary(Unary::Cos, a);
            g.mul(cos, da)
        }
        Unary::Cos => {
            let sin = g.unary(Unary::Sin, a);
            let product = g.mul(sin, da);
            g.neg(product)
        }
        Unary::Tan => {
            let one = g.one();
            let square = g.square(id);
            let slope = g.add(one, square);
            g.mul(slope, da)
        }
        Unary::Asin => arc_rule(g, a, da),
        Unary::Acos => {
            let slope = arc_rule(g, a, da);
            g.neg(slope)
        }
        Unary::Atan => {
            let one = g.one();
            let square = g.square(a);
            let sum = g.add(one, square);
            g.div(da, sum)
        }
        Unary::Sign | Unary::InverseScale => g.zero(),
    }
}

/// `da / sqrt((1 - a)(1 + a))`
fn arc_rule(g: &mut Graph, a: NodeId, da: NodeId) -> NodeId {
    let one = g.one();
    let below = g.sub(one, a);
    let above = g.add(one, a);
    let product = g.mul(below, above);
    let root = g.sqrt(product);
    g.div(da, root)
}

fn binary_rule(
    g: &mut Graph,
    id: NodeId,
    op: Binary,
    [a, b]: [NodeId; 2],
    [da, db]: [NodeId; 2],
) -> NodeId {
    match op {
        Binary::Add | Binary::Sub => rate_times_sum(g, op, da, db),
        Binary::Mul => {
            let left = times_rate(g, b, da);
            let right = times_rate(g, a, db);
            g.add(left, right)
        }
        Binary::Div => {
            let back = g.mul(id, db);
            let numerator = g.sub(da, back);
            g.div(numerator, b)
        }
        Binary::Atan2 => argument_rule(g, a, b, da, db),
        Binary::Hypot => {
            let left = g.mul(a, da);
            let right = g.mul(b, db);
            let numerator = g.add(left, right);
            g.div(numerator, id)
        }
        Binary::Min | Binary::Max => {
            let (first, second) = if op == Binary::Min { (b, a) } else { (a, b) };
            let prefer_a = g.sub(first, second);
            g.ternary(Ternary::Select, prefer_a, da, db)
        }
        Binary::Root => unary_rule(g, id, Unary::Sqrt, a, da),
    }
}

/// `p (r x)` as `r (p x)` where `p x` is known already: the vector of a link, whose direction `x` is.
fn times_rate(g: &mut Graph, p: NodeId, derivative: NodeId) -> NodeId {
    let mut factors = factors(g, derivative);
    let known = factors
        .iter()
        .enumerate()
        .find_map(|(place, &x)| Some((place, g.known_product(p, x)?)));
    match known {
        Some((place, vector)) if factors.len() > 1 => {
            factors[place] = vector;
            product(g, factors)
        }
        _ => g.mul(p, derivative),
    }
}

fn product(g: &mut Graph, factors: Vec<NodeId>) -> NodeId {
    let one = g.one();
    factors
        .into_iter()
        .rev()
        .fold(one, |product, x| g.mul(x, product))
}

/// `r x + r y` as `r (x + y)`: where vectors turn with one angle, `x + y` is mostly a component of their sum that is
/// known already.
fn rate_times_sum(g: &mut Graph, op: Binary, a: NodeId, b: NodeId) -> NodeId {
    let (mut left, mut right) = (factors(g, a), factors(g, b));
    let is_common = |x: &&NodeId| g.binding(**x) == Binding::Call && right.contains(x);
    let Some(rate) = left.iter().find(is_common).copied() else {
        return g.binary(op, a, b);
    };
    for list in [&mut left, &mut right] {
        let place = list.iter().position(|&x| x == rate);
        place.map(|place| list.remove(place));
    }
    let [left, right] = [left, right].map(|factors| product(g, factors));
    let sum = rate_times_sum(g, op, left, right);
    g.mul(rate, sum)
}

/// The factors of nested products, signs as -1.
fn factors(g: &mut Graph, id: NodeId) -> Vec<NodeId> {
    match g.node(id) {
        Node::Unary(Unary::Neg, x) => {
            let sign = g.constant(-1.0);
            let mut factors = factors(g, x);
            factors.push(sign);
            factors
        }
        Node::Binary(Binary::Mul, x, y) => {
            let mut factors = factors(g, x);
            factors.extend(self::factors(g, y));
            factors
        }
        _ => vec![id],
    }
}

/// The derivative of the argument of `x + i y`.
fn argument_rule(g: &mut Graph, y: NodeId, x: NodeId, dy: NodeId, dx: NodeId) -> NodeId {
    let left = g.mul(x, dy);
    let right = g.mul(y, dx);
    let numerator = g.sub(left, right);
    let x2 = g.square(x);
    let y2 = g.square(y);
    let square = g.add(x2, y2);
    g.div(numerator, square)
}
