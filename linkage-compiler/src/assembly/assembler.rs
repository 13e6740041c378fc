//! The state while the groups of a mechanism are closed one after the other.

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::ir::Outputs;
use crate::machine::{Machine, Numbers};
use crate::message_format::MessageFormat;
use crate::solve::Solved;

use super::closed_part::InnerPart;
use super::refused_range::{FoundBox, RefusedRange};

/// A position with a smaller margin is taken for a dead point.
pub(super) const SINGULAR: f64 = 1e-6;

/// A mechanism whose groups are closed one after the other.
pub(super) struct Assembly<'a, 'm> {
    pub(super) algebra: &'a Algebra<'m>,
    pub(super) words: MessageFormat<'m>,
    pub(super) nominal: &'a mut Nominal,
    pub(super) reporter: Reporter<'a>,
    pub(super) machine: Machine,
    pub(super) longest: f64,
    /// The largest length of the mechanism.
    pub(super) size: f64,
    /// See [`Reference::found`].
    pub(super) found: Vec<(usize, Vec<f64>)>,
    /// True if polynomials over two inputs are not accurate over the ranges of a group.
    pub(super) needs_slopes: bool,
    /// The first refusal of the declared ranges, of which `nominal` has a part that works.
    pub(super) refused: Option<RefusedRange>,
    /// Parts of which it is not known yet where they are.
    pub(super) parts: Vec<InnerPart<'m>>,
    /// The values of the closing program so far.
    pub(super) values: Vec<f64>,
}

impl<'m> Assembly<'_, 'm> {
    pub(super) fn output(&self, output: usize) -> f64 {
        self.machine.output(&self.values, output)
    }

    /// Centres angles at their estimates, so that each is the one nearest to its estimate at the
    /// reference: all angles, or those of a part.
    pub(super) fn centre(&mut self, part: Option<&InnerPart>) {
        for (index, angle) in self.algebra.names.angles.iter().enumerate() {
            let mut summands = angle.summands().into_iter();
            if part.is_none_or(|part| summands.any(|(unknown, _)| part.has(unknown))) {
                let estimate = angle.estimate(self.nominal);
                self.machine.centres.insert(index, estimate);
            }
        }
    }

    /// Goes on within a part of the declared ranges that works, and keeps the first refusal.
    pub(super) fn work_within(
        &mut self,
        narrower: Nominal,
        refused: RefusedRange,
        found: FoundBox,
    ) {
        *self.nominal = narrower;
        let first = self.refused.get_or_insert(refused);
        match found {
            FoundBox::Largest => {}
            FoundBox::Halved => first.found = found,
        }
    }

    pub(super) fn advance(
        &mut self,
        solved: &Solved<'m>,
        stage: &Outputs,
        start: usize,
        sign: f64,
    ) {
        if let Some(mode) = solved.mode {
            self.machine.modes[mode] = sign;
        }
        // The mode is loaded again: loads of earlier groups' modes do not change.
        let inputs = self.nominal.inputs.clone();
        self.machine
            .advance(&mut self.values, start, stage.end, &inputs);
    }

    /// Returns the unit in which distances from the estimate of an unknown length or vector are
    /// measured.
    pub(super) fn yardstick(&self, unknown: usize) -> f64 {
        match self.algebra.mechanism.unknowns[unknown].ty.dimension() {
            Some(dimension) if dimension.half_lengths == 0 => 1.0,
            _ => self.longest,
        }
    }

    /// A coupled group at the reference inputs, and those inputs that are its own.
    pub(super) fn coupled(&self, number: usize) -> (Numbers<'_>, Vec<f64>) {
        Numbers::new(&self.machine, number, &self.nominal.inputs)
    }
}
