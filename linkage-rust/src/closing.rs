//! The reasons for which `assemble()` is refused: dimensions that are not finite numbers, groups
//! that do not close.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;
use linkage_compiler::ir::CompiledMechanism;

/// Checks that the dimensions that the groups need are finite numbers.
pub(super) fn finite(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let title = outline.title();
    let mut needed = unit
        .groups
        .iter()
        .flat_map(|group| &group.parameters)
        .peekable();
    if needed.peek().is_none() {
        return quote!(__p::Ok(()));
    }
    let needed = needed.map(|&index| literal::index(index));
    quote! {
        #runtime::finite(
            #title,
            #name::<__p::f64>::PARAMETERS,
            &[#(#needed),*],
            &__m.__values(),
        )
    }
}

/// Checks that the groups close.
pub(super) fn close(outline: &Outline, unit: &CompiledMechanism) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let title = outline.title();
    let units = unit.groups.iter().map(|group| &group.gap_unit);
    quote! {
        #runtime::close(
            #title,
            #name::<__p::f64>::STRUCTURE.groups,
            &[#(#units),*],
            &__gaps,
        )
    }
}
