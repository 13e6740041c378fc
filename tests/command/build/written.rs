//! The mechanisms that stand in a text. The engine reads texts as well: a build script that used it would build it a second time.

use proc_macro2::{TokenStream, TokenTree};

/// Returns the tokens of each call of `mechanism!`, or all of a text without one, which is a mechanism as a whole.
pub(crate) fn written(text: &str) -> Vec<TokenStream> {
    let tokens: TokenStream = text.parse().expect("tokens");
    let mut calls = Vec::new();
    collect(tokens.clone(), &mut calls);
    if calls.is_empty() {
        calls.push(tokens);
    }
    calls
}

fn collect(tokens: TokenStream, calls: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        match &tokens[..index] {
            [.., TokenTree::Ident(word), TokenTree::Punct(mark)]
                if word == "mechanism" && mark.as_char() == '!' =>
            {
                calls.push(group.stream());
            }
            _ => collect(group.stream(), calls),
        }
    }
}
