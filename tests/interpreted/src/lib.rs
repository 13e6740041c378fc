//! The macro `interpreted!`: a mechanism for tests that compare numbers. It takes the text of
//! `linkage::mechanism!` and leaves the same types and methods for `f64`, but no code of the
//! mechanism: the engine compiles the text when it is first needed, and computes all numbers. That
//! they are those of generated code to the last bit is tested by `linkage-command`. Each mechanism
//! saves rustc half a second to two.
//!
//! Not here: constants other than `INDEX_*` (there are functions `structure()`, `parameters()` and
//! `inputs()`), followers, other numbers than `f64`, pictures. Sweeps return a list of results.

mod items;

use linkage_language::diagnostic::Diagnostics;
use linkage_language::model;
use linkage_language::model::{Library, Shape};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::rc::Rc;

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

// Types of parameters and results, and their numbers one after the other.

/// The Rust type of a value.
pub(crate) fn rust_type(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(f64),
        Shape::Vector(2) => quote!(::linkage::Vector2<f64>),
        Shape::Vector(_) => quote!(::linkage::Vector3<f64>),
        Shape::Array(count, entry) => {
            let entry = rust_type(entry);
            quote!([#entry; #count])
        }
        Shape::Frame => quote!(::linkage::Frame<f64>),
        Shape::PlaneFrame => quote!(::linkage::PlaneFrame<f64>),
    }
}

/// The value made of the numbers that `next()` returns.
pub(crate) fn from_numbers(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(next()),
        Shape::Vector(2) => quote!(::linkage::Vector2::new(next(), next())),
        Shape::Vector(_) => quote!(::linkage::Vector3::new(next(), next(), next())),
        Shape::Array(_, entry) => {
            let entry = from_numbers(entry);
            quote!(::std::array::from_fn(|_| #entry))
        }
        Shape::Frame => {
            let vector = from_numbers(&Shape::Vector(3));
            quote!(::linkage::Frame { origin: #vector, x: #vector, y: #vector, z: #vector })
        }
        Shape::PlaneFrame => {
            let vector = from_numbers(&Shape::Vector(2));
            quote!(::linkage::PlaneFrame { origin: #vector, x: #vector, y: #vector })
        }
    }
}

/// The numbers of a value that is a number or a vector.
pub(crate) fn to_numbers(shape: &Shape, value: &TokenStream) -> Vec<TokenStream> {
    match shape {
        Shape::Vector(count) => ["x", "y", "z"][..*count]
            .iter()
            .map(|component| {
                let component = quote::format_ident!("{component}");
                quote!(#value.#component)
            })
            .collect(),
        _ => vec![value.clone()],
    }
}
