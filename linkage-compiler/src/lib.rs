//! The compiler behind `linkage::mechanism!`: tokens in, tokens out.
//!
//! The phases, each in a folder of its own: `syntax` parses, `model` resolves names and checks dimensions, `structure`
//! finds the Assur groups, `formulate` expresses every unknown, `lower` makes programs of expressions, `close` runs them to check
//! assembly and range, `request` puts the programs of all functions into one `unit`, `emit` prints that. `algebra` is what the
//! middle phases share; `forces` and `picture` make expressions of what functions ask for.

mod algebra;
mod close;
pub mod diagnostic;
pub mod emit;
mod forces;
mod formulate;
mod lower;
pub mod model;
pub mod oracle;
mod picture;
mod request;
mod structure;
pub mod syntax;
pub mod trace;
pub mod unit;
mod vector;
mod watch;

use linkage_symbolic::Graph;
use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;

use algebra::{Algebra, Nominal};
use diagnostic::{Diagnostics, Origins, Reporter};
use forces::Forces;
use model::Mechanism;
use request::{AtReference, State};
use unit::Unit;
use watch::Watch;

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
    let unit = mechanism
        .as_ref()
        .filter(|_| diagnostics.is_empty())
        .map(|mechanism| analyse(mechanism, &origins, &mut diagnostics));
    match (&mechanism, &unit) {
        (Some(_), Some(unit)) if diagnostics.is_empty() => emit::emit(&krate, &definition, unit),
        _ => {
            let errors = diagnostics.to_tokens();
            let skeleton = emit::skeleton(&krate, &definition, mechanism.as_ref());
            quote!(#errors #skeleton)
        }
    }
}

/// The middle phases of a resolved mechanism: structure, formulation, checks and lowering.
pub fn analyse(mechanism: &Mechanism, origins: &Origins, diagnostics: &mut Diagnostics) -> Unit {
    analyse_watched(mechanism, origins, diagnostics, &mut ())
}

/// The order of the phases: it stands here alone.
fn analyse_watched(
    mechanism: &Mechanism,
    origins: &Origins,
    diagnostics: &mut Diagnostics,
    watch: &mut dyn Watch,
) -> Unit {
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let nominal = Nominal::of(&mut algebra);
    let mut reporter = Reporter {
        origins,
        diagnostics,
    };
    let before = reporter.errors();
    close::check_directions(mechanism, &nominal, &mut reporter);
    if reporter.errors() > before {
        // What is computed with them would be reported as not finite.
        return Unit::default();
    }
    nominal.check(mechanism, &mut reporter);
    let structure = structure::decompose(&mut algebra, &nominal, reporter.reborrow());
    watch.structure(&algebra, &structure);
    if reporter.errors() > before {
        return Unit::default();
    }
    let formulation = formulate::formulate(&mut algebra, structure);
    watch.formulated(&mut algebra, &formulation, &nominal);
    let closing = lower::closing(&mut algebra, &formulation, &nominal);
    let mut reference = close::assemble_reference(
        &algebra,
        &formulation,
        closing,
        &nominal,
        reporter.reborrow(),
    );
    let mut forces = Forces::new(&mut algebra);
    if reference.closed {
        forces::check(
            &mut algebra,
            &mut forces,
            &reference,
            &nominal,
            &mut reporter,
        );
    }
    let state = State {
        algebra: &mut algebra,
        forces: &mut forces,
        formulation: &formulation,
        drawn: Vec::new(),
    };
    let at = AtReference {
        reference: &reference,
        nominal: &nominal,
    };
    let unit = request::unit(state, at, &mut reporter, watch);
    if reference.closed {
        close::check_ranges(
            &mut algebra,
            &formulation,
            &nominal,
            &mut reference,
            &unit.angles,
            &mut reporter,
        );
    }
    unit
}

/// The bracketed path that the facade's wrapper puts in front, and the rest.
fn split_crate_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut tokens = input.into_iter();
    match tokens.next() {
        Some(TokenTree::Group(path)) => (Group::stream(&path), tokens.collect()),
        first => (quote!(::linkage), first.into_iter().chain(tokens).collect()),
    }
}
