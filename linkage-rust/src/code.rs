//! Code as tokens and as text.
//!
//! The macro runs without optimisation: each token that it makes takes thousands of instructions.
//! A text is read by rustc, at a tenth of that, so most code is printed as text. Tokens are left
//! where names have their places in the text of the user.

use std::fmt::{Arguments, Write};

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;

extern crate proc_macro;

/// The tokens of a text. The function of `proc_macro2` would read it twice, without optimisation.
pub(super) fn tokens(text: &str) -> TokenStream {
    const READ: &str = "printed code consists of tokens";
    match proc_macro::is_available() {
        true => text.parse::<proc_macro::TokenStream>().expect(READ).into(),
        false => text.parse().expect(READ),
    }
}

/// The text of tokens.
pub(super) fn text(tokens: &impl ToTokens) -> String {
    tokens.to_token_stream().to_string()
}

/// Appends a formatted text.
pub(super) fn put(text: Arguments, code: &mut String) {
    code.write_fmt(text).expect("a string has no errors");
}

/// A list of tokens. Each stream of tokens is kept by rustc, and every step from stream to stream
/// is a call of it.
#[derive(Clone, Debug, Default)]
pub(super) struct Code(Vec<TokenTree>);

impl From<TokenStream> for Code {
    fn from(stream: TokenStream) -> Self {
        Self(stream.into_iter().collect())
    }
}

impl ToTokens for Code {
    /// Appends the tokens one by one: no stream is made on the way.
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(self.0.iter().cloned());
    }
}

/// Several streams as one. One step: a stream that grows is handed to rustc and back each time.
pub(super) fn joined(streams: impl IntoIterator<Item = TokenStream>) -> TokenStream {
    streams.into_iter().collect()
}
