//! The fields of an assembly. A module may write to every field of the types that a macro makes in
//! it, and rustc suggests them there, so the fields are those of the runtime's `Sealed`. A private
//! module around the types would do the same, but within a function body it could not name the
//! struct of dimensions, which belongs to the body.

use proc_macro2::TokenStream;
use quote::quote;

use super::array_types;
use super::literal;
use super::outline::Outline;

/// The only field of the assembly.
pub(super) fn field(outline: &Outline) -> TokenStream {
    let (runtime, core) = (&outline.runtime, core_type(outline));
    let starts = (!outline.starts.is_empty()).then(|| array_types::starts_type(outline));
    let starts = starts.map(|starts| quote!(, #starts));
    quote!(__sealed: #runtime::Sealed<#core #starts>,)
}

/// The type of the core, over `T`.
pub(super) fn core_type(outline: &Outline) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let [modes, angles, inputs, prepared] = [
        outline.modes.len(),
        outline.continuous_angles,
        outline.inputs.len(),
        outline.prepared,
    ]
    .map(literal::index);
    quote! {
        #runtime::Core<
            #name<T>,
            [#runtime::AssemblyMode; #modes],
            #runtime::Turns<T, #angles, #inputs>,
            [T; #prepared],
        >
    }
}

/// A reference to the core of the assembly `of`.
pub(super) fn core(outline: &Outline, of: &TokenStream) -> TokenStream {
    let runtime = &outline.runtime;
    quote!(#runtime::Sealed::core(&#of.__sealed))
}

/// A reference to the prepared starts of the assembly `of`.
pub(super) fn starts(outline: &Outline, of: &TokenStream) -> TokenStream {
    let runtime = &outline.runtime;
    quote!(#runtime::Sealed::starts(&#of.__sealed))
}
