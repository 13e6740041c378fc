//! Characters that pictures and pages can show.

use std::string::{String, ToString};

use crate::mistake::Mistake;

/// Returns the first character that neither XML nor HTML can show, such as a control character.
/// Line ends and tabs are spaces there.
pub fn control(what: &str, words: &str) -> Option<Mistake> {
    let is_shown = |c: char| matches!(c, '\t' | '\n' | '\r') || !c.is_control();
    let is_character = |c: char| u32::from(c) & 0xFFFE != 0xFFFE;
    let (at, character) = words
        .char_indices()
        .find(|&(_, c)| !is_shown(c) || !is_character(c))?;
    Some(Mistake::Control {
        what: what.to_string(),
        before: words[..at].to_string(),
        character,
    })
}

/// Text that is no markup.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
