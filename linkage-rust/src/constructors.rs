//! The public functions that make an assembly of dimensions.

use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Outline, plain};
use linkage_language::model::Sweep;
use linkage_language::syntax::Word;

/// The methods that are called on dimensions although they need an assembly: rustc then points at
/// `assemble`, which has these names as aliases.
fn aliases(outline: &Outline) -> Vec<String> {
    let functions = outline.functions.iter().flat_map(|function| {
        let name = plain(function.name);
        [name.clone(), format!("{name}{}", Sweep::Owned.word())]
    });
    functions.filter(|name| name != "assemble").collect()
}

/// `assemble`, `assemblies`, `assemblies_at`, `assemble_from`.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let assemble = outline.body(match outline.starts.is_empty() {
        true => quote!(#runtime::assemble(self)),
        false => quote!(#runtime::assemble_coupled(self)),
    });
    let assemblies = outline.body(quote!(#runtime::assemblies(self)));
    let from = outline.body(quote!(#runtime::assemble_from(self, __assembly)));
    let error = quote!(#runtime::AssemblyError);
    let list = quote!(__p::Result<#runtime::Vec<#assembly<T>>, #error>);
    let from_estimates = outline.starts.iter().any(|start| start.followed);
    let from_estimates = from_estimates.then(|| {
        let doc = "\nIt is not complete: of groups whose solutions cannot be listed (`STRUCTURE` says which), only the assembly is in it to which \
                   the start estimates lead.";
        quote!(#[doc = #doc])
    });
    let at = (!outline.inputs.is_empty()).then(|| {
        let names: Vec<_> = outline.inputs.iter().map(|input| input.name).collect();
        let body = outline.body(quote!(#runtime::assemblies_at(self, &[#(#names),*])));
        quote! {
            /// Every real assembly at the given inputs, each ready to evaluate; the one that the start estimates
            /// choose comes first if it is real there.
            #from_estimates
            ///
            /// # Errors
            ///
            /// As `assemblies()`.
            pub fn assemblies_at(&self, #(#names: T),*) -> #list { #body }
        }
    });
    let aliases = aliases(outline);
    let aliases = (!aliases.is_empty()).then(|| quote!(#[doc(alias(#(#aliases),*))]));
    quote! {
        impl<T: #runtime::Scalar> #name<T> {
            /// Closes the loops at the reference inputs in the assembly mode that the start estimates choose, and
            /// computes what depends on the dimensions alone.
            ///
            /// # Errors
            ///
            /// Says which loop cannot close and by how much it misses, or has no finite solution, or which angle cannot be
            /// followed through the range.
            #aliases
            pub fn assemble(&self) -> __p::Result<#assembly<T>, #error> { #assemble }
        }
        #runtime::if_alloc! {
            impl<T: #runtime::Scalar> #name<T> {
                /// Every real assembly at the reference inputs, each ready to evaluate; the one that the start
                /// estimates choose comes first if it is real. The list is empty if no assembly is.
                #from_estimates
                ///
                /// # Errors
                ///
                /// Fails if a dimension is not a finite number, if there are more than 16 groups with two modes, or if the assemblies of a
                /// group without a closed form cannot be listed or followed.
                pub fn assemblies(&self) -> #list { #assemblies }
                #at

                /// These dimensions in the assembly of a mechanism with others: it is followed along the straight way from those to these, at
                /// the reference inputs, in steps too small to leave it. Each lane of `T` has a way of its own; it is followed in `f64`, on
                /// real parts, and the assembly has the digits and derivatives of `T` as one from `assemble()` has.
                ///
                /// # Errors
                ///
                /// `Blocked` where the assembly ends on the way, in one lane at least; what `assemble()` says of these dimensions.
                pub fn assemble_from(
                    &self,
                    __assembly: &#assembly<T>,
                ) -> __p::Result<#assembly<T>, #error> { #from }
            }
        }
    }
}

/// `circuits()`; nothing for a mechanism without groups or with another number of inputs than one.
pub(super) fn circuits(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    if outline.inputs.len() != 1 {
        return TokenStream::new();
    }
    let float = quote!(__p::f64);
    let body = outline.body(quote!(#runtime::circuits_of(self)));
    quote! {
        #runtime::if_alloc! {
            impl #name<#float> {
                /// Every assembly over the range of the input (a turn about the reference where an angle has none): how far each
                /// reaches, its turning points, and where its margin is smallest.
                ///
                /// # Errors
                ///
                /// As `assemblies()`, if it fails at every position.
                #[inline]
                pub fn circuits(&self) -> __p::Result<
                    #runtime::Circuits<#assembly<#float>>, #runtime::AssemblyError,
                > {
                    #body
                }
            }
        }
    }
}
