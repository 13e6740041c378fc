//! The strategy for the results, and the direction of sensitivities: every function takes the
//! cheapest.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::{Ex, NodeId};

use crate::algebra::Direction;
use crate::algebra::derivatives::preaccumulation;
use crate::lower::Formulas;
use crate::model::EvaluatorDef;

use super::quantity::{Requested, Strategy, request};
use super::state::State;

/// The results of a function in the plain graph, and the method for derivatives by parameters among
/// them.
#[derive(Debug)]
pub(super) struct Choice<'m> {
    /// The scalars as requested.
    scalars: Vec<Ex<'m>>,
    pub(super) formulas: Formulas,
    strategy: Strategy,
    /// The scalars that are differentiated by parameters.
    sensed: Vec<Ex<'m>>,
    /// The time of a call, once another variant has been tried.
    time: Option<u32>,
}

/// The share of the time that known products of links must save. They join the results of several
/// groups, and an optimiser that packs two groups that wait for each other's roots lets both wait:
/// with 165 instead of 168, a call took 47 ns instead of 40.
const WORTH: f64 = 0.02;

impl<'m> Choice<'m> {
    /// Returns the results as requested, computed in the requested way.
    pub(super) fn first(
        inliner: &mut Inliner,
        requested: Requested<'m>,
        strategy: Strategy,
    ) -> Self {
        Self {
            formulas: Formulas::new(inliner, &requested.scalars),
            scalars: requested.scalars,
            strategy,
            sensed: requested.sensed,
            time: None,
        }
    }

    /// Returns the direction of the derivatives by parameters; `None` if there are none.
    pub(super) fn direction(&self) -> Option<Direction> {
        (!self.sensed.is_empty()).then_some(self.strategy.direction)
    }

    /// The results with the definitions as they are now.
    pub(super) fn renewed(&self, inliner: &mut Inliner) -> Vec<NodeId> {
        let formulas = Formulas::new(inliner, &self.scalars);
        formulas.settled(&inliner.target).last
    }

    /// Tries the other strategies; the first of equals stays.
    pub(super) fn improve(
        &mut self,
        state: &mut State<'_, 'm>,
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
        directions: &[Direction],
    ) {
        // One after the other: each choice is made with those before.
        if !self.sensed.is_empty() {
            preaccumulation::find_intermediates(state.algebra, &self.sensed);
            for &direction in directions {
                let strategy = Strategy {
                    direction,
                    ..self.strategy
                };
                self.try_strategy(state, inliner, definition, strategy, 0.0);
            }
        }
        if !state.algebra.solutions.via_sliders.is_empty() {
            let strategy = Strategy {
                other_sides: true,
                ..self.strategy
            };
            self.try_strategy(state, inliner, definition, strategy, 0.0);
        }
        let offered = state.algebra.derivatives.offered;
        if offered.turns {
            let mut strategy = self.strategy;
            strategy.shortcuts.turns = true;
            self.try_strategy(state, inliner, definition, strategy, 0.0);
        }
        if offered.products {
            let mut strategy = self.strategy;
            strategy.shortcuts.products = true;
            self.try_strategy(state, inliner, definition, strategy, WORTH);
        }
        let formulas = std::mem::take(&mut self.formulas);
        self.formulas = formulas.settled(&inliner.target);
    }

    /// Takes another strategy if it costs less, by more than a share.
    fn try_strategy(
        &mut self,
        state: &mut State<'_, 'm>,
        inliner: &mut Inliner,
        definition: &EvaluatorDef,
        strategy: Strategy,
        share: f64,
    ) {
        let scalars = request(state, definition, strategy).scalars;
        if scalars == self.scalars {
            return;
        }
        let formulas = Formulas::new(inliner, &scalars);
        let graph = &inliner.target;
        let before = *self.time.get_or_insert_with(|| self.formulas.time(graph));
        let other = formulas.time(graph);
        if f64::from(other) < f64::from(before) * (1.0 - share) {
            self.scalars = scalars;
            self.formulas = formulas;
            self.strategy = strategy;
            self.time = Some(other);
        }
    }
}
