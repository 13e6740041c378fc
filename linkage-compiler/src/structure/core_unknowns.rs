//! The unknowns of a core: what is an angle, a length or a number, and which lengths are a point together.

use super::Analysis;
use super::coupled_core::Core;
use super::equations::{Coordinate, CoordinateKind};
use crate::model::{Dimension, Type};

pub(super) fn of_core(
    analysis: &Analysis<'_, '_>,
    coordinate: &Coordinate,
) -> (Core, Option<usize>) {
    match coordinate.kind {
        CoordinateKind::Angle(angle) => (Core::Angle(angle), None),
        CoordinateKind::Length(symbol) => (
            Core::Length {
                symbol,
                number: coordinate
                    .unknown
                    .is_some_and(|k| is_number_unknown(analysis, k)),
                component: None,
            },
            coordinate.unknown,
        ),
    }
}

/// True for an unknown without a length in it.
fn is_number_unknown(analysis: &Analysis<'_, '_>, unknown: usize) -> bool {
    is_number(analysis.algebra.mechanism.unknowns[unknown].ty.dimension())
}

/// True for a loop without a length in it.
pub(super) fn is_number_loop(analysis: &Analysis<'_, '_>, index: usize) -> bool {
    let own = &analysis.algebra.mechanism.loops[index];
    let dimensions = [&own.left.ty, &own.right.ty].map(Type::dimension);
    is_number(dimensions.into_iter().flatten().next())
}

fn is_number(dimension: Option<Dimension>) -> bool {
    dimension.is_some_and(|own| own.half_lengths == 0)
}

/// Marks neighbours that are the components of one point of the plane.
pub(super) fn paired(core: Vec<(Core, Option<usize>)>) -> Vec<Core> {
    let mut marked: Vec<Core> = core.iter().map(|(core, _)| *core).collect();
    for k in 1..core.len() {
        let together = core.iter().filter(|(_, unknown)| *unknown == core[k].1);
        if core[k].1.is_none() || core[k].1 != core[k - 1].1 || together.count() != 2 {
            continue;
        }
        for (component, place) in [k - 1, k].into_iter().enumerate() {
            if let Core::Length { symbol, number, .. } = marked[place] {
                marked[place] = Core::Length {
                    symbol,
                    number,
                    component: Some(component),
                };
            }
        }
    }
    marked
}
