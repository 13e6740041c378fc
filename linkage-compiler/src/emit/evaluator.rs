//! One function of the `impl` block: its result type, the method, and the program behind it.

use linkage_symbolic::passes::stages::Stage;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::docs::{doc, documented, in_unit, tokens, with_note};
use super::load::loader;
use super::mechanism::{marker_field, marker_value};
use super::outline::{Field, Function, Outline, plain};
use super::{attribute, body, literal, starts};

/// The result type and the public method.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    let mut items = result(outline, function);
    items.extend(method(outline, function));
    items
}

fn result(outline: &Outline, function: &Function) -> TokenStream {
    let Function {
        visibility, result, ..
    } = function;
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
    let user_derives = split.result.iter().map(|a| &a.tokens);
    let derives = attribute::derives(split.result.iter().copied());
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
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #head
        #allow
        #derives
        #(#user_derives)*
        #visibility struct #result<T = ::core::primitive::f64> { #(#fields)* #marker }
    }
}

fn field_item(outline: &Outline, field: &Field) -> TokenStream {
    let name = field.name;
    let ty = outline.field_type(&field.shape, &quote!(T));
    let unit = in_unit(&field.unit);
    let summary = format!("`{}`{unit}.", plain(name));
    let note = match unit.strip_prefix(", in ") {
        Some(unit) if documented(field.attributes) => format!("In {unit}."),
        _ => String::new(),
    };
    let attributes = tokens(field.attributes);
    let head = with_note(&attributes, documented(field.attributes), &note, &summary);
    quote!(#head pub #name: #ty,)
}

fn method(outline: &Outline, function: &Function) -> TokenStream {
    let Outline {
        runtime, assembly, ..
    } = outline;
    let Function {
        visibility,
        name,
        result,
        arguments,
        ..
    } = function;
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
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
    let body = outline.body(call(outline, function));
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #assembly<T> {
            #head
            #must_use
            #inline
            #visibility fn #name(&self, #(#arguments: T),*) -> #result<T> { #body }
        }
    }
}

/// What the method returns: the program's results at its arguments.
fn call(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function {
        result, arguments, ..
    } = function;
    let arguments = match function.states.is_empty() {
        true => quote!([#(#arguments),*]),
        false => starts::with_states(outline, function),
    };
    let kernel = kernel_name(function, Version::Called);
    let called = quote!(self.__core.#kernel::<{ #runtime::FUSED }>(__x));
    let row = match function.beside {
        true => {
            let kernel = kernel_name(function, Version::Beside);
            quote! {
                if T::REFINES {
                    self.__core.#kernel::<{ #runtime::FUSED }>(__x)
                } else {
                    #called
                }
            }
        }
        false => called,
    };
    quote! {
        let __x = #arguments;
        #result::__from_row(#row)
    }
}

/// Which of the programs of a function.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    /// The one of calls.
    Called,
    /// The one for dimensions, derivatives or digits that tables do not know.
    Beside,
}

/// The method that runs a program.
fn kernel_name(function: &Function, version: Version) -> Ident {
    let kernel = &function.kernel;
    match version {
        Version::Called => kernel.clone(),
        Version::Beside => format_ident!("{kernel}_beside"),
    }
}

/// The methods that run the program, stage by stage and as a whole.
pub(super) fn kernel(
    outline: &Outline,
    function: &Function,
    stages: &[Stage],
    version: Version,
) -> TokenStream {
    let Outline { runtime, core, .. } = outline;
    let kernel = kernel_name(function, version);
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
    let places = function.places(outline);
    let count = literal::index(places.width());
    let width = literal::index(function.width());
    let methods = (0..stages.len()).map(|index| stage(outline, function, stages, index, version));
    let calls = (0..stages.len()).map(|index| {
        let method = stage_name(function, index, version);
        let results = results(index);
        let before = match index {
            0 => quote!([]),
            _ => quote!(__carried),
        };
        quote!(let (__carried, #results) = self.#method::<__FUSED>(__x, #before);)
    });
    let mut outputs = vec![TokenStream::new(); function.width()];
    for (index, stage) in stages.iter().enumerate() {
        let results = results(index);
        for (place, &result) in stage.results.iter().enumerate() {
            let place = literal::index(place);
            outputs[result] = quote!(#results[#place]);
        }
    }
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #core<T> {
            #[inline(always)]
            fn #kernel<const __FUSED: ::core::primitive::bool>(&self, __x: [T; #count]) -> [T; #width] {
                #(#calls)*
                [#(#outputs),*]
            }
            #(#methods)*
        }
    }
}

/// The way from a program's outputs to the result type.
pub(super) fn from_row(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let result = function.result;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let width = literal::index(function.width());
    let fields = row_fields(outline, function);
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #result<T> {
            #[inline(always)]
            fn __from_row(__row: [T; #width]) -> Self { Self { #fields } }
        }
    }
}

/// The method that runs a stage.
pub(super) fn stage_name(function: &Function, index: usize, version: Version) -> Ident {
    let name = function.name;
    match version {
        Version::Called => format_ident!("__stage{index}_of_{name}"),
        Version::Beside => format_ident!("__stage{index}_beside_of_{name}"),
    }
}

/// The variable that holds what a stage has finished.
fn results(stage: usize) -> Ident {
    format_ident!("__results{stage}", span = Span::mixed_site())
}

/// From what the stage before carries to what it carries on itself, and results.
fn stage(
    outline: &Outline,
    function: &Function,
    stages: &[Stage],
    index: usize,
    version: Version,
) -> TokenStream {
    let Stage {
        program,
        carried,
        results,
    } = &stages[index];
    let before = index
        .checked_sub(1)
        .map_or(0, |index| stages[index].carried);
    let method = stage_name(function, index, version);
    let places = function.places(outline);
    let statements = body::statements(program, &loader(outline, &places));
    let (next, finished) = program.outputs.split_at(*carried);
    let [next, finished] = [next, finished].map(|values| {
        let names = values.iter().map(|value| body::name(*value));
        quote!([#(#names),*])
    });
    let [count, before, carried, results] =
        [places.width(), before, *carried, results.len()].map(literal::index);
    quote! {
        #[inline(always)]
        fn #method<const __FUSED: ::core::primitive::bool>(
            &self,
            __x: [T; #count],
            __carried: [T; #before],
        ) -> ([T; #carried], [T; #results]) {
            let Self { __mechanism: __m, __modes, __prepared, .. } = self;
            #statements
            (#next, #finished)
        }
    }
}

/// `tracer: Vector2::new(__row[0], __row[1]), ...`
fn row_fields(outline: &Outline, function: &Function) -> TokenStream {
    let mut scalars = (0..function.width()).map(|index| {
        let index = literal::index(index);
        quote!(__row[#index])
    });
    let fields: Vec<_> = function
        .fields
        .iter()
        .map(|field| {
            let name = field.name;
            let value = outline.field_value(&field.shape, &mut scalars);
            quote!(#name: #value,)
        })
        .collect();
    let marker = function.fields.is_empty().then(marker_value);
    quote!(#(#fields)* #marker)
}
