//! The block around generated code: it has short names for the runtime, and silences lints once.

use proc_macro2::TokenStream;
use quote::quote;

use super::attribute;
use super::outline::Outline;

/// All items but types, in the block of a constant. They see what the module or the function around
/// them has, and what the block imports is seen by nothing else.
pub(super) fn items(outline: &Outline, code: &TokenStream) -> TokenStream {
    let facade = &outline.facade;
    let allow = attribute::allow();
    quote! {
        #allow
        const _: () = {
            use #facade as __p;
            #code
        };
    }
}
