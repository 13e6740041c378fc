//! Nonlinear relations between parameters.

use linkage_core::Cycle;
use std::boxed::Box;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use super::DesignError;
use super::cycle::{self, Chosen, Conditions, CycleObjective, Piece, PieceKey};
use super::objective::{Candidates, Evaluate, Objective, Rows};
use linkage_runtime::Parameter;

/// A number of the dimensions that must not be negative.
pub(crate) struct Condition<F> {
    title: String,
    function: F,
}

impl<F> Condition<F> {
    pub(crate) fn new(title: &str, function: F) -> Self {
        Self {
            title: title.to_string(),
            function,
        }
    }
}

impl<M, A, F, const N: usize> Objective<M, A> for Condition<F>
where
    F: Fn(&M) -> (f64, [f64; N]) + Send + Sync,
{
    fn title(&self) -> String {
        self.title.clone()
    }

    fn rows(&self) -> usize {
        1
    }

    fn is_condition(&self) -> bool {
        true
    }

    fn check(&self, _: &Cycle, _: &[Parameter], _: &[usize]) -> Vec<DesignError> {
        Vec::new()
    }

    fn evaluator(&self) -> Box<dyn Evaluate<M, A> + '_> {
        Box::new(self)
    }
}

impl<M, A, F, const N: usize> Evaluate<M, A> for &Condition<F>
where
    F: Fn(&M) -> (f64, [f64; N]),
{
    fn evaluate(&mut self, candidates: &Candidates<'_, M, A>, rows: &mut Rows) {
        for (index, mechanism) in candidates.mechanisms.iter().enumerate() {
            let (value, slopes) = (self.function)(mechanism);
            let (slot, by, _) = rows.row_mut(index, 0);
            *slot = value;
            by.copy_from_slice(&slopes);
        }
    }
}

impl<M, A, F, const N: usize> CycleObjective<M, A, N> for Condition<F>
where
    F: Fn(&M) -> (f64, [f64; N]) + Send + Sync,
{
    fn title(&self) -> String {
        self.title.clone()
    }

    fn is_goal(&self) -> bool {
        false
    }

    fn evaluate(
        &self,
        candidate: &cycle::Candidate<'_, M, A>,
        _: Chosen<'_>,
    ) -> Option<Conditions<N>> {
        let (value, slopes) = (self.function)(candidate.mechanism);
        let piece = Piece {
            key: PieceKey::Nth(0),
            value,
            parameters: slopes,
            auxiliary: Vec::new(),
        };
        Some(Conditions {
            conditions: vec![vec![piece.times(-1.0, 0.0)]],
            ..Conditions::default()
        })
    }

    /// All assemblies have the same dimensions.
    fn known_by(&self, _: &cycle::Candidate<'_, M, A>, _: Chosen<'_>) -> Option<Vec<f64>> {
        Some(Vec::new())
    }
}
