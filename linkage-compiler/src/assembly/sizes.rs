//! The size of the mechanism: lengths that others are compared with.

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, Bound, Nominal};
use crate::model::{Dimension, Expr, ExprKind, Mechanism};
use crate::solve::Formulation;

/// Lengths of one mechanism.
pub(super) struct Sizes {
    /// The unit in which lengths are compared with angles: the longest link that turns with an
    /// unknown angle, else the largest length among the parameters and estimates.
    pub(super) longest: f64,
    /// The largest known length: links, parameters, inputs at the reference, lengths that are
    /// written in loops.
    pub(super) largest: f64,
}

impl Sizes {
    pub(super) fn new<'m>(
        algebra: &Algebra<'m>,
        formulation: &Formulation<'m>,
        nominal: &Nominal,
    ) -> Self {
        let mechanism = algebra.mechanism;
        let parameters = mechanism.scalar_parameters.iter().zip(&nominal.parameters);
        let parameters = parameters.filter(|(p, _)| p.dimension.fits(Dimension::LENGTH));
        let parameter = largest(parameters.map(|(_, x)| *x));
        let unknowns = algebra.names.bound.iter().zip(&nominal.estimates);
        let slides = unknowns.filter(|(bound, _)| matches!(bound, Bound::Lengths(_)));
        let estimate = largest(slides.flat_map(|(_, estimate)| estimate.iter().copied()));
        let inputs = mechanism.inputs.iter().zip(&nominal.inputs);
        let inputs = inputs.filter(|(input, _)| input.dimension.fits(Dimension::LENGTH));
        let input = largest(inputs.map(|(_, x)| *x));

        let positive = |length: f64| Some(length).filter(|&length| length > 0.0);
        let link = largest(links(formulation, nominal).into_iter());
        let longest = positive(link).or_else(|| positive(parameter.max(estimate)));
        let longest = longest.unwrap_or(1.0);
        let known = [longest, parameter, input, largest(written(mechanism))];
        Self {
            longest,
            largest: largest(known.into_iter()),
        }
    }
}

fn largest(lengths: impl Iterator<Item = f64>) -> f64 {
    lengths.map(f64::abs).fold(0.0, f64::max)
}

/// The lengths of the links that turn with unknown angles.
fn links<'m>(formulation: &Formulation<'m>, nominal: &Nominal) -> Vec<f64> {
    let groups = formulation.groups.iter();
    let vectors: Vec<Vec<Ex>> = groups.flat_map(|s| s.group.form.links()).collect();
    let values = nominal.evaluate(&vectors.concat());
    let mut values = values.into_iter();
    let links = vectors.iter().map(|vector| {
        let components = values.by_ref().take(vector.len());
        components.fold(0.0, |length: f64, x| length.hypot(x))
    });
    links.collect()
}

/// Returns the lengths that are written as numbers in loops and in the definitions that loops use.
fn written(mechanism: &Mechanism) -> impl Iterator<Item = f64> {
    let constants = mechanism.constants.iter().map(|item| &item.value);
    let lets = mechanism.lets.iter().map(|item| &item.value);
    let sides = mechanism
        .loops
        .iter()
        .flat_map(|item| [&item.left, &item.right]);
    let parts = constants.chain(lets).chain(sides).flat_map(Expr::parts);
    parts.filter_map(|part| match (&part.kind, part.ty.dimension()) {
        (ExprKind::Number(x), Some(dimension)) if dimension.fits(Dimension::LENGTH) => Some(*x),
        _ => None,
    })
}
