//! The coupled groups on plain numbers, as the runtime prepares them.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::array_types::{Types, coupled_name, starts_type};
use crate::load::Places;
use crate::outline::Outline;
use crate::{literal, winding};
use linkage_compiler::ir::{CompiledMechanism, Coupled};

use super::description::description;

/// The groups on plain numbers, as the runtime prepares them.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        // A type of the public trait `Compiled`.
        visibility,
        ..
    } = outline;
    let Types { modes, .. } = Types::new(outline, unit);
    let float = quote!(__p::f64);
    // The prepared slots are plain numbers.
    let slots = literal::index(outline.prepared);
    let prepared = quote!([#float; #slots]);
    let starts = starts_type(outline);
    let coupled = coupled_name(outline);
    let inputs = literal::index(outline.inputs.len());
    let width = literal::index(Places::all(outline).width());
    let count = literal::index(outline.starts.len());
    let arms = |arm: &dyn Fn(usize, &Coupled) -> TokenStream| -> TokenStream {
        let last = unit.coupled.len() - 1;
        let arms = unit.coupled.iter().enumerate().map(|(number, group)| {
            let pattern = match number == last {
                true => quote!(_),
                false => {
                    let number = literal::index(number);
                    quote!(#number)
                }
            };
            let arm = arm(number, group);
            quote!(#pattern => { #arm })
        });
        quote!(match self.__number { #(#arms)* })
    };
    let set_inputs = arms(&|_, group| {
        let inputs = group.inputs.iter().enumerate().map(|(k, &input)| {
            let [k, input] = [k, input].map(literal::index);
            quote!(self.__at[#input] = __own[#k];)
        });
        quote!(#(#inputs)*)
    });
    let enclosure = quote!(#runtime::Enclosure);
    let is_followed = unit.coupled.iter().any(|group| group.followed);
    let residuals = is_followed.then(|| {
        let residuals = arms(&|number, group| {
            if !group.followed {
                return quote!(#runtime::Vec::new());
            }
            let first = literal::index(Places::all(outline).state(number, 0));
            let method = format_ident!("__residuals{number}");
            quote! {
                let mut __x = self.__place(__own).map(<#enclosure as #runtime::Scalar>::from_f64);
                #runtime::put_state(&mut __x, #first, __state);
                <#runtime::Vec<_> as ::core::convert::From<[_; _]>>::from(
                    #assembly::<#enclosure>::#method::<{ #runtime::FUSED }>(
                        &self.__m.cast(),
                        &self.__modes,
                        &self.__prepared.map(<#enclosure as #runtime::Scalar>::from_f64),
                        __x,
                    ),
                )
            }
        });
        quote! {
            #[inline]
            fn residuals(&mut self, __own: &[#float], __state: &[#enclosure]) -> #runtime::Vec<#enclosure> { #residuals }
        }
    });
    let call = |kind: &str, number: usize| {
        let method = format_ident!("__{kind}{number}");
        quote! {
            #assembly::<#float>::#method::<{ #runtime::FUSED }>(
                &self.__m, &self.__modes, &self.__prepared, __x,
            )
        }
    };
    let with_state = |number: usize| {
        let first = literal::index(Places::all(outline).state(number, 0));
        quote! {
            let mut __x = self.__place(__own);
            #runtime::put_state(&mut __x, #first, __state);
        }
    };
    let correct = arms(&|number, _| {
        let (with_state, call) = (with_state(number), call("correct", number));
        quote!(#with_state #runtime::stepped(__state, &#call))
    });
    let system = arms(&|number, group| {
        if group.followed {
            return quote!(#runtime::Vec::new());
        }
        let call = call("system", number);
        quote!(let __x = self.__place(__own); #runtime::pairs(&#call))
    });
    let of_followed = is_followed.then(|| {
        let numbers = |kind: &str, number: usize, placed: TokenStream| {
            let call = call(kind, number);
            quote!(#placed <#runtime::Vec<_> as ::core::convert::From<[_; _]>>::from(#call))
        };
        let estimate = arms(&|number, group| match group.followed {
            false => quote!(#runtime::Vec::new()),
            true => numbers("estimate", number, quote!(let __x = self.__place(__own);)),
        });
        let missed = arms(&|number, group| match group.followed {
            false => quote!(#runtime::Vec::new()),
            true => numbers("missed", number, with_state(number)),
        });
        quote! {
            #[inline]
            fn estimate(&mut self, __own: &[#float]) -> #runtime::Vec<#float> { #estimate }
            #[inline]
            fn missed(&mut self, __own: &[#float], __state: &[#float]) -> #runtime::Vec<#float> { #missed }
        }
    });
    let placed = arms(&|number, group| {
        let (with_state, call) = (with_state(number), call("placed", number));
        let angles = group.unknowns.iter().map(|unknown| unknown.angle);
        let reach = literal::float(group.reach);
        quote!(#with_state #runtime::placed(&[#(#angles),*], #reach, &#call))
    });
    let groups = unit
        .coupled
        .iter()
        .map(|group| description(outline, unit, group));
    let turns = turns(outline, unit);
    quote! {
        #[derive(::core::clone::Clone)]
        #[doc(hidden)]
        #visibility struct #coupled {
            __number: __p::usize,
            __m: #name<#float>,
            __modes: #modes,
            __prepared: #prepared,
            __starts: #starts,
            __at: [#float; #inputs],
        }
        impl #coupled {
            #[inline]
            fn __place(&mut self, __own: &[#float]) -> [#float; #width] {
                #set_inputs
                #assembly::<#float>::__extend(&self.__starts, self.__at)
            }
        }
        impl #runtime::Correction for #coupled {
            #[inline]
            fn correct(&mut self, __own: &[#float], __state: &mut [#float]) -> #runtime::Step { #correct }
        }
        impl #runtime::Residuals for #coupled { #residuals }
        impl #runtime::CoupledPrograms for #coupled {
            #[inline]
            fn system(&mut self, __own: &[#float]) -> #runtime::Vec<[#float; 2]> { #system }
            #[inline]
            fn placed(&mut self, __own: &[#float], __state: &[#float]) -> #runtime::Vec<[#float; 2]> { #placed }
            #of_followed
        }
        impl #assembly<#float> {
            const __GROUPS: [#runtime::CoupledGroup; #count] = [#(#groups),*];

            /// Group `__number` with what is prepared of those before it.
            #[inline]
            fn __coupled(
                __m: &#name<#float>,
                __modes: &#modes,
                __at: [#float; #inputs],
                __number: __p::usize,
                __prepared_starts: &[#runtime::Start; #count],
            ) -> __p::Result<#coupled, #runtime::AssemblyError> {
                let __starts = Self::__starts(::core::slice::from_ref(__prepared_starts));
                #turns
                let __prepared = <#assembly<#float>>::__prepare_for_machine(__m, __modes, &__turns);
                __p::Ok(#coupled {
                    __number, __m: *__m, __modes: *__modes, __prepared, __starts, __at,
                })
            }
        }
    }
}

/// The turns of angles on which a coupled group depends, found with the slots that are prepared
/// before it.
fn turns(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let runtime = &outline.runtime;
    let title = outline.title();
    if unit.coupled.iter().all(|group| group.turning == 0) {
        let at_estimates = winding::at_estimates(outline, unit);
        return quote!(let __turns = #at_estimates;);
    }
    let counts = unit
        .coupled
        .iter()
        .map(|group| literal::index(group.turning));
    quote! {
        let __count = [#(#counts),*][__number];
        let __turns = Self::__wind(__m, __modes, &__starts, __at, __count).map_err(|__unknown| {
            #runtime::AssemblyError::NoWinding { mechanism: #title, unknown: __unknown }
        })?;
    }
}
