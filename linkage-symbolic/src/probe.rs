//! Are two expressions equal? By evaluating both at chosen places: sums and products may be written in more ways than
//! constructors can bring to one form.

use std::collections::HashMap;

use crate::graph::{Graph, Node, NodeId, SymbolId};
use crate::interpret::{apply_binary, apply_ternary, apply_unary};

/// Places at which both sides must agree.
const PLACES: u64 = 4;

/// Differences below this share of the larger terms are rounding.
const ROUNDING: f64 = 1e-10;

/// True if two nodes have equal values wherever their symbols are independent, up to rounding. Definitions are not
/// followed.
pub fn agree(graph: &Graph, a: NodeId, b: NodeId) -> bool {
    agree_within(graph, a, b, ROUNDING)
}

/// The same up to a given share of the larger terms.
pub fn agree_within(graph: &Graph, a: NodeId, b: NodeId, share: f64) -> bool {
    a == b || (0..PLACES).all(|place| agree_at(graph, a, b, place, share))
}

fn agree_at(graph: &Graph, a: NodeId, b: NodeId, place: u64, share: f64) -> bool {
    // Each value comes with the size of the terms that it is made of: a small sum of large terms is known less well.
    let mut values: HashMap<NodeId, (f64, f64)> = HashMap::new();
    for id in graph.reachable(&[a, b]) {
        let known = match graph.node(id) {
            Node::Constant(bits) => sized(f64::from_bits(bits)),
            Node::Symbol(symbol) => sized(sample(graph, symbol, place)),
            Node::Unary(op, x) => {
                let (value, size) = values[&x];
                let result = apply_unary(op, value);
                (result, result.abs().max(size * (result / value).abs()))
            }
            Node::Binary(op, x, y) => {
                let ((x, x_size), (y, y_size)) = (values[&x], values[&y]);
                let result = apply_binary(op, x, y);
                let size = match op {
                    crate::program::Binary::Mul => x_size * y_size,
                    crate::program::Binary::Div => x_size / y.abs(),
                    _ => x_size.max(y_size),
                };
                (result, result.abs().max(size))
            }
            Node::Ternary(op, x, y, z) => {
                sized(apply_ternary(op, values[&x].0, values[&y].0, values[&z].0))
            }
        };
        values.insert(id, known);
    }
    let ((a, a_size), (b, b_size)) = (values[&a], values[&b]);
    (a - b).abs() <= share * a_size.max(b_size).max(f64::MIN_POSITIVE)
}

fn sized(value: f64) -> (f64, f64) {
    (value, value.abs())
}

/// A value for each symbol and place; the cosine and the sine of one angle fit each other.
fn sample(graph: &Graph, symbol: SymbolId, place: u64) -> f64 {
    match graph.cosine_of(symbol) {
        Some(cosine) => number(cosine, place).sin(),
        None if graph.is_cosine(symbol) => number(symbol, place).cos(),
        None => number(symbol, place),
    }
}

/// A number in 0.5..1.5, without pattern.
fn number(symbol: SymbolId, place: u64) -> f64 {
    let mut x = (symbol.index() as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        ^ (place + 1).wrapping_mul(0xd1b5_4a32_d192_ed03);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    0.5 + ((x ^ (x >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}
