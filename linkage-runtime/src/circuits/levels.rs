//! A mechanism as the search for circuits sees it: group by group, in the order in which they are
//! solved.

use crate::data::AssemblyMode;
use crate::error::AssemblyError;
use crate::structure::Group;
use crate::support::{Bounds, CoupledGroup, CoupledPrograms, InitialState, SurveyedUnknown};
use alloc::vec::Vec;
use linkage_core::Level;
use linkage_core::range_check::Slack;

/// The assemblies that have been chosen for the first groups.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// The modes; those of later groups mean nothing.
    pub modes: Vec<AssemblyMode>,
    /// The initial states of coupled groups; those of later groups are empty.
    pub starts: Vec<InitialState>,
}

/// The data of a mechanism with one input that are known before the search.
#[derive(Clone, Copy, Debug)]
pub struct Searched {
    /// Name of the mechanism.
    pub name: &'static str,
    /// Name of the input.
    pub input: &'static str,
    /// The input that start estimates are for.
    pub reference: f64,
    /// The groups in order.
    pub levels: &'static [Level],
    /// Their descriptions.
    pub groups: &'static [Group],
    /// The kinds of their slacks.
    pub slacks: &'static [Slack],
    /// The unknowns in the order of their numbers in a survey.
    pub unknowns: &'static [SurveyedUnknown],
    /// The number of groups with modes.
    pub modes: usize,
    /// The number of coupled groups.
    pub coupled: usize,
}

/// A mechanism with one input.
pub trait Levels {
    /// An assembled mechanism.
    type Assembly: Clone;
    /// Result of a survey: the least margin of all groups, the slack of every group, the numbers of
    /// the unknowns.
    type Survey: AsRef<[f64]>;
    /// The programs of a coupled group.
    type Programs: CoupledPrograms;

    /// The data of the mechanism.
    fn searched(&self) -> Searched;
    /// An assembly in which only the chosen groups are valid.
    fn surveyor(&self, chosen: &Chosen, at: f64) -> Self::Assembly;
    /// Surveys an assembly at an input.
    fn survey(&self, assembly: &Self::Assembly, at: f64) -> Self::Survey;
    /// The slack of a group at an input, as a survey has it.
    fn slack(&self, assembly: &Self::Assembly, group: usize, at: f64) -> f64 {
        self.survey(assembly, at).as_ref()[1 + group]
    }
    /// Bounds of the slack of a group over inputs. Those of groups after a coupled one are not
    /// known.
    fn bounds(&self, assembly: &Self::Assembly, group: usize) -> Option<Bounds<'_>> {
        let _ = (assembly, group);
        None
    }
    /// The assembly in which all groups are chosen.
    ///
    /// # Errors
    ///
    /// If it does not close at that input, or its angles cannot be followed.
    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<Self::Assembly, AssemblyError>;
    /// Checks that some assembly exists at an input. An error about loops out of reach does not
    /// count.
    ///
    /// # Errors
    ///
    /// As `assemblies()`.
    fn check(&self, at: f64) -> Result<(), AssemblyError>;
    /// A coupled group, given the assemblies of the groups before it; `None` if there is none.
    fn coupled(
        &self,
        _chosen: &Chosen,
        _number: usize,
        _at: f64,
    ) -> Option<Result<(&'static CoupledGroup, Self::Programs), AssemblyError>> {
        None
    }
}
