//! `Debug` of results with vectors: their components by name, where a derive would show columns of
//! a matrix.

use proc_macro2::TokenStream;
use quote::quote;

use super::attribute;
use super::outline::{Field, Function, Outline, plain};
use super::spanned::aside;
use linkage_language::model::Shape;

/// False where a derive shows the same, or where the user derives it.
pub(super) fn is_shown(function: &Function) -> bool {
    let split = attribute::split(function.attributes);
    let derived = attribute::derived(split.result.iter().copied());
    derived.iter().all(|name| name != "Debug") && function.fields.iter().any(has_vectors)
}

/// Nothing where a derive shows the same, or where the user derives it.
pub(super) fn shown(outline: &Outline, function: &Function) -> Option<TokenStream> {
    if !is_shown(function) {
        return None;
    }
    let runtime = &outline.runtime;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let result = function.result;
    let title = plain(function.result);
    let fields = function.fields.iter().map(|field| {
        let (name, title) = (aside(field.name), plain(field.name));
        match has_vectors(field) {
            true => quote!(.field(#title, &#runtime::named(&self.#name))),
            false => quote!(.field(#title, &self.#name)),
        }
    });
    Some(quote! {
        #(#everywhere)*
        #[automatically_derived]
        impl<T: ::core::fmt::Debug> ::core::fmt::Debug for #result<T> {
            fn fmt(&self, __f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                __f.debug_struct(#title)#(#fields)*.finish()
            }
        }
    })
}

fn has_vectors(field: &Field) -> bool {
    fn within(shape: &Shape) -> bool {
        match shape {
            Shape::Vector(_) => true,
            Shape::Array(_, entry) => within(entry),
            // It shows its own.
            Shape::Scalar | Shape::Frame | Shape::PlaneFrame => false,
        }
    }
    within(&field.shape)
}
