//! Many positions at once: the sweeps of a function over inputs, and over mechanisms.

mod doc_text;

pub(super) use doc_text::about;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal;
use super::outline::{Function, Outline, plain};
use linkage_language::model::Sweep;
use linkage_language::syntax::Word;

/// All sweeps of a function; nothing for one without inputs. The docs of the assembly describe
/// sweeps once, for all methods.
pub(super) fn methods(outline: &Outline, function: &Function) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let over_sets = (!outline.parameters.is_empty()).then(|| over_sets(outline, function));
    let over_inputs = over_inputs(outline, function);
    quote!(#over_inputs #over_sets)
}

/// The runtime's `sweeps!`.
fn over_inputs(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function {
        visibility,
        arguments,
        result,
        columns,
        ..
    } = function;
    let title = plain(function.name);
    let width = literal::index(function.width());
    let by = match outline.complete {
        true => quote!(#runtime::sweeps),
        false => quote!(#runtime::missing_sweeps),
    };
    let methods = names(
        function,
        [
            Sweep::Owned,
            Sweep::Into,
            Sweep::Slices,
            Sweep::ParallelInto,
        ],
    );
    let others = ["columns", "slices"].map(|name| argument(function, name));
    quote! {
        #runtime::sweeps! {
            (#visibility fn) #title (#(#arguments),*) -> #columns of [#result; #width] by #by,
            [#(#methods),*], [#(#others),*]
        }
    }
}

/// The runtime's `set_sweeps!`.
fn over_sets(outline: &Outline, function: &Function) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let Function {
        visibility,
        arguments,
        columns,
        ..
    } = function;
    let title = plain(function.name);
    let by = match (outline.complete, function.states.is_empty()) {
        (true, true) => quote!(#runtime::sweeps),
        (true, false) => quote!(#runtime::followed_sweeps),
        (false, _) => quote!(#runtime::missing_sweeps),
    };
    let methods = names(
        function,
        [Sweep::Sets, Sweep::SetsInto, Sweep::SetsParallelInto],
    );
    let others = ["sets", "columns"].map(|name| argument(function, name));
    quote! {
        #runtime::set_sweeps! {
            (#visibility fn) #title (#(#arguments),*) -> #columns of #name by #by,
            [#(#methods),*], [#(#others),*]
        }
    }
}

/// The names of sweeps.
fn names<const N: usize>(function: &Function, sweeps: [Sweep; N]) -> [Ident; N] {
    sweeps.map(|sweep| format_ident!("{}{}", function.name, sweep.word()))
}

/// The name of an argument that no input has.
fn argument(function: &Function, name: &str) -> Ident {
    let is_taken = function.arguments.iter().any(|argument| *argument == name);
    match is_taken {
        true => format_ident!("__{name}"),
        false => format_ident!("{name}"),
    }
}
