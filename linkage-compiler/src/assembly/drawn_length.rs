//! Lengths of links that are given, and drawn otherwise.

use std::collections::BTreeSet;

use crate::algebra::Nominal;
use crate::diagnostic::OriginId;
use crate::model::{Expr, ExprKind, Loop, Mechanism, Name};

/// The difference from the drawing, as a share of the length, that is no rounding of coordinates.
const DRAWN_APART: f64 = 0.02;

/// A given length and that of the drawing, in the unit of the mechanism.
pub(super) struct DrawnLength {
    pub(super) name: String,
    pub(super) given: f64,
    pub(super) drawn: f64,
    /// The text of the given length.
    pub(super) origin: OriginId,
}

/// Returns the given length on which loops depend that differs most from its drawing, as a share;
/// `None` if all of them are as they are drawn.
pub(super) fn drawn_otherwise(
    mechanism: &Mechanism,
    nominal: &Nominal,
    loops: &[usize],
) -> Option<DrawnLength> {
    let links = mechanism.links.as_ref()?;
    let used = parameters_of(mechanism, loops);
    let lengths = used.into_iter().filter_map(|index| {
        let parameter = &mechanism.parameters[index];
        let drawn = links.drawn_lengths.get(&parameter.name)? / mechanism.unit.metres();
        Some(DrawnLength {
            name: parameter.name.clone(),
            given: nominal.parameters[parameter.first_scalar.0],
            drawn,
            origin: parameter.nominal.origin,
        })
    });
    let apart = |length: &DrawnLength| {
        (length.given - length.drawn).abs() / length.given.abs().max(length.drawn)
    };
    let largest = lengths.max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
    (apart(&largest) > DRAWN_APART).then_some(largest)
}

/// Returns the parameters that loops are written with, also by derived quantities.
fn parameters_of(mechanism: &Mechanism, loops: &[usize]) -> BTreeSet<usize> {
    let sides = loops.iter().flat_map(|&index| {
        let Loop { left, right, .. } = &mechanism.loops[index];
        [left, right]
    });
    let lets = mechanism.lets.iter().zip(mechanism.usage(loops).lets);
    let lets = lets.filter(|(_, used)| *used).map(|(item, _)| &item.value);
    let parts = sides.chain(lets).flat_map(Expr::parts);
    let named = parts.filter_map(|part| match part.kind {
        ExprKind::Name(Name::Parameter(index)) => Some(index),
        _ => None,
    });
    named.collect()
}
