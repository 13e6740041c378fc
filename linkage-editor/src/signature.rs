//! The call around a place: its arguments, and the one that is being written.

use std::ops::Range;

use linkage_language::model::{Function, MotionLawWord, QuantityWord};
use linkage_language::syntax::Word;

use crate::context::call_at;
use crate::document::Document;

/// A call of a function or quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// The call: `polar(length, angle)`.
    pub label: String,
    /// The bytes of each argument in the label.
    pub arguments: Vec<Range<usize>>,
    /// The index of the argument that is being written.
    pub active: usize,
    /// Its meaning, in Markdown.
    pub documentation: String,
}

/// Returns the call around a byte.
pub(crate) fn signature(document: &Document, offset: usize) -> Option<Signature> {
    let call = call_at(document, offset)?;
    let word = call.word.as_str();
    let described = Function::from_word(word)
        .map(|word| (call_of_function(word), word.description()))
        .or_else(|| {
            let word = QuantityWord::from_word(word)?;
            Some((call_of_quantity(word), word.description()))
        })
        .or_else(|| {
            let word = MotionLawWord::from_word(word)?;
            let form = word.form();
            // Of several forms, the first one.
            let form = form.split('`').next().unwrap_or(form);
            Some((form.to_owned(), word.description()))
        });
    let (label, documentation) = described?;
    Some(Signature {
        arguments: arguments(&label),
        label,
        active: call.argument,
        documentation: documentation.to_owned(),
    })
}

/// Returns the call of a function as messages show it.
pub(crate) fn call_of_function(word: Function) -> String {
    format!("{}({})", word.word(), word.parameters().join(", "))
}

/// Returns the call of a quantity; arguments that may be left out end with `?`.
pub(crate) fn call_of_quantity(word: QuantityWord) -> String {
    format!("{}({})", word.word(), word.parameters().join(", "))
}

/// Returns the bytes of the arguments between the parentheses of a call.
fn arguments(label: &str) -> Vec<Range<usize>> {
    let Some(open) = label.find('(') else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let (mut depth, mut start) = (0, open + 1);
    for (index, c) in label.char_indices().skip(open + 1) {
        match c {
            '(' | '[' => depth += 1,
            ')' if depth == 0 => {
                found.push(start..index);
                break;
            }
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                found.push(start..index);
                start = index + 2;
            }
            _ => {}
        }
    }
    found.retain(|range| !range.is_empty());
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_one_argument() {
        let label = "piecewise(x, [(place, value), (place, value, law)])";
        let found = arguments(label);
        let texts: Vec<&str> = found.into_iter().map(|range| &label[range]).collect();
        assert_eq!(texts, ["x", "[(place, value), (place, value, law)]"]);
        assert!(arguments("margin()").is_empty());
    }
}
