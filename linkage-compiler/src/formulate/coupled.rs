//! Coupled groups: a fixed number of Newton steps from a prepared state near the solution.
//!
//! A private link `V = -(the rest of its loop)` keeps its length: `(r^2 - V.V)/2 = 0`, whose derivative by another unknown is
//! `V . column`. A private slide leaves `guide x rest = 0`. The steps work with unit vectors, one division each, and neither root nor
//! arc function.

mod bound;
mod close;
mod equations;
mod jacobian;
mod laurent;
mod newton;
mod refused;

use linkage_symbolic::program::Source;
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::Rule;
use crate::structure::{Core, Coupled};

use super::{Closed, GapIn, Solver};

use laurent::System;
use newton::Plan;

/// From a table over one input, whose error is known.
const FROM_TABLE: Plan = Plan {
    steps: 1,
    first: None,
};

/// From such a table for dimensions, derivatives or digits that it does not know. Dimensions that move the solution by more than
/// this, in radians or scaled lengths, might lead to another assembly than a gradual change would.
const BESIDE_TABLE: Plan = Plan {
    steps: 4,
    first: Some(0.05),
};

/// From the nearest of prepared states over several inputs.
const FROM_GRID: Plan = Plan {
    steps: 4,
    first: None,
};

/// What is prepared for a coupled group and how it is used.
#[derive(Clone, Debug)]
pub(crate) struct Prepared {
    /// Index among the coupled groups.
    pub(crate) number: usize,
    /// The inputs that the group depends on.
    pub(crate) inputs: Vec<usize>,
    /// Numbers in a state.
    pub(crate) size: usize,
    /// Polynomials of which the assemblies are the real roots.
    pub(crate) system: System,
    pub(crate) core: Vec<Definition>,
    /// One step: the new state, the square of the correction, the determinant.
    pub(crate) step: Vec<NodeId>,
    /// The sum of the lengths of its links.
    pub(crate) reach: NodeId,
}

/// The symbol of an unknown of the core with all that it may stand for.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    pub(crate) symbol: SymbolId,
    /// As prepared, without a step.
    pub(crate) raw: NodeId,
    /// After the steps of a call.
    pub(crate) called: NodeId,
    /// After the steps that other dimensions need.
    pub(crate) beside: NodeId,
}

impl Prepared {
    /// True if calls and sweeps over dimensions take different numbers of steps.
    pub(crate) fn has_table(&self) -> bool {
        self.inputs.len() == 1
    }
}

impl Solver<'_, '_> {
    pub(super) fn coupled(&mut self, form: &Coupled) -> Closed {
        self.declare_core(&form.core);
        let variables: Vec<SymbolId> = (0..form.core.len())
            .map(|position| self.algebra.unknown_variable(self.index, position))
            .collect();
        let equations = self.core_equations(form, &variables);
        let system = System::new(self.algebra, form, equations.scale, equations.unit);

        let state: Vec<Vec<NodeId>> = self.state_nodes(&form.core);
        let size = state.iter().map(Vec::len).sum();
        let floor = self.state(size);
        let first = self.step(&equations, &form.core, &state);
        let unguarded = self.corrected(&first, &first.corrections);
        let mut step: Vec<NodeId> = unguarded.concat();
        step.extend([first.size2, first.determinant]);

        let rows: Vec<NodeId> = form.blocks.iter().flat_map(|b| b.rows.clone()).collect();
        let inputs = self.algebra.inputs_below(&rows);
        let (called, beside) = match inputs.len() {
            1 => (FROM_TABLE, BESIDE_TABLE),
            _ => (FROM_GRID, FROM_GRID),
        };
        let called = self.solution(&equations, &form.core, &state, floor, called);
        let beside = self.solution(&equations, &form.core, &state, floor, beside);
        let core = self.define_core(&form.core, &state, [&called, &beside], equations.unit);

        let determinant = self.algebra.determinant(&equations.matrix);
        let determinant = self.alias("det", determinant, determinant);
        self.push_coupled(form, &variables, &equations, determinant);

        let bound = self.largest_core_determinant(form, &equations);
        let graph = &mut self.algebra.graph;
        let slack = graph.div(determinant, bound);
        let margin = self.abs(slack);
        let gap = self.linear_gap(determinant);
        self.prepared = Some(Prepared {
            number: self.number,
            inputs,
            size,
            system,
            core,
            step,
            reach: equations.reach,
        });
        Closed {
            kind: form.kind.clone().into(),
            class: form.class,
            order: form.order,
            method: match self.prepared.as_ref().is_some_and(Prepared::has_table) {
                true => "prepared table over the input, one Newton step, certificate",
                false => "prepared states, fixed number of Newton steps, certificate",
            },
            two_modes: false,
            margin,
            slack,
            slack_scale: margin,
            gap,
            gap_in: GapIn::Loop,
        }
    }

    /// Derivatives by the unknowns of the core follow these rules before there are definitions.
    fn declare_core(&mut self, core: &[Core]) {
        for (position, core) in core.iter().enumerate() {
            match *core {
                Core::Angle(angle) => self.declare_angle(angle, 1.0, position),
                Core::Length { symbol, .. } => {
                    let group = self.index;
                    let rule = Rule::Unknown { group, position };
                    self.algebra.rules.insert(symbol, rule);
                }
            }
        }
    }

    fn state(&mut self, component: usize) -> NodeId {
        let source = Source::State(self.number, component);
        self.algebra.graph.source(source)
    }

    /// The prepared numbers of each unknown of the core.
    fn state_nodes(&mut self, core: &[Core]) -> Vec<Vec<NodeId>> {
        let mut next = 0;
        core.iter()
            .map(|core| {
                let width = match core {
                    Core::Angle(_) => 2,
                    Core::Length { .. } => 1,
                };
                next += width;
                (next - width..next).map(|k| self.state(k)).collect()
            })
            .collect()
    }

    /// Gives the unknowns of the core their definitions for calls.
    fn define_core(
        &mut self,
        core: &[Core],
        state: &[Vec<NodeId>],
        [called, beside]: [&[Vec<NodeId>]; 2],
        unit: NodeId,
    ) -> Vec<Definition> {
        let mut definitions = Vec::new();
        for (position, core) in core.iter().enumerate() {
            let versions = [&state[position], &called[position], &beside[position]];
            match *core {
                Core::Angle(angle) => {
                    let own = &called[position];
                    self.define_angle(angle, 1.0, [own[0], own[1]], position);
                    let angle = &self.algebra.angles[angle];
                    for (k, symbol) in [angle.cos, angle.sin].into_iter().enumerate() {
                        let [raw, called, beside] = versions.map(|v| v[k]);
                        definitions.push(Definition {
                            symbol,
                            raw,
                            called,
                            beside,
                        });
                    }
                }
                Core::Length { symbol, .. } => {
                    let [raw, called, beside] =
                        versions.map(|v| self.algebra.graph.mul(unit, v[0]));
                    self.define_length(symbol, called, position);
                    definitions.push(Definition {
                        symbol,
                        raw,
                        called,
                        beside,
                    });
                }
            }
        }
        definitions
    }
}
