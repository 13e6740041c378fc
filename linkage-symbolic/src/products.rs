//! Constructors of products and quotients.

use crate::graph::{Binding, Node, NodeId, Store};
use crate::program::{Binary, Unary};

impl Store {
    /// `a * b`
    pub(crate) fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) || self.is_zero(b) {
            return self.zero();
        }
        if self.is_one(a) {
            return b;
        }
        if self.is_one(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.constant_value(a), self.constant_value(b)) {
            return self.constant(x * y);
        }
        let (a, b) = if self.binding(b) < self.binding(a) {
            (b, a)
        } else {
            (a, b)
        };
        if self.constant_value(a) == Some(-1.0) {
            return self.neg(b);
        }
        if self.binding(a) == self.binding(b) {
            if let Some(x) = self.negative_term(a) {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            if let Some(y) = self.negative_term(b) {
                let product = self.mul(a, y);
                return self.neg(product);
            }
        } else if let Node::Unary(Unary::Neg, y) = self.node(b) {
            let a = self.neg(a);
            return self.mul(a, y);
        }
        // a (x / a) = x, and p (q x) = (p q) x where p and q are known before x.
        for (x, y) in [(a, b), (b, a)] {
            if let Some((p, q)) = self.quotient(x)
                && q == y
            {
                return p;
            }
        }
        if let Some((p, x)) = self.product(b)
            && self.binding(a) < Binding::Call
            && self.binding(p) < self.binding(x)
        {
            let factor = self.mul(a, p);
            return self.mul(factor, x);
        }
        if self.binding(a) < Binding::Call
            && let Some(sum) = self.distribute(a, b)
        {
            return sum;
        }
        self.commute_product(a, b)
    }

    /// `a (p x + q y) = (a p) x + (a q) y` where `a`, `p`, `q` are known before `x` and `y`: a link's point needs
    /// no product of its own.
    fn distribute(&mut self, a: NodeId, b: NodeId) -> Option<NodeId> {
        let (op, first, second) = match self.node(b) {
            Node::Binary(op @ (Binary::Add | Binary::Sub), x, y) => (op, x, y),
            _ => return None,
        };
        let (p, x) = self.product(first)?;
        let (q, y) = self.product(second)?;
        let early = |g: &Store, x| g.binding(x) < Binding::Call;
        if !early(self, p) || !early(self, q) || early(self, x) || early(self, y) {
            return None;
        }
        let (ap, aq) = (self.mul(a, p), self.mul(a, q));
        let (left, right) = (self.mul(ap, x), self.mul(aq, y));
        Some(self.binary(op, left, right))
    }

    /// The product of a factor that is known early with `x`, if it has been formed before.
    pub(crate) fn known_product(&self, p: NodeId, x: NodeId) -> Option<NodeId> {
        let early = self.binding(p) < Binding::Call && self.binding(x) == Binding::Call;
        early.then(|| self.find(Node::Binary(Binary::Mul, p, x)))?
    }

    /// Products keep the factor that is known earlier in front.
    pub(crate) fn commute_product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let key = |g: &Store, x: NodeId| (g.binding(x), x);
        let (a, b) = if key(self, b) < key(self, a) {
            (b, a)
        } else {
            (a, b)
        };
        self.intern(Node::Binary(Binary::Mul, a, b))
    }

    /// `a / b`
    pub(crate) fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) && !self.is_zero(b) {
            return a;
        }
        if self.is_one(b) {
            return a;
        }
        if let (Some(x), Some(y)) = (self.constant_value(a), self.constant_value(b)) {
            return self.constant(x / y);
        }
        if a == b {
            return self.one();
        }
        if let Some(y) = self.negated(b) {
            let a = self.neg(a);
            return self.div(a, y);
        }
        if let Node::Unary(Unary::Neg, x) = self.node(a) {
            let value = self.div(x, b);
            return self.neg(value);
        }
        if let Some((x, y)) = self.product(a) {
            if y == b {
                return x;
            }
            if x == b {
                return y;
            }
        }
        if let Some((x, y)) = self.product(b) {
            // a / (a y) = 1 / y
            let rest = if x == a {
                Some(y)
            } else if y == a {
                Some(x)
            } else {
                None
            };
            if let Some(rest) = rest {
                let one = self.one();
                return self.div(one, rest);
            }
        }
        // a / (p x) = a ((1/p) / x): one division for all dividends, and it does not wait for a product.
        if let Some((p, x)) = self.product(b)
            && self.binding(p) < Binding::Call
            && self.binding(x) == Binding::Call
        {
            let one = self.one();
            let factor = self.div(one, p);
            if self.binding(a) < Binding::Call {
                let factor = self.mul(a, factor);
                return self.div(factor, x);
            }
            let inverse = self.div(factor, x);
            return self.mul(a, inverse);
        }
        // A divisor known in assemble() costs one division there and a product here.
        let power_of_two = self.constant_value(b).is_some_and(is_power_of_two);
        if power_of_two || (self.binding(b) < Binding::Call && self.binding(a) == Binding::Call) {
            let one = self.one();
            let inverse = self.fold(Binary::Div, one, b);
            return self.mul(inverse, a);
        }
        self.fold(Binary::Div, a, b)
    }
}

fn is_power_of_two(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0 && (1.0 / x).is_normal()
}
