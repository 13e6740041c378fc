//! C that is written once for both types of numbers.
//!
//! In a template `real` is the type of numbers, `word` an unsigned integer as long, `own_` the
//! beginning of names that nothing else has; numbers with a point and names in capitals become
//! constants of that type.

use crate::real::Real;

/// Fills a template for a type of numbers. `own_` becomes `private`, the beginning of private names
/// of the mechanism, and `other` returns the texts for more names.
pub(crate) fn fill(
    template: &str,
    real: Real,
    private: &str,
    other: impl Fn(&str) -> Option<String>,
) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if first.is_ascii_digit() {
            number_length(rest)
        } else if is_of_name(first) {
            rest.find(|c| !is_of_name(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (piece, next) = rest.split_at(length);
        rest = next;
        let is_real = first.is_ascii_digit() && piece.contains('.');
        if let (true, Ok(x)) = (is_real, piece.parse()) {
            text += &real.literal(x);
        } else if let Some(name) = piece.strip_prefix("own_") {
            text += private;
            text += name;
        } else if let Some(word) = real.template_word(piece).or_else(|| other(piece)) {
            text += &word;
        } else {
            text += piece;
        }
    }
    text
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The length of a number at the beginning of a text, its exponent with it.
fn number_length(text: &str) -> usize {
    let mut before = ' ';
    let end = text.find(|c: char| {
        let sign = (c == '-' || c == '+') && before == 'e';
        before = c;
        !(is_of_name(c) || c == '.' || sign)
    });
    end.unwrap_or(text.len())
}
