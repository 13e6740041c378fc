//! Gears and belts as they are written.

use linkage_language::syntax::{MechanismDef, PairOfWheels};

use super::expression_text::text;

/// A pair of wheels as it is written.
pub(super) struct DeclaredWheels {
    /// The indices of the bodies; `None` is the frame.
    pub(super) bodies: [Option<usize>; 2],
    pub(super) carrier: Option<usize>,
    /// The turns of the second wheel for one turn of the first, as seen from the carrier.
    pub(super) ratio: String,
}

/// Returns the pairs of wheels of a definition.
pub(super) fn declared_wheels(
    definition: &MechanismDef,
    index_of: impl Fn(&str) -> Option<usize>,
) -> Vec<DeclaredWheels> {
    let pairs = definition.link_elements.pairs.iter();
    let declared = pairs.map(|pair: &PairOfWheels| {
        let index = |name: &proc_macro2::Ident| index_of(&name.to_string());
        let body = |wheel: usize| pair.wheels[wheel].body.as_ref().and_then(index);
        DeclaredWheels {
            bodies: [body(0), body(1)],
            carrier: pair.carrier.as_ref().and_then(index),
            ratio: text(&pair.ratio),
        }
    });
    declared.collect()
}
