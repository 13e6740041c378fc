//! The printer of Rust: from compiled mechanisms to the items that the macro `linkage::mechanism!`
//! leaves in a program.
//!
//! An `Outline` lists the items with their names, types and docs. It is the same for a mechanism
//! without mistakes (`items`) and for the items that are known after errors (`skeleton`). The other
//! files each print one kind of item. Types are next to each other in the module of the call.
//! Everything else is in a `block`, where `__p` is `$crate::__private`. Generated code names only
//! these and `::core`, and all its own names begin with `__`.

mod array_fields;
mod array_types;
mod assembly;
mod assembly_data;
mod attribute;
mod block;
mod body;
mod code;
mod columns;
mod compiled;
mod constructors;
mod count;
mod coupled;
mod debug;
mod dimensions;
mod docs;
mod drawing;
mod editor_names;
mod evaluator;
mod follower;
mod grouped;
mod guess;
mod items;
mod kernels;
mod literal;
mod load;
mod mechanism;
mod outline;
mod picture;
mod range_check;
mod result_module;
mod shape;
mod skeleton;
mod slots;
mod spanned;
mod stages;
mod structure;
mod sweeps;
mod table;
#[cfg(test)]
mod tests;

use std::iter;

use linkage_compiler::ir::CompiledMechanism;
use linkage_compiler::{Analysed, Driver};
use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

pub use editor_names::names;
use items::Printer;

/// Compiles the macro's input: the path of the facade in brackets, then one or several mechanisms.
/// Mistakes become `compile_error!`s next to a skeleton of the generated items. A mechanism that is
/// drawn gets its programs as a text, too, which `printed` makes of its name and its unit: reports
/// compute with it.
pub fn compile(
    input: TokenStream,
    printed: impl Fn(&str, &CompiledMechanism) -> String,
) -> TokenStream {
    let (krate, body) = split_crate_path(input);
    let driver = Driver::analyse(body);
    let sound = driver.syntax.is_empty();
    let mechanisms = driver.mechanisms.iter();
    let mechanisms = mechanisms.map(|mechanism| emitted(mechanism, &krate, &printed, sound));
    iter::once(driver.syntax.to_tokens())
        .chain(mechanisms)
        .collect()
}

/// The items of a mechanism, or its mistakes and a skeleton.
fn emitted(
    mechanism: &Analysed,
    krate: &TokenStream,
    printed: &Printer,
    sound: bool,
) -> TokenStream {
    let Analysed {
        definition,
        model,
        unit,
        diagnostics,
        ..
    } = mechanism;
    let errors = diagnostics.to_tokens();
    match unit {
        Some(unit) if sound && diagnostics.is_empty() => {
            let items = items::emit(krate, definition, unit, printed);
            let warnings = diagnostics.warnings_to_tokens(&definition.allows());
            quote!(#items #warnings)
        }
        _ => {
            let mechanism = model.as_ref().map(|model| &model.mechanism);
            let skeleton = skeleton::skeleton(krate, definition, mechanism);
            quote!(#errors #skeleton)
        }
    }
}

/// The bracketed path that the facade's wrapper puts in front, and the rest.
fn split_crate_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = input.into_iter();
    match tokens.next() {
        Some(TokenTree::Group(path)) => (Group::stream(&path), tokens.collect()),
        first => (quote!(::linkage), first.into_iter().chain(tokens).collect()),
    }
}
