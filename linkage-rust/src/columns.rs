//! The columns that the sweeps of a function fill.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs::{behind_name, doc};
use super::outline::{Field, Function, Outline, plain};
use super::spanned::tuple_type_at;
use super::{attribute, literal, result_module};
use linkage_language::model::Shape;

/// The type of the columns of a function; nothing for a function without inputs.
pub(super) fn types(outline: &Outline, function: &Function) -> TokenStream {
    match function.arguments.is_empty() {
        true => TokenStream::new(),
        false => structure(outline, function),
    }
}

fn structure(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function {
        result, columns, ..
    } = function;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let doc = doc(&format!(
        "Many `{}` values, one column for each number.",
        plain(result)
    ));
    let allow = result_module::allow(outline, function);
    let visibility = result_module::visibility(outline, function);
    let private = result_module::private(outline, function);
    let width = literal::index(function.width());
    let inner = quote!(#runtime::ResultColumns<T, #result<T>, #width>);
    let item = tuple_type_at(
        function.result,
        columns,
        &visibility,
        quote!(#private #inner),
    );
    quote! {
        #(#everywhere)*
        #doc
        #allow
        #[derive(::core::clone::Clone, ::core::cmp::PartialEq, ::core::fmt::Debug)]
        #item
    }
}

/// The functions of the columns; nothing for a function without inputs.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let runtime = &outline.runtime;
    let columns = &function.columns;
    let result = function.result;
    let width = literal::index(function.width());
    let everywhere = &attribute::split(function.attributes).everywhere;
    let fields = fields(outline, function);
    // A field of this name has the accessor.
    let is_taken = |field: &Field| plain(field.name) == "new";
    let constructor = (!function.fields.iter().any(is_taken)).then(|| {
        quote! {
            /// Empty columns; nothing is allocated before the first sweep.
            #[must_use]
            pub fn new() -> Self { ::core::default::Default::default() }
        }
    });
    quote! {
        #(#everywhere)*
        #runtime::columns! { #columns of [#result; #width] }
        #runtime::if_alloc! {
            #(#everywhere)*
            impl<T: #runtime::Scalar> #columns<T> {
                #constructor
                #fields
            }
        }
    }
}

/// One accessor for each field, in the field's shape with slices for numbers.
fn fields(outline: &Outline, function: &Function) -> TokenStream {
    let mut next = 0;
    let accessors = function.fields.iter().map(|field| {
        let name = field.name;
        let ty = slices_type(&field.shape);
        let body = outline.body(slices(&field.shape, &mut next));
        let doc = doc(&format!(
            "`{}` at all positions{}.{}",
            plain(name),
            behind_name(&field.about),
            match field.shape {
                Shape::Frame => " Entries are its origin and its axes x, y, z.",
                Shape::PlaneFrame => " Entries are its origin and its axes x, y.",
                _ => "",
            }
        ));
        quote! {
            #doc
            #[must_use]
            pub fn #name(&self) -> #ty { #body }
        }
    });
    accessors.collect()
}

fn slices_type(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(&[T]),
        Shape::Vector(n) => {
            let n = literal::index(*n);
            quote!([&[T]; #n])
        }
        Shape::Array(n, entry) => {
            let (n, entry) = (literal::index(*n), slices_type(entry));
            quote!([#entry; #n])
        }
        Shape::Frame => quote!([[&[T]; 3]; 4]),
        Shape::PlaneFrame => quote!([[&[T]; 2]; 3]),
    }
}

fn slices(shape: &Shape, next: &mut usize) -> TokenStream {
    let mut entries = |n: usize, entry: &Shape| {
        let entries: Vec<_> = (0..n).map(|_| slices(entry, next)).collect();
        quote!([#(#entries),*])
    };
    match shape {
        Shape::Vector(n) => entries(*n, &Shape::Scalar),
        Shape::Array(n, entry) => entries(*n, entry),
        Shape::Frame => entries(4, &Shape::Vector(3)),
        Shape::PlaneFrame => entries(3, &Shape::Vector(2)),
        Shape::Scalar => {
            let column = literal::index(*next);
            *next += 1;
            quote!(self.0.column(#column))
        }
    }
}
