//! Vectors that turn with an angle by the sine pair of its half, where that is computed anyway: `p
//! cos 2x = p - (2 p sin x) sin x` and `p sin 2x = (2 p sin x) cos x`.
//!
//! With a factor that is known before a call this spares the cosine and sine themselves, and `q +
//! p` is known before the call, too. Values are rounded as often as by [double
//! angles](crate::passes).

use crate::expression::rebuild_shared;
use crate::graph::{Binding, Graph, Node, NodeId};
use crate::lookup::Map;
use crate::program::{Binary, Unary};

/// The values `outputs` by halves of angles; `None` where no angle is the double of another.
pub fn by_half_angles(graph: &Graph, outputs: &[NodeId]) -> Option<Vec<NodeId>> {
    let reachable = graph.reachable(outputs);
    let halves = Halves::new(graph, &reachable);
    if halves.halves.is_empty() {
        return None;
    }
    let mut renewed: Map<NodeId, NodeId> = Map::new();
    for id in reachable {
        let new = |x: NodeId| renewed[&x];
        let node = halves
            .product(id)
            .map(|(early, late)| graph.add(early, late));
        let node = node.or_else(|| halves.sum(id));
        let node = node.unwrap_or_else(|| rebuild_shared(graph, id, graph.node(id), new));
        renewed.insert(id, node);
    }
    Some(outputs.iter().map(|output| renewed[output]).collect())
}

struct Halves<'a> {
    graph: &'a Graph,
    /// The half of each angle, and true if the angle is twice the half backward.
    halves: Map<NodeId, (NodeId, bool)>,
}

impl<'a> Halves<'a> {
    fn new(graph: &'a Graph, reachable: &[NodeId]) -> Self {
        let pairs = reachable.iter().filter_map(|&id| match graph.node(id) {
            Node::Unary(Unary::Cos | Unary::Sin, angle) => Some(angle),
            _ => None,
        });
        let angles: Vec<NodeId> = pairs
            .filter(|&x| graph.binding(x) == Binding::Call)
            .collect();
        let multiple = |angle: NodeId| match graph.node(angle) {
            Node::Binary(Binary::Mul, k, x) => graph.constant_value(k).map(|k| (k, x)),
            _ => None,
        };
        // By angle: the last place in the list, and that of the last half of it with its factor.
        let mut indices: Map<NodeId, usize> = Map::new();
        let mut halved: Map<NodeId, (usize, f64)> = Map::new();
        for (index, &half) in angles.iter().enumerate() {
            indices.insert(half, index);
            if let Some((k, angle)) = multiple(half).filter(|(k, _)| k.abs() == 0.5) {
                halved.insert(angle, (index, k));
            }
        }
        let mut halves: Map<NodeId, (NodeId, bool)> = Map::new();
        for &angle in &angles {
            let by_half = halved.get(&angle).copied();
            let by_double = multiple(angle).filter(|(k, _)| k.abs() == 2.0);
            let by_double = by_double.and_then(|(k, half)| Some((*indices.get(&half)?, k)));
            let found = by_double.into_iter().chain(by_half);
            if let Some((index, k)) = found.max_by_key(|(index, _)| *index) {
                halves.insert(angle, (angles[index], k < 0.0));
            }
        }
        // Halves are not halved again.
        let found = angles.iter().filter_map(|angle| {
            let &(half, backward) = halves.get(angle)?;
            (!halves.contains_key(&half)).then_some((*angle, (half, backward)))
        });
        Self {
            graph,
            halves: found.collect(),
        }
    }

    /// Returns the part of `p cos` or `p sin` of an angle with a half that is known before a call,
    /// and the rest.
    fn product(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        let graph = self.graph;
        let Node::Binary(Binary::Mul, p, x) = graph.node(id) else {
            return None;
        };
        let Node::Unary(function @ (Unary::Cos | Unary::Sin), angle) = graph.node(x) else {
            return None;
        };
        let &(half, backward) = self.halves.get(&angle)?;
        if graph.binding(p) == Binding::Call {
            return None;
        }
        let [sin, cos] = [Unary::Sin, Unary::Cos].map(|entry| graph.unary(entry, half));
        let twice = graph.mul(graph.mul(graph.constant(2.0), p), sin);
        Some(match function {
            Unary::Cos => (p, graph.neg(graph.mul(twice, sin))),
            _ => {
                let product = graph.mul(twice, cos);
                let signed = if backward {
                    graph.neg(product)
                } else {
                    product
                };
                (graph.constant(0.0), signed)
            }
        })
    }

    /// The sum of such a product and something that is known before a call.
    fn sum(&self, id: NodeId) -> Option<NodeId> {
        let graph = self.graph;
        let Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) = graph.node(id) else {
            return None;
        };
        let join = |x: NodeId, y: NodeId| graph.binary(op, x, y);
        let is_early = |x: NodeId| graph.binding(x) < Binding::Call;
        let zero = graph.constant(0.0);
        if is_early(a) {
            let (early, late) = self.product(b)?;
            let late = if op == Binary::Sub {
                graph.neg(late)
            } else {
                late
            };
            Some(graph.add(join(a, early), late))
        } else if is_early(b) {
            let (early, late) = self.product(a)?;
            Some(graph.add(join(early, b), join(late, zero)))
        } else {
            None
        }
    }
}
