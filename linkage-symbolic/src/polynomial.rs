//! An expression as a polynomial in chosen symbols: how the solver sees a loop whatever way it was written.

use std::collections::{BTreeMap, HashMap};

use crate::graph::{Graph, Node, NodeId, SymbolId};
use crate::program::{Binary, Unary};

/// Exponents of the chosen symbols, in their order.
pub type Monomial = Vec<u8>;

/// Coefficients, free of the chosen symbols and never the constant 0, by monomial.
pub type Polynomial = BTreeMap<Monomial, NodeId>;

/// Higher total degrees are of no use to any solver.
const MAX_DEGREE: u8 = 4;

/// `root` as a polynomial in `symbols`; `None` if it is none. `unit_pairs` are the positions in `symbols` of the cosine
/// and sine of one angle; even powers of the sine are expressed by the cosine, so that `c^2 + s^2` is 1.
pub fn collect(
    graph: &Graph,
    root: NodeId,
    symbols: &[SymbolId],
    unit_pairs: &[(usize, usize)],
) -> Option<Polynomial> {
    let mut known: HashMap<NodeId, Polynomial> = HashMap::new();
    let nodes = graph.reachable(&[root]);
    let free = vec![0; symbols.len()];
    // Nodes without chosen symbols are coefficients as they stand and need no entry.
    let of = |known: &HashMap<NodeId, Polynomial>, id: NodeId| {
        known
            .get(&id)
            .cloned()
            .unwrap_or_else(|| Polynomial::from([(free.clone(), id)]))
    };
    for id in nodes {
        let node = graph.node(id);
        let polynomial = match node {
            Node::Constant(_) => continue,
            Node::Symbol(symbol) => match symbols.iter().position(|&s| s == symbol) {
                None => continue,
                Some(place) => {
                    let mut monomial = free.clone();
                    monomial[place] = 1;
                    let one = graph.one();
                    Polynomial::from([(monomial, one)])
                }
            },
            _ if !node.operands().any(|x| known.contains_key(&x)) => continue,
            Node::Unary(Unary::Neg, a) => {
                let zero = Polynomial::new();
                sum(graph, zero, of(&known, a), true)
            }
            Node::Binary(Binary::Add, a, b) => sum(graph, of(&known, a), of(&known, b), false),
            Node::Binary(Binary::Sub, a, b) => sum(graph, of(&known, a), of(&known, b), true),
            Node::Binary(Binary::Mul, a, b) => {
                product(graph, &of(&known, a), &of(&known, b), unit_pairs)?
            }
            Node::Binary(Binary::Div, a, b) if !known.contains_key(&b) => of(&known, a)
                .into_iter()
                .map(|(monomial, coefficient)| (monomial, graph.div(coefficient, b)))
                .collect(),
            _ => return None,
        };
        known.insert(id, polynomial);
    }
    let mut result = of(&known, root);
    result.retain(|_, coefficient| !graph.is_zero(*coefficient));
    Some(result)
}

fn sum(graph: &Graph, mut a: Polynomial, b: Polynomial, minus: bool) -> Polynomial {
    for (monomial, coefficient) in b {
        let coefficient = if minus {
            graph.neg(coefficient)
        } else {
            coefficient
        };
        add_term(graph, &mut a, monomial, coefficient);
    }
    a
}

fn add_term(graph: &Graph, a: &mut Polynomial, monomial: Monomial, coefficient: NodeId) {
    let old = a.get(&monomial).copied();
    let new = match old {
        Some(old) => graph.add(old, coefficient),
        None => coefficient,
    };
    if graph.is_zero(new) {
        a.remove(&monomial);
    } else {
        a.insert(monomial, new);
    }
}

fn product(
    graph: &Graph,
    a: &Polynomial,
    b: &Polynomial,
    unit_pairs: &[(usize, usize)],
) -> Option<Polynomial> {
    let mut result = Polynomial::new();
    for (m, &x) in a {
        for (n, &y) in b {
            let monomial: Monomial = m.iter().zip(n).map(|(i, j)| i + j).collect();
            if monomial.iter().sum::<u8>() > MAX_DEGREE {
                return None;
            }
            let coefficient = graph.mul(x, y);
            add_reduced(graph, &mut result, monomial, coefficient, unit_pairs);
        }
    }
    Some(result)
}

/// Adds a term, with `s^2` written as `1 - c^2`.
fn add_reduced(
    graph: &Graph,
    result: &mut Polynomial,
    monomial: Monomial,
    coefficient: NodeId,
    unit_pairs: &[(usize, usize)],
) {
    let Some(&(cos, sin)) = unit_pairs.iter().find(|&&(_, sin)| monomial[sin] >= 2) else {
        return add_term(graph, result, monomial, coefficient);
    };
    let mut lower = monomial.clone();
    lower[sin] -= 2;
    let mut other = lower.clone();
    other[cos] += 2;
    let negative = graph.neg(coefficient);
    add_reduced(graph, result, lower, coefficient, unit_pairs);
    add_reduced(graph, result, other, negative, unit_pairs);
}
