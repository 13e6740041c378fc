//! States of a core: values of its unknowns, as they are prepared and as Newton's steps leave them.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use crate::algebra::Rule;
use crate::solve::Solver;
use crate::structure::Core;

use super::Meaning;

/// A value of an unknown of the core.
#[derive(Clone, Copy)]
pub(super) enum Part<'m> {
    /// The unit vector of an angle.
    Angle(usize, V2<'m>),
    /// A scaled slide or component of a point.
    Length(SymbolId, Ex<'m>),
    /// A number, as it is.
    Number(SymbolId, Ex<'m>),
}

impl<'m> Part<'m> {
    /// The numbers that it consists of.
    pub(super) fn numbers(self) -> Vec<Ex<'m>> {
        match self {
            Self::Angle(_, unit) => unit.components().collect(),
            Self::Length(_, number) | Self::Number(_, number) => vec![number],
        }
    }

    /// The number that it is; no angle is one.
    pub(super) fn number(self) -> Ex<'m> {
        match self {
            Self::Angle(..) => unreachable!("an angle is no number"),
            Self::Length(_, number) | Self::Number(_, number) => number,
        }
    }

    /// The same unknown with another number.
    pub(super) fn with(self, number: Ex<'m>) -> Self {
        match self {
            Self::Angle(..) => self,
            Self::Length(symbol, _) => Self::Length(symbol, number),
            Self::Number(symbol, _) => Self::Number(symbol, number),
        }
    }

    /// A step of the inverse root: it makes the length of a unit vector exact that is 1 to about eight digits, as those of tables and those
    /// after a correction are.
    pub(super) fn unit_length(self) -> Self {
        match self {
            Self::Angle(angle, unit) => {
                let factor = 1.5 - 0.5 * unit.square();
                Self::Angle(angle, factor * unit)
            }
            Self::Length(..) | Self::Number(..) => self,
        }
    }

    /// The value after a correction: a unit vector turns to second order.
    pub(super) fn corrected(self, correction: Ex<'m>) -> Self {
        match self {
            Self::Angle(angle, Vector([cos, sin])) => {
                let versine = 0.5 * correction.square();
                let fall = sin * correction + cos * versine;
                let rise = cos * correction - sin * versine;
                Self::Angle(angle, Vector([cos - fall, sin + rise]))
            }
            Self::Length(symbol, number) => Self::Length(symbol, number + correction),
            Self::Number(symbol, number) => Self::Number(symbol, number + correction),
        }
    }
}

/// Derivatives by the unknowns of the core follow these rules before there are definitions.
pub(super) fn declare_core(solver: &mut Solver<'_, '_>, core: &[Core]) {
    for (position, core) in core.iter().enumerate() {
        match *core {
            Core::Angle(angle) => solver.declare_angle(angle, 1.0, position),
            Core::Length { symbol, .. } => {
                let group = solver.index;
                let rule = Rule::Unknown { group, position };
                solver.algebra.solutions.set_rule(symbol, rule);
            }
        }
    }
}

/// A number that is prepared for the group.
pub(super) fn prepared_number<'m>(solver: &Solver<'_, 'm>, component: usize) -> Ex<'m> {
    solver
        .algebra
        .source(Source::State(solver.number, component))
}

/// The state that is prepared for a core.
pub(super) fn prepared_state<'m>(solver: &Solver<'_, 'm>, core: &[Core]) -> Vec<Part<'m>> {
    let mut numbers = (0..).map(|component| prepared_number(solver, component));
    let mut number = || numbers.next().expect("there is always another one");
    let parts = core.iter().map(|core| match *core {
        Core::Angle(angle) => Part::Angle(angle, Vector([number(), number()])),
        Core::Length {
            symbol,
            number: true,
            ..
        } => Part::Number(symbol, number()),
        Core::Length { symbol, .. } => Part::Length(symbol, number()),
    });
    parts.collect()
}

/// What the symbols of the core stand for in a state; `unit` is the length of a scaled 1.
pub(super) fn meanings<'m>(
    solver: &Solver<'_, 'm>,
    state: &[Part<'m>],
    unit: Ex<'m>,
) -> Vec<Meaning<'m>> {
    let angles = &solver.algebra.names.angles;
    let meanings = state.iter().flat_map(|part| match *part {
        Part::Angle(angle, Vector([cos, sin])) => {
            let angle = &angles[angle];
            vec![(angle.cos, cos), (angle.sin, sin)]
        }
        Part::Length(symbol, number) => vec![(symbol, unit * number)],
        Part::Number(symbol, number) => vec![(symbol, number)],
    });
    meanings
        .map(|(symbol, value)| Meaning { symbol, value })
        .collect()
}

/// Gives the unknowns of the core their definitions for calls.
pub(super) fn define_core<'m>(solver: &mut Solver<'_, 'm>, called: &[Part<'m>], unit: Ex<'m>) {
    for (position, part) in called.iter().enumerate() {
        match *part {
            Part::Angle(angle, direction) => solver.define_angle(angle, 1.0, direction, position),
            Part::Length(symbol, number) => solver.define_length(symbol, unit * number, position),
            Part::Number(symbol, number) => solver.define_length(symbol, number, position),
        }
    }
}
