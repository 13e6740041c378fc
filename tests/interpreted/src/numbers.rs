//! Types of parameters and results, and their numbers one after the other.

use linkage_language::model::Shape;
use proc_macro2::TokenStream;
use quote::quote;

/// The Rust type of a value.
pub(crate) fn rust_type(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(f64),
        Shape::Vector(2) => quote!(::linkage::Vector2<f64>),
        Shape::Vector(_) => quote!(::linkage::Vector3<f64>),
        Shape::Array(count, entry) => {
            let entry = rust_type(entry);
            quote!([#entry; #count])
        }
        Shape::Frame => quote!(::linkage::Frame<f64>),
        Shape::PlaneFrame => quote!(::linkage::PlaneFrame<f64>),
    }
}

/// The value made of the numbers that `next()` returns.
pub(crate) fn from_numbers(shape: &Shape) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(next()),
        Shape::Vector(2) => quote!(::linkage::Vector2::new(next(), next())),
        Shape::Vector(_) => quote!(::linkage::Vector3::new(next(), next(), next())),
        Shape::Array(_, entry) => {
            let entry = from_numbers(entry);
            quote!(::std::array::from_fn(|_| #entry))
        }
        Shape::Frame => {
            let vector = from_numbers(&Shape::Vector(3));
            quote!(::linkage::Frame { origin: #vector, x: #vector, y: #vector, z: #vector })
        }
        Shape::PlaneFrame => {
            let vector = from_numbers(&Shape::Vector(2));
            quote!(::linkage::PlaneFrame { origin: #vector, x: #vector, y: #vector })
        }
    }
}

/// The numbers of a value that is a number or a vector.
pub(crate) fn to_numbers(shape: &Shape, value: &TokenStream) -> Vec<TokenStream> {
    match shape {
        Shape::Vector(count) => ["x", "y", "z"][..*count]
            .iter()
            .map(|component| {
                let component = quote::format_ident!("{component}");
                quote!(#value.#component)
            })
            .collect(),
        _ => vec![value.clone()],
    }
}
