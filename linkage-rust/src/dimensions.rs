//! The mechanism as a list of numbers.

use proc_macro2::TokenStream;

use super::code;
use super::outline::Outline;

/// The trait `Dimensions`.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let name = code::text(outline.name);
    let fields = outline.scalar_fields();
    let count = fields.len();
    let fields = fields.iter().map(code::text);
    let fields: String = fields
        .map(|field| format!("__mechanism.{field},"))
        .collect();
    let fields = format!("[{fields}]");
    let from_values = outline.body_text("__of(|__k| __values[__k])");
    let [values, of_trait] = [&fields, "__values(self)"].map(|body| outline.body_text(body));
    code::tokens(&format!(
        "#[automatically_derived]
        impl __p::Dimensions<{count}> for {name}<__p::f64> {{
            const PARAMETERS: &'static [__p::Parameter] = Self::PARAMETERS;

            #[inline]
            fn from_values(__values: &[__p::f64; {count}]) -> Self {{ {from_values} }}

            #[inline]
            fn values(&self) -> [__p::f64; {count}] {{ {of_trait} }}
        }}
        /// The scalar dimensions in the order of `PARAMETERS`.
        #[inline(always)]
        fn __values<T: __p::Scalar>(__mechanism: &{name}<T>) -> [T; {count}] {{ {values} }}"
    ))
}
