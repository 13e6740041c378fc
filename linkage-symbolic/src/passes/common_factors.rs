//! Sums that are multiples of each other by something known early: `r c x + r s y` is `r (c x + s
//! y)`.
//!
//! Constructors gather factors in front of each term, so that a lone vector that turns with a link
//! costs nothing for its length. Where the same direction occurs with several lengths, as it does
//! among sensitivities, one sum and a product for each further length are cheaper. Nothing is
//! divided: a length may be 0.
//!
//! A multiple has as many roundings as the sum had that it stands for. Divisors among the factors
//! add one, as they are inverted; numbers add three at most, for their quotients are rounded. As in
//! [`crate::rules`], results in between must be in range, and no NaN is lost.

use std::collections::BTreeMap;

use crate::lookup::Map;

use crate::expression::rebuild;
use crate::graph::{Binding, Graph, Node, NodeId, NodeNumbers};
use crate::program::{Binary, Unary};

/// A product as a number and its other factors in order; the number is never 0.
#[derive(Clone, Debug)]
struct Factors {
    number: f64,
    nodes: Vec<NodeId>,
}

/// The common part of multiples of one sum: both terms without their common factor, the first with
/// the number 1.
type Base = ([NodeId; 2], [Vec<NodeId>; 2], u64);

/// The values `outputs` with multiples of the same sum computed as such.
pub fn share_common_factors(graph: &Graph, outputs: &[NodeId]) -> Vec<NodeId> {
    let reachable = graph.reachable(outputs);
    let mut members: BTreeMap<Base, Vec<(NodeId, Factors)>> = BTreeMap::new();
    for &id in &reachable {
        if let Some((base, common)) = sum_of_terms(graph, id) {
            members.entry(base).or_default().push((id, common));
        }
    }
    let mut multiples: Map<NodeId, (NodeId, Factors)> = Map::new();
    for group in members.values() {
        let least = group.iter().min_by_key(|(_, other)| other.nodes.len());
        for (id, common) in group {
            if let Some((first, divisor)) = least
                && first != id
                && let Some(ratio) = common.over(divisor)
            {
                multiples.insert(*id, (*first, ratio));
            }
        }
    }
    if multiples.is_empty() {
        return outputs.to_vec();
    }
    let mut renewed = NodeNumbers::new(graph.len());
    for id in reachable {
        let node = graph.node(id);
        let new = match multiples.get(&id) {
            None => rebuild(graph, id, node, |x| renewed.node(x)),
            Some((first, ratio)) => {
                // It may stand behind its multiple, but both are made of the same.
                let sum = renew_sum(graph, *first, &renewed);
                ratio.times(graph, sum)
            }
        };
        renewed.set(id, new.index());
    }
    outputs.iter().map(|output| renewed.node(*output)).collect()
}

/// A sum of two terms of factors known early and values known late, as a base and its multiple.
fn sum_of_terms(graph: &Graph, id: NodeId) -> Option<(Base, Factors)> {
    let Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) = graph.node(id) else {
        return None;
    };
    let (first, x) = term(graph, a)?;
    let (mut second, y) = term(graph, b)?;
    if op == Binary::Sub {
        second.number = -second.number;
    }
    let [(first, x), (second, y)] = match x < y {
        true => [(first, x), (second, y)],
        false => [(second, y), (first, x)],
    };
    let (shared, rests) = split(first.nodes, second.nodes);
    let common = Factors {
        number: first.number,
        nodes: shared,
    };
    let ratio = second.number / first.number;
    if !ratio.is_normal() {
        return None;
    }
    Some((([x, y], rests, ratio.to_bits()), common))
}

/// `p` and `x` of a term `p x`.
fn term(graph: &Graph, id: NodeId) -> Option<(Factors, NodeId)> {
    let (p, x) = graph.store().product(id)?;
    let split_by_time = graph.binding(p) < Binding::Call && graph.binding(x) == Binding::Call;
    let mut factors = Factors {
        number: 1.0,
        nodes: Vec::new(),
    };
    factors.gather(graph, p);
    factors.nodes.sort_unstable();
    (split_by_time && factors.number.is_normal()).then_some((factors, x))
}

/// Returns the common part of two sorted lists, and the rest of each.
fn split(a: Vec<NodeId>, mut b: Vec<NodeId>) -> (Vec<NodeId>, [Vec<NodeId>; 2]) {
    let (mut shared, mut rest) = (Vec::new(), Vec::new());
    for x in a {
        match b.iter().position(|&y| y == x) {
            Some(index) => shared.push(b.remove(index)),
            None => rest.push(x),
        }
    }
    (shared, [rest, b])
}

impl Factors {
    fn gather(&mut self, graph: &Graph, id: NodeId) {
        match graph.node(id) {
            Node::Constant(bits) => self.number *= f64::from_bits(bits),
            Node::Unary(Unary::Neg, x) => {
                self.number = -self.number;
                self.gather(graph, x);
            }
            Node::Binary(Binary::Mul, x, y) => {
                self.gather(graph, x);
                self.gather(graph, y);
            }
            Node::Binary(Binary::Div, x, y) if !graph.store().is_one(x) => {
                self.gather(graph, x);
                let one = graph.one();
                let inverse = graph.div(one, y);
                self.nodes.push(inverse);
            }
            _ => self.nodes.push(id),
        }
    }

    /// `self / other`, where that is a product.
    fn over(&self, other: &Self) -> Option<Self> {
        let (_, [nodes, missing]) = split(self.nodes.clone(), other.nodes.clone());
        let number = self.number / other.number;
        (missing.is_empty() && number.is_normal()).then_some(Self { number, nodes })
    }

    /// `self * sum`, not distributed over the terms.
    fn times(&self, graph: &Graph, sum: NodeId) -> NodeId {
        let number = graph.constant(self.number);
        let factor = self
            .nodes
            .iter()
            .fold(number, |product, &x| graph.mul(product, x));
        if graph.constant_value(factor).is_some_and(|x| x.abs() == 1.0) {
            return graph.mul(factor, sum);
        }
        graph.store_mut().plain_product(factor, sum)
    }
}

/// A sum of two terms of renewed values.
fn renew_sum(graph: &Graph, id: NodeId, renewed: &NodeNumbers) -> NodeId {
    let Node::Binary(op, a, b) = graph.node(id) else {
        unreachable!("a sum");
    };
    let [a, b] = [a, b].map(|term| {
        let (p, x) = graph.store().product(term).expect("a term");
        graph.mul(p, renewed.node(x))
    });
    graph.binary(op, a, b)
}
