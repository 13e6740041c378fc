//! Types whose errors rustc reports at a word of the user, and names without a place in the text.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

/// A generated type, all of it but its fields where the user wrote `word`; so is its `visibility`.
pub(super) fn type_at(
    word: &Ident,
    name: &Ident,
    visibility: &TokenStream,
    fields: TokenStream,
) -> TokenStream {
    let span = word.span();
    let mut name = name.clone();
    name.set_span(span);
    quote_spanned!(span=> #visibility struct #name<T = ::core::primitive::f64> { #fields })
}

/// The same for a type with one field, without a name.
pub(super) fn tuple_type_at(
    word: &Ident,
    name: &Ident,
    visibility: &TokenStream,
    field: TokenStream,
) -> TokenStream {
    let span = word.span();
    let mut name = name.clone();
    name.set_span(span);
    quote_spanned!(span=> #visibility struct #name<T = ::core::primitive::f64>(#field);)
}

/// The name as generated code uses it: an editor that asks for the meaning of the user's word does
/// not come here.
pub(super) fn aside(name: &Ident) -> Ident {
    let mut name = name.clone();
    name.set_span(Span::call_site());
    name
}
