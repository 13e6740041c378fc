//! The mechanism as a list of numbers.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;

/// The trait `Dimensions`.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let fields = outline.scalar_fields();
    let count = literal::index(fields.len());
    let from_values = outline.body(quote!(__of(|__k| __values[__k])));
    let values = outline.body(quote!([#(__mechanism.#fields),*]));
    let of_trait = outline.body(quote!(__values(self)));
    quote! {
        #[automatically_derived]
        impl #runtime::Dimensions<#count> for #name<__p::f64> {
            const PARAMETERS: &'static [#runtime::Parameter] = Self::PARAMETERS;

            #[inline]
            fn from_values(__values: &[__p::f64; #count]) -> Self { #from_values }

            #[inline]
            fn values(&self) -> [__p::f64; #count] { #of_trait }
        }
        /// The scalar dimensions in the order of `PARAMETERS`.
        #[inline(always)]
        fn __values<T: #runtime::Scalar>(__mechanism: &#name<T>) -> [T; #count] { #values }
    }
}
