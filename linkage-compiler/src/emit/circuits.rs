//! The assemblies of a mechanism with one input that run through its range.

use linkage_core::Cycle;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::outline::Outline;
use super::{array_types, attribute, literal, survey};
use crate::ir::{CompiledMechanism, Input};

/// `circuits()`; nothing for a mechanism without groups or with another number of inputs than one.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let ([input], false) = (&unit.inputs[..], unit.groups.is_empty()) else {
        return TokenStream::new();
    };
    let runtime = &outline.runtime;
    let cycle = cycle(outline, input);
    let levels = levels(outline, unit);
    let method = method(
        outline,
        quote! {
            #levels
            #runtime::circuits(&__Levels(self), &#cycle)
        },
    );
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

/// The mechanism as the runtime searches it.
fn levels(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types { modes, .. } = Types::new(outline, unit);
    let float = quote!(::core::primitive::f64);
    let title = outline.title();
    let input = &unit.inputs[0];
    let (input_name, reference) = (&input.name, literal::float(input.reference));
    let count = literal::index(unit.survey.outputs.len());
    let levels = survey::levels(outline, unit);
    let unknowns = unit.surveyed.iter().map(|surveyed| {
        let unknown = &unit.unknowns[surveyed.unknown];
        let name = &unknown.name;
        let angle = surveyed.angle;
        let unit = match angle {
            true => "",
            false => &unknown.unit,
        };
        let numbers = literal::index(surveyed.numbers);
        quote!(#runtime::SurveyedUnknown { name: #name, unit: #unit, angle: #angle, numbers: #numbers })
    });
    let [mode_count, coupled_count] =
        [outline.modes.len(), outline.starts.len()].map(literal::index);
    let modes = quote!(let __modes: #modes = ::core::array::from_fn(|__k| __chosen.modes[__k]););
    let starts = literal::index(outline.starts.len());
    let lane = quote! {
        let __lane: [#runtime::Start; #starts] =
            ::core::array::from_fn(|__k| ::core::clone::Clone::clone(&__chosen.starts[__k]));
    };
    let (programs, assembled, coupled) = match outline.starts.is_empty() {
        true => (
            quote!(#runtime::NoPrograms),
            quote!(#assembly::__assemble(self.0, __modes, [__at])),
            TokenStream::new(),
        ),
        false => {
            let coupled = array_types::coupled_name(outline);
            (
                quote!(#coupled),
                quote! {
                    #lane
                    #assembly::__with_starts(self.0, __modes, [__at], ::core::slice::from_ref(&__lane))
                },
                quote! {
                    fn coupled(
                        &self,
                        __chosen: &#runtime::Chosen,
                        __number: ::core::primitive::usize,
                        __at: #float,
                    ) -> ::core::option::Option<::core::result::Result<
                        (&'static #runtime::CoupledGroup, #coupled), #runtime::AssemblyError,
                    >> {
                        #modes
                        #lane
                        let __groups: &'static [#runtime::CoupledGroup; #starts] =
                            &#assembly::<#float>::__GROUPS;
                        let __made = #assembly::<#float>::__coupled(
                            self.0, &__modes, [__at], __number, &__lane,
                        );
                        ::core::option::Option::Some(__made.map(|__made| (&__groups[__number], __made)))
                    }
                },
            )
        }
    };
    let allow = attribute::allow();
    // Inside the method, which keeps it private.
    quote! {
        struct __Levels<'a>(&'a #name<#float>);

        #allow
        impl #runtime::Levels for __Levels<'_> {
            type Assembly = #assembly<#float>;
            type Survey = [#float; #count];
            type Programs = #programs;

            fn searched(&self) -> #runtime::Searched {
                #runtime::Searched {
                    name: #title,
                    input: #input_name,
                    reference: #reference,
                    levels: &#levels,
                    unknowns: &[#(#unknowns),*],
                    modes: #mode_count,
                    coupled: #coupled_count,
                }
            }
            fn surveyor(&self, __chosen: &#runtime::Chosen, __at: #float) -> #assembly<#float> {
                #assembly::__surveyor(self.0, &__chosen.modes, &__chosen.starts, [__at])
            }
            fn survey(&self, __assembly: &#assembly<#float>, __at: #float) -> [#float; #count] {
                __assembly.__survey::<{ #runtime::FUSED }>([__at])
            }
            fn bounds(
                &self,
                __assembly: &#assembly<#float>,
                __number: ::core::primitive::usize,
            ) -> ::core::option::Option<#runtime::Bounds<'_>> {
                let __bounds = #assembly::<#runtime::Enclosure>::__without_starts(__assembly);
                ::core::option::Option::Some(#runtime::Box::new(move |__x| {
                    __bounds.__survey::<{ #runtime::FUSED }>([__x])[__number]
                }))
            }
            fn assembled(
                &self,
                __chosen: &#runtime::Chosen,
                __at: #float,
            ) -> ::core::result::Result<#assembly<#float>, #runtime::AssemblyError> {
                #modes
                #assembled
            }
            fn check(&self, __at: #float) -> ::core::result::Result<(), #runtime::AssemblyError> {
                self.0.assemblies_at(__at).map(|_| ())
            }
            #coupled
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
