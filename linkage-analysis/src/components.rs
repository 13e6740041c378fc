//! Scalars and vectors as arrays of components.

use linkage_core::math::double::sqrt;
use linkage_runtime::{Vector2, Vector3};

/// A sensitivity, a force or a moment: a number, or a vector of two or three components.
///
/// Implemented for `f64`, `Vector2<f64>`, `Vector3<f64>` and arrays of one to three numbers.
pub trait Components<const K: usize>: Copy {
    /// The components.
    fn components(self) -> [f64; K];
}

impl Components<1> for f64 {
    fn components(self) -> [f64; 1] {
        [self]
    }
}

macro_rules! arrays {
    ($($k:literal)*) => {
        $(impl Components<$k> for [f64; $k] {
            fn components(self) -> [f64; $k] {
                self
            }
        })*
    };
}

arrays!(1 2 3);

impl Components<2> for Vector2<f64> {
    fn components(self) -> [f64; 2] {
        self.into()
    }
}

impl Components<3> for Vector3<f64> {
    fn components(self) -> [f64; 3] {
        self.into()
    }
}

/// The vector in space, with zeros for components that it has not.
#[cfg(feature = "alloc")]
pub fn in_space<const K: usize>(components: &[f64; K]) -> [f64; 3] {
    let mut space = [0.0; 3];
    for (to, from) in space.iter_mut().zip(components) {
        *to = *from;
    }
    space
}

/// The length of a vector.
pub fn norm(components: &[f64]) -> f64 {
    let largest = components.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return components.iter().map(|x| x.abs()).sum();
    }
    let squares: f64 = components
        .iter()
        .map(|x| (x / largest) * (x / largest))
        .sum();
    largest * sqrt(squares)
}
