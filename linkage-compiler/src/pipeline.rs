//! The phases between resolution and emission, in their order.

use std::rc::Rc;

use linkage_symbolic::Graph;

use crate::algebra::Algebra;
use crate::assembly::{self, AssembledPart};
use crate::checks;
use crate::diagnostic::{Diagnostics, Reporter};
use crate::ir::CompiledMechanism;
use crate::model::Model;
use crate::observer::PhaseObserver;
use crate::structure::Scope;
use crate::{lower, outputs, structure};

/// A mechanism after the phases.
#[derive(Default)]
pub(crate) struct PhaseResults {
    /// Its programs, which are not to be used after a mistake.
    pub(crate) compiled: CompiledMechanism,
    /// Its assembly for mechanisms that have it as a part.
    pub(crate) part: Option<AssembledPart>,
    /// True if there is no mistake but that of declared ranges.
    pub(crate) closes: bool,
}

/// Compiles a resolved mechanism.
///
/// `parts` are the assemblies of its own parts. After a mistake the rest is not compiled.
pub(crate) fn run(
    model: &Model,
    parts: &[Rc<AssembledPart>],
    diagnostics: &mut Diagnostics,
    observer: &mut dyn PhaseObserver,
) -> PhaseResults {
    let mut reporter = Reporter::new(&model.origins, diagnostics);
    let before = reporter.errors();
    let graph = Graph::new();
    let mut algebra = Algebra::new(&model.mechanism, &graph);
    let algebra = &mut algebra;
    let Some(nominal) = checks::dimensions(&mut algebra.names, &mut reporter) else {
        return Default::default();
    };
    let scope = Scope::all(&model.mechanism);
    let structure = structure::decompose(&mut algebra.names, &nominal, &scope, reporter.reborrow());
    observer.structure(algebra, &structure);
    if reporter.errors() > before {
        return Default::default();
    }
    let mut assembled =
        assembly::assemble(algebra, &nominal, structure, parts, &mut reporter, observer);
    let at = assembled.at_reference();
    let functions = outputs::expressions(algebra, &assembled.formulation, at, &mut reporter);
    let compiled = lower::mechanism(algebra, &assembled.formulation, at, functions, observer);
    let sound = reporter.errors() == 0 && assembled.reference.closed;
    assembled.check_ranges(algebra, &compiled.angles, &mut reporter);
    let of_ranges = reporter.errors();
    assembled.check_redundant(algebra, &mut reporter);
    PhaseResults {
        compiled,
        closes: sound && reporter.errors() == of_ranges,
        part: assembled.into_part(algebra),
    }
}
