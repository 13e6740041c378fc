//! The `STRUCTURE` constant.

use proc_macro2::TokenStream;
use quote::quote;

use super::count::Count;
use super::facts::{Facts, GroupFacts};
use super::literal;
use super::outline::{Outline, plain};
use crate::lower::Lowered;

/// The literal of the runtime's `Structure`.
pub(super) fn literal(outline: &Outline, facts: &Facts, lowered: &Lowered) -> TokenStream {
    let runtime = &outline.runtime;
    let mobility = literal::index(facts.mobility);
    let groups = facts.groups.iter().map(|facts| group(outline, facts));
    let functions =
        outline
            .functions
            .iter()
            .zip(&lowered.evaluators)
            .map(|(function, evaluator)| {
                let name = plain(function.name);
                let operations = Count::of(&evaluator.program).literal(outline);
                quote!(#runtime::FunctionInfo { name: #name, operations: #operations })
            });
    let prepare = Count::of(&lowered.prepare).literal(outline);
    quote! {
        #runtime::Structure {
            mobility: #mobility,
            groups: &[#(#groups),*],
            functions: &[#(#functions),*],
            prepare: #prepare,
        }
    }
}

/// A structure with nothing in it, for the skeleton.
pub(super) fn empty(outline: &Outline) -> TokenStream {
    literal(outline, &Facts::default(), &Lowered::default())
}

fn group(outline: &Outline, facts: &GroupFacts) -> TokenStream {
    let runtime = &outline.runtime;
    let GroupFacts {
        class,
        order,
        kind,
        unknowns,
        method,
        ..
    } = facts;
    let loops = facts.loops.iter().map(|n| literal::index(*n));
    let mode = match facts.mode {
        Some(mode) => {
            let mode = literal::index(mode);
            quote!(::core::option::Option::Some(#mode))
        }
        None => quote!(::core::option::Option::None),
    };
    quote! {
        #runtime::Group {
            class: #class,
            order: #order,
            kind: #kind,
            loops: &[#(#loops),*],
            unknowns: &[#(#unknowns),*],
            mode: #mode,
            method: #method,
        }
    }
}
