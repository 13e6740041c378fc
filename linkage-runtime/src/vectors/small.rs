//! Vectors of two and three components, for builds without nalgebra.
//!
//! They have the names of nalgebra's vectors and those of their methods that mechanisms need.
//! Feature `nalgebra` replaces them.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub, SubAssign};

use linkage_core::Scalar;

/// A vector type with its components and the operations on each of them.
macro_rules! vector {
    ($(#[$meta:meta])* $Vector:ident: $size:literal, $($component:ident $index:literal)*) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        pub struct $Vector<T = f64> {
            $(
                #[doc = concat!("Component ", stringify!($component), ".")]
                pub $component: T,
            )*
        }

        impl<T> $Vector<T> {
            /// Makes a vector of its components.
            #[inline(always)]
            pub const fn new($($component: T),*) -> Self {
                Self { $($component),* }
            }

            /// Returns the components in order.
            pub fn iter(&self) -> impl ExactSizeIterator<Item = &T> {
                [$(&self.$component),*].into_iter()
            }

            /// Changes each component.
            #[must_use]
            pub fn map<U>(self, mut change: impl FnMut(T) -> U) -> $Vector<U> {
                $Vector::new($(change(self.$component)),*)
            }
        }

        impl<T: Scalar> $Vector<T> {
            /// The vector of length 0.
            #[must_use]
            pub fn zeros() -> Self {
                let zero = T::from_f64(0.0);
                Self { $($component: zero),* }
            }

            /// Returns the scalar product.
            #[must_use]
            pub fn dot(&self, other: &Self) -> T {
                let products = [$(self.$component * other.$component),*];
                let [first, rest @ ..] = products;
                rest.into_iter().fold(first, |sum, product| sum + product)
            }

            /// Returns the square of the length.
            #[must_use]
            pub fn norm_squared(&self) -> T {
                self.dot(self)
            }

            /// Returns the length.
            #[must_use]
            pub fn norm(&self) -> T {
                self.norm_squared().sqrt()
            }
        }

        impl<T> From<[T; $size]> for $Vector<T> {
            fn from([$($component),*]: [T; $size]) -> Self {
                Self { $($component),* }
            }
        }

        impl<T> From<$Vector<T>> for [T; $size] {
            fn from(vector: $Vector<T>) -> Self {
                [$(vector.$component),*]
            }
        }

        impl<T> Index<usize> for $Vector<T> {
            type Output = T;

            /// Returns a component by its number.
            ///
            /// # Panics
            ///
            /// If there is no such component.
            #[inline(always)]
            fn index(&self, index: usize) -> &T {
                match index {
                    $($index => &self.$component,)*
                    _ => panic!("component {index} of {} components", $size),
                }
            }
        }

        impl<T> IndexMut<usize> for $Vector<T> {
            #[inline(always)]
            fn index_mut(&mut self, index: usize) -> &mut T {
                match index {
                    $($index => &mut self.$component,)*
                    _ => panic!("component {index} of {} components", $size),
                }
            }
        }

        impl<T: Add<Output = T>> Add for $Vector<T> {
            type Output = Self;

            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self { $($component: self.$component + other.$component),* }
            }
        }

        impl<T: Sub<Output = T>> Sub for $Vector<T> {
            type Output = Self;

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self { $($component: self.$component - other.$component),* }
            }
        }

        impl<T: Neg<Output = T>> Neg for $Vector<T> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self { $($component: -self.$component),* }
            }
        }

        impl<T: Copy + Mul<Output = T>> Mul<T> for $Vector<T> {
            type Output = Self;

            #[inline(always)]
            fn mul(self, factor: T) -> Self {
                Self { $($component: self.$component * factor),* }
            }
        }

        impl<T: Copy + Div<Output = T>> Div<T> for $Vector<T> {
            type Output = Self;

            #[inline(always)]
            fn div(self, divisor: T) -> Self {
                Self { $($component: self.$component / divisor),* }
            }
        }

        impl Mul<$Vector<f64>> for f64 {
            type Output = $Vector<f64>;

            #[inline(always)]
            fn mul(self, vector: $Vector<f64>) -> $Vector<f64> {
                vector * self
            }
        }

        impl<T: Copy + Add<Output = T>> AddAssign for $Vector<T> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<T: Copy + Sub<Output = T>> SubAssign for $Vector<T> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<T: Scalar> Sum for $Vector<T> {
            fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
                vectors.fold(Self::zeros(), |sum, vector| sum + vector)
            }
        }
    };
}

vector! {
    /// A vector of the plane. With feature `nalgebra` it is nalgebra's.
    Vector2: 2, x 0 y 1
}

vector! {
    /// A vector in space. With feature `nalgebra` it is nalgebra's.
    Vector3: 3, x 0 y 1 z 2
}

impl<T: Scalar> Vector2<T> {
    /// Returns the determinant of two vectors: `x` of the one by `y` of the other, less `y` by `x`.
    #[must_use]
    pub fn perp(&self, other: &Self) -> T {
        self.x * other.y - self.y * other.x
    }
}

impl<T: Scalar> Vector3<T> {
    /// Returns the vector product.
    #[must_use]
    pub fn cross(&self, other: &Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_those_of_components() {
        let (a, b) = (Vector3::new(1.0, 2.0, -2.0), Vector3::new(3.0, -1.0, 0.5));
        assert_eq!(a + b, Vector3::new(4.0, 1.0, -1.5));
        assert_eq!(a - b, Vector3::new(-2.0, 3.0, -2.5));
        assert_eq!(-a * 2.0, Vector3::new(-2.0, -4.0, 4.0));
        assert_eq!(2.0 * a / 4.0, Vector3::new(0.5, 1.0, -1.0));
        assert_eq!((a.norm(), a.dot(&b)), (3.0, 0.0));
        // Perpendicular to both, as long as their product.
        let c = a.cross(&b);
        assert_eq!((c.dot(&a), c.dot(&b)), (0.0, 0.0));
        assert_eq!(c.norm_squared(), a.norm_squared() * b.norm_squared());
        assert_eq!([a, b].into_iter().sum::<Vector3<f64>>(), a + b);
        let (d, e) = (Vector2::new(2.0, 1.0), Vector2::from([-1.0, 3.0]));
        assert_eq!((d.perp(&e), e.perp(&d)), (7.0, -7.0));
        let mut f = d;
        f += e;
        f -= d;
        f[1] *= 2.0;
        assert_eq!((f, f[0]), (Vector2::new(-1.0, 6.0), -1.0));
        assert_eq!(<[f64; 2]>::from(d.map(|x| x + 1.0)), [3.0, 2.0]);
        assert_eq!(Vector3::<f64>::zeros(), Vector3::default());
    }

    #[test]
    #[should_panic(expected = "component 2 of 2 components")]
    fn a_component_that_is_not_there_is_named() {
        let _ = Vector2::new(1.0, 2.0)[2];
    }
}
