//! The functions of expressions: one table.

use super::derivative::QUANTITIES;
use super::mechanics::MECHANICS;
use super::types::Function;

/// Name, function, arguments as messages show them.
pub(super) const FUNCTIONS: [(&str, Function, &[&str]); 26] = [
    ("polar", Function::Polar, &["length", "angle"]),
    ("dir", Function::Dir, &["angle"]),
    ("rotate", Function::Rotate, &["vector", "angle"]),
    ("turn", Function::Turn, &["vector", "axis", "angle"]),
    ("dot", Function::Dot, &["a", "b"]),
    ("cross", Function::Cross, &["a", "b"]),
    ("norm", Function::Norm, &["vector"]),
    ("distance", Function::Distance, &["a", "b"]),
    ("unit", Function::Unit, &["vector"]),
    ("angle", Function::Angle, &["vector"]),
    ("triangle_angle", Function::TriangleAngle, &["a", "b", "c"]),
    ("sin", Function::Sin, &["angle"]),
    ("cos", Function::Cos, &["angle"]),
    ("tan", Function::Tan, &["angle"]),
    ("asin", Function::Asin, &["number"]),
    ("acos", Function::Acos, &["number"]),
    ("atan", Function::Atan, &["number"]),
    ("atan2", Function::Atan2, &["y", "x"]),
    ("sqrt", Function::Sqrt, &["a"]),
    ("hypot", Function::Hypot, &["a", "b"]),
    ("abs", Function::Abs, &["a"]),
    ("min", Function::Min, &["a", "b"]),
    ("max", Function::Max, &["a", "b"]),
    ("frame", Function::Frame, &["origin", "x", "z"]),
    ("point_in", Function::PointIn, &["frame", "vector"]),
    (
        "coordinates_in",
        Function::CoordinatesIn,
        &["frame", "point"],
    ),
];

pub(super) fn is_function(name: &str) -> bool {
    FUNCTIONS.iter().any(|(known, ..)| *known == name) || is_quantity(name)
}

/// Whether it is known in the functions of the `impl` block.
pub(super) fn is_quantity(name: &str) -> bool {
    QUANTITIES.contains(&name) || MECHANICS.contains(&name)
}

impl Function {
    /// As it is written.
    pub fn name(self) -> &'static str {
        FUNCTIONS
            .iter()
            .find(|(_, function, _)| *function == self)
            .map_or("", |(name, ..)| name)
    }
}
