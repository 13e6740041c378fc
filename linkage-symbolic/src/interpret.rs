//! Programs and graphs on plain numbers: the oracle for the generated code, and what closes the loops at compile time.

use std::collections::HashMap;
use std::f64::consts::TAU;

use crate::graph::{Graph, Node, NodeId};
use crate::program::{Binary, Fused, Instruction, Program, Source, Ternary, Unary};

/// One unary operation.
pub fn apply_unary(op: Unary, a: f64) -> f64 {
    match op {
        Unary::Neg => -a,
        Unary::Abs => a.abs(),
        Unary::Sqrt => a.sqrt(),
        Unary::Sin => a.sin(),
        Unary::Cos => a.cos(),
        Unary::Tan => a.tan(),
        Unary::Asin => a.asin(),
        Unary::Acos => a.acos(),
        Unary::Atan => a.atan(),
        Unary::Sign if a.is_nan() => a,
        Unary::Sign => {
            if a >= 0.0 {
                1.0
            } else {
                -1.0
            }
        }
        Unary::InverseScale => inverse_scale(a),
    }
}

/// One binary operation.
pub fn apply_binary(op: Binary, a: f64, b: f64) -> f64 {
    match op {
        Binary::Add => a + b,
        Binary::Sub => a - b,
        Binary::Mul => a * b,
        Binary::Div => a / b,
        Binary::Atan2 => a.atan2(b),
        Binary::Hypot => a.hypot(b),
        Binary::Min | Binary::Max if a.is_nan() || b.is_nan() => f64::NAN,
        Binary::Min => a.min(b),
        Binary::Max => a.max(b),
        Binary::Root => root(a, b),
    }
}

/// One ternary operation.
pub fn apply_ternary(op: Ternary, a: f64, b: f64, c: f64) -> f64 {
    match op {
        Ternary::AngleNear => {
            let angle = a.atan2(b);
            angle + TAU * ((c - angle) / TAU).round_ties_even()
        }
        Ternary::Select if a.is_nan() => a,
        Ternary::Select => {
            if a >= 0.0 {
                b
            } else {
                c
            }
        }
    }
}

/// A product and a sum, each rounded.
pub fn apply_fused(op: Fused, a: f64, b: f64, c: f64) -> f64 {
    match op {
        Fused::MulAdd => a * b + c,
        Fused::MulSub => a * b - c,
        Fused::SubMul => c - a * b,
    }
}

/// See [`Unary::InverseScale`].
fn inverse_scale(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    f64::from_bits((2046 - exponent.clamp(1, 2045)) << 52)
}

/// See [`Binary::Root`].
fn root(q: f64, scale: f64) -> f64 {
    if q > 0.0 {
        q.sqrt()
    } else if scale.is_finite() && q >= -8.0 * f64::EPSILON * scale.abs() {
        0.0
    } else {
        f64::NAN
    }
}

/// Runs a program; `load` supplies parameters, inputs, modes and so on. Returns the outputs.
pub fn run(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    let mut values = Vec::new();
    run_steps(program, 0, program.instructions.len(), &mut values, load);
    program
        .outputs
        .iter()
        .map(|output| values[output.0])
        .collect()
}

/// Runs the instructions `from..to`; `values` holds the results of those before.
pub fn run_steps(
    program: &Program,
    from: usize,
    to: usize,
    values: &mut Vec<f64>,
    load: impl Fn(Source) -> f64,
) {
    values.truncate(from);
    for instruction in &program.instructions[from..to] {
        let value = match *instruction {
            Instruction::Constant(value) => value,
            Instruction::Load(source) => load(source),
            Instruction::Unary(op, a) => apply_unary(op, values[a.0]),
            Instruction::Binary(op, a, b) => apply_binary(op, values[a.0], values[b.0]),
            Instruction::Ternary(op, a, b, c) => {
                apply_ternary(op, values[a.0], values[b.0], values[c.0])
            }
            Instruction::Fused(op, a, b, c) => {
                apply_fused(op, values[a.0], values[b.0], values[c.0])
            }
        };
        values.push(value);
    }
}

/// Evaluates nodes of a graph, following definitions. Symbols that have neither source nor definition are NaN.
pub fn evaluate(graph: &Graph, roots: &[NodeId], load: impl Fn(Source) -> f64) -> Vec<f64> {
    let mut memo: HashMap<NodeId, f64> = HashMap::new();
    let mut stack: Vec<NodeId> = roots.to_vec();
    while let Some(&id) = stack.last() {
        if memo.contains_key(&id) {
            stack.pop();
            continue;
        }
        let below = dependencies(graph, id);
        let waiting = stack.len();
        stack.extend(below.iter().filter(|x| !memo.contains_key(x)));
        if stack.len() > waiting {
            continue;
        }
        let value = match graph.node(id) {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Symbol(symbol) => {
                let symbol = graph.symbol(symbol);
                match (symbol.definition, symbol.source) {
                    (Some(definition), _) => memo[&definition],
                    (None, Some(source)) => load(source),
                    (None, None) => f64::NAN,
                }
            }
            Node::Unary(op, a) => apply_unary(op, memo[&a]),
            Node::Binary(op, a, b) => apply_binary(op, memo[&a], memo[&b]),
            Node::Ternary(op, a, b, c) => apply_ternary(op, memo[&a], memo[&b], memo[&c]),
        };
        memo.insert(id, value);
        stack.pop();
    }
    roots.iter().map(|root| memo[root]).collect()
}

/// What must be known before `id`: its operands, or the definition of a symbol.
pub(crate) fn dependencies(graph: &Graph, id: NodeId) -> Vec<NodeId> {
    match graph.node(id) {
        Node::Symbol(symbol) => graph.symbol(symbol).definition.into_iter().collect(),
        node => node.operands().collect(),
    }
}
