//! An expression as a polynomial in chosen symbols: how the solver sees a loop whatever way it was
//! written.

use std::collections::BTreeMap;

use super::ex::Ex;
use crate::graph::{Node, NodeId, SymbolId};
use crate::lookup::Map;
use crate::operation::{Binary, Ternary, Unary};

/// Exponents of the chosen symbols, in their order.
pub type Monomial = Vec<u8>;

/// Coefficients, free of the chosen symbols and never the constant 0, by monomial.
pub type Polynomial<'g> = BTreeMap<Monomial, Ex<'g>>;

/// Higher total degrees are of no use to any solver.
pub const MAX_DEGREE: u8 = 4;

/// Why an expression is no polynomial that [`collect`] gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// Its total degree, which is too high.
    Degree(u32),
    /// A root of the symbols.
    Root,
    /// A division by the symbols.
    Division,
    /// Another function of the symbols.
    Function,
}

/// Returns the obstacle to `root` being a polynomial in `symbols`, if there is one: the first
/// function, else the degree as written, without cancellation.
pub fn obstacle(root: Ex, symbols: &[SymbolId]) -> Option<Obstacle> {
    let graph = root.graph();
    let mut degrees: Map<NodeId, u32> = Map::new();
    for id in graph.reachable(&[root.id()]) {
        let node = graph.node(id);
        let of = |x: NodeId| degrees.get(&x).copied().unwrap_or(0);
        let degree = match node {
            Node::Symbol(symbol) if symbols.contains(&symbol) => 1,
            _ if node.operands().all(|x| of(x) == 0) => continue,
            Node::Unary(Unary::Neg, a) => of(a),
            Node::Binary(Binary::Add | Binary::Sub, a, b) => of(a).max(of(b)),
            Node::Binary(Binary::Mul, a, b) => of(a).saturating_add(of(b)),
            Node::Binary(Binary::Div, a, b) if of(b) == 0 => of(a),
            Node::Binary(Binary::Div, ..) => return Some(Obstacle::Division),
            Node::Unary(Unary::Sqrt, _)
            | Node::Binary(Binary::Hypot, ..)
            | Node::Ternary(Ternary::GuardedSqrt, ..) => {
                return Some(Obstacle::Root);
            }
            _ => return Some(Obstacle::Function),
        };
        degrees.insert(id, degree);
    }
    let degree = degrees.get(&root.id()).copied().unwrap_or(0);
    (degree > u32::from(MAX_DEGREE)).then_some(Obstacle::Degree(degree))
}

/// `root` as a polynomial in `symbols`; `None` if it is none. `unit_pairs` are the positions in
/// `symbols` of the cosine and sine of one angle; even powers of the sine are expressed by the
/// cosine, so that `c^2 + s^2` is 1.
pub fn collect<'g>(
    root: Ex<'g>,
    symbols: &[SymbolId],
    unit_pairs: &[(usize, usize)],
) -> Option<Polynomial<'g>> {
    let graph = root.graph();
    let mut known: Map<NodeId, Polynomial> = Map::new();
    let free = vec![0; symbols.len()];
    // Nodes without chosen symbols are coefficients as they stand and need no entry.
    let of = |known: &Map<NodeId, Polynomial<'g>>, id: NodeId| {
        let entry = known.get(&id).cloned();
        entry.unwrap_or_else(|| Polynomial::from([(free.clone(), graph.ex(id))]))
    };
    for id in graph.reachable(&[root.id()]) {
        let node = graph.node(id);
        let polynomial = match node {
            Node::Constant(_) => continue,
            Node::Symbol(symbol) => match symbols.iter().position(|&s| s == symbol) {
                None => continue,
                Some(index) => {
                    let mut monomial = free.clone();
                    monomial[index] = 1;
                    Polynomial::from([(monomial, graph.number(1.0))])
                }
            },
            _ if !node.operands().any(|x| known.contains_key(&x)) => continue,
            Node::Unary(Unary::Neg, a) => sum(Polynomial::new(), of(&known, a), true),
            Node::Binary(Binary::Add, a, b) => sum(of(&known, a), of(&known, b), false),
            Node::Binary(Binary::Sub, a, b) => sum(of(&known, a), of(&known, b), true),
            Node::Binary(Binary::Mul, a, b) => product(&of(&known, a), &of(&known, b), unit_pairs)?,
            Node::Binary(Binary::Div, a, b) if !known.contains_key(&b) => {
                let terms = of(&known, a).into_iter();
                let divisor = graph.ex(b);
                terms
                    .map(|(monomial, coefficient)| (monomial, coefficient / divisor))
                    .collect()
            }
            _ => return None,
        };
        known.insert(id, polynomial);
    }
    let mut result = of(&known, root.id());
    result.retain(|_, coefficient| !coefficient.is_zero());
    Some(result)
}

fn sum<'g>(mut a: Polynomial<'g>, b: Polynomial<'g>, minus: bool) -> Polynomial<'g> {
    for (monomial, coefficient) in b {
        let coefficient = if minus { -coefficient } else { coefficient };
        add_term(&mut a, monomial, coefficient);
    }
    a
}

fn add_term<'g>(a: &mut Polynomial<'g>, monomial: Monomial, coefficient: Ex<'g>) {
    let new = match a.get(&monomial) {
        Some(&old) => old + coefficient,
        None => coefficient,
    };
    if new.is_zero() {
        a.remove(&monomial);
    } else {
        a.insert(monomial, new);
    }
}

fn product<'g>(
    a: &Polynomial<'g>,
    b: &Polynomial<'g>,
    unit_pairs: &[(usize, usize)],
) -> Option<Polynomial<'g>> {
    let mut result = Polynomial::new();
    for (m, &x) in a {
        for (n, &y) in b {
            let monomial: Monomial = m.iter().zip(n).map(|(i, j)| i + j).collect();
            if monomial.iter().sum::<u8>() > MAX_DEGREE {
                return None;
            }
            add_reduced(&mut result, monomial, x * y, unit_pairs);
        }
    }
    Some(result)
}

/// Adds a term, with `s^2` written as `1 - c^2`.
fn add_reduced<'g>(
    result: &mut Polynomial<'g>,
    monomial: Monomial,
    coefficient: Ex<'g>,
    unit_pairs: &[(usize, usize)],
) {
    let Some(&(cos, sin)) = unit_pairs.iter().find(|&&(_, sin)| monomial[sin] >= 2) else {
        return add_term(result, monomial, coefficient);
    };
    let mut lower = monomial.clone();
    lower[sin] -= 2;
    let mut other = lower.clone();
    other[cos] += 2;
    let negative = -coefficient;
    add_reduced(result, lower, coefficient, unit_pairs);
    add_reduced(result, other, negative, unit_pairs);
}
