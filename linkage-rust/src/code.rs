//! Tokens in a list, for code of which there is much.
//!
//! Each stream of tokens is kept by rustc, and every step from stream to stream is a call of it.
//! A list is one call in all, and one more for each group in it.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::ToTokens;

/// A list of tokens.
#[derive(Clone, Debug, Default)]
pub(super) struct Code(Vec<TokenTree>);

impl Code {
    /// Appends a token.
    pub(super) fn tree(&mut self, tree: TokenTree) {
        self.0.push(tree);
    }

    /// Appends tokens.
    pub(super) fn trees(&mut self, trees: &[TokenTree]) {
        for tree in trees {
            self.0.push(tree.clone());
        }
    }

    /// Appends the tokens of another list.
    pub(super) fn code(&mut self, other: &Self) {
        self.trees(&other.0);
    }

    /// Appends the tokens of a stream.
    pub(super) fn stream(&mut self, stream: TokenStream) {
        self.0.extend(stream);
    }

    /// Appends a name.
    pub(super) fn ident(&mut self, ident: &Ident) {
        self.0.push(TokenTree::Ident(ident.clone()));
    }

    /// Appends a word of the language, or a name of generated code.
    pub(super) fn word(&mut self, word: &str) {
        self.0.push(Ident::new(word, Span::call_site()).into());
    }

    /// Appends a sign of one character.
    pub(super) fn sign(&mut self, sign: char) {
        self.0.push(Punct::new(sign, Spacing::Alone).into());
    }

    /// Appends a group.
    pub(super) fn group(&mut self, delimiter: Delimiter, inner: TokenStream) {
        self.0.push(Group::new(delimiter, inner).into());
    }

    /// Returns the list as a stream.
    pub(super) fn into_stream(self) -> TokenStream {
        self.0.into_iter().collect()
    }
}

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
