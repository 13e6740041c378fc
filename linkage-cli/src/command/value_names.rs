//! Names of a mechanism in values of the command line.

use linkage_engine::Mechanism;
use linkage_language::syntax::is_unit;
use proc_macro2::{TokenStream, TokenTree};

/// A name of the mechanism in a value, except where the word is part of a unit, as `s` in
/// `700mm/s`.
pub(super) fn name_within(mechanism: &Mechanism, tokens: TokenStream) -> Option<String> {
    // True behind a number with a unit, and within that unit.
    let mut in_unit = false;
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Ident(word) => {
            let word = word.to_string();
            in_unit = in_unit && is_unit(&word);
            (!in_unit && is_name(mechanism, &word)).then_some(word)
        }
        TokenTree::Literal(number) => {
            // The exponent of a unit has none.
            in_unit |= number.to_string().ends_with(char::is_alphabetic);
            None
        }
        TokenTree::Punct(sign) => {
            in_unit = in_unit && matches!(sign.as_char(), '*' | '/' | '^');
            None
        }
        TokenTree::Group(group) => {
            in_unit = false;
            name_within(mechanism, group.stream())
        }
    })
}

fn is_name(mechanism: &Mechanism, word: &str) -> bool {
    let parameters = mechanism
        .parameters()
        .iter()
        .map(|parameter| parameter.name);
    let inputs = mechanism.inputs().iter().map(|input| input.name);
    let unknowns = mechanism
        .compiled()
        .unknowns
        .iter()
        .map(|unknown| unknown.name.as_str());
    let mut names = parameters.chain(inputs).chain(unknowns);
    names.any(|name| name == word)
}
