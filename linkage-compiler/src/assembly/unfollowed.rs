//! What is said of a coupled group whose assembly cannot be followed over the range.

use linkage_core::numeric::continuation::Refusal;

use crate::solve::{Prepared, Solved};
use crate::structure::unsolved::OURS;
use crate::words::loop_list;

use super::check::range_of;
use super::reference::Assembly;

impl<'m> Assembly<'_, 'm> {
    pub(super) fn refused(
        &mut self,
        solved: &Solved<'m>,
        prepared: &Prepared<'m>,
        refusal: Refusal,
    ) {
        let loops = loop_list(&solved.group.loops);
        let unknowns = self.words.unknowns(&solved.group.unknowns);
        let [reach, come, are] = match solved.group.loops.len() {
            1 => ["reaches", "comes", "is"],
            _ => ["reach", "come", "are"],
        };
        let place = self.words.at_reference(&self.nominal.inputs);
        let mechanism = self.algebra.mechanism;
        let at_input = |at: f64| {
            let mut inputs = self.nominal.inputs.clone();
            if let Some(&input) = prepared.inputs.first() {
                inputs[input] = at;
            }
            self.words.inputs(&inputs, &prepared.inputs)
        };
        let range = prepared.inputs.first().copied();
        let origins = range
            .filter(|&input| self.nominal.ranges[input].is_some())
            .map_or(
                [mechanism.loops[solved.group.loops[0]].origin; 2],
                |input| range_of(&mechanism.inputs[input]),
            );
        let message = match refusal {
            Refusal::TurningPoint { at } => format!(
                "the mechanism comes apart in this range: {loops} ({unknowns}) {reach} a turning point at {}, where this \
                 assembly meets another one and both end\n\
                 help: restrict the range, or change the lengths so that the links reach each other all the way",
                at_input(at)
            ),
            Refusal::NotConverging { at } => format!(
                "{loops} ({unknowns}) {come} too near to a turning point at {} for a table over this range; {OURS}\n\
                 help: restrict the range, or choose lengths away from the turning point",
                at_input(at)
            ),
            _ => format!(
                "{loops} ({unknowns}) {are} singular{place}, a dead point\n\
                 help: choose a reference input or lengths away from the dead point"
            ),
        };
        self.reporter.error_between(origins, message);
    }
}
