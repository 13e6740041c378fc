//! The way to the results, and the direction of sensitivities: every function takes what costs it least.

use crate::algebra::links;
use crate::algebra::preaccumulation;
use linkage_symbolic::count::time;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::polished;
use linkage_symbolic::schedule::draft;
use linkage_symbolic::{Ex, Graph, NodeId};

use crate::algebra::Direction;
use crate::lower::Formulas;
use crate::model::EvaluatorDef;

use super::State;
use super::quantity::{Requested, Way, request};

/// The results of a function in the plain graph, and how derivatives by parameters among them are found.
#[derive(Debug)]
pub(super) struct Choice<'m> {
    /// As requested.
    scalars: Vec<Ex<'m>>,
    pub(super) formulas: Formulas,
    way: Way,
    /// What is differentiated by parameters.
    sensed: Vec<Ex<'m>>,
    /// What a call costs, once another way has been tried.
    time: Option<u32>,
}

/// What known products of links must spare, as a share of the time. They join what several groups compute, and where two of those wait for each other's roots an optimiser that
/// packs them lets both wait: with 165 instead of 168 that took 47 ns instead of 40.
const WORTH: f64 = 0.02;

impl<'m> Choice<'m> {
    /// What was requested, in the way in which it was.
    pub(super) fn first(inliner: &mut Inliner, requested: Requested<'m>, way: Way) -> Self {
        Self {
            formulas: Formulas::new(inliner, &requested.scalars),
            scalars: requested.scalars,
            way,
            sensed: requested.sensed,
            time: None,
        }
    }

    /// How derivatives by parameters are found; `None` if there are none.
    pub(super) fn direction(&self) -> Option<Direction> {
        (!self.sensed.is_empty()).then_some(self.way.direction)
    }

    /// The results with the definitions as they are now.
    pub(super) fn renewed(&self, inliner: &mut Inliner) -> Vec<NodeId> {
        let formulas = Formulas::new(inliner, &self.scalars);
        formulas.settled(&inliner.target).last
    }

    /// Tries the other ways; the first of equals stays.
    pub(super) fn improve(
        &mut self,
        state: &mut State<'_, 'm>,
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
        directions: &[Direction],
    ) {
        // One after the other: each choice is made with those before.
        if !self.sensed.is_empty() {
            preaccumulation::find_narrow_places(state.algebra, &self.sensed);
            for &direction in directions {
                let way = Way {
                    direction,
                    ..self.way
                };
                self.try_way(state, inliner, definition, way, 0.0);
            }
        }
        if !state.algebra.solutions.other_sides.is_empty() {
            let way = Way {
                other_sides: true,
                ..self.way
            };
            self.try_way(state, inliner, definition, way, 0.0);
        }
        let offered = links::offered_shortcuts(state.algebra);
        if offered.turns {
            let mut way = self.way;
            way.shortcuts.turns = true;
            self.try_way(state, inliner, definition, way, 0.0);
        }
        if offered.products {
            let mut way = self.way;
            way.shortcuts.products = true;
            self.try_way(state, inliner, definition, way, WORTH);
        }
        let formulas = std::mem::take(&mut self.formulas);
        self.formulas = formulas.settled(&inliner.target);
    }

    /// Takes another way if it costs less, by more than a share.
    fn try_way(
        &mut self,
        state: &mut State<'_, 'm>,
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
        way: Way,
        share: f64,
    ) {
        let scalars = request(state, definition, way).scalars;
        if scalars == self.scalars {
            return;
        }
        let formulas = Formulas::new(inliner, &scalars);
        let time_of = |own: &Formulas| time_of(&inliner.target, &own.last);
        let own = *self.time.get_or_insert_with(|| time_of(&self.formulas));
        let other = time_of(&formulas);
        if f64::from(other) < f64::from(own) * (1.0 - share) {
            self.scalars = scalars;
            self.formulas = formulas;
            self.way = way;
            self.time = Some(other);
        }
    }
}

/// What a call costs; what `assemble()` computes is free.
fn time_of(graph: &Graph, outputs: &[NodeId]) -> u32 {
    time(&polished(draft(graph, outputs)))
}
