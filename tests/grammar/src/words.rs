//! Words of grammars.

use crate::parsed::language;

/// Returns the words of the grammar that are no names of nodes.
pub fn kinds_of_words() -> Vec<String> {
    let language = language();
    let kinds = (0..language.node_kind_count() as u16)
        .filter(|kind| !language.node_kind_is_named(*kind) && language.node_kind_is_visible(*kind));
    let kinds = kinds.filter_map(|kind| language.node_kind_for_id(kind));
    let words = kinds.filter(|kind| kind.starts_with(char::is_alphabetic));
    words.map(str::to_owned).collect()
}

/// Returns all texts in quotes.
pub fn quoted(text: &str) -> Vec<&str> {
    text.split('"').skip(1).step_by(2).collect()
}
