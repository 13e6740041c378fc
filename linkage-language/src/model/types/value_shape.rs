//! Numbers of a value, and their arrangement.

use super::parts_of_frame::{PARTS, VECTORS_OF_PLANE};
use super::value_type::Type;

/// The arrangement of a value of a function's result, without dimensions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// 2 or 3 components.
    Vector(usize),
    /// A number of entries of one shape.
    Array(usize, Box<Shape>),
    /// Origin and axes x, y, z: four vectors of space.
    Frame,
    /// Origin and axes x, y: three vectors of the plane.
    PlaneFrame,
}

impl Shape {
    /// The shape of a checked type; a type spoilt by a mistake counts as a scalar.
    pub fn from_type(ty: &Type) -> Self {
        match ty {
            Type::Scalar(_) | Type::Zero(1) | Type::Error => Self::Scalar,
            Type::Vector(count, _) | Type::Zero(count) => Self::Vector(*count),
            Type::Frame => Self::Frame,
            Type::PlaneFrame => Self::PlaneFrame,
            Type::Array(entries) => {
                let entry = entries.first().map_or(Self::Scalar, Self::from_type);
                Self::Array(entries.len(), Box::new(entry))
            }
        }
    }

    /// Returns the number of scalars.
    pub fn width(&self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(n) => *n,
            Self::Array(n, entry) => n * entry.width(),
            Self::Frame => 3 * PARTS.len(),
            Self::PlaneFrame => 2 * VECTORS_OF_PLANE,
        }
    }
}
