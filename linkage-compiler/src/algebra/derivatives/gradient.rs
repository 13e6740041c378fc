//! Derivatives of one number by parameters from its gradient: each parameter visits the ends that
//! it acts on.

use std::rc::Rc;

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::{acting, partial, reverse};
use crate::algebra::memo::{ByParameter, Gradient};

/// The derivative of a number by a parameter, from the gradient of the number.
pub(crate) fn gradient_by<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>, parameter: SymbolId) -> Ex<'m> {
    let known = algebra.derivatives.gradients.get(&x.id()).cloned();
    let gradient = known.unwrap_or_else(|| {
        let ends = reverse::gradient(algebra, x);
        let mut acting = ByParameter::default();
        for (index, (end, _)) in ends.iter().enumerate() {
            let memo = &mut algebra.derivatives.partials.acting;
            let symbols = acting::acting_in(algebra.graph, &algebra.solutions, memo, &[*end]);
            acting.add(index, &symbols);
        }
        let gradient = Rc::new(Gradient { ends, acting });
        let all = &mut algebra.derivatives.gradients;
        all.insert(x.id(), Rc::clone(&gradient));
        gradient
    });
    let zero = algebra.zero();
    let acting = gradient.acting.positions_for(parameter).iter();
    acting.fold(zero, |sum, &index| {
        let (end, weight) = gradient.ends[index];
        sum + partial::partial(algebra, end, parameter) * weight
    })
}
