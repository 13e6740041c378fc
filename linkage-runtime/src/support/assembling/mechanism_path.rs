//! The straight path from the dimensions of a mechanism to others.

use linkage_core::Level;

use super::compiled::{Compiled, CoreOf};
use super::description::Description;
use super::group_programs::GroupPrograms;
use super::grouped::{PlainGroups, prepared_core};
use super::list::List;
use super::winding::{at_estimates, wind};
use crate::error::AssemblyError;
use crate::support::coupled::{CoupledGroup, InitialState};

/// A coupled group with its programs.
pub type CoupledParts<C> = Result<(&'static CoupledGroup, C), AssemblyError>;

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
    (prepared_core(mechanism, modes, revolutions), states)
}

/// The straight path from the dimensions of one mechanism to those of another, at some inputs.
pub(crate) struct MechanismPath<'a, C: Compiled> {
    pub(super) from: C,
    pub(super) to: &'a C,
    pub(super) modes: &'a C::Modes,
    pub(super) at: &'a C::Inputs,
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

    /// Its description.
    pub(crate) fn description(&self) -> &Description {
        self.to.description()
    }

    /// The groups in order.
    pub(crate) fn levels(&self) -> &'static [Level] {
        self.to.group_data().levels
    }

    /// The inputs.
    pub(crate) fn inputs(&self) -> &[f64] {
        self.at.as_ref()
    }

    /// Surveys the mechanism at some share, with the initial states of coupled groups.
    pub(crate) fn survey(&self, share: f64, initial_states: &[InitialState]) -> C::Survey {
        let mechanism = self.mechanism(share);
        let starts = Self::lane(initial_states);
        let (core, states) = surveyor(&mechanism, self.modes, &starts, self.at);
        C::survey::<false>(&core, mechanism.arguments(&states, self.at))
    }

    /// A coupled group at some share, with the initial states of those before it; `None` if there
    /// is none.
    pub(crate) fn coupled(
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
