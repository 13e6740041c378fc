//! Names in one normal form, that of rustc: two spellings that look the same are one name.

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use unicode_normalization::{UnicodeNormalization, is_nfc};

/// Returns a name in the form in which names are compared.
#[must_use]
pub fn normal_form(name: &str) -> String {
    name.nfc().collect()
}

/// Tokens whose names are in the normal form, at the places where they were.
pub(crate) fn normalised(tokens: TokenStream) -> TokenStream {
    let one = |token: TokenTree| match token {
        TokenTree::Ident(name) => name_of(name).into(),
        TokenTree::Group(group) => {
            let mut copy = Group::new(group.delimiter(), normalised(group.stream()));
            copy.set_span(group.span());
            copy.into()
        }
        other => other,
    };
    tokens.into_iter().map(one).collect()
}

fn name_of(name: Ident) -> Ident {
    let text = name.to_string();
    if is_nfc(&text) {
        return name;
    }
    let normal: String = text.nfc().collect();
    match normal.strip_prefix("r#") {
        Some(plain) => Ident::new_raw(plain, name.span()),
        None => Ident::new(&normal, name.span()),
    }
}
