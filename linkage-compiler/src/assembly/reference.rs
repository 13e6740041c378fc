//! Closes the loops at the reference input: the start estimates choose the assembly mode of each
//! group.

use linkage_core::numeric::choose_assembly::{Ambiguity, choose_assembly};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::assembly::{estimates, listing, parts, refusal};
use crate::diagnostic::Reporter;
use crate::ir::{ClosurePrograms, Outputs};
use crate::machine::{Machine, Reference};
use crate::message_format::MessageFormat;
use crate::solve::{Formulation, Prepared, Solved};

use super::assembler::Assembly;
use super::assembler::SINGULAR;
use super::check::report_unfollowed;
use super::closed_part::InnerPart;
use super::estimates::{Choice, Position};
use super::follow::follow_angles;
use super::refusal::Verdict;
use super::refused_range::RefusedRange;
use super::sizes::Sizes;

/// Chooses the modes, and reports groups that do not close, are singular or ambiguous.
///
/// If declared ranges are refused, `nominal` has a part of them that works, and the refusal is
/// returned. Returns `None` if polynomials over two inputs are not accurate over the ranges of a
/// group.
pub(crate) fn assemble_reference<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    closure: ClosurePrograms,
    nominal: &mut Nominal,
    parts: Vec<InnerPart<'m>>,
    reporter: Reporter,
) -> Option<(Reference, Option<RefusedRange>)> {
    let machine = Machine::new(closure, formulation, nominal);
    let Sizes { longest, largest } = Sizes::new(algebra, formulation, nominal);
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
        refused: None,
        values: Vec::new(),
    };
    assembly.centre(None);
    let mut scales = Vec::new();
    let mut closed = true;
    let mut start = 0;
    for (index, solved) in formulation.groups.iter().enumerate() {
        parts::settle_parts(&mut assembly, formulation, index);
        let stage = assembly.machine.closure.groups[index].clone();
        closed &= close(&mut assembly, solved, &stage, start, closed);
        let slack = assembly.output(stage.slack);
        let scale = assembly.output(stage.slack_scale);
        scales.push(1.0 / if slack < 0.0 { -scale } else { scale });
        start = stage.end;
    }
    let reference = Reference {
        machine: assembly.machine,
        scales,
        closed,
        longest,
        found: assembly.found,
    };
    (!assembly.needs_slopes).then_some((reference, assembly.refused))
}

/// One candidate solution of a group.
struct Candidate {
    sign: f64,
    gap: f64,
    margin: f64,
    position: Position,
}

/// Closes one group; returns false if that was not possible. `closed` is true if all groups before
/// it closed.
fn close<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    stage: &Outputs,
    start: usize,
    closed: bool,
) -> bool {
    if let Some(prepared) = &solved.prepared {
        // The known values of a prepared group come from groups before this one.
        if !closed
            || !follow_before(assembly, prepared)
            || !listing::close_coupled(assembly, solved, prepared)
        {
            assembly.advance(solved, stage, start, 1.0);
            return false;
        }
    }
    let candidates: Vec<Candidate> = match solved.mode {
        None => vec![candidate(assembly, solved, stage, start, 1.0)],
        Some(_) => [1.0, -1.0]
            .map(|sign| candidate(assembly, solved, stage, start, sign))
            .into(),
    };
    let distances = candidates.iter().map(|one| one.position.distance);
    let nearest = choose_assembly(distances, Ambiguity::AS_WRITTEN).expect("there is a candidate");
    let chosen = &candidates[nearest.index];
    let (gap, margin, sign) = (chosen.gap, chosen.margin, chosen.sign);
    if solved.mode.is_some() {
        assembly.advance(solved, stage, start, sign);
    }
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
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
        refusal::refuse(assembly, solved, verdict);
        return false;
    }
    let loops = assembly.words.loops(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    let mut positions: Vec<&Position> = candidates.iter().map(|one| &one.position).collect();
    positions.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    if nearest.ambiguous {
        if let [a, b] = &candidates[..]
            && !estimates::lacks_estimates(assembly, solved, &positions, Choice::Listed)
        {
            let message = format!(
                "the start estimates of {unknowns} lie equally near to two assembly modes of {loops}{position}: \
                 `{}` at distance {:.4} and `{}` at distance {:.4}\n\
                 help: move the estimates towards the assembly that is meant",
                estimates::shown(assembly, &a.position),
                a.position.distance,
                estimates::shown(assembly, &b.position),
                b.position.distance
            );
            let unknown = solved.group.unknowns.first();
            let unknown_origin = unknown.map(|&u| assembly.algebra.mechanism.unknowns[u].origin);
            assembly
                .reporter
                .error(unknown_origin.unwrap_or(origin), message);
        }
        return false;
    }
    estimates::keep_found(assembly, &chosen.position);
    // A coupled group has been compared where its assemblies were listed.
    solved.prepared.is_some()
        || estimates::meets_estimates(assembly, solved, &positions, Choice::Listed)
}

/// Finds the turns of angles on which a coupled group depends; false if that was not possible.
fn follow_before<'m>(assembly: &mut Assembly<'_, 'm>, prepared: &Prepared) -> bool {
    let closure = &assembly.machine.closure;
    let count = closure.coupled[prepared.number].turning;
    let angles = closure.valued[..count].to_vec();
    let unfollowed = follow_angles(
        assembly.algebra,
        assembly.nominal,
        &mut assembly.machine,
        &angles,
    );
    if let Some(unfollowed) = unfollowed {
        report_unfollowed(assembly.algebra, unfollowed, &mut assembly.reporter);
    }
    unfollowed.is_none()
}

fn candidate<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    stage: &Outputs,
    start: usize,
    sign: f64,
) -> Candidate {
    assembly.advance(solved, stage, start, sign);
    let unknowns = stage.unknowns.iter().map(|&(unknown, output)| {
        let value = match assembly.algebra.names.bound[unknown] {
            Bound::Angle(_) => {
                let unit = [output, output + 1].map(|k| assembly.output(k));
                vec![estimates::angle_near_estimate(assembly, unknown, unit)]
            }
            Bound::Lengths(_) => {
                let count = assembly.algebra.names.components_of(unknown);
                (0..count).map(|k| assembly.output(output + k)).collect()
            }
        };
        (unknown, value)
    });
    let links = stage.links.iter().map(|&(angle, output)| {
        let unit = [output, output + 1].map(|k| assembly.output(k));
        estimates::link_from_estimate(assembly, angle, unit)
    });
    let links: Vec<f64> = links.collect();
    let position = estimates::position(assembly, unknowns.collect(), &links);
    Candidate {
        sign,
        gap: assembly.output(stage.gap),
        margin: assembly.output(stage.margin),
        position,
    }
}
