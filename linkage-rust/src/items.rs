//! All items of a mechanism, in their order.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use crate::outline::{Function, Outline};
use crate::stages::Version;
use crate::{
    assembly, attribute, block, columns, compiled, constructors, coupled, debug, dimensions,
    evaluator, follower, grouped, kernels, mechanism, picture, range_check, result_module, stages,
    structure, sweeps, table,
};
use linkage_compiler::ir::{self, CompiledMechanism};
use linkage_language::syntax::MechanismDef;

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
    assembled.extend(compiled::items(&outline, unit));
    assembled.extend(grouped::items(&outline, unit));
    assembled.extend(coupled::items(&outline, unit));
    if !unit.groups.is_empty() {
        assembled.extend(constructors::circuits(&outline));
        assembled.extend(range_check::items(&outline));
    }
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
pub(crate) fn types(outline: &Outline, follower: impl Fn(&Outline) -> TokenStream) -> TokenStream {
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
pub(crate) fn results(outline: &Outline, function: &Function) -> TokenStream {
    let mut items = TokenStream::new();
    items.extend(result_module::import(outline, function));
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
