//! Mechanisms within a mechanism that have no parts themselves.

use std::ops::Range;

use crate::model::symbols::part_scopes::PartBody;
use crate::model::types::Leaf;

impl PartBody {
    /// The part itself, or those within it; its loops stand behind so many others.
    pub(in crate::model) fn leaves(&self, loops: usize) -> Vec<Leaf> {
        let mechanism = self.mechanism();
        let whole = Leaf {
            lets: 0..mechanism.lets.len(),
            loops: 0..mechanism.loops.len(),
            unknowns: 0..mechanism.unknowns.len(),
        };
        let own = match mechanism.parts.is_empty() {
            true => vec![whole],
            false => mechanism.leaves.clone(),
        };
        let behind = |own: Range<usize>, others: usize| own.start + others..own.end + others;
        let own = own.into_iter().map(|own| Leaf {
            lets: behind(own.lets, self.own_lets()),
            loops: behind(own.loops, loops),
            unknowns: behind(own.unknowns, self.first_unknown),
        });
        own.collect()
    }
}
