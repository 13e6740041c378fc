//! Shapes of dimensions and results, and expressions of their scalars.

use linkage_compiler::ir::{COMPONENTS, Shape};

/// Components of frames.
const OF_FRAME: [&str; 4] = ["origin", "x", "y", "z"];

/// Returns the shape of the entries of an array, of arrays of arrays too; other shapes as they are.
fn innermost(shape: &Shape) -> &Shape {
    match shape {
        Shape::Array(_, entry) => innermost(entry),
        Shape::Scalar | Shape::Vector(_) | Shape::Frame | Shape::PlaneFrame => shape,
    }
}

/// Returns expressions of all scalars of a variable, in the order in which programs count them:
/// `e[0].x`, as most languages write members and entries.
pub fn scalar_paths(name: &str, shape: &Shape) -> Vec<String> {
    match shape {
        Shape::Scalar => vec![name.to_owned()],
        Shape::Vector(count) => members(name, &COMPONENTS[..*count], &Shape::Scalar),
        Shape::Array(count, entry) => {
            let entries = (0..*count).flat_map(|k| scalar_paths(&format!("{name}[{k}]"), entry));
            entries.collect()
        }
        Shape::Frame => members(name, &OF_FRAME, &Shape::Vector(3)),
        Shape::PlaneFrame => members(name, &OF_FRAME[..3], &Shape::Vector(2)),
    }
}

/// The scalars of members of the same shape.
fn members(name: &str, members: &[&str], shape: &Shape) -> Vec<String> {
    let paths = members.iter();
    let paths = paths.flat_map(|member| scalar_paths(&format!("{name}.{member}"), shape));
    paths.collect()
}

/// A type of vectors or frames.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompoundType {
    /// The number among vectors of the plane, vectors of space, frames and plane frames.
    pub number: usize,
    /// The names of its members.
    pub members: &'static [&'static str],
    /// The shape of each member.
    pub entry: Shape,
}

/// The types that variables of these shapes need, each after those of its members.
pub(crate) fn compound_types<'s>(shapes: impl Iterator<Item = &'s Shape>) -> Vec<CompoundType> {
    let shapes: Vec<&Shape> = shapes.map(innermost).collect();
    let has = |shape: &Shape| shapes.contains(&shape);
    let [in_space, in_plane] = [Shape::Frame, Shape::PlaneFrame].map(|shape| has(&shape));
    let [xy, xyz] = [Shape::Vector(2), Shape::Vector(3)];
    let all = [
        (has(&xy) || in_plane, &COMPONENTS[..2], Shape::Scalar),
        (has(&xyz) || in_space, &COMPONENTS[..3], Shape::Scalar),
        (in_space, &OF_FRAME[..], xyz),
        (in_plane, &OF_FRAME[..3], xy),
    ];
    let needed = all.into_iter().enumerate().filter(|(_, row)| row.0);
    let types = needed.map(|(number, (_, members, entry))| CompoundType {
        number,
        members,
        entry,
    });
    types.collect()
}
