//! Where generated code finds what a program loads. Every function that prints a program binds some of the same names:
//! `__m` the mechanism, `__modes`, `__turns` the centres and windings of the continuous angles, `__prepared`, `__carried` what comes
//! from the stage before, and `__x` the inputs.

use linkage_symbolic::program::Source;
use proc_macro2::TokenStream;
use quote::quote;

use super::literal;
use super::outline::Outline;

/// Prints loads; `__x` holds the inputs `inputs` in this order.
pub(super) fn loader<'a>(
    outline: &'a Outline,
    inputs: &'a [usize],
) -> impl Fn(Source) -> TokenStream + 'a {
    let runtime = &outline.runtime;
    let fields = outline.scalar_fields();
    move |source| match source {
        Source::Parameter(index) => {
            let field = &fields[index];
            quote!(__m.#field)
        }
        Source::Input(input) => {
            let position = inputs.iter().position(|i| *i == input);
            let position = literal::index(position.expect("a program uses only its inputs"));
            quote!(__x[#position])
        }
        Source::Mode(mode) => {
            let mode = literal::index(mode);
            quote!(T::from_f64(#runtime::AssemblyMode::sign(__modes[#mode])))
        }
        Source::Centre(angle) => {
            let angle = literal::index(angle);
            quote!(__turns.centres[#angle])
        }
        Source::Winding(angle, input) => {
            let (angle, input) = (literal::index(angle), literal::index(input));
            quote!(__turns.windings[#angle][#input])
        }
        Source::Prepared(slot) => {
            let slot = literal::index(slot);
            quote!(__prepared[#slot])
        }
        Source::Carried(index) => {
            let index = literal::index(index);
            quote!(__carried[#index])
        }
    }
}
