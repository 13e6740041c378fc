//! Shapes of dimensions and results, and where their scalars are.

use linkage_compiler::ir::{COMPONENTS, Shape};

/// Components of frames.
const OF_FRAME: [&str; 4] = ["origin", "x", "y", "z"];

/// Returns the shape of the entries of an array, of arrays of arrays too; other shapes as they are.
pub(crate) fn innermost(shape: &Shape) -> &Shape {
    match shape {
        Shape::Array(_, entry) => innermost(entry),
        Shape::Scalar | Shape::Vector(_) | Shape::Frame | Shape::PlaneFrame => shape,
    }
}

/// Expressions of all scalars of something, in the order in which programs count them.
pub(crate) fn places(name: &str, shape: &Shape) -> Vec<String> {
    match shape {
        Shape::Scalar => vec![name.to_owned()],
        Shape::Vector(count) => COMPONENTS[..*count]
            .iter()
            .map(|axis| format!("{name}.{axis}"))
            .collect(),
        Shape::Array(count, entry) => {
            let entries = (0..*count).flat_map(|k| places(&format!("{name}[{k}]"), entry));
            entries.collect()
        }
        Shape::Frame => {
            let vectors = OF_FRAME.iter();
            let vectors =
                vectors.flat_map(|vector| places(&format!("{name}.{vector}"), &Shape::Vector(3)));
            vectors.collect()
        }
        Shape::PlaneFrame => {
            let vectors = OF_FRAME[..3].iter();
            let vectors =
                vectors.flat_map(|item| places(&format!("{name}.{item}"), &Shape::Vector(2)));
            vectors.collect()
        }
    }
}
