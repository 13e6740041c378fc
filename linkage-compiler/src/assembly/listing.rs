//! Closes a coupled group at the reference input: lists all its assemblies and takes the one
//! nearest to the estimates. If they cannot be listed, `assembly/followed.rs` continues.

use linkage_core::numeric::choose_assembly::{Ambiguity, choose_assembly, may_be_meant};
use linkage_core::numeric::continuation::{meeting_states, states};
use linkage_core::numeric::roots::{self, Term, Unlisted};

use crate::assembly::{estimates, followed, unfollowed};
use crate::solve::{Prepared, Solved};

use super::assembler::Assembly;
use super::coupled_state::{Candidate, candidate_of, prepare};
use super::estimates::{Choice, LISTED, Position};

/// The real assemblies of a coupled group.
struct Listed {
    /// The assemblies that can be distinguished, the nearest to the estimates first.
    candidates: Vec<Candidate>,
    /// The approximate distances from the estimates of other assemblies, which meet at a dead
    /// point.
    meeting: Vec<f64>,
}

/// Closes a coupled group; false if that was not possible.
pub(super) fn close_coupled<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
) -> bool {
    let loops = assembly.words.loops(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
    if assembly.machine.closure.coupled[prepared.number].followed {
        return followed::close_followed(assembly, solved, prepared, None);
    }
    let Listed {
        candidates,
        meeting,
    } = match candidates(assembly, prepared.number) {
        Ok(listed) => listed,
        Err(Unlisted::NotFinite) => {
            followed::without_equations(assembly, solved);
            return false;
        }
        Err(reason) => return followed::close_followed(assembly, solved, prepared, Some(reason)),
    };
    let listed = candidates
        .iter()
        .take(LISTED)
        .map(|c| {
            format!(
                "`{}` at distance {:.4}",
                estimates::shown(assembly, &c.position),
                c.position.distance
            )
        })
        .collect::<Vec<_>>()
        .join(", ");
    let distances = candidates.iter().map(|one| one.position.distance);
    let chosen = choose_assembly(distances, Ambiguity::AS_WRITTEN);
    let distance = chosen.map_or(f64::INFINITY, |choice| {
        candidates[choice.index].position.distance
    });
    let others_meet = !meeting.is_empty();
    let mut meeting = meeting.into_iter();
    if meeting.any(|other| may_be_meant(other, distance, Ambiguity::AS_WRITTEN)) {
        unfollowed::report_singular(assembly, solved, prepared);
        return false;
    }
    let Some(chosen) = chosen else {
        assembly.reporter.error(
                origin,
                format!(
                    "{loops} ({unknowns}) cannot close{position}: no assembly is real\n\
                     help: change a length, or give a reference input at which the links reach each other"
                ),
            );
        return false;
    };
    let positions: Vec<&Position> = candidates.iter().map(|one| &one.position).collect();
    let choice = match others_meet {
        false => Choice::Listed,
        true => Choice::ListedApart,
    };
    if chosen.ambiguous && estimates::lacks_estimates(assembly, solved, &positions, choice) {
        return false;
    }
    if chosen.ambiguous {
        let unknown = solved.group.unknowns.first();
        let unknown_origin = unknown.map(|&u| assembly.algebra.mechanism.unknowns[u].origin);
        assembly.reporter.error(
                unknown_origin.unwrap_or(origin),
                format!(
                    "the start estimates of {unknowns} lie equally near to two assemblies of {loops}{position}; there are {}{}{}: \
                     {listed}\n\
                     help: move the estimates towards the assembly that is meant",
                    candidates.len(),
                    choice.beside(),
                    if candidates.len() > LISTED { ", the nearest" } else { "" }
                ),
            );
        return false;
    }
    if !estimates::meets_estimates(assembly, solved, &positions, choice) {
        return false;
    }
    prepare(assembly, solved, prepared, &candidates[chosen.index].state)
}

/// All real assemblies.
fn candidates(assembly: &mut Assembly<'_, '_>, number: usize) -> Result<Listed, Unlisted> {
    let (mut numbers, inputs) = assembly.coupled(number);
    let group = &assembly.machine.closure.coupled[number];
    let coefficients = numbers.run(&group.system, &[]);
    let coefficients: Vec<[f64; 2]> = coefficients.chunks(2).map(|c| [c[0], c[1]]).collect();
    let terms: Vec<Term> = group
        .terms
        .iter()
        .map(|(equation, exponents)| Term {
            equation: *equation,
            exponents,
        })
        .collect();
    let system = roots::System {
        variables: &group.variables,
        terms: &terms,
    };
    let listing = roots::solve(&system, &coefficients)?;
    let regular = states(&group.variables, &listing, &inputs, &mut numbers);
    let candidate = |state: Vec<f64>| {
        let placed = numbers.run(&group.placed, &state);
        candidate_of(assembly, group, state, &placed)
    };
    let mut candidates: Vec<Candidate> = regular.into_iter().map(candidate).collect();
    candidates.sort_by(|a, b| a.position.distance.total_cmp(&b.position.distance));
    let meeting = meeting_states(&group.variables, &listing).into_iter();
    let meeting = meeting.map(|state| candidate(state).position.distance);
    Ok(Listed {
        candidates,
        meeting: meeting.collect(),
    })
}
