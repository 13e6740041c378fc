//! Do the ends of springs and dampers stay apart?

use crate::forces::geometry;
use crate::forces::positions;
use linkage_symbolic::Vn;

use crate::diagnostic::Reporter;
use crate::model::{Between, Element, ElementKind};

use super::Mechanics;
use super::positions::{Positions, size};
use super::print::element_word;

/// A length below this share of the mechanism's has no direction: so far apart rounding may leave two points at one place.
const NOTHING: f64 = 1e-9;

/// Reports the first spring or damper whose ends meet: in which direction it acts cannot be told.
pub(super) fn check_lengths(
    mechanics: &mut Mechanics<'_, '_>,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    let mechanism = mechanics.algebra.mechanism;
    let spans = spans(mechanics);
    for position in positions.iter() {
        for &(element, between) in &spans {
            let length = size(&positions::vector(position, between));
            if length > NOTHING * positions::longest(position) || length.is_nan() {
                continue;
            }
            reporter.error(
                    element.origin,
                    format!(
                        "the ends of the {} meet: {}it has no direction\n\
                         help: check its points; what turns in a joint is written `{0} VALUE on JOINT`",
                        element_word(element.kind),
                        positions::words(position, mechanism)
                    ),
                );
            return;
        }
    }
}

/// Springs and dampers between points, and from the end of each to its start. A spring that has no length without force does not
/// need a direction.
fn spans<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Vec<(&'m Element, Vn<'m>)> {
    let mut spans = Vec::new();
    for element in &mechanics.algebra.mechanism.elements {
        let needs_direction = match element.kind {
            ElementKind::Spring => element.free.is_some(),
            ElementKind::Damper => true,
        };
        if let Between::Points(ends) = &element.between
            && needs_direction
        {
            let [start, end] =
                [0, 1].map(|end| geometry::vector_of(mechanics.algebra, &ends[end].1));
            spans.push((element, start - end));
        }
    }
    spans
}
