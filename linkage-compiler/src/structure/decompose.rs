//! Decomposition of a mechanism into groups that are solved one after the other.

use crate::algebra::{Names, Nominal};
use crate::diagnostic::Reporter;
use crate::model::{Mechanism, unknown_frames};
use crate::structure::analysis_state::{Analysis, checkpoint, is_open_since, return_to};
use crate::structure::coupled::{classify_coupled, distance_polynomials};
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::form::Form;
use crate::structure::group::{Group, Structure};
use crate::structure::mobility_check::MobilityCheck;
use crate::structure::reductions::Reductions;
use crate::structure::scope::Scope;
use crate::structure::{
    classify, crossing, eliminate, equations, matching, mobility_check, point, separation,
    triangle, unsolved,
};

/// The systems among which a component can be separated.
#[derive(Clone, Copy, PartialEq)]
enum Attempt {
    /// As it was written, and after all reductions.
    AsWritten,
    /// After all reductions only.
    Reduced,
}

/// Finds the groups of a scope, and reports those that cannot be solved.
pub(crate) fn decompose<'m>(
    names: &mut Names<'m>,
    nominal: &Nominal,
    scope: &Scope,
    mut reporter: Reporter,
) -> Structure<'m> {
    let mut analysis = Analysis {
        names,
        nominal,
        groups: Vec::new(),
        faults: Vec::new(),
        reductions: Reductions::default(),
        steps: 0,
        separations: 0,
    };
    let (equations, coordinates) = equations::equations(analysis.names, scope);
    solve(&mut analysis, equations, coordinates, Attempt::AsWritten);
    for fault in analysis.faults {
        reporter.error(fault.origin, fault.text);
    }
    Structure {
        groups: analysis.groups,
        explicit: analysis.reductions.explicit,
        mobility: analysis.names.mechanism.inputs.len(),
    }
}

/// No mechanism needs as many reductions for each of its loops.
const STEPS_PER_LOOP: usize = 10;

/// Splits equations into groups and solves each for its coordinates.
fn solve<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: Vec<Equation<'m>>,
    coordinates: Vec<Coordinate>,
    attempt: Attempt,
) {
    let incidence: Vec<Vec<usize>> = equations
        .iter()
        .map(|e| equations::incidence(analysis.names, e, &coordinates))
        .collect();
    let rows: Vec<usize> = equations.iter().map(|e| e.rows.len()).collect();
    let matching = matching::maximum(&rows, &incidence, coordinates.len());
    let MobilityCheck { complete, faults } = mobility_check::check_mobility(
        analysis.names,
        analysis.nominal,
        &equations,
        &coordinates,
        &incidence,
        &matching,
    );
    if !complete && faults.is_empty() {
        // Equations or unknowns that are missing here have been introduced here: the loop before
        // has no known form.
        let fault = unsolved::unsolved_group(analysis.names, &equations, &coordinates);
        analysis.faults.push(fault);
    }
    analysis.faults.extend(faults);
    if !complete {
        return;
    }
    for component in matching::components(&incidence, &matching) {
        let is_member =
            |k: &usize| component.contains(&matching.equation_of[*k].unwrap_or(usize::MAX));
        let coordinates: Vec<Coordinate> = (0..coordinates.len())
            .filter(is_member)
            .map(|k| coordinates[k].clone())
            .collect();
        let equations = component.iter().map(|&k| equations[k].clone()).collect();
        solve_component(analysis, equations, coordinates, attempt);
    }
}

/// One strongly connected component: recognised, reduced, separated, or reported.
fn solve_component<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: Vec<Equation<'m>>,
    coordinates: Vec<Coordinate>,
    attempt: Attempt,
) {
    let mechanism = analysis.names.mechanism;
    if let Some(form) = closed_form(analysis.names, analysis.nominal, &equations, &coordinates) {
        let group = group(mechanism, &equations, &coordinates, form);
        return analysis.groups.push(group);
    }
    let before = checkpoint(analysis);
    solve_reduced(analysis, &equations, &coordinates);
    if attempt != Attempt::AsWritten || !is_open_since(analysis, &before) {
        return;
    }
    // The loops as they are written show best which of them a group consists of.
    if is_separable(analysis, &equations, &coordinates) {
        return_to(analysis, &before);
        solve_separated(analysis, &equations, &coordinates, attempt);
    } else if has_triangle(analysis, &equations, &coordinates) {
        return_to(analysis, &before);
        let Analysis {
            names,
            nominal,
            reductions,
            ..
        } = analysis;
        let turned = triangle::by_shape(names, nominal, reductions, &equations, &coordinates);
        if let Some((equations, coordinates)) = turned {
            solve(analysis, equations, coordinates, attempt);
        }
    } else if has_crossing(analysis, &equations, &coordinates) {
        return_to(analysis, &before);
        let Analysis {
            names, reductions, ..
        } = analysis;
        let led = crossing::by_crossing(names, reductions, &equations, &coordinates);
        if let Some((equations, coordinates)) = led {
            solve(analysis, equations, coordinates, attempt);
        }
    }
}

/// A component without a closed form: reduced, separated, or solved as a coupled group.
fn solve_reduced<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) {
    let mechanism = analysis.names.mechanism;
    analysis.steps += 1;
    let allowed = analysis.steps <= STEPS_PER_LOOP * mechanism.loops.len();
    let reduced = if allowed {
        eliminate::reduce(
            analysis.names,
            analysis.nominal,
            &mut analysis.reductions,
            equations,
            coordinates,
        )
    } else {
        None
    };
    if let Some((equations, coordinates)) = reduced {
        return solve(analysis, equations, coordinates, Attempt::Reduced);
    }
    if allowed && is_separable(analysis, equations, coordinates) {
        return solve_separated(analysis, equations, coordinates, Attempt::Reduced);
    }
    let squared =
        distance_polynomials::with_squared_distances(analysis.names, equations, coordinates);
    match classify_coupled::classify_coupled(analysis.names, &squared, coordinates) {
        Some(form) => {
            let group = group(mechanism, equations, coordinates, form);
            analysis.groups.push(group);
        }
        None => {
            let fault = unsolved::unsolved_group(analysis.names, &squared, coordinates);
            analysis.faults.push(fault);
        }
    }
}

/// Checks if the set has a triangle of distances.
fn has_triangle<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> bool {
    let (nominal, reductions) = (analysis.nominal, &analysis.reductions);
    analysis.names.tried(|names| {
        triangle::by_shape(names, nominal, reductions, equations, coordinates).is_some()
    })
}

/// Checks if two lines of the set cross in one point of a chain.
fn has_crossing<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> bool {
    let reductions = &analysis.reductions;
    analysis
        .names
        .tried(|names| crossing::by_crossing(names, reductions, equations, coordinates).is_some())
}

/// Checks if combinations of the loops fall apart. A coupled group stays as it is otherwise: the
/// order of its sums depends on the expressions that the graph has.
fn is_separable<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> bool {
    let reductions = &analysis.reductions;
    analysis
        .names
        .tried(|names| separation::separated(names, reductions, equations, coordinates).is_some())
}

fn solve_separated<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    attempt: Attempt,
) {
    let Analysis {
        names, reductions, ..
    } = &*analysis;
    if let Some((equations, coordinates)) =
        separation::separated(names, reductions, equations, coordinates)
    {
        analysis.separations += 1;
        solve(analysis, equations, coordinates, attempt);
    }
}

/// Returns the form in which a component is solved as it is; `None` if it has no closed form.
fn closed_form<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<Form<'m>> {
    let single = match equations {
        [equation] => classify::classify(names, equation, coordinates),
        _ => None,
    };
    single.or_else(|| point::classify_point(names, nominal, equations, coordinates))
}

/// Builds a group from its equations, its coordinates and its form.
fn group<'m>(
    mechanism: &Mechanism,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    form: Form<'m>,
) -> Group<'m> {
    let found = coordinates.iter().filter_map(|c| c.unknown);
    let eliminated = equations.iter().flat_map(|e| e.eliminated.iter().copied());
    let loops = equations.iter().flat_map(|e| e.loops.iter().copied());
    let mut loops: Vec<usize> = loops.collect();
    if loops
        .iter()
        .any(|&k| !unknown_frames::is_loop_of_frame(mechanism, k))
    {
        // Loops that the user did not write have no number.
        loops.retain(|&k| !unknown_frames::is_loop_of_frame(mechanism, k));
    }
    let sorted = |numbers: Vec<usize>| {
        let mut numbers = numbers;
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    };
    Group {
        loops: sorted(loops),
        written: equations[0].written,
        unknowns: sorted(found.chain(eliminated).collect()),
        form,
    }
}
