//! The assemblies of a mechanism with one input that run through its range.

use linkage_core::Cycle;
use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;
use linkage_compiler::ir::{CompiledMechanism, Input};

/// `circuits()`; nothing for a mechanism without groups or with another number of inputs than one.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let ([input], false) = (&unit.inputs[..], unit.groups.is_empty()) else {
        return TokenStream::new();
    };
    let runtime = &outline.runtime;
    let cycle = cycle(outline, input);
    let method = method(outline, quote!(#runtime::circuits_of(self, &#cycle)));
    quote!(#runtime::if_alloc! { #method })
}

/// The range, and at how many inputs coupled groups are listed.
fn cycle(outline: &Outline, input: &Input) -> TokenStream {
    let runtime = &outline.runtime;
    let Cycle {
        low,
        high,
        angle,
        samples,
    } = input.cycle();
    let (low, high) = (literal::float(low), literal::float(high));
    let samples = literal::index(samples);
    quote!(#runtime::Cycle { low: #low, high: #high, angle: #angle, samples: #samples })
}

/// The method of a mechanism with mistakes.
pub(super) fn skeleton(outline: &Outline) -> TokenStream {
    let runtime = &outline.runtime;
    let method = method(outline, TokenStream::new());
    quote!(#runtime::if_alloc! { #method })
}

fn method(outline: &Outline, body: TokenStream) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let float = quote!(__p::f64);
    let body = outline.body(body);
    quote! {
        impl #name<#float> {
            /// Every assembly over the range of the input (a turn about the reference where an angle has none): how far each
            /// reaches, its turning points, and where its margin is smallest.
            ///
            /// # Errors
            ///
            /// As `assemblies()`, if it fails at every position.
            #[inline]
            pub fn circuits(&self) -> __p::Result<
                #runtime::Circuits<#assembly<#float>>, #runtime::AssemblyError,
            > {
                #body
            }
        }
    }
}
