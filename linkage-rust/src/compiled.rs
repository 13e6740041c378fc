//! The mechanism as the searches of the runtime see it: the traits `Compiled` and `OneInput`.

use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::outline::Outline;
use super::{array_types, literal, survey};
use linkage_compiler::ir::CompiledMechanism;

/// The traits; nothing for a mechanism without groups.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if unit.groups.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let float = quote!(__p::f64);
    let title = outline.title();
    let levels = survey::levels(outline, unit);
    let [parameters, inputs, count] = [
        outline.scalar_fields().len(),
        outline.inputs.len(),
        unit.survey.outputs.len(),
    ]
    .map(literal::index);
    let (programs, coupled) = match outline.starts.is_empty() {
        true => (quote!(#runtime::NoPrograms), TokenStream::new()),
        false => {
            let programs = array_types::coupled_name(outline);
            (quote!(#programs), coupled(outline, unit))
        }
    };
    let one_input = (unit.inputs.len() == 1).then(|| one_input(outline, unit));
    quote! {
        #runtime::if_alloc! {
            impl #runtime::Compiled<#parameters, #inputs> for #name<#float> {
                type Assembly = #assembly<#float>;
                type Survey = [#float; #count];
                type Programs = #programs;

                const NAME: &'static __p::str = #title;
                const INPUTS: &'static [#runtime::Input] = Self::INPUTS;
                const GROUPS: &'static [#runtime::Group] = Self::STRUCTURE.groups;
                const LEVELS: &'static [#runtime::Level] = &#levels;

                #[inline]
                fn surveyor(
                    &self,
                    __modes: &[#runtime::AssemblyMode],
                    __starts: &[#runtime::Start],
                    __at: [#float; #inputs],
                ) -> #assembly<#float> {
                    #assembly::__surveyor(self, __modes, __starts, __at)
                }

                #[inline]
                fn survey(__assembly: &#assembly<#float>, __at: [#float; #inputs]) -> [#float; #count] {
                    __assembly.__survey::<{ #runtime::FUSED }>(__at)
                }
                #coupled
            }
            #one_input
        }
    }
}

/// Copies of the modes and of the initial states of one lane.
fn copies(outline: &Outline, unit: &CompiledMechanism) -> [TokenStream; 2] {
    let runtime = &outline.runtime;
    let Types { modes, .. } = Types::new(outline, unit);
    let starts = literal::index(outline.starts.len());
    [
        quote!(let __modes: #modes = ::core::array::from_fn(|__k| __modes[__k]);),
        quote! {
            let __lane: [#runtime::Start; #starts] =
                ::core::array::from_fn(|__k| ::core::clone::Clone::clone(&__starts[__k]));
        },
    ]
}

/// A coupled group, given those before it.
fn coupled(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let float = quote!(__p::f64);
    let programs = array_types::coupled_name(outline);
    let [starts, inputs] = [outline.starts.len(), outline.inputs.len()].map(literal::index);
    let [modes, lane] = copies(outline, unit);
    quote! {
        #[inline]
        fn coupled(
            &self,
            __modes: &[#runtime::AssemblyMode],
            __starts: &[#runtime::Start],
            __number: __p::usize,
            __at: [#float; #inputs],
        ) -> __p::Option<#runtime::CoupledParts<#programs>> {
            #modes
            #lane
            let __groups: &'static [#runtime::CoupledGroup; #starts] = &#assembly::<#float>::__GROUPS;
            let __made = #assembly::<#float>::__coupled(self, &__modes, __at, __number, &__lane);
            __p::Some(__made.map(|__made| (&__groups[__number], __made)))
        }
    }
}

/// The trait of a mechanism with one input.
fn one_input(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let float = quote!(__p::f64);
    let parameters = literal::index(outline.scalar_fields().len());
    let counts = [outline.modes.len(), outline.starts.len()].map(literal::index);
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
    let [modes, lane] = copies(outline, unit);
    let assembled = match outline.starts.is_empty() {
        true => quote!(#assembly::__assemble(self, __modes, [__at])),
        false => quote! {
            let __starts = &__chosen.starts;
            #lane
            #assembly::__with_starts(self, __modes, [__at], ::core::slice::from_ref(&__lane))
        },
    };
    quote! {
        impl #runtime::OneInput<#parameters> for #name<#float> {
            const UNKNOWNS: &'static [#runtime::SurveyedUnknown] = &[#(#unknowns),*];
            const COUNTS: [__p::usize; 2] = [#(#counts),*];

            #[inline]
            fn bounds(
                __assembly: &#assembly<#float>,
                __number: __p::usize,
            ) -> #runtime::Bounds<'static> {
                let __bounds = #assembly::<#runtime::Enclosure>::__without_starts(__assembly);
                #runtime::Box::new(move |__x| __bounds.__survey::<{ #runtime::FUSED }>([__x])[__number])
            }

            #[inline]
            fn assembled(
                &self,
                __chosen: &#runtime::Chosen,
                __at: #float,
            ) -> __p::Result<#assembly<#float>, #runtime::AssemblyError> {
                let __modes = &__chosen.modes;
                #modes
                #assembled
            }

            #[inline]
            fn check(&self, __at: #float) -> __p::Result<(), #runtime::AssemblyError> {
                self.assemblies_at(__at).map(|_| ())
            }
        }
    }
}
