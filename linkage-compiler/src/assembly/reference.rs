//! Closing the loops at the reference input: the assembly mode of each group, chosen by the start estimates.

use crate::assembly::estimates;
use crate::assembly::listing;
use crate::assembly::parts;
use crate::assembly::refusal;
use linkage_core::numeric::choose_assembly::{Ambiguity, choose_assembly};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::diagnostic::Reporter;
use crate::ir::{Closing, Outputs};
use crate::message_format::loop_list;
use crate::solve::{Formulation, Prepared, Solved};

use super::check::report_unfollowed;
use super::estimates::{Choice, Position};
use super::follow::follow_angles;
use super::machine::Machine;
use super::parts::InnerPart;
use super::refusal::Verdict;
use super::sizes::Sizes;
use crate::message_format::MessageFormat;

/// Below this margin a position cannot be told from a dead point.
pub(super) const SINGULAR: f64 = 1e-6;

/// The mechanism assembled at the reference input.
#[derive(Debug)]
pub(crate) struct Reference {
    pub(crate) machine: Machine,
    /// Factors that make the slack of each group positive and about 1 at the reference.
    pub(crate) scales: Vec<f64>,
    /// True if all groups closed.
    pub(crate) closed: bool,
    /// The length that counts like a radian where assemblies are compared with estimates.
    pub(crate) longest: f64,
    /// What unknowns without an estimate are at the reference, with their numbers.
    pub(crate) found: Vec<(usize, Vec<f64>)>,
    /// Whether polynomials over two inputs do not serve the ranges of a group.
    pub(crate) needs_slopes: bool,
}

/// Chooses the modes; what does not close, is singular or ambiguous is reported.
pub(crate) fn assemble_reference<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    closing: Closing,
    nominal: &mut Nominal,
    parts: Vec<InnerPart<'m>>,
    reporter: Reporter,
) -> Reference {
    let machine = Machine::new(closing, formulation, nominal);
    let Sizes { longest, largest } = Sizes::of(algebra, formulation, nominal);
    let mut assembly = Assembly {
        words: MessageFormat::new(algebra.mechanism),
        algebra,
        nominal,
        reporter,
        machine,
        longest,
        size: largest,
        parts,
        found: Vec::new(),
        needs_slopes: false,
        values: Vec::new(),
    };
    assembly.centre(None);
    let mut scales = Vec::new();
    let mut closed = true;
    let mut start = 0;
    for (index, solved) in formulation.groups.iter().enumerate() {
        parts::settle_parts(&mut assembly, formulation, index);
        let stage = assembly.machine.closing.groups[index].clone();
        closed &= assembly.close(solved, &stage, start, closed);
        let slack = assembly.output(stage.slack);
        let scale = assembly.output(stage.slack_scale);
        scales.push(1.0 / if slack < 0.0 { -scale } else { scale });
        start = stage.end;
    }
    Reference {
        machine: assembly.machine,
        scales,
        closed,
        longest,
        found: assembly.found,
        needs_slopes: assembly.needs_slopes,
    }
}

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
    /// See [`Reference::needs_slopes`].
    pub(super) needs_slopes: bool,
    /// Parts of which it is not known yet where they are.
    pub(super) parts: Vec<InnerPart<'m>>,
    values: Vec<f64>,
}

/// One candidate solution of a group.
struct Candidate {
    sign: f64,
    gap: f64,
    margin: f64,
    position: Position,
}

impl<'m> Assembly<'_, 'm> {
    fn output(&self, output: usize) -> f64 {
        self.machine.output(&self.values, output)
    }

    /// At the reference every angle is the one nearest to its estimate: all of them, or those of a part.
    pub(super) fn centre(&mut self, part: Option<&InnerPart>) {
        for (index, angle) in self.algebra.names.angles.iter().enumerate() {
            let mut summands = angle.summands().into_iter();
            if part.is_none_or(|part| summands.any(|(unknown, _)| part.has(unknown))) {
                let estimate = angle.estimate(self.nominal);
                self.machine.centres.insert(index, estimate);
            }
        }
    }

    /// Closes one group; false if that was not possible. `closed` says whether all groups before it closed.
    fn close(&mut self, solved: &Solved<'m>, stage: &Outputs, start: usize, closed: bool) -> bool {
        if let Some(prepared) = &solved.prepared {
            // What is known of it comes from groups before this one.
            if !closed
                || !self.follow_before(prepared)
                || !listing::close_coupled(self, solved, prepared)
            {
                self.advance(solved, stage, start, 1.0);
                return false;
            }
        }
        let candidates: Vec<Candidate> = match solved.mode {
            None => vec![self.candidate(solved, stage, start, 1.0)],
            Some(_) => [1.0, -1.0]
                .map(|sign| self.candidate(solved, stage, start, sign))
                .into(),
        };
        let distances = candidates.iter().map(|one| one.position.distance);
        let nearest =
            choose_assembly(distances, Ambiguity::AS_WRITTEN).expect("there is a candidate");
        let chosen = &candidates[nearest.index];
        let (gap, margin, sign) = (chosen.gap, chosen.margin, chosen.sign);
        if solved.mode.is_some() {
            self.advance(solved, stage, start, sign);
        }
        let origin = self.algebra.mechanism.loops[solved.group.loops[0]].origin;
        let undefined = gap.is_nan() || margin.is_nan();
        if undefined && !closed {
            // A group before this one did not close and has been reported.
            return false;
        }
        // With a sound margin, it is not the group that is singular.
        let sound = solved.closed.two_modes || margin >= SINGULAR;
        let verdict = if gap.is_nan() && sound {
            Some(Verdict::NotFinite)
        } else if gap > 0.0 {
            Some(Verdict::Open(gap))
        } else if undefined || margin < SINGULAR {
            Some(Verdict::Singular)
        } else {
            None
        };
        if let Some(verdict) = verdict {
            refusal::refuse(self, solved, verdict);
            return false;
        }
        let loops = loop_list(&solved.group.loops);
        let unknowns = self.words.unknowns(&solved.group.unknowns);
        let place = self.words.at_reference(&self.nominal.inputs);
        let mut positions: Vec<&Position> = candidates.iter().map(|one| &one.position).collect();
        positions.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        if nearest.ambiguous {
            if let [a, b] = &candidates[..]
                && !estimates::lacks_estimates(self, solved, &positions, Choice::Listed)
            {
                let message = format!(
                    "the start estimates of {unknowns} lie equally near to two assembly modes of {loops}{place}: \
                     `{}` at distance {:.4} and `{}` at distance {:.4}\n\
                     help: move the estimates towards the assembly that is meant",
                    estimates::shown(self, &a.position),
                    a.position.distance,
                    estimates::shown(self, &b.position),
                    b.position.distance
                );
                let unknown = solved.group.unknowns.first();
                let own = unknown.map(|&u| self.algebra.mechanism.unknowns[u].origin);
                self.reporter.error(own.unwrap_or(origin), message);
            }
            return false;
        }
        estimates::keep_found(self, &chosen.position);
        // A coupled group has been compared where its assemblies were listed.
        solved.prepared.is_some()
            || estimates::meets_estimates(self, solved, &positions, Choice::Listed)
    }

    /// Finds the turns of angles on which a coupled group depends; false if that was not possible.
    fn follow_before(&mut self, prepared: &Prepared) -> bool {
        let closing = &self.machine.closing;
        let count = closing.coupled[prepared.number].turning;
        let angles = closing.valued[..count].to_vec();
        let unfollowed = follow_angles(self.algebra, self.nominal, &mut self.machine, &angles);
        if let Some(unfollowed) = unfollowed {
            report_unfollowed(self.algebra, unfollowed, &mut self.reporter);
        }
        unfollowed.is_none()
    }

    fn advance(&mut self, solved: &Solved<'m>, stage: &Outputs, start: usize, sign: f64) {
        if let Some(mode) = solved.mode {
            self.machine.modes[mode] = sign;
        }
        // The mode is loaded anew: loads of earlier groups' modes do not change.
        let inputs = self.nominal.inputs.clone();
        self.machine
            .advance(&mut self.values, start, stage.end, &inputs);
    }

    /// What distances from the estimate of an unknown length or vector are measured by.
    pub(super) fn yardstick(&self, unknown: usize) -> f64 {
        match self.algebra.mechanism.unknowns[unknown].ty.dimension() {
            Some(dimension) if dimension.half_lengths == 0 => 1.0,
            _ => self.longest,
        }
    }

    fn candidate(
        &mut self,
        solved: &Solved<'m>,
        stage: &Outputs,
        start: usize,
        sign: f64,
    ) -> Candidate {
        self.advance(solved, stage, start, sign);
        let unknowns = stage.unknowns.iter().map(|&(unknown, output)| {
            let value = match self.algebra.names.bound[unknown] {
                Bound::Angle(_) => {
                    let unit = [output, output + 1].map(|k| self.output(k));
                    vec![estimates::angle_near_estimate(self, unknown, unit)]
                }
                Bound::Lengths(_) => {
                    let count = self.algebra.names.components_of(unknown);
                    (0..count).map(|k| self.output(output + k)).collect()
                }
            };
            (unknown, value)
        });
        let position = estimates::position(self, unknowns.collect());
        Candidate {
            sign,
            gap: self.output(stage.gap),
            margin: self.output(stage.margin),
            position,
        }
    }
}
