//! Do the ends of springs and dampers stay apart?

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::diagnostic::Reporter;
use crate::forces::positions::Positions;
use crate::forces::{geometry, names, positions};
use crate::model::{Between, Element, ElementKind};

/// A length below this share of the mechanism's has no direction: so far apart rounding may leave
/// two points at one place.
const NOTHING: f64 = 1e-9;

/// Reports the first spring or damper whose ends meet, so that its direction is undefined.
pub(super) fn check_lengths(algebra: &mut Algebra, positions: &Positions, reporter: &mut Reporter) {
    let mechanism = algebra.mechanism;
    let spans = spans(algebra);
    for position in positions.iter() {
        for &(element, between) in &spans {
            let length = positions::size(&positions::vector(position, between));
            if length > NOTHING * positions::longest(position) || length.is_nan() {
                continue;
            }
            reporter.error(
                    element.origin,
                    format!(
                        "the ends of the {} meet: {}it has no direction\n\
                         help: check its points; what turns in a joint is written `{0} VALUE on JOINT`",
                        names::element_name(element.kind),
                        positions::described(position, mechanism)
                    ),
                );
            return;
        }
    }
}

/// Springs and dampers between points, and from the end of each to its start. A spring that has no
/// length without force does not need a direction.
fn spans<'m>(algebra: &mut Algebra<'m>) -> Vec<(&'m Element, Vn<'m>)> {
    let mut spans = Vec::new();
    for element in &algebra.mechanism.elements {
        let needs_direction = match element.kind {
            ElementKind::Spring => element.free.is_some(),
            ElementKind::Damper => true,
        };
        if let Between::Points(ends) = &element.between
            && needs_direction
        {
            let [start, end] = [0, 1].map(|end| geometry::vector_of(algebra, &ends[end].1));
            spans.push((element, start - end));
        }
    }
    spans
}
