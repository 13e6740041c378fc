//! Mechanisms within a mechanism that have no parts themselves.

use std::ops::Range;

use crate::model::symbols::part_scopes::PartBody;
use crate::model::types::Leaf;

impl PartBody {
    /// Returns the part itself, or the parts within it. Its loops come after `loops` others.
    pub(in crate::model) fn leaves(&self, loops: usize) -> Vec<Leaf> {
        let mechanism = self.mechanism();
        let whole = Leaf {
            lets: 0..mechanism.lets.len(),
            loops: 0..mechanism.loops.len(),
            unknowns: 0..mechanism.unknowns.len(),
        };
        let leaves = if mechanism.parts.is_empty() {
            vec![whole]
        } else {
            mechanism.leaves.clone()
        };
        let behind = |range: Range<usize>, others: usize| range.start + others..range.end + others;
        let leaves = leaves.into_iter().map(|leaf| Leaf {
            lets: behind(leaf.lets, self.own_lets()),
            loops: behind(leaf.loops, loops),
            unknowns: behind(leaf.unknowns, self.first_unknown),
        });
        leaves.collect()
    }
}
