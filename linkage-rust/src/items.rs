//! All items of a mechanism, in their order.

use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;
use quote::quote;

use crate::code::joined;
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
    let mut code = vec![mechanism::items(&outline)];
    code.push(mechanism::constants(
        &outline,
        &structure::literal(&outline, unit),
    ));
    if let Some(picture) = &unit.picture {
        let programs = printed(&def.title(), unit);
        code.push(picture::items(&outline, picture, &programs));
    }
    code.push(dimensions::items(&outline));
    let mut assembled = vec![assembly::items(&outline)];
    assembled.push(compiled::items(&outline, unit));
    assembled.push(grouped::items(&outline, unit));
    assembled.push(coupled::items(&outline, unit));
    if !unit.groups.is_empty() {
        assembled.push(constructors::circuits(&outline));
        assembled.push(range_check::items(&outline));
    }
    assembled.push(follower::items(&outline, unit));
    for (function, compiled) in outline.functions.iter().zip(&unit.functions) {
        assembled.push(self::function(&outline, function, compiled, &unit.prepare));
    }
    code.push(with_prepared(&outline, joined(assembled)));
    let types = types(&outline, follower::types);
    joined([types, block::items(&outline, &joined(code))])
}

/// The types of a mechanism and of its functions; `follower` prints that of its follower.
pub(crate) fn types(outline: &Outline, follower: impl Fn(&Outline) -> TokenStream) -> TokenStream {
    let outline = &outline.for_types();
    let mut assembled = vec![assembly::structure(outline)];
    assembled.push(follower(outline));
    for function in &outline.functions {
        let result = evaluator::result(outline, function);
        let columns = columns::types(outline, function);
        assembled.push(result_module::with_imports(
            outline, function, &result, &columns,
        ));
    }
    let assembled = with_prepared(outline, joined(assembled));
    joined([mechanism::structure(outline), assembled])
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
    let mut items = vec![
        results(outline, function),
        evaluator::programs(outline, function),
    ];
    let versions = [
        (Some(&compiled.called), Version::Called),
        (compiled.beside.as_ref(), Version::Beside),
    ];
    for (body, version) in versions {
        items.extend(body.map(|body| stages::items(outline, function, body, version)));
    }
    items.push(table::items(outline, function, &compiled.columns));
    let of_sets = compiled.beside.as_ref().unwrap_or(&compiled.called);
    items.push(kernels::items(outline, function, &of_sets.stages, prepare));
    joined(items)
}

/// The functions of the types of a function, and its methods.
pub(crate) fn results(outline: &Outline, function: &Function) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let method = evaluator::method(outline, function);
    let sweeps = sweeps::methods(outline, function);
    let methods = quote! {
        #(#everywhere)*
        impl<T: #runtime::Scalar> #assembly<T> { #method #sweeps }
    };
    let shown = [
        result_module::import(outline, function),
        debug::shown(outline, function),
    ];
    let printed = [
        evaluator::result_row(outline, function),
        columns::items(outline, function),
        methods,
    ];
    joined(shown.into_iter().flatten().chain(printed))
}
