//! The phases between resolving and emission.

use std::rc::Rc;

use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::Graph;

use crate::algebra::{Algebra, Nominal};
use crate::assembly::Closed;
use crate::diagnostic::{Diagnostics, Reporter};
use crate::forces::Forces;
use crate::ir::CompiledMechanism;
use crate::model::Model;
use crate::observer::PhaseObserver;
use crate::outputs::{AtReference, State};
use crate::structure::Scope;
use crate::{assembly, forces, lower, outputs, solve, structure};

/// The middle phases of a resolved mechanism: structure, formulation, checks and lowering.
pub(crate) fn analyse(
    model: &Model,
    parts: &[Rc<Closed>],
    diagnostics: &mut Diagnostics,
    watch: &mut dyn PhaseObserver,
) -> (CompiledMechanism, Option<Closed>) {
    // Which steps calls make is known when it is known whether polynomials serve the ranges: seldom not.
    let mut own = Diagnostics::default();
    let done = analysed(model, parts, &mut own, watch, Terms::Polynomials).unwrap_or_else(|| {
        own = Diagnostics::default();
        analysed(model, parts, &mut own, watch, Terms::Slopes).unwrap_or_default()
    });
    diagnostics.append(own);
    done
}

/// The phases in their order, which stands here alone, with what grids over two inputs know in their cells; `None` if polynomials do not serve.
fn analysed(
    model: &Model,
    parts: &[Rc<Closed>],
    diagnostics: &mut Diagnostics,
    watch: &mut dyn PhaseObserver,
    in_cells: Terms,
) -> Option<(CompiledMechanism, Option<Closed>)> {
    let Model { mechanism, origins } = model;
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let mut nominal = Nominal::of(&mut algebra);
    let mut reporter = Reporter {
        origins,
        diagnostics,
    };
    let before = reporter.errors();
    assembly::check_directions(mechanism, &nominal, &mut reporter);
    if reporter.errors() > before {
        // What is computed with them would be reported as not finite.
        return Some((CompiledMechanism::default(), None));
    }
    nominal.check(mechanism, &mut reporter);
    assembly::check_courses(mechanism, &nominal, &mut reporter);
    if reporter.errors() == before {
        assembly::check_values(mechanism, &nominal, &mut reporter);
    }
    assembly::warn_of_unused(mechanism, &nominal, &mut reporter);
    let structure = structure::decompose(
        &mut algebra,
        &nominal,
        &Scope::all(mechanism),
        reporter.reborrow(),
    );
    watch.structure(&algebra, &structure);
    if reporter.errors() > before {
        return Some((CompiledMechanism::default(), None));
    }
    let formulation = solve::formulate(&mut algebra, &nominal, structure, in_cells);
    assembly::check_names_of_follower(mechanism, &formulation, &mut reporter);
    watch.formulated(&mut algebra, &formulation, &nominal);
    let closing = lower::closing(&mut algebra, &formulation, &nominal);
    let inner = assembly::inner_parts(&mut algebra, &nominal, parts);
    let written = nominal.clone();
    let mut reference = assembly::assemble_reference(
        &algebra,
        &formulation,
        closing,
        &mut nominal,
        inner,
        reporter.reborrow(),
    );
    if reference.needs_slopes {
        return None;
    }
    nominal.complete(&reference.found);
    let at = AtReference {
        reference: &reference,
        nominal: &nominal,
        written: &written,
    };
    // Behind what is said of bodies.
    let mut of_functions = Diagnostics::default();
    let mut silent = Reporter {
        origins,
        diagnostics: &mut of_functions,
    };
    let of_motion = outputs::of_motion(&mut algebra, &formulation, at, &mut silent);
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
    reporter.diagnostics.append(of_functions);
    let state = State {
        algebra: &mut algebra,
        forces: &mut forces,
        formulation: &formulation,
        drawn: Vec::new(),
    };
    let unit = outputs::unit(state, at, of_motion, &mut reporter, watch);
    if reference.closed {
        assembly::check_ranges(
            &mut algebra,
            &formulation,
            &nominal,
            &mut reference,
            &unit.angles,
            &mut reporter,
        );
        assembly::check_redundant(&mut algebra, &reference, &nominal, &mut reporter);
    }
    let closed = reference
        .closed
        .then(|| Closed::new(&algebra, reference, nominal));
    Some((unit, closed))
}
