//! The assembled mechanism: its type, and the functions that make one and read it.

use proc_macro2::TokenStream;
use quote::quote;

use super::code::joined;
use super::docs::doc;
use super::outline::{Outline, plain};
use super::{assembly_data, attribute, constructors, coupled, literal, sweeps};

/// The name of its core, and the public functions of the assembly type that make one and read it.
pub(super) fn items(outline: &Outline) -> TokenStream {
    joined([
        core_name(outline),
        accessors(outline),
        constructors::items(outline),
    ])
}

/// The assembly type and its data.
pub(super) fn structure(outline: &Outline) -> TokenStream {
    let Outline {
        visibility,
        assembly,
        ..
    } = outline;
    let doc = doc(&format!(
        "An assembled `{}`: closed loops in one assembly, everything prepared that does not depend on the inputs.{}",
        outline.title(),
        sweeps::about(outline)
    ));
    let derives = attribute::derives([], &[]);
    let own_derives = match outline.starts.is_empty() {
        true => derives.clone(),
        false => {
            quote!(#[derive(::core::clone::Clone, ::core::fmt::Debug, ::core::cmp::PartialEq)])
        }
    };
    let sealed = assembly_data::field(outline);
    let allow = attribute::allow();
    quote! {
        #doc
        #allow
        #own_derives
        #visibility struct #assembly<T = ::core::primitive::f64> { #sealed }
    }
}

/// The name of the core's type in the block around code.
fn core_name(outline: &Outline) -> TokenStream {
    let (name, core) = (&outline.core, assembly_data::core_type(outline));
    quote!(type #name<T> = #core;)
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
