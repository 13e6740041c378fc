//! Types and values of fields from their shapes.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;
use linkage_language::model::Shape;

impl Outline<'_> {
    /// The Rust type of a field over the scalar type `scalar`.
    pub(super) fn field_type(&self, shape: &Shape, scalar: &TokenStream) -> TokenStream {
        let runtime = &self.runtime;
        match shape {
            Shape::Scalar => scalar.clone(),
            Shape::Vector(2) => quote!(#runtime::Vector2<#scalar>),
            Shape::Vector(_) => quote!(#runtime::Vector3<#scalar>),
            Shape::Array(n, entry) => {
                let entry = self.field_type(entry, scalar);
                let n = literal::index(*n);
                quote!([#entry; #n])
            }
            Shape::Frame => quote!(#runtime::Frame<#scalar>),
            Shape::PlaneFrame => quote!(#runtime::PlaneFrame<#scalar>),
        }
    }

    /// The value of a field from its scalars in order.
    pub(super) fn field_value(
        &self,
        shape: &Shape,
        scalars: &mut dyn Iterator<Item = TokenStream>,
    ) -> TokenStream {
        let runtime = &self.runtime;
        match shape {
            Shape::Scalar => scalars.next().unwrap_or_default(),
            Shape::Vector(n) => {
                let components: Vec<_> = scalars.take(*n).collect();
                match n {
                    2 => quote!(#runtime::Vector2::new(#(#components),*)),
                    _ => quote!(#runtime::Vector3::new(#(#components),*)),
                }
            }
            Shape::Array(n, entry) => {
                let entries: Vec<_> = (0..*n).map(|_| self.field_value(entry, scalars)).collect();
                quote!([#(#entries),*])
            }
            Shape::Frame => {
                let [origin, x, y, z] =
                    [(); 4].map(|()| self.field_value(&Shape::Vector(3), scalars));
                quote!(#runtime::Frame { origin: #origin, x: #x, y: #y, z: #z })
            }
            Shape::PlaneFrame => {
                let [origin, x, y] = [(); 3].map(|()| self.field_value(&Shape::Vector(2), scalars));
                quote!(#runtime::PlaneFrame { origin: #origin, x: #x, y: #y })
            }
        }
    }
}

/// The scalars of a field's value in order: the way back from [`Outline::field_value`].
pub(super) fn field_scalars(shape: &Shape, value: &TokenStream) -> Vec<TokenStream> {
    let vector = |value: &TokenStream, size: usize| -> Vec<TokenStream> {
        let components = [quote!(#value.x), quote!(#value.y), quote!(#value.z)];
        components.into_iter().take(size).collect()
    };
    match shape {
        Shape::Scalar => vec![value.clone()],
        Shape::Vector(size) => vector(value, *size),
        Shape::Array(count, entry) => (0..*count)
            .flat_map(|index| {
                let index = literal::index(index);
                field_scalars(entry, &quote!(#value[#index]))
            })
            .collect(),
        Shape::Frame => [quote!(origin), quote!(x), quote!(y), quote!(z)]
            .iter()
            .flat_map(|axis| vector(&quote!(#value.#axis), 3))
            .collect(),
        Shape::PlaneFrame => [quote!(origin), quote!(x), quote!(y)]
            .iter()
            .flat_map(|axis| vector(&quote!(#value.#axis), 2))
            .collect(),
    }
}
