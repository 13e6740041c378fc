//! The check of the declared range of an assembly.

use linkage_core::range_check::Slack;
use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Outline, plain};
use super::{assembly_data, literal};
use linkage_compiler::ir::CompiledMechanism;

/// `check_range()`; nothing for a mechanism without groups.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if unit.groups.is_empty() {
        return TokenStream::new();
    }
    let Outline { runtime, name, .. } = outline;
    let float = quote!(__p::f64);
    let title = outline.title();
    let slacks = unit.groups.iter().map(|group| {
        let slack = match group.slack {
            Slack::Number => quote!(Number),
            Slack::Relative => quote!(Relative),
            Slack::Signed => quote!(Signed),
            Slack::Prepared => quote!(Prepared),
        };
        quote!(#runtime::Slack::#slack)
    });
    let units = unit.groups.iter().map(|group| &group.gap_unit);
    let repeats = unit.repeats();
    let count = literal::index(unit.inputs.len());
    let inputs = quote!(::core::array::from_fn::<#float, #count, _>(|__k| __x[__k]));
    let x = match outline.starts.is_empty() {
        true => inputs.clone(),
        false => {
            let starts = assembly_data::starts(outline, &quote!(self));
            quote!(Self::__extend(#starts, #inputs))
        }
    };
    let core = &outline.core;
    let fields = assembly_data::core(outline, &quote!(self));
    method(
        outline,
        quote! {
            #runtime::check_range(
                &#runtime::Ranged {
                    mechanism: #title,
                    inputs: #name::<#float>::INPUTS,
                    groups: #name::<#float>::STRUCTURE.groups,
                    slacks: &[#(#slacks),*],
                    units: &[#(#units),*],
                    repeats: #repeats,
                },
                &|__x| ::core::convert::From::from(self.__survey::<{ #runtime::FUSED }>(#inputs)),
                &|__x| {
                    let #core { __mechanism: __m, __modes, __prepared, .. } = #fields;
                    ::core::convert::From::from(Self::__gaps::<{ #runtime::FUSED }>(__m, __modes, __prepared, #x))
                },
            )
        },
    )
}

/// The method of a mechanism with mistakes.
pub(super) fn skeleton(outline: &Outline) -> TokenStream {
    method(outline, TokenStream::new())
}

/// Nothing if a function of the user has this name.
fn method(outline: &Outline, body: TokenStream) -> TokenStream {
    let Outline {
        runtime,
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
    let body = outline.body(body);
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
