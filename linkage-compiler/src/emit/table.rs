//! Names and units of the columns that sweeps fill: the trait `Table`.

use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Function, Outline, plain};
use super::{attribute, literal, result_module};
use crate::ir::{Column, Meaning};

/// The trait for the columns of a function; nothing for a function without arguments.
pub(super) fn items(outline: &Outline, function: &Function, columns: &[Column]) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let runtime = &outline.runtime;
    let ty = result_module::columns(outline, function);
    let name = plain(function.name);
    let arguments = function.arguments.iter().map(|argument| plain(argument));
    let first = columns
        .iter()
        .position(|column| column.meaning == Meaning::Picture);
    let picture = first.map(|first| {
        let (first, mechanism) = (literal::index(first), outline.name);
        quote! {
            #runtime::PictureColumns { first: #first, picture: <#mechanism<::core::primitive::f64>>::PICTURE }
        }
    });
    let picture = optional(picture);
    let columns = columns
        .iter()
        .map(|description| column(outline, description));
    let heading = outline.body(quote! {
        const __HEADING: &#runtime::Heading = &#runtime::Heading {
            function: #name,
            arguments: &[#(#arguments),*],
            columns: &[#(#columns),*],
            picture: #picture,
        };
        __HEADING
    });
    let rows = outline.body(quote!(Self::__of(self).len()));
    let values = outline.body(quote!(Self::__of(self).column(index)));
    let everywhere = &attribute::split(function.attributes).everywhere;
    let allow = attribute::allow();
    quote! {
        #runtime::if_report! {
            #(#everywhere)*
            #allow
            #[automatically_derived]
            impl #runtime::Table for #ty<::core::primitive::f64> {
                fn heading(&self) -> &'static #runtime::Heading { #heading }
                fn rows(&self) -> ::core::primitive::usize { #rows }
                fn column(&self, index: ::core::primitive::usize) -> &[::core::primitive::f64] { #values }
            }
        }
    }
}

fn column(outline: &Outline, column: &Column) -> TokenStream {
    let runtime = &outline.runtime;
    let Column {
        name,
        unit,
        meaning,
    } = column;
    let optional_index =
        |of: Option<usize>| optional(of.map(literal::index).map(|index| quote!(#index)));
    let meaning = match *meaning {
        Meaning::Value => quote!(Value),
        Meaning::Margin => quote!(Margin),
        Meaning::Picture => quote!(Picture),
        Meaning::Rate { order, of } => {
            let of = optional_index(of);
            quote!(Rate { order: #order, of: #of })
        }
        Meaning::Sensitivity { parameter, of } => {
            let (parameter, of) = (literal::index(parameter), optional_index(of));
            quote!(Sensitivity { parameter: #parameter, of: #of })
        }
    };
    quote!(#runtime::Column { name: #name, unit: #unit, meaning: #runtime::Meaning::#meaning })
}

fn optional(value: Option<TokenStream>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}
