//! Numbers as tokens and as text.

use proc_macro2::{Literal, TokenStream};

use super::code;

/// An `f64` expression of exactly this value: shortest digits that read back the same, an exponent
/// where that is shorter, parentheses around a negative number so that nothing binds to its sign.
pub(super) fn float(x: f64) -> TokenStream {
    code::tokens(&float_text(x))
}

/// The text of [`float`].
pub(super) fn float_text(x: f64) -> String {
    if x.is_nan() {
        "__p::f64::NAN".to_owned()
    } else if x == f64::INFINITY {
        "__p::f64::INFINITY".to_owned()
    } else if x == f64::NEG_INFINITY {
        "__p::f64::NEG_INFINITY".to_owned()
    } else if x.is_sign_negative() {
        format!("({x:?}f64)")
    } else {
        format!("{x:?}f64")
    }
}

/// A constant index or length.
pub(super) fn index(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}
