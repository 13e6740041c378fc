//! Vectors of expressions, of the plane and of space by type.

use std::array::from_fn;
use std::ops::{Add, Div, Index, Mul, Neg, Sub};

use super::ex::Ex;
use crate::graph::NodeId;

/// A vector of `N` components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Vector<'g, const N: usize>(pub [Ex<'g>; N]);

/// A vector of the plane; as a complex number where it turns.
pub type V2<'g> = Vector<'g, 2>;

/// A vector of space.
pub type V3<'g> = Vector<'g, 3>;

impl<'g, const N: usize> Vector<'g, N> {
    /// The nodes alone, as they are stored.
    pub fn ids(self) -> [NodeId; N] {
        self.0.map(Ex::id)
    }

    /// Another value for each component.
    #[must_use]
    pub fn map(mut self, mut other: impl FnMut(Ex<'g>) -> Ex<'g>) -> Self {
        // In place: `map` of arrays compiles to several times the code, in a hundred callers.
        for component in &mut self.0 {
            *component = other(*component);
        }
        self
    }

    /// The components in order.
    pub fn components(self) -> impl Iterator<Item = Ex<'g>> {
        self.0.into_iter()
    }

    fn zip(self, other: Self, join: impl Fn(Ex<'g>, Ex<'g>) -> Ex<'g>) -> Self {
        let mut joined = self;
        for (a, b) in joined.0.iter_mut().zip(other.0) {
            *a = join(*a, b);
        }
        joined
    }

    /// True if every component is the constant 0.
    pub fn is_zero(self) -> bool {
        self.0.iter().all(|x| x.is_zero())
    }

    /// True if every component is known at compile time or in `assemble()`.
    pub fn is_fixed(self) -> bool {
        self.0.iter().all(|x| x.is_fixed())
    }
}

impl<'g> V2<'g> {
    /// The vector turned by +90 degrees.
    #[must_use]
    pub fn perp(self) -> Self {
        Vector([-self.0[1], self.0[0]])
    }

    /// `a x b`, a number in the plane.
    pub fn cross(self, other: Self) -> Ex<'g> {
        let left = self.0[0] * other.0[1];
        left - self.0[1] * other.0[0]
    }

    /// The product of complex numbers: turned by the angle of `z` and stretched by its length.
    #[must_use]
    pub fn turned(self, z: Self) -> Self {
        let [a, b] = [self.0, z.0];
        let [xx, yy] = [a[0] * b[0], a[1] * b[1]];
        let [xy, yx] = [a[0] * b[1], a[1] * b[0]];
        Vector([xx - yy, xy + yx])
    }

    /// The quotient of complex numbers.
    #[must_use]
    pub fn turned_back(self, z: Self) -> Self {
        if z.0[1].is_zero() {
            return self / z.0[0];
        }
        let factor = z / z.square();
        self.turned(factor.conjugate())
    }

    /// The vector mirrored at the x axis: the conjugate complex number.
    #[must_use]
    pub fn conjugate(self) -> Self {
        Vector([self.0[0], -self.0[1]])
    }
}

impl V3<'_> {
    /// The vector product.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Vector(from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            Vector([self.0[i], self.0[j]]).cross(Vector([other.0[i], other.0[j]]))
        }))
    }
}

impl<'g, const N: usize> Index<usize> for Vector<'g, N> {
    type Output = Ex<'g>;

    fn index(&self, component: usize) -> &Ex<'g> {
        &self.0[component]
    }
}

impl<const N: usize> Add for Vector<'_, N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl<const N: usize> Sub for Vector<'_, N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl<const N: usize> Neg for Vector<'_, N> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<'g, const N: usize> Mul<Vector<'g, N>> for Ex<'g> {
    type Output = Vector<'g, N>;

    fn mul(self, vector: Vector<'g, N>) -> Vector<'g, N> {
        vector.map(|x| self * x)
    }
}

impl<'g, const N: usize> Div<Ex<'g>> for Vector<'g, N> {
    type Output = Self;

    fn div(self, divisor: Ex<'g>) -> Self {
        self.map(|x| x / divisor)
    }
}
