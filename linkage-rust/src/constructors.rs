//! The public functions that make an assembly of dimensions.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
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

/// `assemble`, `assemblies`, `assemblies_at`.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let Outline {
        runtime,
        name,
        assembly,
        ..
    } = outline;
    let modes = outline.default_modes();
    let references: Vec<_> = outline
        .inputs
        .iter()
        .map(|input| {
            let reference = literal::float(input.reference);
            quote!(T::from_f64(#reference))
        })
        .collect();
    let explained = |result: TokenStream| explained(outline, &result);
    let assemble = explained(quote!(#assembly::__assemble(self, #modes, [#(#references),*])));
    let assemble = outline.body(assemble);
    let enumerate = |at: TokenStream| {
        let title = outline.title();
        let all = match outline.starts.is_empty() {
            true => quote! {
                #assembly::__assemble(self, __modes, #at).map(|__assembly| #runtime::one(__assembly))
            },
            false => quote!(#assembly::__assemblies(self, __modes, #at)),
        };
        let all = quote!(#runtime::assemblies(#title, #modes, |__modes| #all));
        outline.body(explained(all))
    };
    let assemblies = enumerate(quote!([#(#references),*]));
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
        let body = enumerate(quote!([#(#names),*]));
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
    quote! {
        impl<T: #runtime::Scalar> #name<T> {
            /// Closes the loops at the reference inputs in the assembly mode that the start estimates choose, and
            /// computes what depends on the dimensions alone.
            ///
            /// # Errors
            ///
            /// Says which loop cannot close and by how much it misses, or has no finite solution, or which angle cannot be
            /// followed through the range.
            #(#[doc(alias = #aliases)])*
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
            }
        }
    }
}

/// A result of assembling, in which an error about a dimension names the dimension as its cause.
pub(super) fn explained(outline: &Outline, result: &TokenStream) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    quote! {
        #runtime::explained(
            #result, #name::<__p::f64>::PARAMETERS, || self.__values(),
        )
    }
}
