//! The unknowns of a core: angles, lengths and numbers, and the lengths that are a point together.

use crate::model::{Dimension, Mechanism, Type};
use crate::structure::coupled::group::Core;
use crate::structure::equations::{Coordinate, CoordinateKind};

pub(crate) fn core_unknown(
    mechanism: &Mechanism,
    coordinate: &Coordinate,
) -> (Core, Option<usize>) {
    match coordinate.kind {
        CoordinateKind::Angle(angle) => (Core::Angle(angle), None),
        CoordinateKind::Length(symbol) => (
            Core::Length {
                symbol,
                number: coordinate
                    .unknown
                    .is_some_and(|k| is_number_unknown(mechanism, k)),
                component: None,
            },
            coordinate.unknown,
        ),
    }
}

/// True for an unknown without a length in it.
fn is_number_unknown(mechanism: &Mechanism, unknown: usize) -> bool {
    is_number(mechanism.unknowns[unknown].ty.dimension())
}

/// True for a loop without a length in it.
pub(crate) fn is_number_loop(mechanism: &Mechanism, index: usize) -> bool {
    is_number(loop_dimension(mechanism, index))
}

/// True for a loop whose two sides are lengths.
pub(crate) fn is_length_loop(mechanism: &Mechanism, index: usize) -> bool {
    let dimension = loop_dimension(mechanism, index);
    dimension.is_some_and(|dimension| dimension.fits(Dimension::LENGTH))
}

fn loop_dimension(mechanism: &Mechanism, index: usize) -> Option<Dimension> {
    let equation = &mechanism.loops[index];
    let dimensions = [&equation.left.ty, &equation.right.ty].map(Type::dimension);
    dimensions.into_iter().flatten().next()
}

fn is_number(dimension: Option<Dimension>) -> bool {
    dimension.is_some_and(|dimension| dimension.half_lengths == 0)
}

/// Marks neighbours that are the components of one point of the plane.
pub(crate) fn with_paired_components(core: Vec<(Core, Option<usize>)>) -> Vec<Core> {
    let mut marked: Vec<Core> = core.iter().map(|(core, _)| *core).collect();
    for k in 1..core.len() {
        let together = core.iter().filter(|(_, unknown)| *unknown == core[k].1);
        if core[k].1.is_none() || core[k].1 != core[k - 1].1 || together.count() != 2 {
            continue;
        }
        for (component, index) in [k - 1, k].into_iter().enumerate() {
            if let Core::Length { symbol, number, .. } = marked[index] {
                marked[index] = Core::Length {
                    symbol,
                    number,
                    component: Some(component),
                };
            }
        }
    }
    marked
}
