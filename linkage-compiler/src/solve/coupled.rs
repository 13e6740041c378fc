//! Coupled groups: a fixed number of Newton steps from a prepared state near the solution.
//!
//! A private link `V = -(the rest of its loop)` keeps its length: `(r^2 - V.V)/2 = 0`, whose
//! derivative by another unknown is `V . column`. A private slide leaves `guide x rest = 0`. The
//! steps work with unit vectors, one division each, and neither root nor arc function.

mod differentiate;
mod equations;
mod large_rows;
mod large_system;
mod largest;
mod laurent;
mod newton;
pub(crate) mod prepared;
mod rotation_variation;
mod state;
mod system;
use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::Ex;

use crate::algebra::{Algebra, bodies, cofactors, derivatives::dependence};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::definitions;
use crate::solve::group_context::GroupContext;
use crate::structure::Coupled;

use super::plane::linear_gap;
use newton::Plan;
use prepared::Prepared;
use state::StatePart;
use system::System;

/// Newton steps for the core, from which the private unknowns follow.
pub(super) fn coupled<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    form: &Coupled<'m>,
) -> (ClosedForm<'m>, Prepared<'m>) {
    state::declare_core(algebra, group, &form.core);
    let mut equations = equations::core_equations(algebra, group, form);
    equations.large = form
        .is_large()
        .then(|| large_rows::large_system(algebra, group, &equations));
    let system = System::new(algebra, &equations);

    let rows: Vec<Ex> = form.blocks.iter().flat_map(|b| b.rows.clone()).collect();
    let inputs =
        dependence::inputs_below(algebra.graph, &mut algebra.derivatives.dependence, &rows);
    let looked_up = state::prepared_state(algebra, group, &form.core);
    let size = looked_up.iter().flat_map(|part| part.numbers()).count();
    let floor = state::prepared_number(algebra, group, size);
    let in_cells = match inputs.len() {
        2 => group.in_cells,
        _ => Terms::Slopes,
    };
    let plans = Plan::for_calls_and_sweeps(inputs.len(), in_cells);
    let state = plans[1].start(&looked_up);
    let first = newton::step(algebra, &equations, &state);
    let next = first.corrected(&first.corrections);
    let numbers = next.into_iter().flat_map(StatePart::numbers);
    let step = numbers.chain([first.size2, first.determinant]).collect();

    let [called, beside] =
        plans.map(|plan| newton::solution(algebra, &equations, &state, floor, plan));
    let unit = equations.unit;
    let meanings =
        [&looked_up, &called, &beside].map(|state| state::meanings(algebra, state, unit));
    state::define_core(algebra, group, &called, unit);

    let determinant = match &equations.large {
        Some(large) => {
            let nothing = vec![algebra.zero(); equations.matrix.len()];
            let solved =
                bodies::solve_by_scheme(algebra.graph, &large.scheme, &equations.matrix, &nothing);
            solved.determinant
        }
        None => cofactors::determinant(algebra.graph, &equations.matrix),
    };
    let determinant = definitions::alias(algebra, group, "det", determinant, determinant);
    differentiate::push_coupled(algebra, group, &equations, determinant);

    let slack = determinant / largest::largest_core_determinant(algebra, &equations);
    let margin = slack.abs();
    let gap = linear_gap(determinant);
    let [raw, called, beside] = meanings;
    let prepared = Prepared {
        number: group.number,
        inputs,
        size,
        in_cells,
        system,
        step,
        equations: equations.residuals,
        reach: equations.reach,
        scale: equations.scale,
        core: form.core.clone(),
        raw,
        called,
        beside,
    };
    let method = prepared.method();

    let closed = ClosedForm {
        kind: form.kind.clone().into(),
        class: form.class,
        order: form.order,
        method,
        two_modes: false,
        margin,
        slack,
        slack_scale: margin,
        gap,
        gap_in: GapIn::Loop,
    };
    (closed, prepared)
}
