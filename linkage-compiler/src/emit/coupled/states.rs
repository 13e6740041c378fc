//! The source of the prepared states that a function starts from: one state for a call, many side
//! by side for a sweep.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::outline::{Function, Outline};
use crate::emit::{assembly_data, attribute, literal};

use super::look_up::{look_up, places};

/// The type that looks up the states of a function; it refers to the assembly.
pub(in crate::emit) fn states_name(outline: &Outline, function: &Function) -> Ident {
    format_ident!("__{}_states_of_{}", outline.name, function.name)
}

/// The arguments of a function's program: the inputs, then the states of the groups that it uses.
pub(in crate::emit) fn with_states(outline: &Outline, function: &Function) -> TokenStream {
    let inputs = &function.arguments;
    let count = literal::index(inputs.len());
    let starts = assembly_data::starts(outline, &quote!(self));
    let (looked_up, states) = look_up(
        outline,
        &function.positions,
        &function.states,
        &starts,
        &quote!(__FUSED),
    );
    quote! {
        {
            let __x: [T; #count] = [#(#inputs),*];
            #looked_up
            [#(#inputs,)* #(#states),*]
        }
    }
}

/// The runtime's `States` of one function; nothing if it uses none or has no sweep.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    if function.states.is_empty() || function.arguments.is_empty() {
        return TokenStream::new();
    }
    let Outline {
        runtime, assembly, ..
    } = outline;
    let name = states_name(outline, function);
    let everywhere = &attribute::split(function.attributes).everywhere;
    let starts = assembly_data::starts(outline, &quote!(self.0));
    let mut filled = TokenStream::new();
    let mut first = 0;
    for &group in &function.states {
        // Its numbers and its floor.
        let behind = first + outline.starts[group].size + 1;
        let [number, from, to] = [group, first, behind].map(literal::index);
        let places = places(outline, &function.positions, group);
        filled.extend(match &places[..] {
            [one] => quote! {
                #starts.#number
                    .fill::<T, __FUSED, __LANES, __BLOCK>(&__x[#one], __vectors, &mut __states[#from..#to]);
            },
            several => quote! {
                #starts.#number
                    .fill::<T, __FUSED, __LANES, __BLOCK>([#(&__x[#several]),*], __vectors, &mut __states[#from..#to]);
            },
        });
        first = behind;
    }
    let [inputs, states] = [function.positions.len(), first].map(literal::index);
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        struct #name<'a, T>(&'a #assembly<T>);

        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #runtime::States<T, #inputs, #states> for #name<'_, T> {
            #[inline(always)]
            fn fill<
                const __FUSED: ::core::primitive::bool,
                const __LANES: ::core::primitive::usize,
                const __BLOCK: ::core::primitive::usize,
            >(
                &self,
                __x: &[[T; __BLOCK]; #inputs],
                __vectors: ::core::primitive::usize,
                __states: &mut [[T; __BLOCK]; #states],
            ) { #filled }
        }
    }
}
