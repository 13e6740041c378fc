//! The assembly of a group at the reference inputs: all solutions are listed, the one nearest to
//! the start estimates is taken.

use super::estimate::followed;
use super::group::CoupledGroup;
use super::programs::CoupledPrograms;
use super::solution::{CoupledSolution, placed, solution};
use crate::error::{AssemblyError, CoupledCause};
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::numeric::choose_assembly::{Ambiguity, choose_assembly, may_be_meant};
use linkage_core::numeric::continuation::{meeting_states, states};
use linkage_core::numeric::roots::{Listing, System, Unlisted};

fn listed(group: &CoupledGroup, coefficients: &[[f64; 2]]) -> Result<Listing, AssemblyError> {
    let system = System {
        variables: group.variables,
        terms: group.terms,
    };
    (group.list)(&system, coefficients).map_err(|why| match why {
        Unlisted::NotFinite => group.undefined(),
        why => group.error(CoupledCause::NotListed(why)),
    })
}

/// The real solutions of a listing, the nearest to the estimates first.
fn solutions(
    group: &CoupledGroup,
    listing: &Listing,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<Vec<CoupledSolution>, AssemblyError> {
    let mut solutions: Vec<CoupledSolution> = states(group.variables, listing, x, programs)
        .into_iter()
        .map(|state| solution(group, programs, x, state))
        .filter(|solution| solution.distance.is_finite())
        .collect();
    if solutions.is_empty() {
        let complex = listing.complex;
        return Err(group.error(CoupledCause::NoneReal { complex }));
    }
    solutions.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    Ok(solutions)
}

/// All real solutions at the inputs `x`, the nearest to the estimates first; of a group that is
/// followed the one to which these lead.
///
/// # Errors
///
/// If the solutions cannot be listed, or none is real.
pub fn list_solutions(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<Vec<CoupledSolution>, AssemblyError> {
    if group.is_followed() {
        return followed(group, programs, x).map(|found| vec![found]);
    }
    let listing = listed(group, &programs.system(x))?;
    solutions(group, &listing, programs, x)
}

/// The solution at the inputs `x` that is nearest to the estimates, or to which they lead.
///
/// # Errors
///
/// If the solutions cannot be listed, none is real, two are equally near, or two meet at a turning
/// point; if the estimates lead nowhere.
pub fn nearest_solution(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
) -> Result<CoupledSolution, AssemblyError> {
    if group.is_followed() {
        return followed(group, programs, x);
    }
    let listing = listed(group, &programs.system(x))?;
    let listed = solutions(group, &listing, programs, x);
    let nearest_one = listed
        .as_ref()
        .map_or(f64::INFINITY, |solutions| solutions[0].distance);
    let meeting = meeting_states(group.variables, &listing).into_iter();
    let mut meeting = meeting.map(|state| solution(group, programs, x, state).distance);
    if meeting.any(|other| may_be_meant(other, nearest_one, Ambiguity::AT_RUN_TIME)) {
        return Err(group.error(CoupledCause::Singular));
    }
    let mut solutions = listed?;
    let distances = solutions.iter().map(|one| one.distance);
    let chosen = choose_assembly(distances, Ambiguity::AT_RUN_TIME);
    if chosen.is_some_and(|chosen| chosen.ambiguous) {
        let assemblies = solutions.iter().map(|one| placed(group, &one.values));
        return Err(group.error(CoupledCause::Ambiguous {
            assemblies: assemblies.collect(),
        }));
    }
    Ok(solutions.swap_remove(0))
}
