//! The compiler behind `linkage::mechanism!`: tokens in, tokens out.
//!
//! The phases, each in a folder of its own: `syntax` parses, `model` resolves names and checks dimensions, `structure`
//! finds the Assur groups, `formulate` expresses every unknown and checks assembly and range, `lower` makes programs of
//! the requested quantities, `emit` prints them. `algebra` is what the middle phases share.

mod algebra;
pub mod diagnostic;
pub mod emit;
mod facts;
mod forces;
mod formulate;
pub mod lower;
pub mod model;
pub mod oracle;
pub mod picture;
mod structure;
pub mod syntax;
pub mod trace;
mod vector;

use linkage_symbolic::Graph;
use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

use algebra::{Algebra, Nominal};
use diagnostic::{Diagnostics, Origins};
use emit::facts::Facts;
use forces::Forces;
use lower::Lowered;
use model::Mechanism;

/// Compiles the macro's input: the path of the facade in brackets, then the mechanism. Mistakes become `compile_error!`s
/// beside a skeleton of the generated items.
pub fn compile(input: TokenStream) -> TokenStream {
    let (krate, body) = split_crate_path(input);
    let mut diagnostics = Diagnostics::default();
    let Some(definition) = syntax::parse(body, &mut diagnostics) else {
        return diagnostics.to_tokens();
    };
    let mut origins = Origins::default();
    let mechanism = model::resolve(&definition, &mut origins, &mut diagnostics);
    let analysed = mechanism
        .as_ref()
        .filter(|_| diagnostics.is_empty())
        .map(|mechanism| analyse(mechanism, &origins, &mut diagnostics));
    match (&mechanism, &analysed) {
        (Some(mechanism), Some(analysis)) if diagnostics.is_empty() => emit::emit(
            &krate,
            &definition,
            mechanism,
            &analysis.facts,
            &analysis.lowered,
        ),
        _ => {
            let errors = diagnostics.to_tokens();
            let skeleton = emit::skeleton(&krate, &definition, mechanism.as_ref());
            quote!(#errors #skeleton)
        }
    }
}

/// What the middle phases find out about a mechanism.
#[derive(Clone, Debug, Default)]
pub struct Analysis {
    /// Numbers and words for emission.
    pub facts: Facts,
    /// All programs.
    pub lowered: Lowered,
}

/// Structure, formulation, checks and lowering of a resolved mechanism.
pub fn analyse(
    mechanism: &Mechanism,
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) -> Analysis {
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let nominal = Nominal::of(&mut algebra);
    let before = diagnostics.len();
    formulate::check_directions(mechanism, &nominal, origins, diagnostics);
    if diagnostics.len() > before {
        // What is computed with them would be reported as not finite.
        return Analysis::default();
    }
    nominal.check(mechanism, origins, diagnostics);
    let structure = structure::decompose(&mut algebra, &nominal, origins, diagnostics);
    if diagnostics.len() > before {
        return Analysis::default();
    }
    let formulation = formulate::formulate(&mut algebra, structure);
    let mut reference =
        formulate::assemble_reference(&mut algebra, &formulation, &nominal, origins, diagnostics);
    let mut forces = Forces::new(&mut algebra);
    if reference.closed {
        let numbers = (&reference, &nominal);
        forces::check(&mut algebra, &mut forces, numbers, origins, diagnostics);
    }
    let whole = (&mut algebra, &mut forces, &formulation);
    let lowered = lower::lower(whole, (&reference, &nominal), origins, diagnostics);
    if reference.closed {
        let asked = &lowered.continuous_angles;
        let checked = (&mut algebra, &formulation, &nominal);
        formulate::check_ranges(checked, &mut reference, asked, origins, diagnostics);
    }
    let facts = facts::collect(&algebra, &formulation, &nominal, &reference);
    Analysis { facts, lowered }
}

/// The bracketed path that the facade's wrapper puts in front, and the rest.
fn split_crate_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = input.into_iter();
    match tokens.next() {
        Some(TokenTree::Group(path)) => (Group::stream(&path), tokens.collect()),
        first => (quote!(::linkage), first.into_iter().chain(tokens).collect()),
    }
}
