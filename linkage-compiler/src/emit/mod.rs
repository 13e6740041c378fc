//! Emission: from the resolved model and its straight-line programs to Rust items.
//!
//! An `Outline` lists the items with their names, types and docs; it is the same for a mechanism
//! without mistakes ([`emit`]) and for the items that are known after errors ([`skeleton`]). The
//! other files each print one kind of item. Types are next to each other in the module of the call;
//! everything else is in a [`block`], where `__p` is `$crate::__private`. Generated code names only
//! these and `::core`, and all its own names begin with `__`.

mod array_fields;
mod array_types;
mod assembly;
mod assembly_data;
mod attribute;
mod block;
mod body;
mod circuits;
mod closing;
mod columns;
mod compiled;
mod constructors;
mod count;
mod coupled;
mod debug;
mod dimension_path;
mod dimensions;
mod docs;
mod evaluator;
mod follower;
mod guess;
mod kernels;
mod literal;
mod load;
mod mechanism;
mod outline;
mod picture;
mod prepare;
mod range_check;
mod result_module;
mod shape;
mod skeleton;
mod slots;
mod spanned;
mod stages;
mod structure;
mod survey;
mod sweeps;
mod table;
#[cfg(test)]
mod tests;
mod winding;

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

pub(crate) use self::skeleton::skeleton;

use self::outline::{Function, Outline};
use self::stages::Version;
use crate::ir::{self, CompiledMechanism};
use crate::syntax::MechanismDef;

/// A function that prints programs as a text in another language.
pub(crate) type Printer<'a> = dyn Fn(&str, &CompiledMechanism) -> String + 'a;

/// All items for a mechanism without mistakes. `krate` is the path of the facade.
pub(crate) fn emit(
    krate: &TokenStream,
    def: &MechanismDef,
    unit: &CompiledMechanism,
    printed: &Printer,
) -> TokenStream {
    let outline = Outline::complete(krate, def, unit);
    let mut code = mechanism::items(&outline);
    code.extend(mechanism::constants(
        &outline,
        &structure::literal(&outline, unit),
    ));
    if let Some(picture) = &unit.picture {
        let programs = printed(&def.title(), unit);
        code.extend(picture::items(&outline, picture, &programs));
    }
    code.extend(dimensions::items(&outline));
    let mut assembled = assembly::items(&outline);
    assembled.extend(assembly::plumbing(&outline, unit));
    assembled.extend(coupled::items(&outline, unit));
    assembled.extend(winding::items(&outline, unit));
    assembled.extend(survey::items(&outline, unit));
    assembled.extend(compiled::items(&outline, unit));
    assembled.extend(circuits::items(&outline, unit));
    assembled.extend(range_check::items(&outline, unit));
    assembled.extend(dimension_path::items(&outline, unit));
    assembled.extend(follower::items(&outline, unit));
    for (function, compiled) in outline.functions.iter().zip(&unit.functions) {
        assembled.extend(self::function(&outline, function, compiled, &unit.prepare));
    }
    code.extend(with_prepared(&outline, assembled));
    let mut items = types(&outline, follower::types);
    items.extend(block::items(&outline, &code));
    items
}

/// The types of a mechanism and of its functions; `follower` prints that of its follower.
fn types(outline: &Outline, follower: impl Fn(&Outline) -> TokenStream) -> TokenStream {
    let outline = &outline.for_types();
    let mut types = mechanism::structure(outline);
    let mut assembled = assembly::structure(outline);
    assembled.extend(follower(outline));
    for function in &outline.functions {
        let result = evaluator::result(outline, function);
        let columns = columns::types(outline, function);
        assembled.extend(result_module::with_imports(
            outline, function, &result, &columns,
        ));
    }
    types.extend(with_prepared(outline, assembled));
    types
}

/// The items, with an allocator only if values are prepared that need one.
fn with_prepared(outline: &Outline, items: TokenStream) -> TokenStream {
    match outline.starts.is_empty() {
        true => items,
        false => {
            let runtime = &outline.runtime;
            quote!(#runtime::if_alloc! { #items })
        }
    }
}

/// One function with its programs and sweeps.
fn function(
    outline: &Outline,
    function: &Function,
    compiled: &ir::Function,
    prepare: &Program,
) -> TokenStream {
    let mut items = results(outline, function);
    items.extend(evaluator::programs(outline, function));
    let versions = [
        (Some(&compiled.called), Version::Called),
        (compiled.beside.as_ref(), Version::Beside),
    ];
    for (body, version) in versions {
        items.extend(body.map(|body| stages::items(outline, function, body, version)));
    }
    items.extend(table::items(outline, function, &compiled.columns));
    let of_sets = compiled.beside.as_ref().unwrap_or(&compiled.called);
    items.extend(kernels::items(outline, function, &of_sets.stages, prepare));
    items
}

/// The functions of the types of a function, and its methods.
fn results(outline: &Outline, function: &Function) -> TokenStream {
    let mut items = TokenStream::new();
    items.extend(debug::shown(outline, function));
    items.extend(evaluator::result_row(outline, function));
    items.extend(columns::items(outline, function));
    let Outline {
        runtime, assembly, ..
    } = outline;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let method = evaluator::method(outline, function);
    let sweeps = sweeps::methods(outline, function);
    items.extend(quote! {
        #(#everywhere)*
        impl<T: #runtime::Scalar> #assembly<T> { #method #sweeps }
    });
    items
}
