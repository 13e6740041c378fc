//! The assembled mechanism: its type, its construction, and the private functions for that.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::body::Runs;
use super::docs::doc;
use super::load::{Places, loader};
use super::outline::{Outline, plain};
use super::{
    assembly_data, attribute, body, closing, constructors, coupled, literal, prepare, sweeps,
    winding,
};
use linkage_compiler::ir::CompiledMechanism;

/// The public functions of the assembly type that make one and read it.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let mut items = accessors(outline);
    items.extend(constructors::items(outline));
    items
}

/// The assembly type and its data.
pub(super) fn structure(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        visibility,
        name,
        assembly,
        core,
        ..
    } = outline;
    let doc = doc(&format!(
        "An assembled `{}`: closed loops in one assembly, everything prepared that does not depend on the inputs.{}",
        outline.title(),
        sweeps::about(outline)
    ));
    let derives = attribute::derives([], &[]);
    let modes = literal::index(outline.modes.len());
    let [angles, inputs, prepared] = [
        outline.continuous_angles,
        outline.inputs.len(),
        outline.prepared,
    ]
    .map(literal::index);
    let own_derives = match outline.starts.is_empty() {
        true => derives.clone(),
        false => {
            quote!(#[derive(::core::clone::Clone, ::core::fmt::Debug, ::core::cmp::PartialEq)])
        }
    };
    let sealed = assembly_data::field(outline);
    let allow = attribute::allow();
    quote! {
        // As visible as the mechanism: the runtime's traits of public results name it.
        #allow
        #derives
        #[doc(hidden)]
        #visibility struct #core<T> {
            __mechanism: #name<T>,
            __modes: [#runtime::AssemblyMode; #modes],
            __turns: #runtime::Turns<T, #angles, #inputs>,
            __prepared: [T; #prepared],
        }
        #doc
        #allow
        #own_derives
        #visibility struct #assembly<T = ::core::primitive::f64> { #sealed }
    }
}

/// `mechanism()`, `modes()` and, with prepared states over several inputs, `served()`, unless the
/// user's functions have these names.
fn accessors(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let core = assembly_data::core(outline, &quote!(self));
    let free = |accessor: &str| outline.functions.iter().all(|f| plain(f.name) != accessor);
    let mechanism = free("mechanism").then(|| {
        quote! {
            /// The dimensions that it was assembled with.
            #[must_use]
            pub const fn mechanism(&self) -> &#name<T> { &#core.__mechanism }
        }
    });
    let modes = free("modes").then(|| {
        let count = literal::index(outline.modes.len());
        quote! {
            /// The assembly mode of each group that has two; `STRUCTURE` says which group is which.
            #[must_use]
            pub const fn modes(&self) -> &[#runtime::AssemblyMode; #count] { &#core.__modes }
        }
    });
    let served = free("served").then(|| coupled::served(outline));
    quote! {
        impl<T> #assembly<T> { #mechanism #modes #served }
    }
}

/// The private functions of the assembly: `__assemble` and the programs that it runs.
pub(super) fn plumbing(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let types = Types::new(outline, unit);
    let Types {
        modes,
        turns,
        prepared,
        arguments,
        gaps,
        ..
    } = &types;
    let assemble = match outline.starts.is_empty() {
        true => assemble(outline, unit, &types),
        false => coupled::assemble(outline, unit, &types),
    };
    let (finite, close) = (
        closing::finite(outline, unit),
        closing::close(outline, unit),
    );
    let prepare_body = program(outline, &unit.prepare);
    let (prepare, preparing) = prepare::for_machine(outline, &types);
    let gaps_body = program(outline, &unit.gaps);
    quote! {
        impl<T: #runtime::Scalar> #assembly<T> {
            #assemble

            fn __finite(__m: &#name<T>) -> __p::Result<(), #runtime::AssemblyError> { #finite }

            fn __close(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> __p::Result<(), #runtime::AssemblyError> {
                let __gaps = Self::__gaps::<{ #runtime::FUSED }>(__m, __modes, __prepared, __x);
                #close
            }

            #[inline(always)]
            fn __prepare<const __FUSED: __p::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __turns: &#turns,
            ) -> #prepared { #prepare_body }

            /// As calls compute: what is the same in both is so to the last bit.
            fn __prepare_for_machine(
                __m: &#name<T>,
                __modes: &#modes,
                __turns: &#turns,
            ) -> #prepared { #prepare }

            fn __gaps<const __FUSED: __p::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> #gaps { #gaps_body }
        }

        #preparing
    }
}

fn assemble(outline: &Outline, unit: &CompiledMechanism, types: &Types) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let Types {
        modes,
        inputs,
        turns,
        ..
    } = types;
    let turning = winding::turning(outline, unit);
    let made = assembly_data::made(outline);
    quote! {
        fn __assemble(
            __m: &#name<T>,
            __modes: #modes,
            __at: #inputs,
        ) -> __p::Result<Self, #runtime::AssemblyError> {
            Self::__finite(__m)?;
            let __turns: #turns = #turning;
            let __prepared = Self::__prepare_for_machine(__m, &__modes, &__turns);
            Self::__close(__m, &__modes, &__prepared, __at)?;
            __p::Ok(#made)
        }
    }
}

/// A program over all inputs and states of the mechanism, ending in the array of its outputs.
fn program(outline: &Outline, program: &Program) -> TokenStream {
    let places = Places::all(outline);
    let statements = body::statements(program, Runs::Once, &loader(outline, &places));
    let outputs = body::outputs(program);
    quote!(#statements #outputs)
}
