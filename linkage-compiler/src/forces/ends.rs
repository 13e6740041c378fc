//! Do the ends of springs and dampers stay apart?

use crate::diagnostic::{Diagnostics, Origins};
use crate::formulate::{Reference, Words};
use crate::model::{Between, ElementKind, Mechanism};

use super::Mechanics;

/// A length below this share of the mechanism's has no direction.
const NOTHING: f64 = 1e-9;

impl Mechanics<'_, '_> {
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

fn word(mechanism: &Mechanism, element: usize) -> &'static str {
    match mechanism.elements[element].kind {
        ElementKind::Spring => "spring",
        ElementKind::Damper => "damper",
    }
}

/// `at phi = 30deg `; nothing without inputs.
pub(super) fn place(mechanism: &Mechanism, inputs: &[f64]) -> String {
    let all: Vec<usize> = (0..inputs.len()).collect();
    match inputs.len() {
        0 => String::new(),
        _ => format!("at {} ", Words::new(mechanism).inputs(inputs, &all)),
    }
}
