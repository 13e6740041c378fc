//! Do the ends of springs and dampers stay on their bodies, and apart?

use crate::diagnostic::{Diagnostics, Origins};
use crate::formulate::Reference;
use crate::model::{Between, ElementKind, Mechanism, OriginId};

use super::Mechanics;
use super::check::{Pair, What, place};

/// A length below this share of the mechanism's has no direction.
const NOTHING: f64 = 1e-9;

impl Mechanics<'_, '_> {
    /// The ends of all springs and dampers between points, which stay on their bodies.
    pub(super) fn ends_of_elements(&mut self, input: usize) -> Vec<Pair> {
        let mut pairs = Vec::new();
        for (number, element) in self.algebra.mechanism.elements.iter().enumerate() {
            let Between::Points(ends) = &element.between else {
                continue;
            };
            for (end, (body, at)) in ends.iter().enumerate() {
                let point = self.algebra.vector_of(at);
                pairs.push(self.stays(*body, &point, input, What::End(number, end)));
            }
        }
        pairs
    }

    /// Reports a spring or damper whose ends meet: in which direction it acts cannot be told. A spring that has no length
    /// without force does not need one.
    pub(super) fn check_lengths(
        &mut self,
        (reference, inputs): (&Reference, &[f64]),
        origins: &Origins,
        diagnostics: &mut Diagnostics,
    ) -> bool {
        let mechanism = self.algebra.mechanism;
        for (number, element) in mechanism.elements.iter().enumerate() {
            let Between::Points(ends) = &element.between else {
                continue;
            };
            if element.kind == ElementKind::Spring && element.free.is_none() {
                continue;
            }
            let [start, end] = [0, 1].map(|end| self.algebra.vector_of(&ends[end].1));
            let between = self.algebra.difference(&start, &end);
            let graph = &self.algebra.graph;
            let between = reference.machine.evaluate(graph, &between, inputs);
            let length = between.iter().map(|x| x * x).sum::<f64>().sqrt();
            if length > NOTHING * reference.longest || length.is_nan() {
                continue;
            }
            diagnostics.error(
                origins.span(element.origin),
                format!(
                    "the ends of the {} meet: {}it has no direction\n\
                     help: check its points; what turns in a joint is written `{0} VALUE on JOINT`",
                    word(mechanism, number),
                    place(mechanism, inputs)
                ),
            );
            return true;
        }
        false
    }
}

pub(super) fn end_name(mechanism: &Mechanism, element: usize) -> String {
    format!("an end of the {}", word(mechanism, element))
}

pub(super) fn end_body(mechanism: &Mechanism, element: usize, end: usize) -> Option<usize> {
    match &mechanism.elements[element].between {
        Between::Points(ends) => ends[end].0,
        Between::Joint(_) => None,
    }
}

pub(super) fn end_origin(mechanism: &Mechanism, element: usize, end: usize) -> OriginId {
    match &mechanism.elements[element].between {
        Between::Points(ends) => ends[end].1.origin,
        Between::Joint(_) => mechanism.elements[element].origin,
    }
}

fn word(mechanism: &Mechanism, element: usize) -> &'static str {
    match mechanism.elements[element].kind {
        ElementKind::Spring => "spring",
        ElementKind::Damper => "damper",
    }
}
