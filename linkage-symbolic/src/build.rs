//! Constructors: every operation is simplified where that is certain and cheap, then interned.
//!
//! The rules keep results exact or more exact: they fold constants, drop neutral elements, cancel equal terms, pull signs
//! outwards and gather what depends on parameters alone, so that it moves to `assemble()`.

use crate::graph::{Node, NodeId, Store};
use crate::program::{Binary, Ternary, Unary};

impl Store {
    /// A number.
    pub(crate) fn constant(&mut self, value: f64) -> NodeId {
        // -0 and 0 are one constant: the sign of zero carries no meaning in a mechanism.
        let value = if value == 0.0 { 0.0 } else { value };
        self.intern(Node::Constant(value.to_bits()))
    }

    /// The constant 0.
    pub(crate) fn zero(&mut self) -> NodeId {
        self.constant(0.0)
    }

    /// The constant 1.
    pub(crate) fn one(&mut self) -> NodeId {
        self.constant(1.0)
    }

    /// True for the constant 0.
    pub(crate) fn is_zero(&self, id: NodeId) -> bool {
        self.constant_value(id) == Some(0.0)
    }

    pub(crate) fn is_one(&self, id: NodeId) -> bool {
        self.constant_value(id) == Some(1.0)
    }

    /// `x` of `-x`, also of a negative constant.
    pub(crate) fn negated(&mut self, id: NodeId) -> Option<NodeId> {
        match self.node(id) {
            Node::Unary(Unary::Neg, x) => Some(x),
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => {
                Some(self.constant(-f64::from_bits(bits)))
            }
            _ => None,
        }
    }

    pub(crate) fn product(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Mul, a, b) => Some((a, b)),
            _ => None,
        }
    }

    pub(crate) fn quotient(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Div, a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Any unary operation.
    pub(crate) fn unary(&mut self, op: Unary, a: NodeId) -> NodeId {
        if let Some(value) = self.constant_value(a) {
            return self.constant(op.apply([value]));
        }
        match op {
            Unary::Neg => self.neg(a),
            Unary::Abs => self.abs(a),
            Unary::Sin | Unary::Tan | Unary::Asin | Unary::Atan => match self.negated(a) {
                Some(x) => {
                    let value = self.intern(Node::Unary(op, x));
                    self.neg(value)
                }
                None => self.intern(Node::Unary(op, a)),
            },
            Unary::Cos => {
                let x = self.negated(a).unwrap_or(a);
                self.intern(Node::Unary(op, x))
            }
            Unary::Sqrt => match self.product(a) {
                Some((x, y)) if x == y => self.abs(x),
                _ => self.intern(Node::Unary(op, a)),
            },
            _ => self.intern(Node::Unary(op, a)),
        }
    }

    /// Any binary operation.
    pub(crate) fn binary(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        match op {
            Binary::Add => self.add(a, b),
            Binary::Sub => self.sub(a, b),
            Binary::Mul => self.mul(a, b),
            Binary::Div => self.div(a, b),
            Binary::Hypot => self.hypot(a, b),
            _ => self.fold(op, a, b),
        }
    }

    /// Any ternary operation.
    pub(crate) fn ternary(&mut self, op: Ternary, a: NodeId, b: NodeId, c: NodeId) -> NodeId {
        let values = [a, b, c].map(|x| self.constant_value(x));
        match (op, values) {
            (_, [Some(x), Some(y), Some(z)]) => self.constant(op.apply([x, y, z])),
            (Ternary::Select, [Some(s), ..]) => {
                if s.is_nan() {
                    a
                } else if s >= 0.0 {
                    b
                } else {
                    c
                }
            }
            (Ternary::Select, _) if b == c => b,
            _ => self.intern(Node::Ternary(op, a, b, c)),
        }
    }

    pub(crate) fn fold(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(op.apply([x, y])),
            _ => self.intern(Node::Binary(op, a, b)),
        }
    }

    /// Interns a commutative operation with its operands in canonical order.
    pub(crate) fn commute(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        self.fold(op, a.min(b), a.max(b))
    }

    /// `sqrt(a^2 + b^2)`
    pub(crate) fn hypot(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) {
            return self.abs(b);
        }
        if self.is_zero(b) {
            return self.abs(a);
        }
        let a = self.negated(a).unwrap_or(a);
        let b = self.negated(b).unwrap_or(b);
        self.commute(Binary::Hypot, a, b)
    }
}
