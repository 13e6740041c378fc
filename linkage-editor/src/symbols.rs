//! The names of a text as a tree.

use std::ops::Range;

use crate::declaration::{Declaration, NameKind};
use crate::document::Document;

/// A declared name, with those within it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The name.
    pub name: String,
    /// Its kind.
    pub kind: NameKind,
    /// Its type, if that is known.
    pub detail: String,
    /// The item that declares it.
    pub item: Range<usize>,
    /// The name in the item.
    pub range: Range<usize>,
    /// The names within it.
    pub inner: Vec<Symbol>,
}

/// Returns the mechanisms, their names and functions.
pub(crate) fn symbols(document: &Document) -> Vec<Symbol> {
    let outlines = document.outlines.iter();
    let mechanisms = outlines.map(|outline| {
        let facts = document.facts(&outline.mechanism.name);
        let named = |declared: &Declaration| {
            let fact = facts.and_then(|facts| facts.names.get(&declared.name));
            let detail = fact.map_or_else(String::new, |fact| fact.ty.clone());
            symbol(declared, detail, Vec::new())
        };
        let functions = outline.functions.iter().map(|function| {
            let fields = function.fields.iter().map(named);
            symbol(&function.function, String::new(), fields.collect())
        });
        let inner = outline.names.iter().map(named).chain(functions);
        symbol(&outline.mechanism, String::new(), inner.collect())
    });
    mechanisms.collect()
}

fn symbol(declared: &Declaration, detail: String, inner: Vec<Symbol>) -> Symbol {
    // Functions follow after the struct block, and belong to it.
    let end = inner
        .iter()
        .map(|symbol| symbol.item.end)
        .max()
        .unwrap_or(0);
    Symbol {
        name: declared.name.clone(),
        kind: declared.kind,
        detail,
        item: declared.item.start..declared.item.end.max(end),
        range: declared.range.clone(),
        inner,
    }
}
