//! Declarations of names, and all their uses.

use std::ops::Range;

use crate::document::Document;
use crate::uses::declaration;

impl Document {
    /// Returns the words that declare the name at a byte.
    #[must_use]
    pub fn definition(&self, offset: usize) -> Option<Range<usize>> {
        let found = self.use_at(offset)?;
        Some(declaration(&self.outlines, found.symbol).range.clone())
    }

    /// Returns all uses of the name at a byte, in order, with its declaration if that is wanted.
    #[must_use]
    pub fn references(&self, offset: usize, with_declaration: bool) -> Vec<Range<usize>> {
        let Some(found) = self.use_at(offset) else {
            return Vec::new();
        };
        let declared = &declaration(&self.outlines, found.symbol).range;
        let uses = self
            .uses
            .iter()
            .filter(|other| other.symbol == found.symbol);
        let ranges = uses.map(|other| other.range.clone());
        ranges
            .filter(|range| with_declaration || range != declared)
            .collect()
    }
}
