//! The `STRUCTURE` constant.

use linkage_symbolic::count::Count;
use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Outline, plain};
use super::{count, literal};
use linkage_compiler::ir::{CompiledMechanism, Group};

/// The literal of the runtime's `Structure`.
pub(super) fn literal(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let runtime = &outline.runtime;
    let mobility = literal::index(unit.mobility);
    let groups = unit.groups.iter().map(|solved| group(outline, solved));
    let functions = outline.functions.iter().zip(&unit.functions);
    let functions = functions.map(|(function, compiled)| {
        let name = plain(function.name);
        let operations = count::literal(&compiled.called.count);
        quote!(#runtime::function(#name, #operations))
    });
    let prepare = count::literal(&Count::of_program(&unit.prepare));
    quote! {
        #runtime::Structure {
            mobility: #mobility,
            groups: &[#(#groups),*],
            functions: &[#(#functions),*],
            prepare: #runtime::operations(#prepare),
        }
    }
}

/// A structure with nothing in it, for the skeleton.
pub(super) fn empty(outline: &Outline) -> TokenStream {
    literal(outline, &CompiledMechanism::default())
}

fn group(outline: &Outline, group: &Group) -> TokenStream {
    let runtime = &outline.runtime;
    let Group {
        class,
        order,
        kind,
        joints,
        unknowns,
        method,
        ..
    } = group;
    let loops = group.loops.iter().map(|n| literal::index(*n));
    let mode = match group.mode {
        Some(mode) => {
            let mode = literal::index(mode);
            quote!(__p::Some(#mode))
        }
        None => quote!(__p::None),
    };
    quote! {
        #runtime::Group {
            class: #class,
            order: #order,
            kind: #kind,
            loops: &[#(#loops),*],
            joints: #joints,
            unknowns: &[#(#unknowns),*],
            mode: #mode,
            method: #method,
        }
    }
}
