//! One function of the `impl` block: its result type, the method, and the program that it runs.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::array_fields::entries;
use super::array_types::Types;
use super::docs::{behind_name, doc, documented, sentence, tokens, with_note};
use super::load::Places;
use super::mechanism::{marker_field, marker_value};
use super::outline::{Field, Function, Outline, plain};
use super::shape::field_scalars;
use super::spanned::{aside, type_at};
use super::stages::Version;
use super::{attribute, code, debug, result_module, stages};

/// The result type.
pub(super) fn result(outline: &Outline, function: &Function) -> TokenStream {
    let result = function.result;
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
    let user_derives = split.result.iter().map(|a| &a.tokens);
    let ours: &[&str] = match debug::is_shown(function) {
        true => &["Debug"],
        false => &[],
    };
    let derives = attribute::derives(split.result.iter().copied(), ours);
    let head = doc(&format!(
        "What `{}::{}` returns.",
        outline.assembly,
        plain(function.name)
    ));
    let fields = function
        .fields
        .iter()
        .map(|field| field_item(outline, field));
    let marker = function.fields.is_empty().then(marker_field);
    let allow = result_module::allow(outline, function);
    let visibility = result_module::visibility(outline, function);
    let item = type_at(result, result, &visibility, quote!(#(#fields)* #marker));
    quote! {
        #(#everywhere)*
        #head
        #allow
        #derives
        #(#user_derives)*
        #item
    }
}

fn field_item(outline: &Outline, field: &Field) -> TokenStream {
    let name = field.name;
    let ty = outline.field_type(&field.shape, &quote!(T));
    let summary = format!("`{}`{}.", plain(name), behind_name(&field.about));
    let note = match field.about.as_str() {
        "" => String::new(),
        about => sentence(about),
    };
    let attributes = tokens(field.attributes);
    let head = with_note(&attributes, documented(field.attributes), &note, &summary);
    quote!(#head pub #name: #ty,)
}

/// The public method.
pub(super) fn method(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function {
        visibility,
        name,
        arguments,
        ..
    } = function;
    let split = attribute::split(function.attributes);
    let names: Vec<_> = function
        .fields
        .iter()
        .map(|f| format!("`{}`", plain(f.name)))
        .collect();
    let notes = &function.notes;
    let head = with_note(
        &split.method,
        documented(function.attributes),
        notes,
        &format!("Computes {} at one position.\n\n{notes}", names.join(", ")),
    );
    let must_use = (!attribute::has(function.attributes, "must_use")).then(|| quote!(#[must_use]));
    let inline = (!attribute::has(function.attributes, "inline")).then(|| quote!(#[inline]));
    let result = function.result;
    let call = outline.body(match function.chooses {
        true => quote!(#runtime::call(&self.__sealed, [#(#arguments),*])),
        false => quote!(#runtime::call_inlined(&self.__sealed, [#(#arguments),*])),
    });
    quote! {
        #head
        #must_use
        #inline
        #visibility fn #name(&self, #(#arguments: T),*) -> #result<T> { #call }
    }
}

/// The runtime's `Function`: the programs of calls and sweeps.
pub(super) fn programs(outline: &Outline, function: &Function) -> TokenStream {
    let everywhere = attribute::everywhere(function.attributes);
    let [core, result] = [code::text(&outline.core), code::text(function.result)];
    let starts = Types::new(outline).starts;
    let arguments: Vec<_> = function.arguments.iter().map(|name| plain(name)).collect();
    let title = plain(function.name);
    let [called, refining] = [Version::Called, Version::refining(function)]
        .map(|version| code::text(&stages::name(function, version)));
    let states = match function.states.is_empty() {
        true => "__p::NoStates",
        false => &called,
    };
    let inputs = arguments.len();
    let count = Places::of_function(outline, function).width();
    let width = function.width();
    code::tokens(&format!(
        "{everywhere} #[doc(hidden)]
        impl<T: __p::Scalar> __p::Function<T, {core}<T>, {starts}, {inputs}, {count}, {width}> for {result}<T> {{
            type Called = {called};
            type Refining = {refining};
            type States = {states};
            const NAMES: &'static __p::FunctionNames<{inputs}> = &__p::function_names({title:?}, {arguments:?});
        }}"
    ))
}

/// The runtime's `ResultRow` of the result type.
pub(super) fn result_row(outline: &Outline, function: &Function) -> TokenStream {
    let result = code::text(function.result);
    let everywhere = attribute::everywhere(function.attributes);
    let width = function.width();
    let row = entries("__row", width);
    let fields = code::text(&row_fields(outline, function, &row));
    let from_row = format!("Self {{ {fields} }}");
    let scalars = function.fields.iter().flat_map(|field| {
        let name = aside(field.name);
        field_scalars(&field.shape, &quote!(self.#name))
    });
    let scalars: Vec<String> = scalars.map(|scalar| code::text(&scalar)).collect();
    let to_row = format!("[{}]", scalars.join(","));
    let [from_row, to_row] = [&from_row, &to_row].map(|body| outline.body_text(body));
    let row: Vec<String> = row.iter().map(code::text).collect();
    let row = row.join(",");
    code::tokens(&format!(
        "{everywhere} impl<T: __p::Scalar> __p::ResultRow<T, {width}> for {result}<T> {{
            #[inline(always)]
            fn from_row([{row}]: [T; {width}]) -> Self {{ {from_row} }}

            #[inline(always)]
            fn to_row(&self) -> [T; {width}] {{ {to_row} }}
        }}"
    ))
}

/// `tracer: Vector2::new(__row0, __row1), ...`
fn row_fields(outline: &Outline, function: &Function, row: &[Ident]) -> TokenStream {
    let mut scalars = row.iter().map(ToTokens::to_token_stream);
    let fields: Vec<_> = function
        .fields
        .iter()
        .map(|field| {
            let name = aside(field.name);
            let value = outline.field_value(&field.shape, &mut scalars);
            quote!(#name: #value,)
        })
        .collect();
    let marker = function.fields.is_empty().then(marker_value);
    quote!(#(#fields)* #marker)
}
