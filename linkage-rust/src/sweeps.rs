//! Many positions at once: the sweeps of a function over inputs, and over mechanisms.

mod doc_text;

pub(super) use doc_text::about;
use doc_text::summary;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::docs::doc;
use super::outline::{Function, Outline, plain};
use super::{literal, result_module};
use linkage_language::model::Sweep;
use linkage_language::syntax::Word;

/// The common data of the methods of one function.
struct Sweeps<'a> {
    outline: &'a Outline<'a>,
    function: &'a Function<'a>,
    /// The names of arguments that no input has.
    columns: Ident,
    slices: Ident,
    sets: Ident,
}

/// All sweeps of a function; nothing for one without inputs.
pub(super) fn methods(outline: &Outline, function: &Function) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let taken = |name: &str| function.arguments.iter().any(|argument| *argument == name);
    let argument = |name: &str| match taken(name) {
        true => format_ident!("__{name}"),
        false => format_ident!("{name}"),
    };
    let sweeps = Sweeps {
        outline,
        function,
        columns: argument("columns"),
        slices: argument("slices"),
        sets: argument("sets"),
    };
    let over_inputs = sweeps.over_inputs();
    let over_sets = (!outline.parameters.is_empty()).then(|| sweeps.over_sets());
    let runtime = &outline.runtime;
    quote!(#runtime::if_alloc! { #over_inputs #over_sets })
}

impl Sweeps<'_> {
    /// A method. The docs of the assembly describe sweeps once, for all methods.
    fn method(&self, sweep: Sweep, signature: TokenStream, body: TokenStream) -> TokenStream {
        let visibility = self.function.visibility;
        let name = format_ident!("{}{}", self.function.name, sweep.word());
        let name_only = plain(self.function.name);
        let doc = doc(&format!(
            "`{name_only}` {}: see [sweeps](Self#sweeps).",
            summary(sweep)
        ));
        let body = self.outline.body(body);
        quote!(#doc #visibility fn #name #signature { #body })
    }

    fn over_inputs(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let arguments = &self.function.arguments;
        let result = result_module::result(self.outline, self.function);
        let ty = result_module::columns(self.outline, self.function);
        let (columns, slices) = (&self.columns, &self.slices);
        let width = literal::index(self.function.width());
        let inputs = quote!(&self, #(#arguments: &[T]),*);
        let given = quote!(&self.__sealed, [#(#arguments),*]);
        let sweep = self.method(
            Sweep::Owned,
            quote!((#inputs) -> #ty<T>),
            quote!(#ty(#runtime::sweep(#given))),
        );
        let sweep_into = self.method(
            Sweep::Into,
            quote!((#inputs, #columns: &mut #ty<T>)),
            quote!(#runtime::sweep_into(#given, &mut #columns.0);),
        );
        let sweep_slices = self.method(
            Sweep::Slices,
            quote!((#inputs, #slices: [&mut [T]; #width])),
            quote!(#runtime::Slices::<#result<T>>::sweep(#given, #slices);),
        );
        let parallel = self.method(
            Sweep::ParallelInto,
            quote! {
                (#inputs, #columns: &mut #ty<T>)
                where T: __p::Send + __p::Sync
            },
            quote!(#runtime::sweep_parallel_into(#given, &mut #columns.0);),
        );
        quote! {
            #[must_use]
            #sweep
            #sweep_into
            #sweep_slices
            #runtime::if_rayon! { #parallel }
        }
    }

    fn over_sets(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let mechanism = self.outline.name;
        let arguments = &self.function.arguments;
        let ty = result_module::columns(self.outline, self.function);
        let (columns, sets) = (&self.columns, &self.sets);
        let inputs = quote!(&self, #sets: &[#mechanism<T>], #(#arguments: &[T]),*);
        let given = quote!(&self.__sealed, #sets, [#(#arguments),*]);
        let [owned, into, parallel_into] = match self.function.states.is_empty() {
            true => [
                quote!(#runtime::sweep_sets),
                quote!(#runtime::sweep_sets_into),
                quote!(#runtime::sweep_sets_parallel_into),
            ],
            false => [
                quote!(#runtime::followed_sweep_sets),
                quote!(#runtime::followed_sweep_sets_into),
                quote!(#runtime::followed_sweep_sets_parallel_into),
            ],
        };
        let sweep = self.method(
            Sweep::Sets,
            quote!((#inputs) -> #ty<T>),
            quote!(#ty(#owned(#given))),
        );
        let sweep_into = self.method(
            Sweep::SetsInto,
            quote!((#inputs, #columns: &mut #ty<T>)),
            quote!(#into(#given, &mut #columns.0);),
        );
        let parallel = self.method(
            Sweep::SetsParallelInto,
            quote! {
                (#inputs, #columns: &mut #ty<T>)
                where T: __p::Send + __p::Sync
            },
            quote!(#parallel_into(#given, &mut #columns.0);),
        );
        quote! {
            #[must_use]
            #sweep
            #sweep_into
            #runtime::if_rayon! { #parallel }
        }
    }
}
