//! The phases between resolving and emission.

use std::rc::Rc;

use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::Graph;

use crate::algebra::{Algebra, Nominal};
use crate::close::Closed;
use crate::diagnostic::{Diagnostics, Reporter};
use crate::forces::Forces;
use crate::model::Model;
use crate::request::{AtReference, State};
use crate::structure::Scope;
use crate::unit::Unit;
use crate::watch::Watch;
use crate::{close, forces, formulate, lower, request, structure};

/// The middle phases of a resolved mechanism: structure, formulation, checks and lowering.
pub(crate) fn analyse(
    model: &Model,
    parts: &[Rc<Closed>],
    diagnostics: &mut Diagnostics,
    watch: &mut dyn Watch,
) -> (Unit, Option<Closed>) {
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
    watch: &mut dyn Watch,
    in_cells: Terms,
) -> Option<(Unit, Option<Closed>)> {
    let Model { mechanism, origins } = model;
    let graph = Graph::new();
    let mut algebra = Algebra::new(mechanism, &graph);
    let mut nominal = Nominal::of(&mut algebra);
    let mut reporter = Reporter {
        origins,
        diagnostics,
    };
    let before = reporter.errors();
    close::check_directions(mechanism, &nominal, &mut reporter);
    if reporter.errors() > before {
        // What is computed with them would be reported as not finite.
        return Some((Unit::default(), None));
    }
    nominal.check(mechanism, &mut reporter);
    close::check_courses(mechanism, &nominal, &mut reporter);
    if reporter.errors() == before {
        close::check_values(mechanism, &nominal, &mut reporter);
    }
    close::warn_of_unused(mechanism, &nominal, &mut reporter);
    let structure = structure::decompose(
        &mut algebra,
        &nominal,
        &Scope::all(mechanism),
        reporter.reborrow(),
    );
    watch.structure(&algebra, &structure);
    if reporter.errors() > before {
        return Some((Unit::default(), None));
    }
    let formulation = formulate::formulate(&mut algebra, &nominal, structure, in_cells);
    close::check_names_of_follower(mechanism, &formulation, &mut reporter);
    watch.formulated(&mut algebra, &formulation, &nominal);
    let closing = lower::closing(&mut algebra, &formulation, &nominal);
    let inner = close::inner_parts(&mut algebra, &nominal, parts);
    let written = nominal.clone();
    let mut reference = close::assemble_reference(
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
    let of_motion = request::of_motion(&mut algebra, &formulation, at, &mut silent);
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
    let unit = request::unit(state, at, of_motion, &mut reporter, watch);
    if reference.closed {
        close::check_ranges(
            &mut algebra,
            &formulation,
            &nominal,
            &mut reference,
            &unit.angles,
            &mut reporter,
        );
        close::check_redundant(&mut algebra, &reference, &nominal, &mut reporter);
    }
    let closed = reference
        .closed
        .then(|| Closed::new(&algebra, reference, nominal));
    Some((unit, closed))
}
