//! Expressions: nodes to compute with, so that a formula in code reads as the formula in its
//! comment.
//!
//! The order in which operations are written is the order in which their nodes are made, and that
//! order decides which operand of a sum stands first.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::graph::{Binding, Graph, Node, NodeId};
use crate::operation::{Binary, Ternary, Unary};

/// A node together with its graph.
#[derive(Clone, Copy)]
pub struct Ex<'g> {
    graph: &'g Graph,
    id: NodeId,
}

impl<'g> Ex<'g> {
    pub(crate) fn new(graph: &'g Graph, id: NodeId) -> Self {
        Self { graph, id }
    }

    /// The node alone, as it is stored.
    pub fn id(self) -> NodeId {
        self.id
    }

    /// The graph that it stands in.
    pub fn graph(self) -> &'g Graph {
        self.graph
    }

    /// A number beside it.
    pub fn number(self, value: f64) -> Self {
        Self::new(self.graph, self.graph.constant(value))
    }

    /// Its operation.
    pub fn node(self) -> Node {
        self.graph.node(self.id)
    }

    /// The value of a constant.
    pub fn constant_value(self) -> Option<f64> {
        self.graph.constant_value(self.id)
    }

    /// True for the constant 0.
    pub fn is_zero(self) -> bool {
        self.graph.is_zero(self.id)
    }

    /// When its value is known.
    pub fn binding(self) -> Binding {
        self.graph.binding(self.id)
    }

    /// True if its value is known at compile time or in `assemble()`.
    pub fn is_fixed(self) -> bool {
        self.binding() < Binding::Call
    }

    /// Any unary operation.
    pub fn unary(self, op: Unary) -> Self {
        Self::new(self.graph, self.graph.unary(op, self.id))
    }

    /// Any binary operation; this is the first operand.
    pub fn binary(self, op: Binary, other: Self) -> Self {
        Self::new(self.graph, self.graph.binary(op, self.id, other.id))
    }

    /// Any ternary operation; this is the first operand.
    pub fn ternary(self, op: Ternary, b: Self, c: Self) -> Self {
        Self::new(self.graph, self.graph.ternary(op, self.id, b.id, c.id))
    }

    /// The absolute value.
    pub fn abs(self) -> Self {
        self.unary(Unary::Abs)
    }

    /// The square root.
    pub fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }

    /// The product with itself.
    pub fn square(self) -> Self {
        self * self
    }

    /// The nearest whole number, of two the even one.
    pub fn whole(self) -> Self {
        self.unary(Unary::Round)
    }

    /// A power of two near `1/|x|`: scales lengths without rounding.
    pub fn inverse_scale(self) -> Self {
        self.unary(Unary::InverseScale)
    }

    /// The smaller of both; NaN if one is.
    pub fn min(self, other: Self) -> Self {
        self.binary(Binary::Min, other)
    }

    /// The larger of both; NaN if one is.
    pub fn max(self, other: Self) -> Self {
        self.binary(Binary::Max, other)
    }

    /// `sqrt(x^2 + y^2)` without overflow.
    pub fn hypot(self, other: Self) -> Self {
        self.binary(Binary::Hypot, other)
    }

    /// The quotient, NaN where it is infinite.
    pub fn quotient(self, divisor: Self) -> Self {
        self.binary(Binary::Quotient, divisor)
    }

    /// The argument of `x + i y`, this being `y`.
    pub fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }

    /// The root of a discriminant that was computed from terms of the size `scale`: see
    /// [`Ternary::GuardedSqrt`].
    pub fn root(self, scale: Self) -> Self {
        let slack = scale.number(1.0).unary(Unary::Slack);
        self.ternary(Ternary::GuardedSqrt, slack, scale.abs())
    }

    /// Returns the discriminant plus the rounding that [`root`](Self::root) allows: it is not
    /// negative where that is a number.
    pub fn reserve(self, scale: Self) -> Self {
        match self.root(scale).node() {
            Node::Ternary(Ternary::GuardedSqrt, _, slack, size) => {
                let [slack, size] = [slack, size].map(|id| Self::new(self.graph, id));
                slack * size + self
            }
            _ => self,
        }
    }

    /// `a` where this is 0 or positive, `b` where it is negative, NaN where it is NaN.
    pub fn select(self, a: Self, b: Self) -> Self {
        self.ternary(Ternary::Select, a, b)
    }

    /// `(a - b)(a + b)`
    pub fn difference_of_squares(self, other: Self) -> Self {
        let difference = self - other;
        difference * (self + other)
    }
}

impl fmt::Debug for Ex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.id.fmt(f)
    }
}

impl PartialEq for Ex<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Ex<'_> {}

impl Hash for Ex<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.id.hash(state);
    }
}

impl From<Ex<'_>> for NodeId {
    fn from(ex: Ex<'_>) -> Self {
        ex.id
    }
}

impl Neg for Ex<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        self.unary(Unary::Neg)
    }
}

/// An operator between expressions, and between a number and an expression in either order.
macro_rules! operator {
    ($Trait:ident, $method:ident) => {
        impl $Trait for Ex<'_> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                self.binary(Binary::$Trait, other)
            }
        }

        impl $Trait<f64> for Ex<'_> {
            type Output = Self;

            fn $method(self, other: f64) -> Self {
                self.binary(Binary::$Trait, self.number(other))
            }
        }

        impl<'g> $Trait<Ex<'g>> for f64 {
            type Output = Ex<'g>;

            fn $method(self, other: Ex<'g>) -> Ex<'g> {
                other.number(self).binary(Binary::$Trait, other)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl AddAssign for Ex<'_> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Ex<'_> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
