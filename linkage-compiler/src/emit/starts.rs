//! What an assembly with coupled groups has beside the others: prepared starts, the arguments that they add to programs, and the
//! programs that prepare them.

mod assemble;
mod description;
mod moving;
mod preparing;
mod states;

use linkage_symbolic::program::Program;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::assembly::Types;
use super::body::Runs;
use super::load::{Places, loader};
use super::outline::{Outline, Start};
use super::{assembly_data, attribute, body, literal};
use crate::ir::CompiledMechanism;

pub(super) use assemble::assemble;
pub(super) use moving::followed;
pub(super) use states::{states_name, with_states};

/// The type of all starts.
pub(super) fn starts_type(outline: &Outline) -> TokenStream {
    let types = outline
        .starts
        .iter()
        .map(|start| start_type(outline, start));
    quote!((#(#types,)*))
}

/// The type of the groups' programs on plain numbers.
pub(super) fn coupled_name(outline: &Outline) -> Ident {
    format_ident!("__{}Coupled", outline.name)
}

/// `served()`; nothing where no group is prepared over several inputs.
pub(super) fn served(outline: &Outline) -> TokenStream {
    let prepared = assembly_data::starts(outline, &quote!(self));
    let groups = outline.starts.iter().enumerate();
    let over_several = groups.filter(|(_, start)| start.inputs.len() > 1);
    let shares = over_several.map(|(number, _)| {
        let number = literal::index(number);
        quote!(#prepared.#number.served())
    });
    let share = shares.reduce(|least, share| quote!(::core::primitive::f64::min(#least, #share)));
    share.map_or_else(TokenStream::new, |share| {
        quote! {
            /// The share of the ranges of the inputs in which groups without a closed form are assembled, from 0 to 1: elsewhere results are
            /// NaN, because the links do not reach each other there or a dead point is near. Measured on a lattice of positions; of several
            /// groups, and lanes of the scalar, the one that serves least counts.
            #[must_use]
            pub fn served(&self) -> ::core::primitive::f64 { #share }
        }
    })
}

/// A table over one input, or a grid over several or none.
fn start_type(outline: &Outline, start: &Start) -> TokenStream {
    let runtime = &outline.runtime;
    let several = start.inputs.len();
    let [inputs, size, terms] = [several, start.size, start.coefficients].map(literal::index);
    match several {
        1 => quote!(#runtime::Coupled<#size>),
        _ => quote!(#runtime::CoupledGrid<#inputs, #size, #terms>),
    }
}

/// Everything for the coupled groups of a mechanism; nothing if it has none.
pub(super) fn items(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    if outline.starts.is_empty() {
        return TokenStream::new();
    }
    let mut items = lookups(outline);
    items.extend(programs(outline, unit));
    items.extend(preparing::items(outline, unit));
    // Sets of dimensions need some.
    if !outline.parameters.is_empty() {
        items.extend(moving::items(outline, unit));
    }
    items
}

/// From the starts of the lanes to those of the assembly, and from inputs to arguments.
fn lookups(outline: &Outline) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let starts = starts_type(outline);
    let count = literal::index(outline.starts.len());
    let made = outline.starts.iter().enumerate().map(|(number, start)| {
        let number = literal::index(number);
        let ty = start_type(outline, start);
        quote!(<#ty>::of::<T>(|__lane| &__lanes[__lane][#number]))
    });
    let together = extend(outline);
    let inputs = literal::index(outline.inputs.len());
    let width = literal::index(Places::all(outline).width());
    let functions = outline
        .functions
        .iter()
        .map(|function| states::items(outline, function));
    let allow = attribute::allow();
    quote! {
        #allow
        impl<T: #runtime::Scalar> #assembly<T> {
            fn __starts(__lanes: &[[#runtime::Start; #count]]) -> #starts { (#(#made,)*) }

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
    let own = inputs.iter().map(|&k| {
        let k = literal::index(k);
        quote!(__x[#k])
    });
    let starts = quote!(__starts);
    let runtime = &outline.runtime;
    let fused = quote!({ #runtime::FUSED });
    let (looked_up, states) = look_up(outline, &inputs, &groups, &starts, &fused);
    quote!(#looked_up [#(#own,)* #(#states),*])
}

/// Statements that look up the states of groups in `starts` at the inputs `__x`, and the numbers of these; `fused` says whether with fused
/// multiply-add.
fn look_up(
    outline: &Outline,
    inputs: &[usize],
    groups: &[usize],
    starts: &TokenStream,
    fused: &TokenStream,
) -> (TokenStream, Vec<TokenStream>) {
    let mut looked_up = TokenStream::new();
    let mut numbers = Vec::new();
    for &group in groups {
        let name = format_ident!("__state{group}");
        let number = literal::index(group);
        let places = places(outline, inputs, group);
        let found = match &places[..] {
            [one] => quote!(#starts.#number.at::<T, #fused>(__x[#one])),
            several => quote!(#starts.#number.at::<T, #fused>([#(__x[#several]),*])),
        };
        looked_up.extend(quote!(let #name = #found;));
        numbers.extend((0..outline.starts[group].size).map(|k| {
            let k = literal::index(k);
            quote!(#name.0[#k])
        }));
        numbers.push(quote!(#name.1));
    }
    (looked_up, numbers)
}

/// Where the inputs of a group stand among `inputs`.
fn places(outline: &Outline, inputs: &[usize], group: usize) -> Vec<Literal> {
    let of = outline.starts[group].inputs.iter();
    of.map(|input| {
        let place = inputs.iter().position(|own| own == input);
        literal::index(place.expect("a function has the inputs of its groups"))
    })
    .collect()
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
    } = Types::new(outline, unit);
    let places = Places::all(outline);
    let program = |kind: &str, number: usize, program: &Program| {
        let method = format_ident!("__{kind}{number}");
        let statements = body::statements(program, Runs::Once, &loader(outline, &places));
        let outputs = body::outputs(program);
        let count = literal::index(program.outputs.len());
        // Kernels of what is followed run it over rows.
        let inline = (kind == "correct").then(|| quote!(#[inline(always)]));
        quote! {
            #inline
            fn #method<const __FUSED: ::core::primitive::bool>(
                __m: &#name<T>,
                __modes: &#modes,
                __prepared: &#prepared,
                __x: #arguments,
            ) -> [T; #count] { #statements #outputs }
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
    let allow = attribute::allow();
    quote! {
        #allow
        impl<T: #runtime::Scalar> #assembly<T> { #(#methods)* }
    }
}
