//! The same assembly for other dimensions.

use alloc::vec::Vec;
use linkage_core::Scalar;

use super::assemblies::{assembled, with_lanes};
use super::close::{explained, finite};
use super::group_programs::GroupPrograms;
use super::grouped::{Grouped, PlainGroups, prepared_core};
use super::list::List;
use super::mechanism_path::MechanismPath;
use super::preparation::lane_inputs;
use crate::error::AssemblyError;
use crate::support::assembly_data::AssemblyData;
use crate::support::continuation::{follow_path, state_here};
use crate::support::coupled::{InitialState, prepared_over};

/// The mechanism in the assembly of one with other dimensions: it is followed along the straight
/// path from those, at the reference inputs. Each lane has a path of its own.
///
/// # Errors
///
/// As `assemble_from()` of generated code.
pub fn assemble_from<C>(mechanism: &C, assembly: &C::Assembly) -> Result<C::Assembly, AssemblyError>
where
    C: Grouped<Plain: PlainGroups<Lane = C::Lane>>,
{
    let data = C::data(assembly);
    let from = AssemblyData::core(data);
    let at = mechanism.reference();
    if mechanism.description().groups.is_empty() {
        return assembled(mechanism, from.modes.clone(), &at);
    }
    finite(mechanism)?;
    let mut x = mechanism.arguments(AssemblyData::starts(data), &at);
    let groups = mechanism.group_data().coupled;
    let mut lanes = Vec::new();
    for lane in 0..C::Scalar::LANES {
        let plain = mechanism.lane(lane);
        let at = lane_inputs::<C>(&at, lane);
        let state = |number| {
            let state = C::state_mut(&mut x, number).iter();
            state.map(|numbers| numbers.lane(lane)).collect()
        };
        let states = (0..groups.len()).map(state).collect();
        let path = MechanismPath {
            from: from.dimensions.lane(lane),
            to: &plain,
            modes: &from.modes,
            at: &at,
        };
        let states = follow_path(&path, states)?;
        lanes.push(if const { C::COUPLED } {
            let nothing = List::list(groups.len(), |_| InitialState::Nothing);
            prepared_over(groups, nothing, at.as_ref(), &states, |number, starts| {
                GroupPrograms::new(&plain, &from.modes, &at, number, starts)
            })?
        } else {
            List::list(0, |_| InitialState::Nothing)
        });
    }
    with_lanes(mechanism, from.modes.clone(), &at, &lanes)
        .map_err(|error| explained(error, mechanism))
}

/// The data of an assembly of other dimensions that is good at these inputs alone: its coupled
/// groups are followed there. It need not close, and its angles count turns from those of `from`.
/// `None` where it cannot be followed.
pub fn assemble_there<C: PlainGroups>(
    mechanism: &C,
    from: &C::Assembly,
    at: &C::Inputs,
) -> Option<C::Assembly> {
    finite(mechanism).ok()?;
    let data = C::data(from);
    let from = AssemblyData::core(data);
    let mut x = mechanism.arguments(AssemblyData::starts(data), at);
    let groups = mechanism.group_data().coupled;
    let states = (0..groups.len()).map(|number| C::state_mut(&mut x, number).to_vec());
    let path = MechanismPath {
        from: from.dimensions.clone(),
        to: mechanism,
        modes: &from.modes,
        at,
    };
    let states = follow_path(&path, states.collect()).ok()?;
    let mut starts = C::Lane::list(groups.len(), |_| InitialState::Nothing);
    for (number, (group, state)) in groups.iter().zip(&states).enumerate() {
        let programs = GroupPrograms::new(mechanism, &from.modes, at, number, &starts);
        let x = group.inputs_among(at.as_ref());
        starts.as_mut()[number] = state_here(&mut programs.ok()?, &x, state)?;
    }
    let core = prepared_core(mechanism, &from.modes, from.revolutions.clone());
    let states = mechanism.states(core::slice::from_ref(&starts));
    Some(C::assembly(AssemblyData::new(core, states)))
}
