//! Names and units of the columns that sweeps fill: the runtime's `Headed`, by which they are a
//! `Table`.

use proc_macro2::TokenStream;
use quote::quote;

use super::outline::{Function, Outline, plain};
use super::{attribute, literal};
use linkage_compiler::ir::{Column, Meaning};

/// The trait for the columns of a function; nothing for a function without arguments.
pub(super) fn items(outline: &Outline, function: &Function, columns: &[Column]) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let runtime = &outline.runtime;
    let ty = &function.columns;
    let name = plain(function.name);
    let arguments = function.arguments.iter().map(|argument| plain(argument));
    let first = columns
        .iter()
        .position(|column| column.meaning == Meaning::Picture);
    let picture = first.map(|first| {
        let (first, mechanism) = (literal::index(first), outline.name);
        quote! {
            #runtime::PictureColumns { first: #first, picture: <#mechanism<__p::f64>>::PICTURE }
        }
    });
    let picture = optional(picture);
    let columns = columns
        .iter()
        .map(|description| column(outline, description));
    let everywhere = &attribute::split(function.attributes).everywhere;
    quote! {
        #runtime::if_report! {
            #(#everywhere)*
            #[automatically_derived]
            #[doc(hidden)]
            impl #runtime::Headed for #ty<__p::f64> {
                const HEADING: &'static #runtime::Heading = &#runtime::Heading {
                    function: #name,
                    arguments: &[#(#arguments),*],
                    columns: &[#(#columns),*],
                    picture: #picture,
                };
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
    let (plain, quantity) = match *meaning {
        Meaning::Value => (quote!(#runtime::value(#name, #unit)), None),
        Meaning::Margin => (quote!(#runtime::margin(#name, #unit)), None),
        Meaning::Picture => (quote!(#runtime::drawn(#name, #unit)), None),
        Meaning::Rate { order, of } => (quote!(#runtime::rate(#name, #unit, #order)), of),
        Meaning::Sensitivity { parameter, of } => {
            let parameter = literal::index(parameter);
            (quote!(#runtime::sensitivity(#name, #unit, #parameter)), of)
        }
    };
    match quantity.map(literal::index) {
        Some(index) => quote!(#runtime::derivative_of(#index, #plain)),
        None => plain,
    }
}

fn optional(value: Option<TokenStream>) -> TokenStream {
    match value {
        Some(value) => quote!(__p::Some(#value)),
        None => quote!(__p::None),
    }
}
