//! Coupled groups: a fixed number of Newton steps from a prepared state near the solution.
//!
//! A private link `V = -(the rest of its loop)` keeps its length: `(r^2 - V.V)/2 = 0`, whose derivative by another unknown is
//! `V . column`. A private slide leaves `guide x rest = 0`. The steps work with unit vectors, one division each, and neither root nor
//! arc function.

use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::{NodeId, SymbolId, substitute};

use crate::algebra::{CoreRow, Elimination, PrivateColumn, Rule, Solution, Term};
use crate::structure::{Block, Core, Coupled, Private};

use super::laurent::System;
use super::vector::Vector;
use super::{Closed, GapIn, Solver};

/// Newton steps from a table over one input, where the table's error is known.
const STEPS_FROM_TABLE: usize = 1;

/// Newton steps for dimensions, derivatives or digits that the table does not know.
const STEPS_BESIDE_TABLE: usize = 3;

/// Newton steps from the nearest of prepared states over several inputs.
const STEPS_FROM_GRID: usize = 4;

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

/// The equations of the core, in the symbols of the core alone, and all that is made of them.
pub(super) struct Equations {
    reach: NodeId,
    pub(super) scale: NodeId,
    /// 1 over the scale.
    unit: NodeId,
    residuals: Vec<NodeId>,
    rows: Vec<CoreRow>,
    matrix: Vec<Vec<NodeId>>,
}

/// A step from a state.
struct Step {
    corrections: Vec<NodeId>,
    /// Unit vectors of length 1 and lengths, as the corrections apply to them.
    start: Vec<Vec<NodeId>>,
    size2: NodeId,
    determinant: NodeId,
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
            1 => (STEPS_FROM_TABLE, STEPS_BESIDE_TABLE),
            _ => (STEPS_FROM_GRID, STEPS_FROM_GRID),
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

    fn core_equations(&mut self, form: &Coupled, variables: &[SymbolId]) -> Equations {
        let reach = self.reach(form);
        let graph = &mut self.algebra.graph;
        let scale = graph.unary(Unary::InverseScale, reach);
        let one = graph.one();
        let unit = graph.div(one, scale);
        let column_scales: Vec<NodeId> = form
            .core
            .iter()
            .map(|core| match core {
                Core::Angle(_) => scale,
                Core::Length { .. } => one,
            })
            .collect();
        let mut equations = Equations {
            reach,
            scale,
            unit,
            residuals: Vec::new(),
            rows: Vec::new(),
            matrix: Vec::new(),
        };
        let mut first = 0;
        for block in &form.blocks {
            match (&block.private, &block.rest[..]) {
                (Some(private), &[x, y]) => {
                    self.across_private(
                        &mut equations,
                        private,
                        [x, y],
                        first,
                        (variables, &column_scales),
                    );
                }
                _ => {
                    for (row, &node) in block.rows.iter().enumerate() {
                        let (factor, scales): (NodeId, Vec<NodeId>) = match block.rows.len() {
                            2 => (scale, column_scales.clone()),
                            _ => (one, vec![one; variables.len()]),
                        };
                        let residual = self.algebra.graph.mul(factor, node);
                        let entries = variables.iter().zip(&scales).map(|(&variable, &scale)| {
                            let slope = self.algebra.partial(node, variable);
                            self.algebra.graph.mul(scale, slope)
                        });
                        let entries = entries.collect();
                        equations.residuals.push(residual);
                        equations.matrix.push(entries);
                        equations.rows.push(CoreRow {
                            first: first + row,
                            factors: vec![factor],
                        });
                    }
                }
            }
            first += block.rows.len();
        }
        equations
    }

    /// The equation of a loop across its private unknown.
    fn across_private(
        &mut self,
        equations: &mut Equations,
        private: &Private,
        rest: Vector,
        first: usize,
        (variables, column_scales): (&[SymbolId], &[NodeId]),
    ) {
        let scale = equations.scale;
        let slopes: Vec<Vector> = variables
            .iter()
            .map(|&variable| rest.map(|x| self.algebra.partial(x, variable)))
            .collect();
        let (multiplier, residual, entries): (Vector, NodeId, Vec<NodeId>) = match private {
            Private::Rotor(rotor) => {
                let link = self.negative(rest);
                let link = link.map(|x| self.algebra.graph.mul(scale, x));
                let length = self.algebra.length(&rotor.z);
                let graph = &mut self.algebra.graph;
                let length = graph.mul(scale, length);
                let wanted = graph.square(length);
                let square = self.square(link);
                let miss = self.algebra.graph.sub(wanted, square);
                let residual = self.half(miss);
                let entries = slopes.iter().zip(column_scales).map(|(slope, &scale)| {
                    let slope = slope.map(|x| self.algebra.graph.mul(scale, x));
                    self.algebra.dot(&link, &slope)
                });
                let entries = entries.collect();
                (link, residual, entries)
            }
            Private::Slide { guide, .. } => {
                let scaled = rest.map(|x| self.algebra.graph.mul(scale, x));
                let residual = self.algebra.cross(*guide, scaled);
                let entries = variables.iter().zip(&slopes).zip(column_scales);
                let entries = entries.map(|((&variable, slope), &scale)| {
                    let slope = slope.map(|x| self.algebra.graph.mul(scale, x));
                    let turning = guide.map(|x| self.algebra.partial(x, variable));
                    let moved = self.algebra.cross(*guide, slope);
                    let rest = rest.map(|x| self.algebra.graph.mul(scale, x));
                    let turned = self.algebra.cross(turning, rest);
                    self.algebra.graph.add(moved, turned)
                });
                let entries = entries.collect();
                (self.perp(*guide), residual, entries)
            }
        };
        let factors = multiplier.map(|x| self.algebra.graph.mul(scale, x));
        equations.residuals.push(residual);
        equations.matrix.push(entries);
        equations.rows.push(CoreRow {
            first,
            factors: factors.to_vec(),
        });
    }

    /// The sum of the lengths of the links that do not depend on inputs. A power of two near its inverse scales the equations.
    fn reach(&mut self, form: &Coupled) -> NodeId {
        let mut vectors: Vec<Vector> = Vec::new();
        for block in form.blocks.iter().filter(|block| block.rows.len() == 2) {
            for product in &block.terms {
                let turns = |symbol| self.algebra.angles.iter().any(|a| a.cos == symbol);
                if let ([(symbol, 1)], &[x, y]) = (&product.powers[..], &product.coefficient[..])
                    && turns(*symbol)
                    && self.algebra.is_fixed(x)
                    && self.algebra.is_fixed(y)
                {
                    vectors.push([x, y]);
                }
            }
        }
        let zero = self.algebra.graph.zero();
        vectors.iter().fold(zero, |sum, vector| {
            let length = self.algebra.length(vector);
            self.algebra.graph.add(sum, length)
        })
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

    /// The correction of a state.
    fn step(&mut self, equations: &Equations, core: &[Core], state: &[Vec<NodeId>]) -> Step {
        let start: Vec<Vec<NodeId>> = state
            .iter()
            .map(|numbers| self.unit_length(numbers))
            .collect();
        let mut map = std::collections::HashMap::new();
        for (core, numbers) in core.iter().zip(&start) {
            match *core {
                Core::Angle(angle) => {
                    let angle = &self.algebra.angles[angle];
                    map.extend([(angle.cos, numbers[0]), (angle.sin, numbers[1])]);
                }
                Core::Length { symbol, .. } => {
                    let length = self.algebra.graph.mul(equations.unit, numbers[0]);
                    map.insert(symbol, length);
                }
            }
        }
        let roots: Vec<NodeId> = equations.matrix.concat();
        let roots = [&equations.residuals[..], &roots].concat();
        let here = substitute(&mut self.algebra.graph, &roots, &map);
        let (residuals, entries) = here.split_at(core.len());
        let matrix: Vec<Vec<NodeId>> = entries.chunks(core.len()).map(<[_]>::to_vec).collect();
        let determinant = self.algebra.determinant(&matrix);
        let numerators = self.algebra.cofactor_products(&matrix, residuals);
        let graph = &mut self.algebra.graph;
        let corrections: Vec<NodeId> = numerators
            .into_iter()
            .map(|numerator| {
                let quotient = graph.div(numerator, determinant);
                graph.neg(quotient)
            })
            .collect();
        let size2 = self.algebra.dot(&corrections, &corrections);
        Step {
            corrections,
            start,
            size2,
            determinant,
        }
    }

    /// A prepared unit vector has the length 1 to about ten digits: one step of the inverse root makes it exact.
    fn unit_length(&mut self, numbers: &[NodeId]) -> Vec<NodeId> {
        if numbers.len() == 1 {
            return numbers.to_vec();
        }
        let square = self.algebra.dot(numbers, numbers);
        let half = self.half(square);
        let graph = &mut self.algebra.graph;
        let bound = graph.constant(1.5);
        let factor = graph.sub(bound, half);
        numbers.iter().map(|&x| graph.mul(factor, x)).collect()
    }

    /// A state after corrections: unit vectors turn to second order.
    fn corrected(&mut self, step: &Step, corrections: &[NodeId]) -> Vec<Vec<NodeId>> {
        let all = step.start.iter().zip(corrections);
        all.map(|(numbers, &correction)| match numbers[..] {
            [cos, sin] => {
                let square = self.algebra.graph.square(correction);
                let versine = self.half(square);
                let graph = &mut self.algebra.graph;
                let [across, back] = [graph.mul(sin, correction), graph.mul(cos, versine)];
                let fall = graph.add(across, back);
                let [along, down] = [graph.mul(cos, correction), graph.mul(sin, versine)];
                let rise = graph.sub(along, down);
                vec![graph.sub(cos, fall), graph.add(sin, rise)]
            }
            _ => vec![self.algebra.graph.add(numbers[0], correction)],
        })
        .collect()
    }

    /// The state after some steps, NaN unless the last correction is small, every one much smaller than the one before, and the
    /// determinant keeps its sign and, from a table, half of its size.
    fn solution(
        &mut self,
        equations: &Equations,
        core: &[Core],
        state: &[Vec<NodeId>],
        floor: NodeId,
        steps: usize,
    ) -> Vec<Vec<NodeId>> {
        let limit = self.algebra.graph.source(Source::Limit);
        let limit2 = self.algebra.graph.square(limit);
        let mut state = state.to_vec();
        let mut guard: Option<NodeId> = None;
        let mut before: Option<NodeId> = None;
        for index in 0..steps {
            let step = self.step(equations, core, &state);
            let graph = &mut self.algebra.graph;
            let mut sound = graph.mul(step.determinant, floor);
            if steps == 1 {
                let floor2 = graph.square(floor);
                sound = graph.sub(sound, floor2);
            }
            let last = index + 1 == steps;
            let allowed = before.map(|before| {
                let share = graph.constant(1.0 / 16.0);
                let share = graph.mul(share, before);
                graph.binary(Binary::Max, share, limit2)
            });
            let allowed = if last { Some(limit2) } else { allowed };
            let small = allowed.map(|allowed| graph.sub(allowed, step.size2));
            for condition in [Some(sound), small].into_iter().flatten() {
                guard = Some(match guard {
                    Some(guard) => graph.binary(Binary::Min, guard, condition),
                    None => condition,
                });
            }
            before = Some(step.size2);
            let mut corrections = step.corrections.clone();
            if let (true, Some(guard)) = (last, guard) {
                let nan = graph.constant(f64::NAN);
                for correction in &mut corrections {
                    *correction = graph.ternary(Ternary::Select, guard, *correction, nan);
                }
            }
            state = self.corrected(&step, &corrections);
        }
        state
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

    /// Defines the private unknowns and records what differentiation needs.
    fn push_coupled(
        &mut self,
        form: &Coupled,
        variables: &[SymbolId],
        equations: &Equations,
        determinant: NodeId,
    ) {
        let rows: usize = form.blocks.iter().map(|block| block.rows.len()).sum();
        let zero = self.algebra.graph.zero();
        let mut jacobian = vec![vec![zero; rows]; variables.len()];
        let mut privates = Vec::new();
        let mut terms = Vec::new();
        let mut first = 0;
        for block in &form.blocks {
            let position = jacobian.len();
            if let Some(private) = &block.private {
                let own = self.define_private(private, [block.rest[0], block.rest[1]], position);
                let square = match private {
                    Private::Rotor(rotor) => self.square(rotor.z),
                    Private::Slide { guide, .. } => self.square_of_guide(*guide),
                };
                let mut column = vec![zero; rows];
                column[first..first + 2].copy_from_slice(&own);
                jacobian.push(column);
                privates.push(PrivateColumn { first, square });
            }
            for (position, &variable) in variables.iter().enumerate() {
                for (row, &node) in block.rows.iter().enumerate() {
                    jacobian[position][first + row] = self.algebra.partial(node, variable);
                }
            }
            terms.extend(self.block_terms(block, first, rows));
            first += block.rows.len();
        }
        let one = self.algebra.graph.one();
        let units = form.core.iter().map(|core| match core {
            Core::Angle(_) => one,
            Core::Length { .. } => equations.unit,
        });
        let elimination = Elimination {
            rows: equations.rows.clone(),
            matrix: equations.matrix.clone(),
            units: units.collect(),
            privates,
        };
        self.push_solution(Solution {
            terms,
            jacobian,
            determinant,
            elimination: Some(elimination),
        });
    }

    /// Defines a private unknown; returns its column.
    fn define_private(&mut self, private: &Private, rest: Vector, position: usize) -> Vector {
        match private {
            Private::Rotor(rotor) => {
                let unit = self.unit_of(rotor);
                let value = self.negative(rest);
                let vector = self.turning(value, rotor.z, unit, position);
                let quotient = self.complex_quotient(vector, rotor.z);
                self.define_angle(rotor.angle, rotor.sense, quotient, position);
                self.perp(vector)
            }
            Private::Slide { slide, guide } => {
                let along = self.algebra.dot(guide, &rest);
                let square = self.square_of_guide(*guide);
                let graph = &mut self.algebra.graph;
                let quotient = graph.div(along, square);
                let value = graph.neg(quotient);
                self.define_length(*slide, value, position);
                *guide
            }
        }
    }

    fn square_of_guide(&mut self, guide: Vector) -> NodeId {
        match self.algebra.is_unit(guide) {
            true => self.algebra.graph.one(),
            false => self.square(guide),
        }
    }

    /// The terms of one loop among all rows.
    fn block_terms(&mut self, block: &Block, first: usize, rows: usize) -> Vec<Term> {
        let graph = &mut self.algebra.graph;
        let zero = graph.zero();
        let terms = block.terms.iter().map(|product| {
            let mut coefficient = vec![zero; rows];
            coefficient[first..first + block.rows.len()].copy_from_slice(&product.coefficient);
            let mut factor = graph.one();
            for &(symbol, power) in &product.powers {
                for _ in 0..power {
                    let own = graph.symbol_node(symbol);
                    factor = graph.mul(factor, own);
                }
            }
            Term {
                coefficient,
                factor,
            }
        });
        terms.collect()
    }
}
