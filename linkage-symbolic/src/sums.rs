//! Constructors of sums, differences and signs.

use crate::graph::{Node, NodeId, Store};
use crate::program::{Binary, Unary};

impl Store {
    /// `-a`
    pub(crate) fn neg(&mut self, a: NodeId) -> NodeId {
        if let Some(x) = self.negated(a) {
            return x;
        }
        match self.node(a) {
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            // The sign goes where it costs nothing: into what is computed earlier.
            Node::Binary(Binary::Mul, x, y) if self.binding(x) < self.binding(y) => {
                let x = self.neg(x);
                self.commute_product(x, y)
            }
            _ => self.intern(Node::Unary(Unary::Neg, a)),
        }
    }

    /// `|a|`
    pub(crate) fn abs(&mut self, a: NodeId) -> NodeId {
        let a = self.negative_term(a).unwrap_or(a);
        match self.node(a) {
            Node::Constant(bits) => self.constant(f64::from_bits(bits).abs()),
            Node::Unary(Unary::Abs | Unary::Sqrt | Unary::InverseScale, _) => a,
            Node::Binary(Binary::Hypot | Binary::Root, ..) => a,
            _ => self.intern(Node::Unary(Unary::Abs, a)),
        }
    }

    /// `a + b`
    pub(crate) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if let Some(sum) = self.like_terms(a, b, 1.0) {
            return sum;
        }
        if let Some(y) = self.negative_term(b) {
            return self.sub(a, y);
        }
        if let Some(x) = self.negative_term(a) {
            return self.sub(b, x);
        }
        for (x, y) in [(a, b), (b, a)] {
            if let Node::Binary(Binary::Sub, p, q) = self.node(x)
                && q == y
            {
                return p;
            }
        }
        self.commute(Binary::Add, a, b)
    }

    /// `a - b`
    pub(crate) fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.neg(b);
        }
        if let Some(difference) = self.like_terms(a, b, -1.0) {
            return difference;
        }
        if let (Some(x), Some(y)) = (self.constant_value(a), self.constant_value(b)) {
            return self.constant(x - y);
        }
        if let Some(y) = self.negative_term(b) {
            return self.add(a, y);
        }
        if let Some(x) = self.negative_term(a) {
            let sum = self.add(x, b);
            return self.neg(sum);
        }
        match self.node(a) {
            Node::Binary(Binary::Add, p, q) if p == b => return q,
            Node::Binary(Binary::Add, p, q) if q == b => return p,
            Node::Binary(Binary::Sub, p, q) if p == b => return self.neg(q),
            _ => {}
        }
        match self.node(b) {
            Node::Binary(Binary::Add, p, q) if p == a => return self.neg(q),
            Node::Binary(Binary::Add, p, q) if q == a => return self.neg(p),
            Node::Binary(Binary::Sub, p, q) if p == a => return q,
            _ => {}
        }
        // A difference and its negative are one node and a sign, which the next sum or product absorbs.
        if a < b {
            return self.intern(Node::Binary(Binary::Sub, a, b));
        }
        let difference = self.intern(Node::Binary(Binary::Sub, b, a));
        self.intern(Node::Unary(Unary::Neg, difference))
    }

    /// `x` of a term `-x`. The sign may be in a factor that is known early: in a sum or product it costs nothing, and
    /// without it the term may be one that exists.
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

    /// `p x + sign q x = (p + sign q) x` with constants `p` and `q`.
    fn like_terms(&mut self, a: NodeId, b: NodeId, sign: f64) -> Option<NodeId> {
        let (p, x) = self.constant_factor(a);
        let (q, y) = self.constant_factor(b);
        if x != y || self.constant_value(x).is_some() {
            return None;
        }
        let factor = self.constant(p + sign * q);
        Some(self.mul(factor, x))
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
}
