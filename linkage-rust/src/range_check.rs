//! The check of the declared range of an assembly.

use proc_macro2::TokenStream;

use super::code;
use super::outline::{Outline, plain};

/// `check_range()`; nothing if a function of the user has this name.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let mut functions = outline.functions.iter();
    if functions.any(|function| plain(function.name) == "check_range") {
        return TokenStream::new();
    }
    let [name, assembly] = [outline.name, &outline.assembly].map(code::text);
    let body = format!("__p::check_range_of::<{name}<__p::f64>>(self)");
    let body = outline.body_text(&body);
    code::tokens(&format!(
        "__p::if_alloc! {{
            impl {assembly}<__p::f64> {{
                /// Searches the declared range for change points, dead points and gaps, as the compiler does for the default
                /// dimensions. An angle without a range is searched for change points over a turn about its reference.
                #[must_use]
                #[inline]
                pub fn check_range(&self) -> __p::RangeReport {{ {body} }}
            }}
        }}"
    ))
}
