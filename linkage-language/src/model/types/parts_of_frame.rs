//! Parts of a frame: origin, axes, angle.

use super::dimension::Dimension;
use super::value_type::Type;

/// The parts of a frame, in this order.
pub const PARTS: [&str; 4] = ["origin", "x", "y", "z"];

/// The parts of a frame of the plane, in this order.
pub const PLANE_PARTS: [&str; 4] = ["origin", "x", "y", "angle"];

/// The index of the angle among these parts, after as many vectors. As a quantity, the frame is
/// these vectors.
pub(in crate::model) const ANGLE_PART: usize = 3;

pub const VECTORS_OF_PLANE: usize = ANGLE_PART;

/// The type of a part of a frame.
pub(in crate::model) fn type_of_part(frame: &Type, part: usize) -> Type {
    match (frame, part) {
        (Type::PlaneFrame, 0) => Type::Vector(2, Dimension::LENGTH),
        (Type::PlaneFrame, 3) => Type::Scalar(Dimension::ANGLE),
        (Type::PlaneFrame, _) => Type::Vector(2, Dimension::NUMBER),
        (_, 0) => Type::Vector(3, Dimension::LENGTH),
        _ => Type::Vector(3, Dimension::NUMBER),
    }
}
