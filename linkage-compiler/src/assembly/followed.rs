//! Closes a coupled group whose assemblies cannot be listed: the intended one is followed from its
//! estimates.

use linkage_core::numeric::continuation::{Astray, from_estimate};
use linkage_core::numeric::roots::Unlisted;

use crate::assembly::{at_state, coupled_state, estimates, refusal};
use crate::mobility::{Nearest, freedom, nearest};
use crate::solve::{Prepared, Solved};
use crate::structure::fault::OURS;

use super::assembler::Assembly;
use super::coupled_state::Candidate;
use super::estimates::Choice;
use super::refusal::WITHIN_RANGE;

/// Shares of the closure error at the estimates: if more is left, the dead point is at the
/// estimates; if less is left, it is the assembly.
const ALL: f64 = 0.9999;
const NOTHING: f64 = 1e-6;

/// The description of the end of a path.
struct Ends {
    fact: String,
    help: String,
}

/// Closes a coupled group from its estimates; returns false if that was not possible. `unlisted` is
/// the reason why its assemblies were not listed, if that was tried.
pub(super) fn close_followed<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    unlisted: Option<Unlisted>,
) -> bool {
    if has_no_estimates(assembly, solved, unlisted) {
        return false;
    }
    let found = match followed(assembly, prepared) {
        Ok(found) => found,
        Err(astray) => {
            leads_nowhere(assembly, solved, prepared, astray, unlisted);
            return false;
        }
    };
    if !estimates::meets_estimates(assembly, solved, &[&found.position], Choice::Followed) {
        return false;
    }
    let group = &mut assembly.machine.closure.coupled[prepared.number];
    group.followed = true;
    group.terms.clear();
    coupled_state::prepare(assembly, solved, prepared, &found.state)
}

fn followed<'m>(assembly: &Assembly<'_, 'm>, prepared: &Prepared<'m>) -> Result<Candidate, Astray> {
    let (mut numbers, inputs) = assembly.coupled(prepared.number);
    let group = &assembly.machine.closure.coupled[prepared.number];
    let estimate = prepared.estimate_of_default(assembly.algebra, assembly.nominal);
    let state = from_estimate(&mut numbers, &group.variables, &inputs, &estimate)?;
    let placed = numbers.run(&group.placed, &state);
    Ok(coupled_state::candidate_of(assembly, group, state, &placed))
}

/// Reports unknowns without an estimate; false if there is none.
fn has_no_estimates<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    unlisted: Option<Unlisted>,
) -> bool {
    let unknowns = solved.group.unknowns.iter().copied();
    let open: Vec<usize> = unknowns
        .filter(|&k| !estimates::is_estimated(assembly, k))
        .collect();
    let [first, ..] = open[..] else {
        return false;
    };
    let message = format!(
        "{} {} no estimate{}, and {} followed from estimates, since the assemblies cannot be listed: {}; {OURS}\n\
             help: write estimates, as they are read off a drawing",
        assembly.words.unknowns(&open),
        if open.len() == 1 { "has" } else { "have" },
        assembly.words.at_reference(&assembly.nominal.inputs),
        match solved.group.loops.len() {
            1 => format!("{} is", assembly.words.loops(&solved.group.loops)),
            _ => format!("{} are", assembly.words.loops(&solved.group.loops)),
        },
        not_listed(unlisted),
    );
    let origin = assembly.algebra.mechanism.unknowns[first].origin;
    assembly.reporter.error(origin, message);
    true
}

/// Says that the estimates of a group do not lead to an assembly.
fn leads_nowhere<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    astray: Astray,
    unlisted: Option<Unlisted>,
) {
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    let are = match solved.group.loops.len() {
        1 => "is",
        _ => "are",
    };
    let loops = assembly.words.loops(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let why = not_listed(unlisted);
    let message = match astray {
        Astray::NoValue
            if refusal::loops_without_value(assembly, &solved.group.loops).is_some() =>
        {
            return without_equations(assembly, solved);
        }
        Astray::Movable(ref states) => format!(
            "{loops} ({unknowns}) cannot be solved{position}: where the estimates lead, {}\n\
                 help: look for links that coincide, guides that are parallel, lengths that are zero, and a loop that repeats another",
            freedom::freedom(&at_state::standing(assembly, prepared, &states[0])).unwrap_or_else(
                || {
                    let moved = moved(assembly, prepared, states);
                    format!(
                        "{} can change and the loops stay closed",
                        assembly.words.unknowns(&moved)
                    )
                }
            ),
        ),
        Astray::DeadPoint { left, ref at } if left > NOTHING && left < ALL => {
            let Ends { fact, help } = way_ends(assembly, prepared, at);
            format!(
                "{loops} ({unknowns}) {are} followed{position} from the estimates, and the way ends where {:.1} % of what the \
                     estimates miss by is taken back{fact}. The assemblies cannot be listed: {why}; {OURS}\n\
                     help: {help}",
                100.0 * (1.0 - left),
            )
        }
        Astray::NoValue | Astray::DeadPoint { .. } | Astray::Singular(_) => format!(
            "{loops} ({unknowns}) {are} singular{position} where the estimates {}{}; the assemblies cannot be listed: {why}\n\
                 help: look for links that coincide, guides that are parallel, lengths that are zero, and a loop that repeats another; or write \
                 estimates, or a reference input, away from a dead point",
            match astray {
                Astray::DeadPoint { left, .. } if left < ALL => "lead",
                Astray::Singular(_) => "lead",
                _ => "are",
            },
            freedom::freedom(&match astray {
                Astray::DeadPoint { ref at, .. } | Astray::Singular(ref at) => {
                    at_state::standing(assembly, prepared, at)
                }
                _ => {
                    let estimate = prepared.estimate_of_default(assembly.algebra, assembly.nominal);
                    at_state::standing(assembly, prepared, &estimate)
                }
            })
            .map_or_else(String::new, |freedom| format!(": there {freedom}")),
        ),
    };
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
    assembly.reporter.error(origin, message);
}

/// Returns the known facts about the end of a path: a dead point, and the position after it at
/// which the loops come nearest to closing.
fn way_ends<'m>(assembly: &Assembly<'_, 'm>, prepared: &Prepared<'m>, at: &[f64]) -> Ends {
    let end = at_state::standing(assembly, prepared, at);
    let dead = freedom::freedom(&end);
    let dead = dead.map_or_else(String::new, |freedom| {
        format!(", at a dead point: there {freedom}")
    });
    let Some(Nearest { missing, motion }) = nearest::nearest(&end) else {
        return Ends {
                fact: dead,
                help: "write estimates that are nearer to the assembly that is meant; or change a length, if the links do not reach each other"
                    .to_owned(),
            };
    };
    let motion = motion.map_or_else(String::new, |motion| {
        format!("; there {motion}, which closes none of them")
    });
    Ends {
            fact: format!(
                "{dead}. Where the loops come nearest to closing, their sides differ still, in {missing}{motion}"
            ),
            help: "change these lengths by about as much; or write estimates that are nearer to another assembly, if there is one".to_owned(),
        }
}

/// The unknowns that differ between two states.
fn moved<'m>(
    assembly: &Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    states: &[Vec<f64>; 2],
) -> Vec<usize> {
    let (numbers, _) = assembly.coupled(prepared.number);
    let group = &assembly.machine.closure.coupled[prepared.number];
    let [a, b] = states.each_ref().map(|state| {
        let placed = numbers.run(&group.placed, state);
        coupled_state::candidate_of(assembly, group, state.clone(), &placed).position
    });
    estimates::differing(&a, &b, |unknown| assembly.yardstick(unknown))
}

/// Says that the equations of a group have no value.
pub(super) fn without_equations<'m>(assembly: &mut Assembly<'_, 'm>, solved: &Solved<'m>) {
    let loops = assembly.words.loops(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    if let Some((part, fact)) = refusal::loops_without_value(assembly, &solved.group.loops) {
        let fact = format!("{loops} ({unknowns}) cannot be solved{position}: {fact}");
        assembly.reporter.error_with_help(part, fact, WITHIN_RANGE);
        return;
    }
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
    assembly.reporter.error(
            origin,
            format!(
                "{loops} ({unknowns}) cannot be solved{position}: what is known of it is not a finite number\n\
                 help: look for a division by zero, or a root or an arc function out of its range"
            ),
        );
}

/// Why the assemblies of a group are not listed.
fn not_listed(unlisted: Option<Unlisted>) -> String {
    match unlisted {
        None => "they have too many unknowns".to_owned(),
        Some(Unlisted::Degenerate) => "some solutions may not be isolated".to_owned(),
        Some(other) => other.to_string(),
    }
}
