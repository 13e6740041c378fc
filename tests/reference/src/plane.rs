//! Vectors of the plane and of space, of high-precision numbers.

use crate::Big;
use core::ops::{Add, Neg, Sub};

// Vectors of the plane as pairs of high-precision numbers.

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

// Vectors of space as triples of high-precision numbers.

/// A vector of space.
#[derive(Clone, Debug)]
pub struct Space {
    /// Component along the first axis.
    pub x: Big,
    /// Component along the second axis.
    pub y: Big,
    /// Component along the third axis.
    pub z: Big,
}

impl Space {
    /// The vector with the given components.
    pub fn new(x: impl Into<Big>, y: impl Into<Big>, z: impl Into<Big>) -> Self {
        Self {
            x: x.into(),
            y: y.into(),
            z: z.into(),
        }
    }

    /// `along` times the first component of a plane vector, plus `across` times the second.
    pub fn in_plane(vector: &Plane, along: &Self, across: &Self) -> Self {
        along.times(&vector.x) + across.times(&vector.y)
    }

    /// The vector times a number.
    pub fn times(&self, factor: &Big) -> Self {
        Self {
            x: &self.x * factor,
            y: &self.y * factor,
            z: &self.z * factor,
        }
    }

    /// Inner product.
    pub fn dot(&self, other: &Self) -> Big {
        &self.x * &other.x + &self.y * &other.y + &self.z * &other.z
    }

    /// Cross product.
    pub fn cross(&self, other: &Self) -> Self {
        Self {
            x: &self.y * &other.z - &self.z * &other.y,
            y: &self.z * &other.x - &self.x * &other.z,
            z: &self.x * &other.y - &self.y * &other.x,
        }
    }

    /// Length.
    pub fn norm(&self) -> Big {
        self.dot(self).sqrt()
    }

    /// The components.
    pub fn components(self) -> [Big; 3] {
        [self.x, self.y, self.z]
    }
}

impl Add for Space {
    type Output = Space;
    fn add(self, other: Space) -> Space {
        Space {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl Sub for Space {
    type Output = Space;
    fn sub(self, other: Space) -> Space {
        Space {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl Neg for Space {
    type Output = Space;
    fn neg(self) -> Space {
        Space {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}
