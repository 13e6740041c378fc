//! The array types of a mechanism's numbers, over the scalar `T`.

use proc_macro2::TokenStream;
use quote::quote;

use super::load::Places;
use super::outline::{Outline, PreparedGroup};
use super::{code, literal};

/// The types of a mechanism's numbers, over `T`, as text for the block around code.
pub(super) struct Types {
    pub modes: String,
    pub inputs: String,
    pub centres: String,
    pub windings: String,
    pub prepared: String,
    /// Inputs and states.
    pub arguments: String,
    /// The initial states of coupled groups.
    pub starts: String,
}

impl Types {
    pub(super) fn new(outline: &Outline) -> Self {
        let [modes, inputs, angles] = [
            outline.modes.len(),
            outline.inputs.len(),
            outline.continuous_angles,
        ];
        Self {
            modes: format!("[__p::AssemblyMode; {modes}]"),
            inputs: format!("[T; {inputs}]"),
            centres: format!("[T; {angles}]"),
            windings: format!("[[T; {inputs}]; {angles}]"),
            prepared: format!("[T; {}]", outline.prepared),
            arguments: format!("[T; {}]", Places::all(outline).width()),
            starts: code::text(&starts_type(outline)),
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
