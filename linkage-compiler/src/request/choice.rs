//! The direction of sensitivities: every function takes the one that costs it least.

use linkage_symbolic::count::time;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::polished;
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Ex, Graph, NodeId};

use crate::algebra::Direction;
use crate::lower::Formulas;
use crate::model::EvaluatorDef;

use super::State;
use super::quantity::{Requested, request};

/// The results of a function in the plain graph, and how derivatives by parameters among them are found.
#[derive(Debug)]
pub(super) struct Choice<'m> {
    /// As requested.
    scalars: Vec<Ex<'m>>,
    pub(super) formulas: Formulas,
    /// `None` if there are none.
    pub(super) direction: Option<Direction>,
}

impl<'m> Choice<'m> {
    /// What was requested, forward.
    pub(super) fn forward(inliner: &mut Inliner, requested: Requested<'m>) -> Self {
        Self {
            formulas: Formulas::new(inliner, &requested.scalars),
            scalars: requested.scalars,
            direction: requested.by_parameters.then_some(Direction::Forward),
        }
    }

    /// The results with the definitions as they are now.
    pub(super) fn renewed(&self, inliner: &mut Inliner) -> Vec<NodeId> {
        Formulas::new(inliner, &self.scalars).shared
    }

    /// Tries the other directions; the first of equals stays.
    pub(super) fn improve(
        &mut self,
        state: &mut State<'_, 'm>,
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
    ) {
        if self.direction.is_none() {
            return;
        }
        let mut least = time_of(&inliner.target, &self.formulas.shared);
        for direction in [
            Direction::FromResults,
            Direction::FromUnknowns,
            Direction::Gradient,
        ] {
            let scalars = request(state, definition, direction).scalars;
            let formulas = Formulas::new(inliner, &scalars);
            let time = time_of(&inliner.target, &formulas.shared);
            if time < least {
                least = time;
                *self = Self {
                    scalars,
                    formulas,
                    direction: Some(direction),
                };
            }
        }
    }
}

/// What a call costs; what `assemble()` computes is free.
fn time_of(graph: &Graph, outputs: &[NodeId]) -> u32 {
    time(&polished(schedule(graph, outputs, &mut Slots::default())))
}
