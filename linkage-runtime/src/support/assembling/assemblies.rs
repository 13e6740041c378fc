//! The assemblies of a mechanism with coupled groups, and all assemblies of a mechanism.

use alloc::vec;
use alloc::vec::Vec;
use linkage_core::Scalar;

use super::assemble::{check_gaps, with_states};
use super::close::{explained, finite};
use super::group_programs::GroupPrograms;
use super::grouped::{Grouped, PlainGroups, no_states};
use super::list::List;
use super::preparation::{lane_inputs, prepared};
use super::winding::at_estimates;
use crate::error::AssemblyError;
use crate::support::coupled::{InitialState, Which, initial_states};

/// The assembly that the start estimates choose.
///
/// # Errors
///
/// As `assemble()` of generated code.
pub fn assemble_coupled<C>(mechanism: &C) -> Result<C::Assembly, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    let at = mechanism.reference();
    assembled(mechanism, mechanism.default_modes(), &at)
        .map_err(|error| explained(error, mechanism))
}

/// The assembly in these modes that the start estimates choose.
pub(super) fn assembled<C>(
    mechanism: &C,
    modes: C::Modes,
    at: &C::Inputs,
) -> Result<C::Assembly, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    finite(mechanism)?;
    let mut lanes = Vec::new();
    for lane in 0..C::Scalar::LANES {
        match in_lane(mechanism, &modes, at, lane, Which::Nearest) {
            Ok(found) => lanes.extend(found),
            Err(error) => {
                close_closed_forms(mechanism, &modes, at)?;
                return Err(error);
            }
        }
    }
    with_lanes(mechanism, modes, at, &lanes)
}

/// The assembly with these initial states of coupled groups, lane by lane.
pub(crate) fn with_lanes<C>(
    mechanism: &C,
    modes: C::Modes,
    at: &C::Inputs,
    lanes: &[C::Lane],
) -> Result<C::Assembly, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    let states = mechanism.states(lanes);
    with_states(mechanism, modes, at, states, |lane| {
        mechanism.lane(lane).states(&lanes[lane..=lane])
    })
}

/// Every real assembly at the reference inputs, the one that the start estimates choose first.
///
/// # Errors
///
/// As `assemblies()` of generated code.
pub fn assemblies<C>(mechanism: &C) -> Result<Vec<C::Assembly>, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    assemblies_at(mechanism, &mechanism.reference())
}

/// More modes than this are not listed.
const MOST_MODES: usize = 16;

/// Every real assembly at these inputs, the one that the start estimates choose first.
///
/// # Errors
///
/// As `assemblies()` of generated code. An error that is not about a loop that cannot close is
/// returned if nothing closes.
pub fn assemblies_at<C>(mechanism: &C, at: &C::Inputs) -> Result<Vec<C::Assembly>, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    let default = mechanism.default_modes();
    let count = default.as_ref().len();
    if count > MOST_MODES {
        return Err(AssemblyError::TooManyAssemblies {
            mechanism: mechanism.description().name,
            modes: count,
        });
    }
    let mut found = Vec::new();
    let mut failure = None;
    for flips in 0..1_u32 << count {
        let mut modes = default.clone();
        for (number, mode) in modes.as_mut().iter_mut().enumerate() {
            if flips >> number & 1 == 1 {
                *mode = mode.flipped();
            }
        }
        match in_modes(mechanism, &modes, at) {
            Ok(assemblies) => found.extend(assemblies),
            Err(error) if error.is_a_miss() => {}
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    match failure {
        Some(error) if found.is_empty() => Err(explained(error, mechanism)),
        _ => Ok(found),
    }
}

/// All assemblies in these modes: coupled groups have further ones.
fn in_modes<C>(
    mechanism: &C,
    modes: &C::Modes,
    at: &C::Inputs,
) -> Result<Vec<C::Assembly>, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    finite(mechanism)?;
    let all = match in_lane(mechanism, modes, at, 0, Which::All) {
        Ok(all) => all,
        Err(error) => {
            close_closed_forms(mechanism, modes, at)?;
            return Err(error);
        }
    };
    let mut found = Vec::new();
    let mut missed = None;
    for first in all {
        let mut lanes = vec![first.clone()];
        for lane in 1..C::Scalar::LANES {
            let like = Which::Like(first.as_ref());
            lanes.extend(in_lane(mechanism, modes, at, lane, like)?);
        }
        match with_lanes(mechanism, modes.clone(), at, &lanes) {
            Ok(assembly) => found.push(assembly),
            // Others may let closed forms behind the coupled groups close.
            Err(error @ AssemblyError::CannotClose { .. }) => missed = Some(error),
            Err(error) => return Err(error),
        }
    }
    match missed {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
}

/// The initial states of the coupled groups in one lane, for the wanted assemblies.
fn in_lane<C>(
    mechanism: &C,
    modes: &C::Modes,
    at: &C::Inputs,
    lane: usize,
    wanted: Which<'_>,
) -> Result<Vec<C::Lane>, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    if const { !C::COUPLED } {
        return Ok(vec![List::list(0, |_| InitialState::Nothing)]);
    }
    let groups = mechanism.group_data().coupled;
    let nothing = C::Lane::list(groups.len(), |_| InitialState::Nothing);
    let (plain, at) = (mechanism.lane(lane), lane_inputs::<C>(at, lane));
    initial_states(groups, nothing, at.as_ref(), wanted, |number, starts| {
        GroupPrograms::new(&plain, modes, &at, number, starts)
    })
}

/// Fails if a group with a closed form does not close before a coupled one is needed.
fn close_closed_forms<C>(
    mechanism: &C,
    modes: &C::Modes,
    at: &C::Inputs,
) -> Result<(), AssemblyError>
where
    C: Grouped,
{
    let states = mechanism.states(&no_states(mechanism));
    let prepared = prepared(mechanism, modes, &at_estimates(mechanism));
    match check_gaps(
        mechanism,
        modes,
        &prepared,
        mechanism.arguments(&states, at),
    ) {
        Err(error @ AssemblyError::CannotClose { .. }) => Err(error),
        _ => Ok(()),
    }
}
