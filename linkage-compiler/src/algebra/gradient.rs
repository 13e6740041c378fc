//! Derivatives of one number by parameters from its gradient: each parameter visits the ends that it acts on.

use crate::algebra::acting;
use crate::algebra::partial;
use crate::algebra::reverse;
use std::rc::Rc;

use linkage_symbolic::{Ex, SymbolId};

use super::Algebra;
use super::acting::ByParameter;

/// Derivatives of a number by nodes at which a sweep ends: what is known before the input, and inputs.
#[derive(Clone, Debug)]
pub(super) struct Gradient<'m> {
    ends: Vec<(Ex<'m>, Ex<'m>)>,
    /// The ends that a parameter acts on.
    acting: ByParameter,
}

/// The derivative of a number by a parameter, from the gradient of the number.
pub(super) fn gradient_by<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>, parameter: SymbolId) -> Ex<'m> {
    let known = algebra.derivatives.gradients.get(&x.id()).cloned();
    let gradient = known.unwrap_or_else(|| {
        let ends = reverse::gradient(algebra, x);
        let mut acting = ByParameter::default();
        for (place, (end, _)) in ends.iter().enumerate() {
            acting.add(place, &acting::acting_in(algebra, &[*end]));
        }
        let gradient = Rc::new(Gradient { ends, acting });
        let all = &mut algebra.derivatives.gradients;
        all.insert(x.id(), Rc::clone(&gradient));
        gradient
    });
    let zero = algebra.zero();
    let acting = gradient.acting.of(parameter).iter();
    acting.fold(zero, |sum, &place| {
        let (end, weight) = gradient.ends[place];
        sum + partial::partial(algebra, end, parameter) * weight
    })
}
