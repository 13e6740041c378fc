//! Assembling a mechanism with coupled groups.

use proc_macro2::TokenStream;
use quote::quote;

use crate::array_types::Types;
use crate::outline::Outline;
use crate::{assembly_data, literal, winding};
use linkage_compiler::ir::CompiledMechanism;

/// `__assemble` and the items that it needs: the starts are found lane by lane on plain numbers.
pub(crate) fn assemble(outline: &Outline, unit: &CompiledMechanism, types: &Types) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types {
        modes,
        inputs,
        turns,
        ..
    } = types;
    let float = quote!(__p::f64);
    let turning = winding::turning(outline, unit);
    let at_estimates = winding::at_estimates(outline, unit);
    let made = assembly_data::made(outline);
    let count = literal::index(outline.starts.len());
    let at = (0..outline.inputs.len()).map(|input| {
        let input = literal::index(input);
        quote!(T::lane(__at[#input], __lane))
    });
    quote! {
        fn __assemble(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
        ) -> __p::Result<Self, #runtime::AssemblyError> {
            Self::__finite(__m)?;
            let mut __lanes = #runtime::Vec::new();
            for __lane in 0..T::LANES {
                match Self::__on_lane(__m, __modes, __at, __lane, #runtime::Wanted::Nearest) {
                    __p::Ok(__starts) => {
                        ::core::iter::Extend::extend(&mut __lanes, __starts);
                    }
                    __p::Err(__error) => {
                        Self::__close_closed_forms(__m, __modes, __at)?;
                        return __p::Err(__error);
                    }
                }
            }
            Self::__with_starts(__m, __modes, __at, &__lanes)
        }

        fn __assemblies(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
        ) -> __p::Result<#runtime::Vec<Self>, #runtime::AssemblyError> {
            Self::__finite(__m)?;
            let mut __found = #runtime::Vec::new();
            let mut __missed = __p::None;
            let __all = Self::__on_lane(__m, __modes, __at, 0, #runtime::Wanted::All);
            let __all = match __all {
                __p::Ok(__all) => __all,
                __p::Err(__error) => {
                    Self::__close_closed_forms(__m, __modes, __at)?;
                    return __p::Err(__error);
                }
            };
            for __first in __all {
                let mut __lanes = #runtime::one(::core::clone::Clone::clone(&__first));
                for __lane in 1..T::LANES {
                    let __next = Self::__on_lane(
                        __m, __modes, __at, __lane, #runtime::Wanted::Like(&__first),
                    )?;
                    ::core::iter::Extend::extend(&mut __lanes, __next);
                }
                match Self::__with_starts(__m, __modes, __at, &__lanes) {
                    __p::Ok(__assembly) => __found.push(__assembly),
                    // Others may let closed forms behind the coupled groups close.
                    __p::Err(__error @ #runtime::AssemblyError::CannotClose { .. }) => {
                        __missed = __p::Some(__error);
                    }
                    __p::Err(__error) => return __p::Err(__error),
                }
            }
            match __missed {
                __p::Some(__error) if __found.is_empty() => {
                    __p::Err(__error)
                }
                _ => __p::Ok(__found),
            }
        }

        /// What is prepared of the coupled groups in one lane, for the wanted assemblies.
        fn __on_lane(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
            __lane: __p::usize,
            __wanted: #runtime::Wanted<'_, #count>,
        ) -> __p::Result<#runtime::Vec<[#runtime::Start; #count]>, #runtime::AssemblyError> {
            let __m: #name<#float> = #name::__lane(__m, __lane);
            let __at = [#(#at),*];
            #runtime::starts(&#assembly::<#float>::__GROUPS, &__at, __wanted, |__number, __starts| {
                #assembly::<#float>::__coupled(&__m, &__modes, __at, __number, __starts)
            })
        }

        /// Fails if a group with a closed form does not close before a coupled one is needed.
        fn __close_closed_forms(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
        ) -> __p::Result<(), #runtime::AssemblyError> {
            let __lanes = #runtime::nothing::<#count>(T::LANES);
            let __starts = Self::__starts(&__lanes);
            let __turns: #turns = #at_estimates;
            let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
            let __x = Self::__extend(&__starts, __at);
            match Self::__close(__m, &__modes, &__prepared, __x) {
                __p::Err(__error @ #runtime::AssemblyError::CannotClose { .. }) => {
                    __p::Err(__error)
                }
                _ => __p::Ok(()),
            }
        }

        fn __with_starts(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
            __lanes: &[[#runtime::Start; #count]],
        ) -> __p::Result<Self, #runtime::AssemblyError> {
            let __starts = Self::__starts(__lanes);
            let __x = Self::__extend(&__starts, __at);
            let __turns: #turns = #turning;
            let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
            Self::__close(__m, &__modes, &__prepared, __x)?;
            __p::Ok(#made)
        }
    }
}
