//! Numbers as tokens.

use std::str::FromStr;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// An `f64` expression of exactly this value: shortest digits that read back the same, an exponent
/// where that is shorter, parentheses around a negative number so that nothing binds to its sign.
pub(super) fn float(x: f64) -> TokenStream {
    if x.is_nan() {
        return quote!(__p::f64::NAN);
    }
    if x.is_infinite() {
        return if x > 0.0 {
            quote!(__p::f64::INFINITY)
        } else {
            quote!(__p::f64::NEG_INFINITY)
        };
    }
    let text = format!("{:?}f64", x.abs());
    let literal = Literal::from_str(&text).unwrap_or_else(|_| Literal::f64_suffixed(x.abs()));
    if x.is_sign_negative() {
        quote!((-#literal))
    } else {
        quote!(#literal)
    }
}

/// A constant index or length.
pub(super) fn index(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}
