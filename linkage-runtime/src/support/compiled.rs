//! A generated mechanism as the searches of the runtime see it.

use core::marker::PhantomData;

use linkage_core::Level;

use super::continuation::DimensionPath;
use super::coupled::{CoupledGroup, CoupledPrograms, InitialState};
use crate::data::{AssemblyMode, Input};
use crate::dimensions::Dimensions;
use crate::error::AssemblyError;
use crate::structure::Group;

/// A coupled group with its programs.
pub type CoupledParts<C> = Result<(&'static CoupledGroup, C), AssemblyError>;

/// A mechanism with groups: `P` dimensions, `I` inputs. Of assemblies that are searched only the
/// first groups are chosen; the modes and initial states of later groups mean nothing.
pub trait Compiled<const P: usize, const I: usize>: Dimensions<P> {
    /// An assembled mechanism.
    type Assembly: Clone;
    /// The least margin of all groups, the slack of every group, the numbers of the unknowns.
    type Survey: AsRef<[f64]>;
    /// The programs of a coupled group.
    type Programs: CoupledPrograms;

    /// Name of the mechanism.
    const NAME: &'static str;
    /// The inputs.
    const INPUTS: &'static [Input];
    /// The groups of `STRUCTURE`.
    const GROUPS: &'static [Group];
    /// The groups in order.
    const LEVELS: &'static [Level];

    /// An assembly that need not close.
    fn surveyor(
        &self,
        modes: &[AssemblyMode],
        starts: &[InitialState],
        at: [f64; I],
    ) -> Self::Assembly;

    /// Surveys an assembly at some inputs.
    fn survey(assembly: &Self::Assembly, at: [f64; I]) -> Self::Survey;

    /// A coupled group, given those before it; `None` if there is none.
    fn coupled(
        &self,
        _modes: &[AssemblyMode],
        _starts: &[InitialState],
        _number: usize,
        _at: [f64; I],
    ) -> Option<CoupledParts<Self::Programs>> {
        None
    }
}

/// The straight path from the dimensions of one mechanism to those of another, at some inputs.
#[derive(Debug)]
pub struct MechanismPath<'a, M, const P: usize, const I: usize> {
    from: [f64; P],
    to: [f64; P],
    modes: &'a [AssemblyMode],
    at: [f64; I],
    mechanism: PhantomData<fn() -> M>,
}

impl<'a, M: Compiled<P, I>, const P: usize, const I: usize> MechanismPath<'a, M, P, I> {
    /// The path in the assembly with these modes.
    pub fn new(from: &M, to: &M, modes: &'a [AssemblyMode], at: [f64; I]) -> Self {
        Self {
            from: from.values(),
            to: to.values(),
            modes,
            at,
            mechanism: PhantomData,
        }
    }

    /// The mechanism at some share of the path.
    fn mechanism(&self, share: f64) -> M {
        if share == 1.0 {
            return M::from_values(&self.to);
        }
        M::from_values(&core::array::from_fn(|k| {
            self.from[k] + share * (self.to[k] - self.from[k])
        }))
    }
}

impl<M: Compiled<P, I>, const P: usize, const I: usize> DimensionPath
    for MechanismPath<'_, M, P, I>
{
    type Survey = M::Survey;
    type Programs = M::Programs;

    fn name(&self) -> &'static str {
        M::NAME
    }

    fn levels(&self) -> &'static [Level] {
        M::LEVELS
    }

    fn groups(&self) -> &'static [Group] {
        M::GROUPS
    }

    fn inputs(&self) -> &[f64] {
        &self.at
    }

    fn survey(&self, share: f64, initial_states: &[InitialState]) -> M::Survey {
        let mechanism = self.mechanism(share);
        let surveyor = mechanism.surveyor(self.modes, initial_states, self.at);
        M::survey(&surveyor, self.at)
    }

    fn coupled(
        &self,
        share: f64,
        starts: &[InitialState],
        number: usize,
    ) -> Option<CoupledParts<M::Programs>> {
        self.mechanism(share)
            .coupled(self.modes, starts, number, self.at)
    }
}
