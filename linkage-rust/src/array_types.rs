//! The array types of private functions, over the scalar `T`.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal;
use super::load::Places;
use super::outline::{Outline, PreparedGroup};
use linkage_compiler::ir::CompiledMechanism;

/// The array types of private functions, over `T`.
pub(super) struct Types {
    pub modes: TokenStream,
    pub inputs: TokenStream,
    /// Inputs and states.
    pub arguments: TokenStream,
    pub turns: TokenStream,
    pub prepared: TokenStream,
    pub gaps: TokenStream,
}

impl Types {
    pub(super) fn new(outline: &Outline, unit: &CompiledMechanism) -> Self {
        let runtime = &outline.runtime;
        let modes = literal::index(outline.modes.len());
        let inputs = literal::index(unit.inputs.len());
        let prepared = literal::index(outline.prepared);
        let arguments = literal::index(Places::all(outline).width());
        let angles = literal::index(unit.angles.len());
        let gaps = literal::index(unit.gaps.outputs.len());
        Self {
            modes: quote!([#runtime::AssemblyMode; #modes]),
            inputs: quote!([T; #inputs]),
            arguments: quote!([T; #arguments]),
            turns: quote!(#runtime::Turns<T, #angles, #inputs>),
            prepared: quote!([T; #prepared]),
            gaps: quote!([T; #gaps]),
        }
    }
}

/// The type of all starts.
pub(super) fn starts_type(outline: &Outline) -> TokenStream {
    let types = outline
        .starts
        .iter()
        .map(|start| start_type(outline, start));
    quote!((#(#types,)*))
}

/// A table over one input, or a grid over several or none.
pub(super) fn start_type(outline: &Outline, start: &PreparedGroup) -> TokenStream {
    let runtime = &outline.runtime;
    let several = start.inputs.len();
    let [inputs, size, terms] = [several, start.size, start.coefficients].map(literal::index);
    match several {
        1 => quote!(#runtime::Coupled<#size>),
        _ => quote!(#runtime::CoupledGrid<#inputs, #size, #terms>),
    }
}

/// The type of the groups' programs on plain numbers.
pub(super) fn coupled_name(outline: &Outline) -> Ident {
    format_ident!("__{}Coupled", outline.name)
}
