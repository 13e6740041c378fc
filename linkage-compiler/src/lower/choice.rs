//! The direction of sensitivities: every function takes the one that costs it least.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Graph, NodeId, share_multiples};

use crate::algebra::{Algebra, Direction};
use crate::forces::Forces;
use crate::formulate::Formulation;
use crate::model::EvaluatorDef;

use super::cost::cost;
use super::quantity::{Requested, request};

/// The results of a function in the plain graph, and how derivatives by parameters among them are found.
#[derive(Clone, Debug, Default)]
pub(super) struct Choice {
    /// As requested.
    nodes: Vec<NodeId>,
    pub(super) outputs: Vec<NodeId>,
    /// `None` if there are none.
    pub(super) direction: Option<Direction>,
}

impl Choice {
    /// What was requested, forward.
    pub(super) fn forward(algebra: &Algebra, inliner: &mut Inliner, requested: &Requested) -> Self {
        Self {
            nodes: requested.nodes.clone(),
            outputs: plain(algebra, inliner, &requested.nodes),
            direction: requested.by_parameters.then_some(Direction::Forward),
        }
    }

    /// The results with the definitions as they are now.
    pub(super) fn renewed(&self, algebra: &Algebra, inliner: &mut Inliner) -> Vec<NodeId> {
        plain(algebra, inliner, &self.nodes)
    }

    /// Tries the other directions; the first of equals stays.
    pub(super) fn improve(
        &mut self,
        (algebra, forces, formulation): (&mut Algebra, &mut Forces, &Formulation),
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
    ) {
        if self.direction.is_none() {
            return;
        }
        let mut least = cost_of(&inliner.target, &self.outputs);
        for direction in [
            Direction::FromResults,
            Direction::FromUnknowns,
            Direction::Gradient,
        ] {
            let requested = request(
                (&mut *algebra, &mut *forces, formulation),
                definition,
                direction,
            );
            let outputs = plain(algebra, inliner, &requested.nodes);
            let cost = cost_of(&inliner.target, &outputs);
            if cost < least {
                least = cost;
                *self = Self {
                    nodes: requested.nodes,
                    outputs,
                    direction: Some(direction),
                };
            }
        }
    }
}

fn plain(algebra: &Algebra, inliner: &mut Inliner, nodes: &[NodeId]) -> Vec<NodeId> {
    let outputs = super::copy(inliner, algebra, nodes);
    share_multiples(&mut inliner.target, &outputs)
}

/// What a call costs; what `assemble()` computes is free.
fn cost_of(graph: &Graph, outputs: &[NodeId]) -> u32 {
    cost(&schedule(graph, outputs, &mut Slots::default()))
}
