//! The additions to an assembly with coupled groups: prepared starts, the arguments that they add
//! to programs, and the programs that prepare them.

mod description;
mod look_up;
mod moving;
mod states;

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use look_up::look_up;

use super::array_types::{Types, starts_type};
use super::load::Places;
use super::outline::Outline;
use super::{assembly_data, body, code, compiled, literal};
use linkage_compiler::ir::CompiledMechanism;

/// `served()`; nothing where no group is prepared over several inputs.
pub(super) fn served(outline: &Outline) -> TokenStream {
    let prepared = assembly_data::starts(outline, &quote!(self));
    let groups = outline.starts.iter().enumerate();
    let over_several = groups.filter(|(_, start)| start.inputs.len() > 1);
    let shares = over_several.map(|(number, _)| {
        let number = literal::index(number);
        quote!(#prepared.#number.served())
    });
    let share = shares.reduce(|least, share| quote!(__p::f64::min(#least, #share)));
    share.map_or_else(TokenStream::new, |share| {
        quote! {
            /// The share of the ranges of the inputs in which groups without a closed form are assembled, from 0 to 1: elsewhere results are
            /// NaN, because the links do not reach each other there or a dead point is near. Measured on a lattice of positions; of several
            /// groups, and lanes of the scalar, the one that serves least counts.
            #[must_use]
            pub fn served(&self) -> __p::f64 { #share }
        }
    })
}

/// Everything for the coupled groups of a mechanism; nothing if it has none.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if outline.starts.is_empty() {
        return TokenStream::new();
    }
    let mut items = lookups(outline);
    items.extend(programs(outline, unit));
    items.extend(groups(outline, unit));
    // Sets of dimensions need some.
    if !outline.parameters.is_empty() {
        items.extend(moving::items(outline));
    }
    items
}

/// The conversion from inputs to arguments, and the states that functions start from.
fn lookups(outline: &Outline) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let starts = starts_type(outline);
    let together = extend(outline);
    let inputs = literal::index(outline.inputs.len());
    let width = literal::index(Places::all(outline).width());
    let functions = outline
        .functions
        .iter()
        .map(|function| states::items(outline, function));
    quote! {
        impl<T: #runtime::Scalar> #assembly<T> {
            #[inline(always)]
            fn __extend(__starts: &#starts, __x: [T; #inputs]) -> [T; #width] { #together }
        }
        #(#functions)*
    }
}

/// All inputs, `__x`, followed by the states of all groups.
fn extend(outline: &Outline) -> TokenStream {
    let inputs: Vec<usize> = (0..outline.inputs.len()).collect();
    let groups: Vec<usize> = (0..outline.starts.len()).collect();
    let values = inputs.iter().map(|&k| {
        let k = literal::index(k);
        quote!(__x[#k])
    });
    let starts = quote!(__starts);
    let runtime = &outline.runtime;
    let fused = quote!({ #runtime::FUSED });
    let (looked_up, states) = look_up(outline, &inputs, &groups, &starts, &fused);
    quote!(#looked_up [#(#values,)* #(#states),*])
}

/// The programs of all groups as functions of the plumbing's arguments.
fn programs(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let Types {
        modes,
        arguments,
        prepared,
        ..
    } = Types::new(outline);
    let [modes, arguments, prepared] = [modes, arguments, prepared].map(|ty| code::tokens(&ty));
    let program = |kind: &str, number: usize, program: &Program| {
        let method = format_ident!("__{kind}{number}");
        let body = code::tokens(&compiled::program(outline, program, body::outputs));
        let count = literal::index(program.outputs.len());
        // Kernels of a mechanism that is followed run it over rows.
        let inline = (kind == "correct").then(|| quote!(#[inline(always)]));
        quote! {
            #inline
            fn #method<const __FUSED: __p::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> [T; #count] { #body }
        }
    };
    let methods = unit.coupled.iter().enumerate().map(|(number, group)| {
        let system = match group.followed {
            true => {
                let estimate = program("estimate", number, &group.estimate);
                let residuals = program("residuals", number, &group.residuals);
                let missed = program("missed", number, &group.missed);
                quote!(#estimate #residuals #missed)
            }
            false => program("system", number, &group.system),
        };
        let correct = program("correct", number, &group.correct);
        let placed = program("placed", number, &group.placed);
        quote!(#system #correct #placed)
    });
    quote! {
        impl<T: #runtime::Scalar> #assembly<T> { #(#methods)* }
    }
}

/// The descriptions of the groups.
fn groups(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let count = literal::index(unit.coupled.len());
    let groups = unit.coupled.iter();
    let groups = groups.map(|group| description::literal(outline, unit, group));
    quote! {
        impl #assembly<__p::f64> {
            const __GROUPS: [#runtime::CoupledGroup; #count] = [#(#groups),*];
        }
    }
}
