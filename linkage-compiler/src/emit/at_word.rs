//! Types whose errors rustc reports at a word of the user.

use proc_macro2::{Ident, TokenStream};
use quote::quote_spanned;

/// A generated type, all of it but its fields where the user wrote `word`: rustc says there that the module has such a type already, from
/// another mechanism for instance, which nothing that is expanded alone can know.
pub(super) fn type_at(
    word: &Ident,
    name: &Ident,
    visibility: &TokenStream,
    fields: TokenStream,
) -> TokenStream {
    let span = word.span();
    let visibility = visibility.clone().into_iter().map(|mut token| {
        token.set_span(span);
        token
    });
    let visibility: TokenStream = visibility.collect();
    let mut name = name.clone();
    name.set_span(span);
    quote_spanned!(span=> #visibility struct #name<T = ::core::primitive::f64> { #fields })
}
