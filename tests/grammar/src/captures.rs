//! Captures of a query in a text.

use streaming_iterator::StreamingIterator;
use tree_sitter::{Query, QueryCursor};

use crate::parsed::{language, tree};

/// Captures of a query in a text: their names and the texts of their nodes, in the order of the
/// text.
pub struct Captures(Vec<(String, String)>);

impl Captures {
    /// Applies a query to a text.
    ///
    /// # Panics
    ///
    /// If the query has a mistake.
    pub fn of(query: &str, text: &str) -> Self {
        let query = Query::new(&language(), query).unwrap_or_else(|error| panic!("{error}"));
        let tree = tree(text);
        let mut cursor = QueryCursor::new();
        let mut captures = cursor.captures(&query, tree.root_node(), text.as_bytes());
        let mut found = Vec::new();
        while let Some((matched, index)) = captures.next() {
            let capture = matched.captures()[*index];
            let name = query.capture_names()[capture.index as usize];
            // For conditions only.
            if name.starts_with('_') {
                continue;
            }
            let node = capture.node.utf8_text(text.as_bytes());
            found.push((
                name.to_owned(),
                node.expect("a text of whole letters").to_owned(),
            ));
        }
        Self(found)
    }

    /// Returns the last capture of a node with this text: later patterns override earlier
    /// ones.
    pub fn last_of(&self, text: &str) -> Option<&str> {
        let mut captures = self.0.iter().rev();
        let found = captures.find(|(_, node)| node == text);
        found.map(|(name, _)| name.as_str())
    }

    /// Returns the texts of all nodes with a capture of this name.
    pub fn all(&self, name: &str) -> Vec<&str> {
        let captures = self.0.iter().filter(|(own, _)| own == name);
        captures.map(|(_, node)| node.as_str()).collect()
    }
}
