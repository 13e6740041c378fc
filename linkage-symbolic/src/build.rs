//! Constructors: every operation is simplified where that is certain and cheap, then interned.
//!
//! The rules keep results exact or more exact: they fold constants, drop neutral elements, cancel equal terms, pull signs
//! outwards and gather what depends on parameters alone, so that it moves to `assemble()`.

use crate::graph::{Binding, Graph, Node, NodeId};
use crate::interpret::{apply_binary, apply_ternary, apply_unary};
use crate::program::{Binary, Ternary, Unary};

impl Graph {
    /// A number.
    pub fn constant(&mut self, value: f64) -> NodeId {
        // -0 and 0 are one constant: the sign of zero carries no meaning in a mechanism.
        let value = if value == 0.0 { 0.0 } else { value };
        self.intern(Node::Constant(value.to_bits()))
    }

    /// The constant 0.
    pub fn zero(&mut self) -> NodeId {
        self.constant(0.0)
    }

    /// The constant 1.
    pub fn one(&mut self) -> NodeId {
        self.constant(1.0)
    }

    /// True for the constant 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.constant_value(id) == Some(0.0)
    }

    fn is_one(&self, id: NodeId) -> bool {
        self.constant_value(id) == Some(1.0)
    }

    /// `x` of `-x`, also of a negative constant.
    fn negated(&mut self, id: NodeId) -> Option<NodeId> {
        match self.node(id) {
            Node::Unary(Unary::Neg, x) => Some(x),
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => {
                Some(self.constant(-f64::from_bits(bits)))
            }
            _ => None,
        }
    }

    fn product(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Mul, a, b) => Some((a, b)),
            _ => None,
        }
    }

    fn quotient(&self, id: NodeId) -> Option<(NodeId, NodeId)> {
        match self.node(id) {
            Node::Binary(Binary::Div, a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Any unary operation.
    pub fn unary(&mut self, op: Unary, a: NodeId) -> NodeId {
        if let Some(value) = self.constant_value(a) {
            return self.constant(apply_unary(op, value));
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
    pub fn binary(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
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
    pub fn ternary(&mut self, op: Ternary, a: NodeId, b: NodeId, c: NodeId) -> NodeId {
        let values = [a, b, c].map(|x| self.constant_value(x));
        match (op, values) {
            (_, [Some(x), Some(y), Some(z)]) => self.constant(apply_ternary(op, x, y, z)),
            (Ternary::Select, [Some(s), ..]) => {
                if s >= 0.0 {
                    b
                } else {
                    c
                }
            }
            (Ternary::Select, _) if b == c => b,
            _ => self.intern(Node::Ternary(op, a, b, c)),
        }
    }

    fn fold(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(apply_binary(op, x, y)),
            _ => self.intern(Node::Binary(op, a, b)),
        }
    }

    /// Interns a commutative operation with its operands in canonical order.
    fn commute(&mut self, op: Binary, a: NodeId, b: NodeId) -> NodeId {
        self.fold(op, a.min(b), a.max(b))
    }

    /// `-a`
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        if let Some(x) = self.negated(a) {
            return x;
        }
        match self.node(a) {
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            // The sign goes where it costs nothing: into what is computed earlier.
            Node::Binary(Binary::Mul, x, y) if self.binding(x) < self.binding(y) => {
                let x = self.neg(x);
                self.mul(x, y)
            }
            _ => self.intern(Node::Unary(Unary::Neg, a)),
        }
    }

    /// `|a|`
    pub fn abs(&mut self, a: NodeId) -> NodeId {
        let a = self.negated(a).unwrap_or(a);
        match self.node(a) {
            Node::Constant(bits) => self.constant(f64::from_bits(bits).abs()),
            Node::Unary(Unary::Abs | Unary::Sqrt | Unary::InverseScale, _) => a,
            Node::Binary(Binary::Hypot | Binary::Root, ..) => a,
            _ => self.intern(Node::Unary(Unary::Abs, a)),
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if a == b {
            let two = self.constant(2.0);
            return self.mul(two, a);
        }
        if let Some(y) = self.negated(b) {
            return self.sub(a, y);
        }
        if let Some(x) = self.negated(a) {
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
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return self.neg(b);
        }
        if a == b {
            return self.zero();
        }
        if let (Some(x), Some(y)) = (self.constant_value(a), self.constant_value(b)) {
            return self.constant(x - y);
        }
        if let Some(y) = self.negated(b) {
            return self.add(a, y);
        }
        if let Some(x) = self.negated(a) {
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

    /// `a * b`
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
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
        match (self.node(a), self.node(b)) {
            (Node::Unary(Unary::Neg, x), Node::Unary(Unary::Neg, y)) => return self.mul(x, y),
            (Node::Unary(Unary::Neg, x), _) if self.binding(a) == self.binding(b) => {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            (_, Node::Unary(Unary::Neg, y)) if self.binding(a) == self.binding(b) => {
                let product = self.mul(a, y);
                return self.neg(product);
            }
            (_, Node::Unary(Unary::Neg, y)) => {
                let a = self.neg(a);
                return self.mul(a, y);
            }
            _ => {}
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
        let early = |g: &Graph, x| g.binding(x) < Binding::Call;
        if !early(self, p) || !early(self, q) || early(self, x) || early(self, y) {
            return None;
        }
        let (ap, aq) = (self.mul(a, p), self.mul(a, q));
        let (left, right) = (self.mul(ap, x), self.mul(aq, y));
        Some(self.binary(op, left, right))
    }

    /// Products keep the factor that is known earlier in front.
    fn commute_product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let key = |g: &Graph, x: NodeId| (g.binding(x), x);
        let (a, b) = if key(self, b) < key(self, a) {
            (b, a)
        } else {
            (a, b)
        };
        self.intern(Node::Binary(Binary::Mul, a, b))
    }

    /// `a / b`
    pub fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is_zero(a) && !self.is_zero(b) {
            return a;
        }
        if self.is_one(b) {
            return a;
        }
        if a == b {
            return self.one();
        }
        if let (Some(x), Some(y)) = (self.constant_value(a), self.constant_value(b)) {
            return self.constant(x / y);
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
        // A divisor known in assemble() costs one division there and a product here.
        let power_of_two = self.constant_value(b).is_some_and(is_power_of_two);
        if power_of_two || (self.binding(b) < Binding::Call && self.binding(a) == Binding::Call) {
            let one = self.one();
            let inverse = self.fold(Binary::Div, one, b);
            return self.mul(inverse, a);
        }
        self.fold(Binary::Div, a, b)
    }

    /// `sqrt(a^2 + b^2)`
    pub fn hypot(&mut self, a: NodeId, b: NodeId) -> NodeId {
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

    /// `sqrt(a)`
    pub fn sqrt(&mut self, a: NodeId) -> NodeId {
        self.unary(Unary::Sqrt, a)
    }

    /// `a^2`
    pub fn square(&mut self, a: NodeId) -> NodeId {
        self.mul(a, a)
    }
}

fn is_power_of_two(x: f64) -> bool {
    x.is_normal() && x.to_bits() & ((1 << 52) - 1) == 0 && (1.0 / x).is_normal()
}
