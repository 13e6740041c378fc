//! Coupled groups: a fixed number of Newton steps from a prepared state near the solution.
//!
//! A private link `V = -(the rest of its loop)` keeps its length: `(r^2 - V.V)/2 = 0`, whose derivative by another unknown is
//! `V . column`. A private slide leaves `guide x rest = 0`. The steps work with unit vectors, one division each, and neither root nor
//! arc function.

mod differentiate;
mod equations;
mod large;
mod largest;
mod laurent;
mod newton;
mod state;
mod system;
mod turns;

use crate::algebra::bodies;
use crate::algebra::dependence;
use crate::algebra::elimination;
use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::{Ex, Graph, NodeId, SymbolId, Vn, substitute};

use crate::algebra::{Algebra, Nominal};
use crate::structure::{Core, Coupled};

use super::plane::linear_gap;
use super::{Closed, GapIn, Solver};

use newton::Plan;
use state::Part;
use system::System;

/// What is prepared for a coupled group and how it is used.
#[derive(Clone, Debug)]
pub(crate) struct Prepared<'m> {
    /// Index among the coupled groups.
    pub(crate) number: usize,
    /// The inputs that the group depends on.
    pub(crate) inputs: Vec<usize>,
    /// Numbers in a state.
    pub(crate) size: usize,
    /// What a grid over its inputs knows in a cell.
    pub(crate) in_cells: Terms,
    /// Polynomials of which the assemblies are the real roots.
    pub(crate) system: System<'m>,
    /// One step: the new state, the square of the correction, the determinant.
    pub(crate) step: Vec<Ex<'m>>,
    /// What the equations of the core miss by.
    equations: Vec<Ex<'m>>,
    /// The sum of the lengths of its links.
    pub(crate) reach: Ex<'m>,
    /// What lengths are multiplied by in states.
    scale: Ex<'m>,
    core: Vec<Core>,
    raw: Vec<Meaning<'m>>,
    called: Vec<Meaning<'m>>,
    beside: Vec<Meaning<'m>>,
}

/// Which of its meanings an unknown of a core has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Version {
    /// As prepared, without a step.
    Raw,
    /// After the steps of a call.
    Called,
    /// After the steps that other dimensions need.
    Beside,
}

/// What a symbol of an unknown of the core stands for.
#[derive(Clone, Copy, Debug)]
struct Meaning<'m> {
    symbol: SymbolId,
    value: Ex<'m>,
}

/// Where a number of a state is estimated.
#[derive(Clone, Copy, Debug)]
struct Estimated {
    value: f64,
    length: bool,
}

impl<'m> Prepared<'m> {
    /// The state where the unknowns are estimated. Estimates are of the default mechanism: lengths grow with the links.
    pub(crate) fn estimate(&self, algebra: &Algebra<'m>, nominal: &Nominal) -> Vec<Ex<'m>> {
        let growth = self.reach * self.scale;
        let reach = nominal.evaluate(&[self.reach])[0];
        let all = self.estimated(algebra, nominal).into_iter();
        let numbers = all.map(|own| match own.length {
            true => algebra.graph.number(own.value / reach) * growth,
            false => algebra.graph.number(own.value),
        });
        numbers.collect()
    }

    /// The same in numbers, of the default mechanism.
    pub(crate) fn estimate_of_default(&self, algebra: &Algebra<'m>, nominal: &Nominal) -> Vec<f64> {
        let scale = nominal.evaluate(&[self.scale])[0];
        let all = self.estimated(algebra, nominal).into_iter();
        let numbers = all.map(|own| {
            if own.length {
                scale * own.value
            } else {
                own.value
            }
        });
        numbers.collect()
    }

    /// What the equations of the core miss by in a state.
    pub(crate) fn residuals(&self) -> Vec<Ex<'m>> {
        let meanings = self.raw.iter().map(|own| (own.symbol, own.value));
        substitute(&self.equations, &meanings.collect())
    }

    /// The unknowns of a state.
    pub(crate) fn core(&self) -> &[Core] {
        &self.core
    }

    /// A state of the default mechanism, its lengths in the mechanism's unit.
    pub(crate) fn unscaled(&self, nominal: &Nominal, state: &[f64]) -> Vec<f64> {
        let scale = nominal.evaluate(&[self.scale])[0];
        let factors = self.core.iter().flat_map(|core| match core {
            Core::Angle(_) => vec![1.0; 2],
            Core::Length { number: true, .. } => vec![1.0],
            Core::Length { .. } => vec![1.0 / scale],
        });
        factors.zip(state).map(|(factor, x)| factor * x).collect()
    }

    fn estimated(&self, algebra: &Algebra<'m>, nominal: &Nominal) -> Vec<Estimated> {
        let names = &algebra.names;
        let number = |value| Estimated {
            value,
            length: false,
        };
        let all = self.core.iter().flat_map(|core| match *core {
            Core::Angle(angle) => {
                let (sin, cos) = names.angles[angle].estimate(nominal).sin_cos();
                [cos, sin].map(number).to_vec()
            }
            Core::Length { symbol, number, .. } => vec![Estimated {
                value: names.estimate(symbol, nominal),
                length: !number,
            }],
        });
        all.collect()
    }

    /// True if states are prepared as a table over its one input.
    pub(crate) fn has_table(&self) -> bool {
        self.inputs.len() == 1
    }

    /// True if calls take fewer steps than sweeps over dimensions.
    pub(crate) fn is_shorter_in_calls(&self) -> bool {
        self.has_table() || self.in_cells == Terms::Polynomials
    }

    /// True if it depends on several inputs: a follower goes from solution to solution.
    pub(crate) fn has_follower(&self) -> bool {
        self.inputs.len() > 1
    }

    /// How calls find its unknowns, in words.
    pub(crate) fn method(&self) -> &'static str {
        match self.in_cells {
            _ if self.has_table() => "prepared table over the input, one Newton step, certificate",
            Terms::Polynomials => {
                "prepared polynomials over both inputs, one Newton step, certificate"
            }
            Terms::Slopes => "prepared states, fixed number of Newton steps, certificate",
        }
    }

    /// Gives the unknowns of the core one of their meanings.
    pub(crate) fn define(&self, graph: &Graph, version: Version) {
        let meanings = match version {
            Version::Raw => &self.raw,
            Version::Called => &self.called,
            Version::Beside => &self.beside,
        };
        for meaning in meanings {
            graph.define(meaning.symbol, meaning.value.id());
        }
    }
}

/// Newton steps for the core, from which the private unknowns follow.
pub(super) fn coupled<'m>(solver: &mut Solver<'_, 'm>, form: &Coupled<'m>) -> Closed<'m> {
    state::declare_core(solver, &form.core);
    let equations = equations::core_equations(solver, form);
    let system = System::new(solver.algebra, &equations);

    let rows: Vec<Ex> = form.blocks.iter().flat_map(|b| b.rows.clone()).collect();
    let inputs = dependence::inputs_below(solver.algebra, &rows);
    let looked_up = state::prepared_state(solver, &form.core);
    let size = looked_up.iter().flat_map(|part| part.numbers()).count();
    let floor = state::prepared_number(solver, size);
    let in_cells = match inputs.len() {
        2 => solver.in_cells,
        _ => Terms::Slopes,
    };
    let plans = Plan::of(inputs.len(), in_cells);
    let state = plans[1].start(&looked_up);
    let first = newton::step(solver, &equations, &state);
    let next = first.corrected(&first.corrections);
    let numbers = next.into_iter().flat_map(Part::numbers);
    let step = numbers.chain([first.size2, first.determinant]).collect();

    let [called, beside] =
        plans.map(|plan| newton::solution(solver, &equations, &state, floor, plan));
    let unit = equations.unit;
    let meanings = [&looked_up, &called, &beside].map(|state| state::meanings(solver, state, unit));
    state::define_core(solver, &called, unit);

    let determinant = match &equations.large {
        Some(large) => {
            let nothing = vec![solver.algebra.zero(); equations.matrix.len()];
            let solved =
                bodies::solve_by_scheme(solver.algebra, &large.scheme, &equations.matrix, &nothing);
            solved.determinant
        }
        None => elimination::determinant(solver.algebra, &equations.matrix),
    };
    let determinant = solver.alias("det", determinant, determinant);
    differentiate::push_coupled(solver, &equations, determinant);

    let slack = determinant / largest::largest_core_determinant(solver, &equations);
    let margin = slack.abs();
    let gap = linear_gap(determinant);
    let [raw, called, beside] = meanings;
    let prepared = Prepared {
        number: solver.number,
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
    solver.prepared = Some(prepared);
    Closed {
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
    }
}

/// One component for each row of a loop, as a vector.
fn vector<'m>(rows: &[Ex<'m>]) -> Vn<'m> {
    let ids: Vec<NodeId> = rows.iter().map(|x| x.id()).collect();
    rows[0].graph().components(&ids)
}
