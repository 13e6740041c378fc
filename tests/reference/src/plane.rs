//! Vectors of the plane as pairs of high-precision numbers.

use crate::Big;
use core::ops::{Add, Neg, Sub};

/// A vector of the plane.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Component along the first axis.
    pub x: Big,
    /// Component along the second axis.
    pub y: Big,
}

impl Plane {
    /// The vector with the given components.
    pub fn new(x: impl Into<Big>, y: impl Into<Big>) -> Self {
        Self {
            x: x.into(),
            y: y.into(),
        }
    }

    /// The unit vector at an angle from the first axis.
    pub fn direction(angle: &Big) -> Self {
        let (y, x) = angle.sin_cos();
        Self { x, y }
    }

    /// The vector times a number.
    pub fn times(&self, factor: &Big) -> Self {
        Self {
            x: &self.x * factor,
            y: &self.y * factor,
        }
    }

    /// The vector turned by the angle of the unit vector `by`.
    pub fn turned(&self, by: &Self) -> Self {
        Self {
            x: &self.x * &by.x - &self.y * &by.y,
            y: &self.x * &by.y + &self.y * &by.x,
        }
    }

    /// The vector turned back by the angle of the unit vector `by`.
    pub fn turned_back(&self, by: &Self) -> Self {
        Self {
            x: self.dot(by),
            y: by.cross(self),
        }
    }

    /// The vector turned by a quarter.
    pub fn quarter(&self) -> Self {
        Self {
            x: -&self.y,
            y: self.x.clone(),
        }
    }

    /// Inner product.
    pub fn dot(&self, other: &Self) -> Big {
        &self.x * &other.x + &self.y * &other.y
    }

    /// The component of the product of two plane vectors across the plane.
    pub fn cross(&self, other: &Self) -> Big {
        &self.x * &other.y - &self.y * &other.x
    }

    /// Length.
    pub fn norm(&self) -> Big {
        self.dot(self).sqrt()
    }
}

impl Add for Plane {
    type Output = Plane;
    fn add(self, other: Plane) -> Plane {
        Plane {
            x: self.x + other.x,
            y: self.y + other.y,
        }
    }
}

impl Sub for Plane {
    type Output = Plane;
    fn sub(self, other: Plane) -> Plane {
        Plane {
            x: self.x - other.x,
            y: self.y - other.y,
        }
    }
}

impl Neg for Plane {
    type Output = Plane;
    fn neg(self) -> Plane {
        Plane {
            x: -self.x,
            y: -self.y,
        }
    }
}
