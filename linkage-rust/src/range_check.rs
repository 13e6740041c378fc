//! The check of the declared range of an assembly.

use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Outline, plain};

/// `check_range()`; nothing if a function of the user has this name.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        functions,
        ..
    } = outline;
    if functions
        .iter()
        .any(|function| plain(function.name) == "check_range")
    {
        return TokenStream::new();
    }
    let body = outline.body(quote!(#runtime::check_range_of::<#name<__p::f64>>(self)));
    quote! {
        #runtime::if_alloc! {
            impl #assembly<__p::f64> {
                /// Searches the declared range for change points, dead points and gaps, as the compiler does for the default
                /// dimensions. An angle without a range is searched for change points over a turn about its reference.
                #[must_use]
                #[inline]
                pub fn check_range(&self) -> #runtime::RangeReport { #body }
            }
        }
    }
}
