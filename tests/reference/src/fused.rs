//! A double whose multiply-adds are always fused.

use core::ops::{Add, Div, Mul, Neg, Sub};
use linkage::Scalar;

/// An `f64` that computes as machines with fused multiply-add do, whatever this one is: correct but
/// slow where the machine has none.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Fused(pub f64);

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {
        $(impl $trait for Fused {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })*
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! functions {
    ($($method:ident),*) => {
        $(fn $method(self) -> Self {
            Self(Scalar::$method(self.0))
        })*
    };
}

impl Scalar for Fused {
    const LANES: usize = 1;

    functions!(abs, sqrt, tan, asin, acos, atan, inverse_scale);

    fn from_f64(x: f64) -> Self {
        Self(x)
    }

    fn lane(self, _: usize) -> f64 {
        self.0
    }

    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self(f(0))
    }

    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos_with::<true>()
    }

    fn atan2(self, x: Self) -> Self {
        self.atan2_with::<true>(x)
    }

    fn mul_add<const FUSED: bool>(self, factor: Self, term: Self) -> Self {
        Self(f64::mul_add(self.0, factor.0, term.0))
    }

    fn sin_cos_with<const FUSED: bool>(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos_with::<true>();
        (Self(sin), Self(cos))
    }

    fn atan2_with<const FUSED: bool>(self, x: Self) -> Self {
        Self(self.0.atan2_with::<true>(x.0))
    }

    fn root_with<const FUSED: bool>(self, slack: Self, size: Self) -> Self {
        Self(self.0.root_with::<true>(slack.0, size.0))
    }

    fn angle_near(y: Self, x: Self, guide: Self) -> Self {
        Self::angle_near_with::<true>(y, x, guide)
    }

    fn angle_near_with<const FUSED: bool>(y: Self, x: Self, guide: Self) -> Self {
        Self(f64::angle_near_with::<true>(y.0, x.0, guide.0))
    }

    fn select(s: Self, a: Self, b: Self) -> Self {
        Self(Scalar::select(s.0, a.0, b.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_not_rounded_before_the_sum() {
        let x = 1.0 + f64::EPSILON;
        let square = Fused(x).mul_add::<false>(Fused(x), Fused(-1.0 - 2.0 * f64::EPSILON));
        assert_eq!(square.0, f64::EPSILON * f64::EPSILON);
    }
}
