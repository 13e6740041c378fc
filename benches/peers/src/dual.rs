//! The closed forms with the dual numbers of num-dual: `Dual2` for both derivatives by the input,
//! `DualSVec` for the sensitivities. Constants are computed beforehand.

use crate::closed::{Constants1, Constants2, Over, Pair, point1, point2};
use crate::{Motion, Position, Sensitivities1, Sensitivities2};
use num_dual::{Dual2_64, DualSVec64};

/// K1 with plain and with dual constants.
#[derive(Clone, Debug)]
pub struct K1 {
    plain: Constants1<f64>,
    dual: Constants1<DualSVec64<7>>,
}

/// K2 with plain and with dual constants.
#[derive(Clone, Debug)]
pub struct K2 {
    plain: Constants2<f64>,
    dual: Constants2<DualSVec64<12>>,
}

/// Dimensions as independent variables.
#[must_use]
pub fn variables<const N: usize>(dimensions: [f64; N]) -> [DualSVec64<N>; N] {
    std::array::from_fn(|index| DualSVec64::from_re(dimensions[index]).derivative(index))
}

/// A dual input with the derivative 1.
fn variable(phi: f64) -> Dual2_64 {
    Dual2_64::from_re(phi).derivative()
}

/// The numbers of a point in `Dual2`.
#[must_use]
pub fn motion([x, y]: Pair<Dual2_64>) -> Motion {
    [x.re, y.re, x.v1, y.v1, x.v2, y.v2]
}

/// The numbers of a point in `DualSVec`.
#[must_use]
pub fn accuracy<const N: usize, const W: usize>([x, y]: Pair<DualSVec64<N>>) -> [f64; W] {
    let mut row = [0.0; W];
    [row[0], row[1]] = [x.re, y.re];
    for (axis, number) in [x, y].into_iter().enumerate() {
        if let Some(derivatives) = number.eps.0 {
            let cells = row[2 + axis..].iter_mut().step_by(2);
            cells.zip(&derivatives).for_each(|(cell, d)| *cell = *d);
        }
    }
    row
}

macro_rules! kernels {
    ($kernel:ident, $n:literal, $constants:ident, $point:ident, $accuracy:ty) => {
        impl $kernel {
            /// From the dimensions in the order of the mechanism's parameters.
            #[must_use]
            pub fn new(dimensions: [f64; $n]) -> Self {
                Self {
                    plain: $constants::new(dimensions),
                    dual: $constants::new(variables(dimensions)),
                }
            }

            /// The point in a number type of the caller's choice.
            pub fn at<D: Over<f64>>(&self, phi: D) -> Pair<D> {
                $point(&self.plain, phi)
            }

            /// The point, without derivatives.
            pub fn point(&self, phi: f64) -> Position {
                $point(&self.plain, phi)
            }

            /// The point with both derivatives by the input.
            pub fn motion(&self, phi: f64) -> Motion {
                motion($point(&self.plain, variable(phi)))
            }

            /// The point with its sensitivities.
            pub fn accuracy(&self, phi: f64) -> $accuracy {
                accuracy($point(&self.dual, DualSVec64::from_re(phi)))
            }
        }
    };
}

kernels!(K1, 7, Constants1, point1, Sensitivities1);
kernels!(K2, 12, Constants2, point2, Sensitivities2);
