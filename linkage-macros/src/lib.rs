//! The procedural macro `linkage::mechanism!`. Everything it does is in `linkage-rust`, except
//! for the programs of drawn mechanisms as JavaScript, which `linkage-js` prints.

use proc_macro::TokenStream;

/// Called by the facade's `mechanism!` with the path of the facade in front: `[$crate] ...`.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    linkage_rust::compile(input.into(), linkage_js::description).into()
}
