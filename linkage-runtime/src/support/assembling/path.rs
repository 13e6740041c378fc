//! The same assembly for other dimensions.

use alloc::vec::Vec;
use linkage_core::{Level, Scalar};

use super::assemblies::{assembled, with_lanes};
use super::close::{explained, finite};
use super::compiled::{Compiled, CoreOf};
use super::group_programs::GroupPrograms;
use super::grouped::{Grouped, PlainGroups, core};
use super::list::List;
use super::preparation::lane_inputs;
use super::winding::{at_estimates, wind};
use crate::error::AssemblyError;
use crate::structure::Group;
use crate::support::assembly_data::AssemblyData;
use crate::support::continuation::{DimensionPath, follow_path, state_here};
use crate::support::coupled::{CoupledGroup, InitialState, prepared_over};

/// A coupled group with its programs.
pub type CoupledParts<C> = Result<(&'static CoupledGroup, C), AssemblyError>;

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
        let at = lane_inputs(mechanism, &at, lane);
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
    let result = with_lanes(mechanism, from.modes.clone(), &at, &lanes);
    explained(result, mechanism)
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
        let x: Vec<f64> = group
            .inputs
            .iter()
            .map(|input| at.as_ref()[input.index])
            .collect();
        starts.as_mut()[number] = state_here(&mut programs.ok()?, &x, state)?;
    }
    let core = core(mechanism, &from.modes, from.revolutions.clone());
    let states = mechanism.states(core::slice::from_ref(&starts));
    Some(C::assembly(AssemblyData::new(core, states)))
}

/// An assembly that need not close, of the first groups, to be surveyed at these inputs.
pub(crate) fn surveyor<C: PlainGroups>(
    mechanism: &C,
    modes: &C::Modes,
    starts: &C::Lane,
    at: &C::Inputs,
) -> (CoreOf<C>, C::States) {
    let states = mechanism.states(core::slice::from_ref(starts));
    let count = mechanism.group_data().surveying;
    let found = wind(mechanism, modes, &states, count, at);
    let revolutions = found.unwrap_or_else(|_| at_estimates(mechanism));
    (core(mechanism, modes, revolutions), states)
}

/// The straight path from the dimensions of one mechanism to those of another, at some inputs.
struct MechanismPath<'a, C: Compiled> {
    from: C,
    to: &'a C,
    modes: &'a C::Modes,
    at: &'a C::Inputs,
}

impl<C: PlainGroups> MechanismPath<'_, C> {
    /// The mechanism at some share of the path.
    fn mechanism(&self, share: f64) -> C {
        if share == 1.0 {
            return self.to.clone();
        }
        let (from, to) = (self.from.dimensions(), self.to.dimensions());
        let (from, to) = (from.as_ref(), to.as_ref());
        self.from
            .with_dimensions(|k| from[k] + share * (to[k] - from[k]))
    }

    fn lane(starts: &[InitialState]) -> C::Lane {
        C::Lane::list(starts.len(), |k| starts[k].clone())
    }
}

impl<C: PlainGroups> DimensionPath for MechanismPath<'_, C> {
    type Survey = C::Survey;
    type Programs = GroupPrograms<C>;

    fn name(&self) -> &'static str {
        self.to.description().name
    }

    fn levels(&self) -> &'static [Level] {
        self.to.group_data().levels
    }

    fn groups(&self) -> &'static [Group] {
        self.to.description().groups
    }

    fn inputs(&self) -> &[f64] {
        self.at.as_ref()
    }

    fn survey(&self, share: f64, initial_states: &[InitialState]) -> C::Survey {
        let mechanism = self.mechanism(share);
        let starts = Self::lane(initial_states);
        let (core, states) = surveyor(&mechanism, self.modes, &starts, self.at);
        C::survey(&core, mechanism.arguments(&states, self.at))
    }

    fn coupled(
        &self,
        share: f64,
        starts: &[InitialState],
        number: usize,
    ) -> Option<CoupledParts<GroupPrograms<C>>> {
        if const { !C::COUPLED } {
            return None;
        }
        let group = &self.to.group_data().coupled[number];
        let mechanism = self.mechanism(share);
        let starts = Self::lane(starts);
        let programs = GroupPrograms::new(&mechanism, self.modes, self.at, number, &starts);
        Some(programs.map(|programs| (group, programs)))
    }
}
