//! Words of the language, as the compiler lists them.

use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax::parse;

use crate::parsed::language;

/// Returns the words that a message lists for a text with a mistake: those after `before`.
///
/// # Panics
///
/// If no message of the text has `before`.
pub fn listed_by_message(text: &str, before: &str) -> Vec<String> {
    let mut diagnostics = Diagnostics::default();
    let tokens = text.parse().expect("the text has tokens");
    parse(tokens, &mut diagnostics);
    let messages = diagnostics.texts();
    let listed = messages
        .iter()
        .find_map(|message| Some(message.split_once(before)?.1));
    let listed = listed.unwrap_or_else(|| panic!("no `{before}` in {messages:?}"));
    let line = listed.split([';', '\n']).next().unwrap_or_default();
    let words = line.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    let words = words.filter(|word| !word.is_empty() && *word != "and");
    words.map(str::to_owned).collect()
}

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
