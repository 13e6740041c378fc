//! The columns that the sweeps of a function fill.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs::{behind_name, doc};
use super::outline::{Function, Outline, plain};
use super::spanned::type_at;
use super::{attribute, literal, result_module};
use crate::model::Shape;

/// The columns of a function; nothing for a function without inputs.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let mut items = structure(outline, function);
    items.extend(access(outline, function));
    items
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
    let width = literal::index(function.width());
    let new = outline.body(quote!(Self { __columns: #runtime::Columns::new(#width, 0) }));
    let allow = attribute::allow();
    let comparison = comparison(outline, function);
    let constructor = free(function, "new").then(|| {
        quote! {
            #(#everywhere)*
            #allow
            impl<T: #runtime::Scalar> #columns<T> {
                /// Empty columns; nothing is allocated before the first sweep.
                #[must_use]
                pub fn new() -> Self { ::core::default::Default::default() }
            }
        }
    });
    let visibility = result_module::visibility(outline, function);
    let field = quote!(__columns: #runtime::Columns<T>);
    let item = type_at(function.result, columns, &visibility, field);
    quote! {
        #(#everywhere)*
        #doc
        #allow
        #[derive(::core::clone::Clone)]
        #item
        #comparison
        #(#everywhere)*
        #allow
        #[automatically_derived]
        impl<T: #runtime::Scalar> ::core::default::Default for #columns<T> {
            fn default() -> Self { #new }
        }
        #constructor
    }
}

/// `PartialEq` and `Debug`: a derive would bind `T`, not the columns.
fn comparison(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function { columns, .. } = function;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let allow = attribute::allow();
    let title = columns.to_string();
    quote! {
        #(#everywhere)*
        #allow
        #[automatically_derived]
        impl<T: #runtime::Scalar> ::core::cmp::PartialEq for #columns<T> {
            fn eq(&self, __other: &Self) -> ::core::primitive::bool {
                self.__columns == __other.__columns
            }
        }
        #(#everywhere)*
        #allow
        #[automatically_derived]
        impl<T: #runtime::Scalar> ::core::fmt::Debug for #columns<T> {
            fn fmt(&self, __f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                __f.debug_tuple(#title).field(&self.__columns).finish()
            }
        }
    }
}

/// True unless a field of the result has this name: then its accessor takes it.
fn free(function: &Function, name: &str) -> bool {
    function
        .fields
        .iter()
        .all(|field| plain(field.name) != name)
}

fn access(outline: &Outline, function: &Function) -> TokenStream {
    let runtime = &outline.runtime;
    let Function { columns, .. } = function;
    let everywhere = &attribute::split(function.attributes).everywhere;
    let rows = rows(outline, function);
    let fields = fields(outline, function);
    let private = result_module::private(outline, function);
    let allow = attribute::allow();
    quote! {
        #(#everywhere)*
        #allow
        impl<T: #runtime::Scalar> #columns<T> {
            #private fn __of(__columns: &Self) -> &#runtime::Columns<T> { &__columns.__columns }
            #private fn __of_mut(__columns: &mut Self) -> &mut #runtime::Columns<T> { &mut __columns.__columns }
            #rows
            #fields
        }
    }
}

/// `len`, `is_empty`, `get`, `iter`.
fn rows(outline: &Outline, function: &Function) -> TokenStream {
    let result = function.result;
    let row = outline.body(quote! {
        #result::__from_row(::core::array::from_fn(|__column| self.__columns.get(__row, __column)))
    });
    let method = |name: &str, tokens: TokenStream| free(function, name).then_some(tokens);
    let len = outline.body(quote!(self.__columns.len()));
    let len = method(
        "len",
        quote! {
            /// How many positions.
            #[must_use]
            pub fn len(&self) -> ::core::primitive::usize { #len }
        },
    );
    let is_empty = outline.body(quote!(self.__columns.len() == 0));
    let is_empty = method(
        "is_empty",
        quote! {
            /// True before the first sweep, and after one over no position.
            #[must_use]
            pub fn is_empty(&self) -> ::core::primitive::bool { #is_empty }
        },
    );
    let get = method(
        "get",
        quote! {
            /// All quantities at one position, counted from 0.
            ///
            /// # Panics
            ///
            /// Panics if there is no such position.
            #[must_use]
            pub fn get(&self, index: ::core::primitive::usize) -> #result<T> { self.__row(index) }
        },
    );
    let iter = method(
        "iter",
        quote! {
            /// All positions in order.
            pub fn iter(
                &self,
            ) -> impl ::core::iter::DoubleEndedIterator<Item = #result<T>> + ::core::iter::ExactSizeIterator + '_ {
                let __range = ::core::ops::Range { start: 0, end: self.__columns.len() };
                ::core::iter::Iterator::map(__range, move |__row| self.__row(__row))
            }
        },
    );
    quote! {
        fn __row(&self, __row: ::core::primitive::usize) -> #result<T> { #row }
        #len
        #is_empty
        #get
        #iter
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
            quote!(self.__columns.column(#column))
        }
    }
}
