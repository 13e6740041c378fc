//! Formatting: one item on a line, blanks by rules, comments kept.
//!
//! Tokens stay as they are. Line breaks within an item and single blank lines are those of the user.

mod lines;
mod spacing;

use crate::lexer::{Kind, Token, tokens};
use lines::Writer;

/// Returns a text with all blanks by the rules of the language's formatter; `None` if a bracket has
/// no partner, or a character means nothing.
///
/// Formatting a formatted text changes nothing.
///
/// ```
/// use linkage_editor::formatted;
///
/// let text = "struct Crank{unit mm;param r=30mm;//of the crank
/// input phi=30deg in 0deg..360deg;}";
/// let expected = "struct Crank {
///     unit mm;
///     param r = 30mm;                             // of the crank
///     input phi = 30deg in 0deg..360deg;
/// }
/// ";
/// assert_eq!(formatted(text).unwrap(), expected);
/// ```
#[must_use]
pub fn formatted(text: &str) -> Option<String> {
    let all = tokens(text);
    if !is_balanced(text, &all) {
        return None;
    }
    let solid: Vec<&Token> = all
        .iter()
        .filter(|token| token.kind != Kind::Blank)
        .collect();
    let mut writer = Writer::new(text, &solid);
    (0..solid.len()).for_each(|index| writer.write(index));
    let written = writer.finished();
    Some(match text.contains("\r\n") {
        true => written.replace('\n', "\r\n"),
        false => written,
    })
}

/// Returns true if every bracket has its partner, and every character a meaning.
fn is_balanced(text: &str, tokens: &[Token]) -> bool {
    let mut open = Vec::new();
    for token in tokens {
        match (token.kind, token.text(text)) {
            (Kind::Open, bracket) => open.push(bracket),
            (Kind::Close, bracket) => {
                let partner = match bracket {
                    ")" => "(",
                    "]" => "[",
                    _ => "{",
                };
                if open.pop() != Some(partner) {
                    return false;
                }
            }
            (Kind::Unknown, _) => return false,
            _ => {}
        }
    }
    open.is_empty()
}

#[cfg(test)]
mod tests;
