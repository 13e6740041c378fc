//! Entries of arrays by name: a pattern that takes an array apart is checked by rustc at once, an
//! index each time.

use proc_macro2::{Ident, Span};
use quote::format_ident;

/// The name of an entry.
pub(super) fn entry(array: &str, index: usize) -> Ident {
    format_ident!("{array}{index}", span = Span::mixed_site())
}

/// A name for each entry.
pub(super) fn entries(array: &str, len: usize) -> Vec<Ident> {
    (0..len).map(|index| entry(array, index)).collect()
}
