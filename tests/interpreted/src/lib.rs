//! The macro `interpreted!`: a mechanism for tests that compare numbers. It takes the text of
//! `linkage::mechanism!` and leaves the same types and methods for `f64`, but no code of the
//! mechanism: the engine compiles the text when it is first needed, and computes all numbers. That
//! they are those of generated code to the last bit is tested by `linkage-command`. Each mechanism
//! saves rustc half a second to two.
//!
//! Not here: constants other than `INDEX_*` (there are functions `structure()`, `parameters()` and
//! `inputs()`), followers, other numbers than `f64`, pictures. Sweeps return a list of results.

mod items;
mod numbers;

use std::rc::Rc;

use linkage_language::diagnostic::Diagnostics;
use linkage_language::model::{self, Library};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The types and methods of mechanisms, computed by the engine.
#[proc_macro]
pub fn interpreted(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input.into()).into()
}

fn expand(input: TokenStream) -> TokenStream {
    let text = input.to_string();
    let mut diagnostics = Diagnostics::default();
    let definitions = model::read(input, &mut diagnostics);
    let Some(first) = definitions.first() else {
        return diagnostics.to_tokens();
    };
    let all = format_ident!("__{}_AND_OTHERS", first.name);
    let mut library = Library::default();
    let mut items = quote! {
        #[allow(non_upper_case_globals)]
        static #all: ::std::sync::LazyLock<Vec<::linkage_engine::Mechanism>> =
            ::std::sync::LazyLock::new(|| {
                let compiled = ::linkage_engine::compile("mechanism", #text);
                compiled.unwrap_or_else(|error| panic!("{error}"))
            });
    };
    for definition in &definitions {
        let model = model::resolve(definition, &library, &mut diagnostics).map(Rc::new);
        if let Some(model) = &model {
            items.extend(items::mechanism(definition, &model.mechanism, &all));
        }
        library.add(definition, model);
    }
    match diagnostics.is_empty() {
        true => items,
        false => diagnostics.to_tokens(),
    }
}
