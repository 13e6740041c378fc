//! One function of the `impl` block: its result type, the method, and the program that it runs.

use linkage_symbolic::passes::stages::Stage;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::array_fields::{entries, entry};
use super::body::Runs;
use super::docs::{behind_name, doc, documented, sentence, tokens, with_note};
use super::load::{CARRIED, INPUT, Places, loader_by};
use super::mechanism::{marker_field, marker_value};
use super::outline::{Field, Function, Outline, plain};
use super::spanned::type_at;
use super::{assembly_data, attribute, body, coupled, debug, literal, result_module};
use crate::ir::Body;

/// The result type.
pub(super) fn result(outline: &Outline, function: &Function) -> TokenStream {
    let result = function.result;
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
    let user_derives = split.result.iter().map(|a| &a.tokens);
    let shown = debug::shown(outline, function);
    let ours: &[&str] = if shown.is_some() { &["Debug"] } else { &[] };
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
    let allow = attribute::allow();
    let visibility = result_module::visibility(outline, function);
    let item = type_at(result, result, &visibility, quote!(#(#fields)* #marker));
    quote! {
        #(#everywhere)*
        #head
        #allow
        #derives
        #(#user_derives)*
        #item
        #shown
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
    let Outline {
        runtime, assembly, ..
    } = outline;
    let Function {
        visibility,
        name,
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
    let result = result_module::result(outline, function);
    let inputs = match function.states.is_empty() {
        true => quote!([#(#arguments),*]),
        false => coupled::with_states(outline, function),
    };
    let core = assembly_data::core(outline, &quote!(self));
    let body = outline.body(value(outline, function, &inputs, &core, Version::Called));
    let count = literal::index(arguments.len());
    let call = outline.body(match function.chooses {
        true => quote!(#runtime::single(self, [#(#arguments),*])),
        false => quote!(#runtime::inlined(self, [#(#arguments),*])),
    });
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #assembly<T> {
            #head
            #must_use
            #inline
            #visibility fn #name(&self, #(#arguments: T),*) -> #result<T> { #call }
        }

        #(#everywhere)*
        #allow
        #[doc(hidden)]
        impl<T: #runtime::Scalar> #runtime::Single<T, #result<T>, #count> for #assembly<T> {
            #[inline(always)]
            fn at<const __FUSED: ::core::primitive::bool>(
                &self,
                [#(#arguments),*]: [T; #count],
            ) -> #result<T> { #body }
        }
    }
}

/// The value that the method returns: the results of a program of `core` at these arguments, which
/// are inputs and then states. Scalars that refine the prepared values run another program than
/// scalars whose digits the prepared values have.
pub(super) fn value(
    outline: &Outline,
    function: &Function,
    arguments: &TokenStream,
    core: &TokenStream,
    plain: Version,
) -> TokenStream {
    let result = result_module::result(outline, function);
    let refining = match function.beside {
        true => Version::Beside,
        false => Version::Called,
    };
    let [refined, row] = [refining, plain].map(|version| {
        let kernel = kernel_name(function, version);
        quote!(#core.#kernel::<__FUSED>(__x))
    });
    let row = match refining == plain {
        true => row,
        false => quote!(if T::REFINES { #refined } else { #row }),
    };
    quote! {
        let __x = #arguments;
        #result::__from_row(#row)
    }
}

/// The programs that a function can have.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    /// The one of calls.
    Called,
    /// The one for dimensions, derivatives or digits that tables do not know.
    Beside,
    /// The one at the position of a follower, whose states are solutions.
    Settled,
}

impl Version {
    /// The part that the version has in names of items.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Called => "",
            Self::Beside => "_beside",
            Self::Settled => "_settled",
        }
    }
}

/// The method that runs a program.
fn kernel_name(function: &Function, version: Version) -> Ident {
    let kernel = &function.kernel;
    let word = version.word();
    format_ident!("{kernel}{word}")
}

/// The methods that run the program, stage by stage and as a whole.
pub(super) fn kernel(
    outline: &Outline,
    function: &Function,
    body: &Body,
    version: Version,
) -> TokenStream {
    let Outline { runtime, core, .. } = outline;
    let stages = &body.stages;
    let runs = match body.compares_sines {
        true => Runs::InRows,
        false => Runs::InRowsOrAlone,
    };
    let kernel = kernel_name(function, version);
    let split = attribute::split(function.attributes);
    let everywhere = &split.everywhere;
    let places = Places::of_function(outline, function);
    let count = literal::index(places.width());
    let width = literal::index(function.width());
    let methods = (0..stages.len())
        .map(|index| stage(outline, function, (&stages[index], runs), index, version));
    let calls = (0..stages.len()).map(|index| {
        let method = stage_name(function, index, version);
        let stage = &stages[index];
        let results = results(index, stage);
        let [taken, kept] = [&stage.taken, &stage.kept].map(|places| in_memory(places));
        let read = places.read(&stage.program).into_iter().map(literal::index);
        quote! {
            let ([#(#kept),*], [#(#results),*]) =
                self.#method::<__FUSED, false>([#(__x[#read]),*], [#(#taken),*]);
        }
    });
    let mut outputs = vec![TokenStream::new(); function.width()];
    for (index, stage) in stages.iter().enumerate() {
        for (name, &result) in results(index, stage).into_iter().zip(&stage.results) {
            outputs[result] = name.into_token_stream();
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
    let row = entries("__row", function.width());
    let fields = row_fields(outline, function, &row);
    let private = result_module::private(outline, function);
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #result<T> {
            #[inline(always)]
            #private fn __from_row([#(#row),*]: [T; #width]) -> Self { Self { #fields } }
        }
    }
}

/// The method that runs a stage.
pub(super) fn stage_name(function: &Function, index: usize, version: Version) -> Ident {
    let name = function.name;
    let word = version.word();
    format_ident!("__stage{index}{word}_of_{name}")
}

/// The variables that hold the values that a stage has finished.
fn results(index: usize, stage: &Stage) -> Vec<Ident> {
    entries(&format!("__results{index}_"), stage.results.len())
}

/// The variables for places of the stages' memory.
fn in_memory(places: &[usize]) -> Vec<Ident> {
    places
        .iter()
        .map(|&index| entry("__memory", index))
        .collect()
}

/// A function from the inputs and states that the stage reads, and the values that it takes from
/// earlier stages, to the values that it keeps for later stages, and results.
fn stage(
    outline: &Outline,
    function: &Function,
    (stage, runs): (&Stage, Runs),
    index: usize,
    version: Version,
) -> TokenStream {
    let Stage {
        program,
        taken,
        kept,
        results,
    } = stage;
    let method = stage_name(function, index, version);
    let places = Places::of_function(outline, function);
    let input = |index| entry(INPUT, index).into_token_stream();
    let load = loader_by(outline, &places, input);
    let statements = body::statements(program, runs, &load);
    let read = places.read(program);
    let inputs: Vec<_> = read.iter().map(|&index| entry(INPUT, index)).collect();
    let (next, finished) = program.outputs.split_at(kept.len());
    let [next, finished] = [next, finished].map(|values| {
        let names = values.iter().map(|value| body::name(*value));
        quote!([#(#names),*])
    });
    let entries = entries(CARRIED, taken.len());
    let [count, taken, kept, results] =
        [read.len(), taken.len(), kept.len(), results.len()].map(literal::index);
    quote! {
        #[inline(always)]
        fn #method<const __FUSED: ::core::primitive::bool, const __ROWS: ::core::primitive::bool>(
            &self,
            [#(#inputs),*]: [T; #count],
            [#(#entries),*]: [T; #taken],
        ) -> ([T; #kept], [T; #results]) {
            let Self { __mechanism: __m, __modes, __prepared, .. } = self;
            #statements
            (#next, #finished)
        }
    }
}

/// `tracer: Vector2::new(__row0, __row1), ...`
fn row_fields(outline: &Outline, function: &Function, row: &[Ident]) -> TokenStream {
    let mut scalars = row.iter().map(ToTokens::to_token_stream);
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
