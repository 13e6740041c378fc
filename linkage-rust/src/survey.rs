//! The numbers by which the assemblies of a mechanism are compared: the least margin, the distance
//! of each group from its ends, the values of its unknowns.

use linkage_core::Level;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::Outline;
use super::{assembly_data, body, literal, winding};
use linkage_compiler::ir::CompiledMechanism;

/// `__survey` and `__surveyor`; nothing for a mechanism without groups.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if unit.groups.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime,
        assembly,
        core,
        ..
    } = outline;
    let Types {
        inputs, arguments, ..
    } = Types::new(outline, unit);
    let places = Places::all(outline);
    let statements = body::statements(&unit.survey, Runs::Once, &loader(outline, &places));
    let outputs = body::outputs(&unit.survey);
    let count = literal::index(unit.survey.outputs.len());
    let x = match outline.starts.is_empty() {
        true => quote!(__x),
        false => {
            let starts = assembly_data::starts(outline, &quote!(self));
            quote!(Self::__extend(#starts, __x))
        }
    };
    let fields = assembly_data::core(outline, &quote!(self));
    let surveyor = surveyor(outline, unit);
    // For `circuits()`, of mechanisms with one input.
    let without_starts = (unit.inputs.len() == 1).then(|| without_starts(outline));
    quote! {
        #runtime::if_alloc! {
            impl<T: #runtime::Scalar> #assembly<T> {
                /// The smallest margin, the slack of every group, and where every unknown is.
                fn __survey<const __FUSED: __p::bool>(&self, __x: #inputs) -> [T; #count] {
                    let __x: #arguments = #x;
                    let #core { __mechanism: __m, __modes, __prepared, .. } = #fields;
                    #statements
                    #outputs
                }
                #without_starts
            }
            #surveyor
        }
    }
}

/// The same assembly in another scalar, without the prepared states of coupled groups.
fn without_starts(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        assembly,
        core,
        ..
    } = outline;
    let float = quote!(__p::f64);
    let fields = assembly_data::core(outline, &quote!(__of));
    let starts = (!outline.starts.is_empty())
        .then(|| quote!(let __starts = Self::__starts(&#runtime::nothing(T::LANES));));
    let made = assembly_data::made(outline);
    quote! {
        fn __without_starts(__of: &#assembly<#float>) -> Self {
            let #core { __mechanism, __modes, __turns, .. } = #fields;
            let (__m, __modes, __turns) = (&__mechanism.cast::<T>(), *__modes, __turns.cast::<T>());
            let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
            #starts
            #made
        }
    }
}

/// The assemblies that each group has.
pub(super) fn levels(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let runtime = &outline.runtime;
    let levels = unit.levels().into_iter().map(|level| match level {
        Level::Modes(mode) => {
            let mode = literal::index(mode);
            quote!(#runtime::Level::Modes(#mode))
        }
        Level::Coupled(number) => {
            let number = literal::index(number);
            quote!(#runtime::Level::Coupled(#number))
        }
        Level::Single => quote!(#runtime::Level::Single),
    });
    quote!([#(#levels),*])
}

/// An assembly that need not close, of the first groups.
fn surveyor(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types { modes, .. } = Types::new(outline, unit);
    let float = quote!(__p::f64);
    let (found, argument) = match outline.starts.is_empty() {
        true => Default::default(),
        false => {
            let count = literal::index(outline.starts.len());
            (
                quote! {
                    let __lane: [#runtime::Start; #count] =
                        ::core::array::from_fn(|__k| ::core::clone::Clone::clone(&__chosen_starts[__k]));
                    let __starts = Self::__starts(::core::slice::from_ref(&__lane));
                },
                quote!(&__starts,),
            )
        }
    };
    let made = assembly_data::made(outline);
    let turns = match unit.surveying {
        0 => winding::at_estimates(outline, unit),
        count => {
            let count = literal::index(count);
            let at_estimates = winding::at_estimates(outline, unit);
            quote! {
                match Self::__wind(__m, &__modes, #argument __at, #count) {
                    __p::Ok(__turns) => __turns,
                    __p::Err(_) => #at_estimates,
                }
            }
        }
    };
    let inputs = literal::index(outline.inputs.len());
    quote! {
        impl #assembly<#float> {
            #[inline]
            fn __surveyor(
                __m: &#name<#float>,
                __chosen_modes: &[#runtime::AssemblyMode],
                __chosen_starts: &[#runtime::Start],
                __at: [#float; #inputs],
            ) -> Self {
                let __modes: #modes = ::core::array::from_fn(|__k| __chosen_modes[__k]);
                #found
                let __turns = #turns;
                let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
                #made
            }
        }
    }
}
