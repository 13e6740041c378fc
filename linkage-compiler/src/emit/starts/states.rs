//! Where a function finds the prepared states that it starts from: at once for a call, in two steps for a sweep.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::outline::{Function, Outline};
use crate::emit::{attribute, literal, sealed};

use super::look_up;

/// The type that looks up the states of a function; it refers to the assembly.
pub(in crate::emit) fn states_name(outline: &Outline, function: &Function) -> Ident {
    format_ident!("__{}_states_of_{}", outline.name, function.name)
}

/// The arguments of a function's program: the inputs, then the states of the groups that it uses.
pub(in crate::emit) fn with_states(outline: &Outline, function: &Function) -> TokenStream {
    let inputs = &function.arguments;
    let count = literal::index(inputs.len());
    let starts = sealed::starts(outline, &quote!(self));
    let (looked_up, states) = look_up(
        outline,
        &function.positions,
        &function.states,
        &|number, _, at| quote!(#starts.#number.at::<T>(#at)),
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
    let looked_up =
        |how: &dyn Fn(&proc_macro2::Literal, Option<usize>, &TokenStream) -> TokenStream| {
            let (looked_up, states) = look_up(outline, &function.positions, &function.states, how);
            quote!(#looked_up [#(#states),*])
        };
    let starts = sealed::starts(outline, &quote!(self.0));
    let whole = looked_up(&|number, _, at| quote!(#starts.#number.at::<T>(#at)));
    let at = looked_up(&|number, table, at| match table {
        None => quote!(#starts.#number.at::<T>(#at)),
        Some(table) => {
            let [place, slot] = [2 * table, 2 * table + 1].map(literal::index);
            quote!(#starts.#number.at_place::<T, __FUSED>([__places[#place], __places[#slot]]))
        }
    });
    let mut located = Vec::new();
    for &group in &function.states {
        if let [input] = outline.starts[group].inputs[..] {
            let place = function.positions.iter().position(|&own| own == input);
            let place = literal::index(place.expect("a function has the inputs of its groups"));
            let number = literal::index(group);
            located.push(quote!(#starts.#number.locate::<T>(__x[#place])));
        }
    }
    let names: Vec<Ident> = (0..located.len())
        .map(|k| format_ident!("__place{k}"))
        .collect();
    let width = function.places(outline).width() - function.positions.len();
    let [inputs, places, states] =
        [function.positions.len(), 2 * located.len(), width].map(literal::index);
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        struct #name<'a, T>(&'a #assembly<T>);

        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #runtime::States<T, #inputs, #places, #states> for #name<'_, T> {
            #[inline(always)]
            fn locate(&self, __x: [T; #inputs]) -> [::core::primitive::f64; #places] {
                #(let #names = #located;)*
                [#(#names[0], #names[1]),*]
            }

            #[inline(always)]
            fn at<const __FUSED: ::core::primitive::bool>(
                &self,
                __x: [T; #inputs],
                __places: [::core::primitive::f64; #places],
            ) -> [T; #states] { #at }

            #[inline(always)]
            fn whole(&self, __x: [T; #inputs]) -> [T; #states] { #whole }
        }
    }
}
