//! The assembled mechanism: its type, and the functions that make one and read it.

use proc_macro2::TokenStream;
use quote::quote;

use super::array_types::Types;
use super::docs::doc;
use super::outline::{Outline, plain};
use super::{assembly_data, attribute, constructors, coupled, literal, sweeps};

/// The public functions of the assembly type that make one and read it.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let mut items = accessors(outline);
    items.extend(constructors::items(outline));
    items
}

/// The assembly type and its data.
pub(super) fn structure(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        visibility,
        name,
        assembly,
        core,
        ..
    } = outline;
    let doc = doc(&format!(
        "An assembled `{}`: closed loops in one assembly, everything prepared that does not depend on the inputs.{}",
        outline.title(),
        sweeps::about(outline)
    ));
    let derives = attribute::derives([], &[]);
    let Types {
        modes, prepared, ..
    } = Types::new(outline);
    let [angles, inputs] = [outline.continuous_angles, outline.inputs.len()].map(literal::index);
    let own_derives = match outline.starts.is_empty() {
        true => derives.clone(),
        false => {
            quote!(#[derive(::core::clone::Clone, ::core::fmt::Debug, ::core::cmp::PartialEq)])
        }
    };
    let sealed = assembly_data::field(outline);
    let allow = attribute::allow();
    quote! {
        // As visible as the mechanism: the runtime's traits of public results name it.
        #allow
        #[doc(hidden)]
        #visibility type #core<T> = #runtime::Core<
            #name<T>, #modes, #runtime::Turns<T, #angles, #inputs>, #prepared,
        >;
        #doc
        #allow
        #own_derives
        #visibility struct #assembly<T = ::core::primitive::f64> { #sealed }
    }
}

/// `mechanism()`, `modes()` and, with prepared states over several inputs, `served()`, unless the
/// user's functions have these names.
fn accessors(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let core = assembly_data::core(outline, &quote!(self));
    let free = |accessor: &str| outline.functions.iter().all(|f| plain(f.name) != accessor);
    let mechanism = free("mechanism").then(|| {
        quote! {
            /// The dimensions that it was assembled with.
            #[must_use]
            pub const fn mechanism(&self) -> &#name<T> { &#core.dimensions }
        }
    });
    let modes = free("modes").then(|| {
        let count = literal::index(outline.modes.len());
        quote! {
            /// The assembly mode of each group that has two; `STRUCTURE` says which group is which.
            #[must_use]
            pub const fn modes(&self) -> &[#runtime::AssemblyMode; #count] { &#core.modes }
        }
    });
    let served = free("served").then(|| coupled::served(outline));
    quote! {
        impl<T> #assembly<T> { #mechanism #modes #served }
    }
}
