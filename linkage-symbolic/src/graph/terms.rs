//! Forms of operands that rules look for: signs, factors, terms.

use super::binding::Binding;
use super::node::{Node, NodeId};
use super::store::Store;
use crate::operation::{Binary, Ternary, Unary};

impl Store {
    /// True for the constant 0.
    pub(crate) fn is_zero(&self, id: NodeId) -> bool {
        // There is no constant -0.
        matches!(self.node(id), Node::Constant(0))
    }

    /// True for the constant 1.
    pub(crate) fn is_one(&self, id: NodeId) -> bool {
        self.constant_value(id) == Some(1.0)
    }

    /// True for a value that is known before a call: a number, or a value of `assemble()`.
    pub(crate) fn is_early(&self, id: NodeId) -> bool {
        self.binding(id) < Binding::Call
    }

    /// The factors of a product, the one that is known earlier first.
    pub(crate) fn product(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Mul, a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Dividend and divisor.
    pub(crate) fn quotient(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Div, a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// `p` and `x` of `p x` where `p` is known before a call and `x` is not.
    pub(crate) fn early_factor(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        let (p, x) = self.product(id)?;
        (self.is_early(p) && !self.is_early(x)).then_some((p, x))
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

    /// Returns true if the value of an operation is never negative, judged by its operands.
    pub(crate) fn makes_no_negative(&self, node: Node) -> bool {
        match node {
            Node::Constant(bits) => {
                let number = f64::from_bits(bits);
                number >= 0.0 || number.is_nan()
            }
            Node::Symbol(_) => false,
            Node::Binary(Binary::Mul, a, b) if a == b => true,
            // A quotient by -0 may be negative.
            Node::Binary(Binary::Add | Binary::Mul, a, b)
            | Node::Ternary(Ternary::Select, _, a, b) => {
                self.is_never_negative(a) && self.is_never_negative(b)
            }
            Node::Unary(op, _) => op.row().never_negative,
            Node::Binary(op, ..) => op.row().never_negative,
            Node::Ternary(op, ..) => op.row().never_negative,
        }
    }

    /// `p`, `q` and `x` of terms `p x` and `q x` with numbers `p` and `q`.
    pub(crate) fn like_terms(&self, a: NodeId, b: NodeId) -> Option<(f64, f64, NodeId)> {
        let (p, x) = self.constant_factor(a);
        let (q, y) = self.constant_factor(b);
        (x == y && self.constant_value(x).is_none()).then_some((p, q, x))
    }

    /// `p` and `x` of `p x`; a term without a constant factor has 1 or -1.
    fn constant_factor(&self, id: NodeId) -> (f64, NodeId) {
        match self.node(id) {
            Node::Unary(Unary::Neg, x) => (-1.0, x),
            Node::Binary(Binary::Mul, p, x) => match self.constant_value(p) {
                Some(factor) => (factor, x),
                None => (1.0, id),
            },
            _ => (1.0, id),
        }
    }

    /// The product of a factor that is known early with `x`, if it has been formed before.
    pub(crate) fn known_product(&self, p: NodeId, x: NodeId) -> Option<NodeId> {
        let late = self.is_early(p) && !self.is_early(x);
        late.then(|| self.find(Node::Binary(Binary::Mul, p, x)))?
    }
}
