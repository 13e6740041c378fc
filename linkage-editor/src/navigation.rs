//! Declarations of names, and all their uses.

use std::ops::Range;

use crate::document::Document;
use crate::uses::declaration;

/// Returns the words that declare the name at a byte.
pub(crate) fn definition(document: &Document, offset: usize) -> Option<Range<usize>> {
    let found = document.use_at(offset)?;
    Some(declaration(&document.outlines, found.symbol).range.clone())
}

/// Returns all uses of the name at a byte, in order, with its declaration if that is wanted.
pub(crate) fn references(
    document: &Document,
    offset: usize,
    with_declaration: bool,
) -> Vec<Range<usize>> {
    let Some(found) = document.use_at(offset) else {
        return Vec::new();
    };
    let declared = &declaration(&document.outlines, found.symbol).range;
    let uses = document
        .uses
        .iter()
        .filter(|other| other.symbol == found.symbol);
    let ranges = uses.map(|other| other.range.clone());
    ranges
        .filter(|range| with_declaration || range != declared)
        .collect()
}
