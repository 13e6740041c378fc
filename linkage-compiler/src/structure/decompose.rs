//! Decomposition of a mechanism into groups that are solved one after the other.

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::model::unknown_frames;
use crate::structure::analysis::Analysis;
use crate::structure::coupled::{classify_coupled, distance_polynomials};
use crate::structure::equations::{Coordinate, Equation};
use crate::structure::form::Form;
use crate::structure::group::{Group, Structure};
use crate::structure::scope::Scope;
use crate::structure::{classify, eliminate, equations, matching, point, report, unsolved};

/// Finds the groups of a scope, and reports those that cannot be solved.
pub(crate) fn decompose<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    scope: &Scope,
    reporter: Reporter,
) -> Structure<'m> {
    let mut analysis = Analysis {
        algebra,
        nominal,
        reporter,
        structure: Structure::default(),
        substitutions: Default::default(),
        kept_axes: Vec::new(),
        steps: 0,
    };
    analysis.structure.mobility = analysis.algebra.mechanism.inputs.len();
    let (equations, coordinates) = equations::equations(analysis.algebra, scope);
    solve(&mut analysis, equations, coordinates);
    analysis.structure
}

/// No mechanism needs as many reductions for each of its loops.
const STEPS_PER_LOOP: usize = 10;

/// Splits equations into groups and solves each for its coordinates.
fn solve<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: Vec<Equation<'m>>,
    coordinates: Vec<Coordinate>,
) {
    let incidence: Vec<Vec<usize>> = equations
        .iter()
        .map(|e| equations::incidence(analysis.algebra, e, &coordinates))
        .collect();
    let rows: Vec<usize> = equations.iter().map(|e| e.rows.len()).collect();
    let matching = matching::maximum(&rows, &incidence, coordinates.len());
    let before = analysis.reporter.errors();
    if !report::report_mobility(analysis, &equations, &coordinates, &incidence, &matching) {
        if analysis.reporter.errors() == before {
            // Equations or unknowns that are missing here have been introduced here: the loop
            // before has no known form.
            unsolved::report_unsolved(analysis, &equations, &coordinates);
        }
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
        solve_component(analysis, equations, coordinates);
    }
}

/// One strongly connected component: recognised, reduced, or reported.
fn solve_component<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: Vec<Equation<'m>>,
    coordinates: Vec<Coordinate>,
) {
    if let [equation] = &equations[..]
        && let Some(form) = classify::classify(analysis.algebra, equation, &coordinates)
    {
        return push_group(analysis, &equations, &coordinates, form);
    }
    if let Some(form) = point::classify_point(analysis, &equations, &coordinates) {
        return push_group(analysis, &equations, &coordinates, form);
    }
    analysis.steps += 1;
    let allowed = analysis.steps <= STEPS_PER_LOOP * analysis.algebra.mechanism.loops.len();
    let reduced = if allowed {
        eliminate::reduce(analysis, &equations, &coordinates)
    } else {
        None
    };
    if let Some((equations, coordinates)) = reduced {
        return solve(analysis, equations, coordinates);
    }
    let squared =
        distance_polynomials::with_squared_distances(analysis.algebra, &equations, &coordinates);
    match classify_coupled::classify_coupled(analysis.algebra, &squared, &coordinates) {
        Some(form) => push_group(analysis, &equations, &coordinates, form),
        None => unsolved::report_unsolved(analysis, &squared, &coordinates),
    }
}

fn push_group<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
    form: Form<'m>,
) {
    let found = coordinates.iter().filter_map(|c| c.unknown);
    let eliminated = equations.iter().flat_map(|e| e.eliminated.iter().copied());
    let loops = equations.iter().flat_map(|e| e.loops.iter().copied());
    let mut loops: Vec<usize> = loops.collect();
    let mechanism = analysis.algebra.mechanism;
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
    analysis.structure.groups.push(Group {
        loops: sorted(loops),
        written: equations[0].written,
        unknowns: sorted(found.chain(eliminated).collect()),
        form,
    });
}
