//! Constructors: every operation is simplified where a rule of [`rules`] says how, then interned.

use super::by_operation;
use super::rule::first;
use crate::graph::{Graph, Node, NodeId, Store};
use crate::operation::{Binary, Ternary, Unary};

impl Store {
    /// The constant 0.
    pub(crate) fn zero(&mut self) -> NodeId {
        self.constant(0.0)
    }

    /// The constant 1.
    pub(crate) fn one(&mut self) -> NodeId {
        self.constant(1.0)
    }

    /// Any unary operation.
    pub(crate) fn unary(&mut self, op: Unary, a: NodeId) -> NodeId {
        match first(by_operation::of_unary(op), self, op, [a]) {
            Some(simpler) => simpler,
            None => self.intern(Node::Unary(op, a)),
        }
    }

    /// Any binary operation.
    pub(crate) fn binary(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        // Rules of products find the factor that is known earlier in front.
        let operands = match op {
            Binary::Mul if self.binding(b) < self.binding(a) => [b, a],
            _ => [a, b],
        };
        match first(by_operation::of_binary(op), self, op, operands) {
            Some(simpler) => simpler,
            None => self.plain_binary(op, operands),
        }
    }

    /// Any ternary operation.
    pub(crate) fn ternary(&mut self, op: Ternary, a: NodeId, b: NodeId, c: NodeId) -> NodeId {
        match first(by_operation::of_ternary(op), self, op, [a, b, c]) {
            Some(simpler) => simpler,
            None => self.intern(Node::Ternary(op, a, b, c)),
        }
    }

    /// A sum or product of rates.
    pub(crate) fn of_rates(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        match first(by_operation::of_rates(op), self, op, [a, b]) {
            Some(simpler) => simpler,
            None => self.binary(op, a, b),
        }
    }

    /// A choice between values whose definitions are known.
    pub(crate) fn inlined_ternary(&mut self, op: Ternary, [a, b, c]: [NodeId; 3]) -> NodeId {
        match first(by_operation::of_inlined(op), self, op, [a, b, c]) {
            Some(simpler) => simpler,
            None => self.ternary(op, a, b, c),
        }
    }

    /// The operation itself; operands that may change places stand in one order.
    fn plain_binary(&mut self, op: Binary, [a, b]: [NodeId; 2]) -> NodeId {
        match op {
            Binary::Mul => self.plain_product(a, b),
            Binary::Add | Binary::Hypot => self.intern(Node::Binary(op, a.min(b), a.max(b))),
            _ => self.intern(Node::Binary(op, a, b)),
        }
    }

    /// `a * b` as it is. Products keep the factor that is known earlier in front.
    pub(crate) fn plain_product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let key = |g: &Store, x: NodeId| (g.binding(x), x);
        let (a, b) = if key(self, b) < key(self, a) {
            (b, a)
        } else {
            (a, b)
        };
        self.intern(Node::Binary(Binary::Mul, a, b))
    }

    /// `-a`
    pub(crate) fn neg(&mut self, a: NodeId) -> NodeId {
        self.unary(Unary::Neg, a)
    }

    /// `|a|`
    pub(crate) fn abs(&mut self, a: NodeId) -> NodeId {
        self.unary(Unary::Abs, a)
    }

    /// `a + b`
    pub(crate) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Add, a, b)
    }

    /// `a - b`
    pub(crate) fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Sub, a, b)
    }

    /// `a * b`
    pub(crate) fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Mul, a, b)
    }

    /// `a / b`
    pub(crate) fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Div, a, b)
    }

    /// `x` of a term `-x`. The sign may be in a factor that is known early: in a sum or product it
    /// costs nothing, and without it the term may be one that exists.
    pub(crate) fn negative_term(&mut self, id: NodeId) -> Option<NodeId> {
        if let Some(x) = self.negated(id) {
            return Some(x);
        }
        let (factor, x) = self.product(id)?;
        if self.binding(factor) == self.binding(x) {
            return None;
        }
        let factor = self.negated(factor)?;
        Some(self.mul(factor, x))
    }
}

impl Graph {
    /// A number.
    pub fn constant(&self, value: f64) -> NodeId {
        self.store_mut().constant(value)
    }

    /// The constant 0.
    pub fn zero(&self) -> NodeId {
        self.constant(0.0)
    }

    /// The constant 1.
    pub fn one(&self) -> NodeId {
        self.constant(1.0)
    }

    /// Any unary operation.
    pub fn unary(&self, op: Unary, a: NodeId) -> NodeId {
        self.store_mut().unary(op, a)
    }

    /// Any binary operation.
    pub fn binary(&self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        self.store_mut().binary(op, a, b)
    }

    /// Any ternary operation.
    pub fn ternary(&self, op: Ternary, a: NodeId, b: NodeId, c: NodeId) -> NodeId {
        self.store_mut().ternary(op, a, b, c)
    }

    /// `-a`
    pub fn neg(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Neg, a)
    }

    /// `|a|`
    pub fn abs(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Abs, a)
    }

    /// `a + b`
    pub fn add(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Add, a, b)
    }

    /// `a - b`
    pub fn sub(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Sub, a, b)
    }

    /// `a * b`
    pub fn mul(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Mul, a, b)
    }

    /// `a / b`
    pub fn div(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Div, a, b)
    }

    /// `sqrt(a^2 + b^2)`
    pub fn hypot(&self, a: NodeId, b: NodeId) -> NodeId {
        self.binary(Binary::Hypot, a, b)
    }

    /// `sqrt(a)`
    pub fn sqrt(&self, a: NodeId) -> NodeId {
        self.unary(Unary::Sqrt, a)
    }

    /// `a^2`
    pub fn square(&self, a: NodeId) -> NodeId {
        self.mul(a, a)
    }
}
