//! The circuits of a mechanism with one input.

use super::branch::Circuits;
use super::find::circuits;
use super::levels::{Chosen, Levels, Searched};
use crate::data::AssemblyMode;
use crate::error::AssemblyError;
use crate::support::{
    AssemblyData, Bounds, CoupledParts, GroupPrograms, List, PlainGroups, assemblies_at, surveyor,
    with_lanes,
};

/// Every assembly over the range of the only input.
///
/// # Errors
///
/// As `assemblies()`, if it fails at every position.
///
/// # Panics
///
/// If the mechanism has another number of inputs.
pub fn circuits_of<C: PlainGroups>(mechanism: &C) -> Result<Circuits<C::Assembly>, AssemblyError> {
    let cycle = mechanism.group_data().cycle.as_ref();
    circuits(&CircuitLevels(mechanism), cycle.expect("one input"))
}

/// A mechanism as the search for circuits sees it.
struct CircuitLevels<'a, C>(&'a C);

impl<C: PlainGroups> CircuitLevels<'_, C> {
    /// Modes and initial states in the lists of the mechanism.
    fn lists(chosen: &Chosen) -> (C::Modes, C::Lane) {
        let Chosen { modes, starts } = chosen;
        let modes = List::<AssemblyMode>::list(modes.len(), |k| modes[k]);
        (modes, List::list(starts.len(), |k| starts[k].clone()))
    }

    fn inputs(at: f64) -> C::Inputs {
        List::list(1, |_| at)
    }

    fn surveyed<const SLACKS: bool>(&self, assembly: &C::Assembly, at: f64) -> C::Survey {
        let data = C::data(assembly);
        let x = self
            .0
            .arguments(AssemblyData::starts(data), &Self::inputs(at));
        C::survey::<SLACKS>(AssemblyData::core(data), x)
    }
}

impl<C: PlainGroups> Levels for CircuitLevels<'_, C> {
    type Assembly = C::Assembly;
    type Survey = C::Survey;
    type Programs = GroupPrograms<C>;

    fn searched(&self) -> Searched {
        let (description, groups) = (self.0.description(), self.0.group_data());
        Searched {
            name: description.name,
            input: description.inputs[0].name,
            reference: description.inputs[0].reference,
            levels: groups.levels,
            groups: description.groups,
            slacks: groups.slacks,
            unknowns: groups.unknowns,
            modes: description.modes.len(),
            coupled: groups.coupled.len(),
        }
    }

    fn surveyor(&self, chosen: &Chosen, at: f64) -> C::Assembly {
        let (modes, starts) = Self::lists(chosen);
        let (core, states) = surveyor(self.0, &modes, &starts, &Self::inputs(at));
        C::assembly(AssemblyData::new(core, states))
    }

    fn survey(&self, assembly: &C::Assembly, at: f64) -> C::Survey {
        self.surveyed::<false>(assembly, at)
    }

    fn slack(&self, assembly: &C::Assembly, group: usize, at: f64) -> f64 {
        self.surveyed::<true>(assembly, at).as_ref()[1 + group]
    }

    fn bounds(&self, assembly: &C::Assembly, group: usize) -> Option<Bounds<'_>> {
        C::bounds(C::data(assembly), group)
    }

    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<C::Assembly, AssemblyError> {
        let (modes, starts) = Self::lists(chosen);
        with_lanes(self.0, modes, &Self::inputs(at), &[starts])
    }

    fn check(&self, at: f64) -> Result<(), AssemblyError> {
        assemblies_at(self.0, &Self::inputs(at)).map(|_| ())
    }

    fn coupled(
        &self,
        chosen: &Chosen,
        number: usize,
        at: f64,
    ) -> Option<CoupledParts<GroupPrograms<C>>> {
        if const { !C::COUPLED } {
            return None;
        }
        let (modes, starts) = Self::lists(chosen);
        let group = &self.0.group_data().coupled[number];
        let programs = GroupPrograms::new(self.0, &modes, &Self::inputs(at), number, &starts);
        Some(programs.map(|programs| (group, programs)))
    }
}
