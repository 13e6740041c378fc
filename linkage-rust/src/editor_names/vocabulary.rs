//! Words of the language as items that editors know: their meanings in hovers, and functions among
//! the completions.

use std::collections::BTreeSet;

use linkage_language::model::{CalledWord, plain_word};
use linkage_language::syntax::Word;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// Returns a word of items, of clauses or of courses.
pub(super) fn word(word: &str) -> Option<&'static str> {
    plain_word(word, None).map(|(word, _)| word)
}

/// A word as a name of Rust, where it is written.
pub(super) fn raw(word: &Ident) -> Ident {
    Ident::new_raw(&word.to_string(), word.span())
}

/// The type whose fields are these words.
pub(super) fn words(holder: &Ident, words: &BTreeSet<&str>) -> TokenStream {
    let fields = words.iter().filter_map(|word| {
        let (_, meaning) = plain_word(word, None)?;
        let field = Ident::new_raw(word, Span::call_site());
        Some(quote!(#[doc = #meaning] #field: (),))
    });
    quote!(struct #holder { #(#fields)* })
}

/// Returns true for a function of expressions or a quantity.
pub(super) fn is_function(word: &str) -> bool {
    CalledWord::from_word(word).is_some()
}

/// The functions as methods of the names of a mechanism: where a name can be written, they can.
pub(super) fn methods(holder: &Ident) -> TokenStream {
    let methods = functions().map(|(word, arguments, meaning)| {
        let name = format_ident!("{word}");
        let arguments = arguments.iter().enumerate().map(|(index, argument)| {
            // Some may be left out, and some come twice.
            let plain = argument.trim_end_matches('?').trim_matches(['[', ']']);
            let is_second = arguments[..index]
                .iter()
                .any(|before| before.starts_with(plain));
            let number = if is_second { "2" } else { "" };
            let argument = Ident::new_raw(&format!("{plain}{number}"), Span::call_site());
            quote!(#argument: f64)
        });
        quote!(#[doc = #meaning] fn #name(&self, #(#arguments),*) {})
    });
    quote!(impl #holder { #(#methods)* })
}

/// Each word with its arguments and its meaning.
fn functions() -> impl Iterator<Item = (&'static str, &'static [&'static str], &'static str)> {
    CalledWord::all().map(|called| {
        let arguments = match called {
            CalledWord::Function(function) => function.parameters(),
            CalledWord::Quantity(quantity) => quantity.parameters(),
            // Their arguments are knots and words.
            CalledWord::Law(_) => &[],
        };
        (called.word(), arguments, called.description())
    })
}
