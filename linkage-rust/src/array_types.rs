//! The array types of a mechanism's numbers, over the scalar `T`.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::load::Places;
use super::outline::{Outline, PreparedGroup};

/// The types of a mechanism's numbers, over `T`.
pub(super) struct Types {
    pub modes: TokenStream,
    pub inputs: TokenStream,
    pub centres: TokenStream,
    pub windings: TokenStream,
    pub prepared: TokenStream,
    /// Inputs and states.
    pub arguments: TokenStream,
}

impl Types {
    pub(super) fn new(outline: &Outline) -> Self {
        let runtime = &outline.runtime;
        let [modes, inputs, angles, prepared, arguments] = [
            outline.modes.len(),
            outline.inputs.len(),
            outline.continuous_angles,
            outline.prepared,
            Places::all(outline).width(),
        ]
        .map(literal::index);
        Self {
            modes: quote!([#runtime::AssemblyMode; #modes]),
            inputs: quote!([T; #inputs]),
            centres: quote!([T; #angles]),
            windings: quote!([[T; #inputs]; #angles]),
            prepared: quote!([T; #prepared]),
            arguments: quote!([T; #arguments]),
        }
    }
}

/// The type of all starts: nothing, or one of each coupled group.
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
