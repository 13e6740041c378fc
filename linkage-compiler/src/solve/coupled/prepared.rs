//! The states that are prepared for a coupled group, and the meanings of its unknowns.

use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::{Ex, Graph, substitute};

use crate::algebra::{Algebra, Nominal};
use crate::structure::Core;

use super::state::Meaning;
use super::system::System;

/// The prepared states of a coupled group, and the definitions that use them.
#[derive(Clone, Debug)]
pub(crate) struct Prepared<'m> {
    /// Index among the coupled groups.
    pub(crate) number: usize,
    /// The inputs that the group depends on.
    pub(crate) inputs: Vec<usize>,
    /// Numbers in a state.
    pub(crate) size: usize,
    /// The terms that a grid over its inputs stores in a cell.
    pub(crate) in_cells: Terms,
    /// Polynomials of which the assemblies are the real roots.
    pub(crate) system: System<'m>,
    /// One step: the new state, the square of the correction, the determinant.
    pub(crate) step: Vec<Ex<'m>>,
    /// The closure errors of the core's equations.
    pub(super) equations: Vec<Ex<'m>>,
    /// The sum of the lengths of its links.
    pub(crate) reach: Ex<'m>,
    /// The factor of lengths in states.
    pub(super) scale: Ex<'m>,
    pub(super) core: Vec<Core>,
    pub(super) raw: Vec<Meaning<'m>>,
    pub(super) called: Vec<Meaning<'m>>,
    pub(super) beside: Vec<Meaning<'m>>,
}

/// The meaning that an unknown of a core has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Version {
    /// The prepared state, without a step.
    Raw,
    /// After the steps of a call.
    Called,
    /// After the steps that other dimensions need.
    Beside,
}

/// The estimate of a number of a state.
#[derive(Clone, Copy, Debug)]
struct Estimated {
    value: f64,
    length: bool,
}

impl<'m> Prepared<'m> {
    /// The state where the unknowns are estimated. Estimates are of the default mechanism: lengths
    /// grow with the links.
    pub(crate) fn estimate(&self, algebra: &Algebra<'m>, nominal: &Nominal) -> Vec<Ex<'m>> {
        let growth = self.reach * self.scale;
        let reach = nominal.evaluate(&[self.reach])[0];
        let estimates = self.estimated(algebra, nominal).into_iter();
        let numbers = estimates.map(|estimated| {
            if estimated.length {
                algebra.graph.number(estimated.value / reach) * growth
            } else {
                algebra.graph.number(estimated.value)
            }
        });
        numbers.collect()
    }

    /// The same in numbers, of the default mechanism.
    pub(crate) fn estimate_of_default(&self, algebra: &Algebra<'m>, nominal: &Nominal) -> Vec<f64> {
        let scale = nominal.evaluate(&[self.scale])[0];
        let estimates = self.estimated(algebra, nominal).into_iter();
        let numbers = estimates.map(|estimated| {
            if estimated.length {
                scale * estimated.value
            } else {
                estimated.value
            }
        });
        numbers.collect()
    }

    /// The closure errors of the core's equations in a state.
    pub(crate) fn residuals(&self) -> Vec<Ex<'m>> {
        let meanings = self
            .raw
            .iter()
            .map(|meaning| (meaning.symbol, meaning.value));
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
        let estimates = self.core.iter().flat_map(|core| match *core {
            Core::Angle(angle) => {
                let (sin, cos) = names.angles[angle].estimate(nominal).sin_cos();
                [cos, sin].map(number).to_vec()
            }
            Core::Length { symbol, number, .. } => vec![Estimated {
                value: names.estimate(symbol, nominal),
                length: !number,
            }],
        });
        estimates.collect()
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

    /// Describes the method by which calls find its unknowns.
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
