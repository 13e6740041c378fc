//! Looking up the states of coupled groups at given inputs.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::literal;
use crate::outline::Outline;

/// Statements that look up the states of groups in `starts` at the inputs `__x`, and the numbers of
/// these; `fused` says whether with fused multiply-add.
pub(super) fn look_up(
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

/// The indices of the inputs of a group among `inputs`.
pub(super) fn places(outline: &Outline, inputs: &[usize], group: usize) -> Vec<Literal> {
    let of = outline.starts[group].inputs.iter();
    of.map(|input| {
        let position = inputs.iter().position(|other| other == input);
        literal::index(position.expect("a function has the inputs of its groups"))
    })
    .collect()
}
