//! The source of the prepared states that a function starts from: one state for a call, many side
//! by side for a sweep.

use proc_macro2::TokenStream;
use quote::quote;

use crate::array_types::starts_type;
use crate::outline::{Function, Outline};
use crate::stages::Version;
use crate::{attribute, literal, stages};

use super::look_up::{look_up, places};

/// The runtime's `States` of one function; nothing if it uses none.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    if function.states.is_empty() {
        return TokenStream::new();
    }
    let runtime = &outline.runtime;
    let name = stages::name(function, Version::Called);
    let everywhere = &attribute::split(function.attributes).everywhere;
    let (initial, fused) = (quote!(__initial), quote!(__FUSED));
    let (looked_up, states) = look_up(
        outline,
        &function.positions,
        &function.states,
        &initial,
        &fused,
    );
    let inputs = (0..function.arguments.len()).map(literal::index);
    let mut filled = TokenStream::new();
    let mut first = 0;
    for &group in &function.states {
        // Its numbers and its floor.
        let behind = first + outline.starts[group].size + 1;
        let [number, from, to] = [group, first, behind].map(literal::index);
        let places = places(outline, &function.positions, group);
        let arguments = match &places[..] {
            [one] => quote!(&__x[#one]),
            several => quote!([#(&__x[#several]),*]),
        };
        filled.extend(quote! {
            __initial.#number
                .fill::<T, __FUSED, __LANES, __BLOCK>(#arguments, __vectors, &mut __states[#from..#to]);
        });
        first = behind;
    }
    let starts = starts_type(outline);
    let count = literal::index(function.arguments.len());
    let width = literal::index(function.arguments.len() + first);
    quote! {
        #(#everywhere)*
        impl<T: #runtime::Scalar> #runtime::States<T, #starts, #count, #width> for #name {
            #[inline(always)]
            fn extend<const __FUSED: __p::bool>(__initial: &#starts, __x: [T; #count]) -> [T; #width] {
                #looked_up
                [#(__x[#inputs],)* #(#states),*]
            }

            #[inline(always)]
            fn fill<
                const __FUSED: __p::bool,
                const __LANES: __p::usize,
                const __BLOCK: __p::usize,
            >(
                __initial: &#starts,
                __x: &[[T; __BLOCK]],
                __vectors: __p::usize,
                __states: &mut [[T; __BLOCK]],
            ) { #filled }
        }
    }
}
