//! Which assemblies of a mechanism with one input run through its range.

use proc_macro2::TokenStream;
use quote::quote;

use super::assembly::Types;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{attribute, body, literal};
use crate::unit::Unit;

/// At how many positions of a turn, or of a range of lengths, assemblies are listed.
const SAMPLES: usize = 72;

/// `circuits()`; nothing for a mechanism without groups or with another number of inputs than one.
pub(super) fn items(outline: &Outline, unit: &Unit) -> TokenStream {
    let ([input], false) = (&unit.inputs[..], unit.groups.is_empty()) else {
        return TokenStream::new();
    };
    let Outline {
        runtime,
        assembly,
        core,
        ..
    } = outline;
    let Types { arguments, .. } = Types::new(outline, unit);
    let places = Places::all(outline);
    let statements = body::statements(&unit.survey, &loader(outline, &places));
    let outputs = body::outputs(&unit.survey);
    let count = literal::index(unit.survey.outputs.len());
    let x = match outline.starts.is_empty() {
        true => quote!([__x]),
        false => quote!(Self::__extend(&self.__starts, [__x])),
    };
    let angle = input.angle;
    let (low, high) = input.range.unwrap_or(input.followed);
    let turns = (high - low) / std::f64::consts::TAU;
    let samples = match angle {
        true => (turns * SAMPLES as f64).ceil().clamp(24.0, 1000.0) as usize,
        false => SAMPLES,
    };
    let (low, high) = (literal::float(low), literal::float(high));
    let samples = literal::index(samples + 1);
    let allow = attribute::allow();
    let method = method(
        outline,
        quote! {
            #runtime::circuits(
                &#runtime::Cycle { low: #low, high: #high, angle: #angle, samples: #samples },
                |__x| self.assemblies_at(__x),
                |__assembly, __x| __assembly.__survey::<{ #runtime::FUSED }>(__x)[0],
                |__assembly, __x| __assembly.__survey::<{ #runtime::FUSED }>(__x)[1..].to_vec(),
            )
        },
    );
    quote! {
        #runtime::if_alloc! {
            #allow
            impl<T: #runtime::Scalar> #assembly<T> {
                /// The smallest margin, and where every unknown is.
                fn __survey<const __FUSED: ::core::primitive::bool>(&self, __x: T) -> [T; #count] {
                    let __x: #arguments = #x;
                    let #core { __mechanism: __m, __modes, __prepared, .. } = &self.__core;
                    #statements
                    #outputs
                }
            }
            #method
        }
    }
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
    let float = quote!(::core::primitive::f64);
    let (allow, body) = (attribute::allow(), outline.body(body));
    quote! {
        #allow
        impl #name<#float> {
            /// Every assembly over the range of the input (a turn about the reference where an angle has none): how far each
            /// reaches, its turning points, and where its margin is smallest.
            ///
            /// # Errors
            ///
            /// As `assemblies()`, if it fails at every position.
            #[inline]
            pub fn circuits(&self) -> ::core::result::Result<
                #runtime::Circuits<#assembly<#float>>, #runtime::AssemblyError,
            > {
                #body
            }
        }
    }
}
