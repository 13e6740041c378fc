//! Shapes of results.

use linkage_compiler::ir::Shape;

/// What the entries of an array are, of arrays of arrays too; other shapes as they are.
pub(crate) fn innermost(shape: &Shape) -> &Shape {
    match shape {
        Shape::Array(_, entry) => innermost(entry),
        Shape::Scalar | Shape::Vector(_) | Shape::Frame | Shape::PlaneFrame => shape,
    }
}
