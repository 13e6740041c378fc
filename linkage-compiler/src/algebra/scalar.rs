//! Scalars that may be angles: linear in driving and unknown angles, so that directions need no arc tangent.

use linkage_symbolic::program::{Binary, Unary};
use linkage_symbolic::{Binding, Node, NodeId};

use super::{Algebra, Angle};

/// Powers of a unit vector up to this one are products; beyond, the angle itself is cheaper.
const MAX_POWER: f64 = 8.0;

/// An angle that a direction can be built from without knowing its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Atom {
    Input(usize),
    /// Index of an unknown angle of the algebra.
    Angle(usize),
}

/// `sum of coefficient * atom + rest`; atoms in order, coefficients never 0. Anything that is no angle has no atoms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scalar {
    pub(crate) terms: Vec<(Atom, f64)>,
    pub(crate) rest: NodeId,
}

impl From<NodeId> for Scalar {
    fn from(rest: NodeId) -> Self {
        Self {
            terms: Vec::new(),
            rest,
        }
    }
}

impl Scalar {
    pub(crate) fn coefficient(&self, atom: Atom) -> f64 {
        self.terms
            .iter()
            .find(|(a, _)| *a == atom)
            .map_or(0.0, |(_, k)| *k)
    }
}

impl Algebra<'_> {
    pub(crate) fn atom(&mut self, atom: Atom) -> Scalar {
        let rest = self.graph.zero();
        Scalar {
            terms: vec![(atom, 1.0)],
            rest,
        }
    }

    pub(crate) fn combine(&mut self, a: &Scalar, b: &Scalar, sign: f64) -> Scalar {
        let mut terms = a.terms.clone();
        for &(atom, k) in &b.terms {
            match terms.iter_mut().find(|(other, _)| *other == atom) {
                Some((_, old)) => *old += sign * k,
                None => terms.push((atom, sign * k)),
            }
        }
        terms.retain(|(_, k)| *k != 0.0);
        terms.sort_by_key(|(atom, _)| *atom);
        let rest = if sign > 0.0 {
            self.graph.add(a.rest, b.rest)
        } else {
            self.graph.sub(a.rest, b.rest)
        };
        Scalar { terms, rest }
    }

    pub(crate) fn scale(&mut self, a: &Scalar, factor: f64) -> Scalar {
        let terms = a
            .terms
            .iter()
            .map(|&(atom, k)| (atom, factor * k))
            .filter(|(_, k)| *k != 0.0)
            .collect();
        let node = self.graph.constant(factor);
        Scalar {
            terms,
            rest: self.graph.mul(node, a.rest),
        }
    }

    /// The value as one node; unknown angles enter by their values.
    pub(crate) fn node(&mut self, scalar: &Scalar) -> NodeId {
        let mut sum = scalar.rest;
        for &(atom, k) in &scalar.terms {
            let value = match atom {
                Atom::Input(index) => self.input(index),
                Atom::Angle(index) => self.angles[index].value_node,
            };
            let factor = self.graph.constant(k);
            let term = self.graph.mul(factor, value);
            sum = self.graph.add(sum, term);
        }
        sum
    }

    /// Cosine and sine.
    pub(crate) fn direction(&mut self, angle: &Scalar) -> [NodeId; 2] {
        let mut rest = Scalar::from(angle.rest);
        let one = self.graph.one();
        let mut result = [one, self.graph.zero()];
        for &(atom, k) in &angle.terms {
            match atom {
                Atom::Input(index) => {
                    if !self.turning.contains(&(atom, k)) {
                        self.turning.push((atom, k));
                    }
                    let input = self.input(index);
                    let factor = self.graph.constant(k);
                    let argument = self.graph.mul(factor, input);
                    let turned = self.cos_sin(argument);
                    result = self.complex_product(result, turned);
                }
                Atom::Angle(index) if k.fract() == 0.0 && k.abs() <= MAX_POWER => {
                    let power = self.unit_power(index, k as i32);
                    result = self.complex_product(result, power);
                }
                Atom::Angle(_) => rest.terms.push((atom, k)),
            }
        }
        let argument = self.node(&rest);
        let turned = self.cos_sin(argument);
        let unit = self.complex_product(turned, result);
        self.mark_unit(&unit);
        unit
    }

    /// The unit vector of an unknown angle to an integer power.
    fn unit_power(&mut self, angle: usize, power: i32) -> [NodeId; 2] {
        let Angle {
            cos_node, sin_node, ..
        } = self.angles[angle];
        let unit = match power < 0 {
            true => [cos_node, self.graph.neg(sin_node)],
            false => [cos_node, sin_node],
        };
        (1..power.unsigned_abs()).fold(unit, |product, _| self.complex_product(product, unit))
    }

    /// Cosine and sine of a node. Quarter turns are exact, also as summands, and the argument of a vector is not taken
    /// to be undone.
    fn cos_sin(&mut self, argument: NodeId) -> [NodeId; 2] {
        if let Some(value) = self.graph.constant_value(argument) {
            return cos_sin_exact(value).map(|x| self.graph.constant(x));
        }
        if let Some((rest, turn)) = self.without_quarter_turns(argument) {
            let [rest, turn] = [self.cos_sin(rest), turn.map(|x| self.graph.constant(x))];
            return self.complex_product(rest, turn);
        }
        self.undone(argument).unwrap_or_else(|| {
            [
                self.graph.unary(Unary::Cos, argument),
                self.graph.unary(Unary::Sin, argument),
            ]
        })
    }

    /// Cosine and sine of the argument of a vector, or of an angle in a triangle, without any arc function; also as a summand.
    fn undone(&mut self, argument: NodeId) -> Option<[NodeId; 2]> {
        match self.graph.node(argument) {
            Node::Binary(Binary::Atan2, y, x) => {
                let length = self.length(&[x, y]);
                Some([self.graph.div(x, length), self.graph.div(y, length)])
            }
            Node::Binary(Binary::Mul, a, b) => {
                let two = |x| self.graph.constant_value(x) == Some(2.0);
                let half = match (two(a), two(b)) {
                    (true, _) => b,
                    (_, true) => a,
                    _ => return None,
                };
                let Node::Unary(Unary::Atan, tangent) = self.graph.node(half) else {
                    return None;
                };
                Some(self.turned_by_half_tangent(tangent))
            }
            Node::Unary(Unary::Neg, x) => {
                let [cos, sin] = self.undone(x)?;
                Some([cos, self.graph.neg(sin)])
            }
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                let (first, second) = match (self.undone(a), self.undone(b)) {
                    (None, None) => return None,
                    (Some(first), Some(second)) => (first, second),
                    (Some(first), None) => (first, self.cos_sin(b)),
                    (None, Some(second)) => (self.cos_sin(a), second),
                };
                let second = match op {
                    Binary::Sub => [second[0], self.graph.neg(second[1])],
                    _ => second,
                };
                Some(self.complex_product(first, second))
            }
            _ => None,
        }
    }

    /// `(1 - t^2)/(1 + t^2)` and `2 t/(1 + t^2)`
    fn turned_by_half_tangent(&mut self, tangent: NodeId) -> [NodeId; 2] {
        let graph = &mut self.graph;
        let square = graph.square(tangent);
        let one = graph.one();
        let (above, below) = (graph.sub(one, square), graph.add(one, square));
        let two = graph.constant(2.0);
        let twice = graph.mul(two, tangent);
        [graph.div(above, below), graph.div(twice, below)]
    }

    /// An angle without a summand of whole quarter turns, and the unit vector of that summand.
    fn without_quarter_turns(&mut self, angle: NodeId) -> Option<(NodeId, [f64; 2])> {
        let turns = |algebra: &Self, x| algebra.graph.constant_value(x).and_then(quarter_turns);
        match self.graph.node(angle) {
            Node::Unary(Unary::Neg, x) => {
                let (rest, [cos, sin]) = self.without_quarter_turns(x)?;
                Some((self.graph.neg(rest), [cos, -sin]))
            }
            Node::Binary(Binary::Add, x, y) => match (turns(self, x), turns(self, y)) {
                (Some(turn), _) => Some((y, turn)),
                (_, turn) => Some((x, turn?)),
            },
            Node::Binary(Binary::Sub, x, y) => match (turns(self, x), turns(self, y)) {
                (Some(turn), _) => Some((self.graph.neg(y), turn)),
                (_, turn) => turn.map(|[cos, sin]| (x, [cos, -sin])),
            },
            _ => None,
        }
    }

    /// `a b` of complex numbers.
    pub(crate) fn complex_product(&mut self, a: [NodeId; 2], b: [NodeId; 2]) -> [NodeId; 2] {
        let g = &mut self.graph;
        let [xx, yy] = [g.mul(a[0], b[0]), g.mul(a[1], b[1])];
        let [xy, yx] = [g.mul(a[0], b[1]), g.mul(a[1], b[0])];
        [g.sub(xx, yy), g.add(xy, yx)]
    }

    /// True if a node is known at compile time or in `assemble()`.
    pub(crate) fn is_fixed(&self, node: NodeId) -> bool {
        self.graph.binding(node) < Binding::Call
    }
}

/// Cosine and sine of a constant; multiples of a quarter turn give 0 and 1 exactly.
fn cos_sin_exact(angle: f64) -> [f64; 2] {
    quarter_turns(angle).unwrap_or([angle.cos(), angle.sin()])
}

/// Cosine and sine of an angle that is a multiple of a quarter turn.
fn quarter_turns(angle: f64) -> Option<[f64; 2]> {
    use std::f64::consts::FRAC_PI_2;
    let quarters = (angle / FRAC_PI_2).round();
    let is_multiple = (angle - quarters * FRAC_PI_2).abs() <= f64::EPSILON * angle.abs();
    (quarters.abs() < 1e6 && is_multiple).then_some(match (quarters as i64).rem_euclid(4) {
        0 => [1.0, 0.0],
        1 => [0.0, 1.0],
        2 => [-1.0, 0.0],
        _ => [0.0, -1.0],
    })
}
