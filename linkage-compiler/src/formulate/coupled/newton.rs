//! Newton steps of a core, from a state to the next, and what a solution must stand.

use std::collections::HashMap;

use linkage_symbolic::program::{Binary, Source, Ternary};
use linkage_symbolic::{NodeId, substitute};

use crate::formulate::Solver;
use crate::structure::Core;

use super::equations::Equations;

/// How a solution is reached.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    pub(super) steps: usize,
    /// The largest first correction.
    pub(super) first: Option<f64>,
}

/// A step from a state.
pub(super) struct Step {
    pub(super) corrections: Vec<NodeId>,
    /// Unit vectors of length 1 and lengths, as the corrections apply to them.
    start: Vec<Vec<NodeId>>,
    pub(super) size2: NodeId,
    pub(super) determinant: NodeId,
}

impl Solver<'_, '_> {
    /// The correction of a state.
    pub(super) fn step(
        &mut self,
        equations: &Equations,
        core: &[Core],
        state: &[Vec<NodeId>],
    ) -> Step {
        let start: Vec<Vec<NodeId>> = state
            .iter()
            .map(|numbers| self.unit_length(numbers))
            .collect();
        let mut map = HashMap::new();
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
    pub(super) fn corrected(&mut self, step: &Step, corrections: &[NodeId]) -> Vec<Vec<NodeId>> {
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

    /// The state after some steps, NaN unless the first correction is within the plan's limit, the last one tiny, every one much
    /// smaller than the one before, and the determinant keeps its sign and, from a table, half of its size.
    pub(super) fn solution(
        &mut self,
        equations: &Equations,
        core: &[Core],
        state: &[Vec<NodeId>],
        floor: NodeId,
        plan: Plan,
    ) -> Vec<Vec<NodeId>> {
        let Plan { steps, first } = plan;
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
            let first = before.is_none().then_some(first).flatten();
            let first = first.map(|first| graph.constant(first * first));
            let allowed = before.map(|before| {
                let share = graph.constant(1.0 / 16.0);
                let share = graph.mul(share, before);
                graph.binary(Binary::Max, share, limit2)
            });
            let allowed = if last {
                Some(limit2)
            } else {
                allowed.or(first)
            };
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
}
