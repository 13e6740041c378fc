//! The compiler from tokens to tokens: one program, so that it is linked once.

mod arithmetic;
mod closed_chains;
mod directions;
mod forms;
mod forms_space;
mod golden;
mod growth;
mod guides;
mod intervals;
mod joints;
mod margins;
mod part_rates;
mod parts;
mod periodic_courses;
mod proposals;
mod robust;
mod scalar_loops;
mod speed;
mod spellings;
mod splines;

use proc_macro2::TokenStream;

/// What the macro makes of a mechanism, but for its programs in other languages.
fn compiled(tokens: TokenStream) -> TokenStream {
    linkage_rust::compile(tokens, |_, _| String::new())
}
