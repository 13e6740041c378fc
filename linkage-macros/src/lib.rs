//! The procedural macro `linkage::mechanism!`. Everything it does is in `linkage-rust`, except
//! for the programs of drawn mechanisms as JavaScript, which `linkage-js` prints with feature
//! `report`.

use proc_macro::TokenStream;

/// Called by the facade's `mechanism!` with the path of the facade in front: `[$crate] ...`.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    #[cfg(feature = "report")]
    let programs = linkage_js::description;
    // Without the feature what is printed for reports is discarded.
    #[cfg(not(feature = "report"))]
    let programs = |_: &str, _: &_| String::new();
    linkage_rust::compile(input.into(), programs).into()
}

/// Called by the facade's `mechanism!` for rust-analyzer alone, with the same input: the names that
/// the user wrote, for hovers, definitions, renaming and completions.
#[proc_macro]
pub fn names(input: TokenStream) -> TokenStream {
    linkage_rust::names(input.into()).into()
}
