//! The circuits of a generated mechanism.

use linkage_core::Cycle;

use super::branch::Circuits;
use super::find::circuits;
use super::levels::{Bounds, Chosen, Levels, Searched, SurveyedUnknown};
use crate::error::AssemblyError;
use crate::support::{Compiled, CoupledParts};

/// A mechanism with one input, whose circuits are searched.
pub trait OneInput<const P: usize>: Compiled<P, 1> {
    /// The unknowns in the order of their numbers in a survey.
    const UNKNOWNS: &'static [SurveyedUnknown];
    /// The number of groups with modes, and that of coupled groups.
    const COUNTS: [usize; 2];

    /// Bounds of a number of the survey over inputs. Those of groups after a coupled one are not
    /// known.
    fn bounds(assembly: &Self::Assembly, number: usize) -> Bounds<'static>;

    /// The assembly in which all groups are chosen.
    ///
    /// # Errors
    ///
    /// If it does not close at that input, or its angles cannot be followed.
    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<Self::Assembly, AssemblyError>;

    /// Checks that some assembly exists at an input.
    ///
    /// # Errors
    ///
    /// As `assemblies()`.
    fn check(&self, at: f64) -> Result<(), AssemblyError>;
}

/// Every assembly over the range of the input.
///
/// # Errors
///
/// As `assemblies()`, if it fails at every position.
pub fn circuits_of<M: OneInput<P>, const P: usize>(
    mechanism: &M,
    cycle: &Cycle,
) -> Result<Circuits<M::Assembly>, AssemblyError> {
    circuits(&CircuitLevels(mechanism), cycle)
}

/// A mechanism as the search for circuits sees it.
struct CircuitLevels<'a, M, const P: usize>(&'a M);

impl<M: OneInput<P>, const P: usize> Levels for CircuitLevels<'_, M, P> {
    type Assembly = M::Assembly;
    type Survey = M::Survey;
    type Programs = M::Programs;

    fn searched(&self) -> Searched {
        let [modes, coupled] = M::COUNTS;
        Searched {
            name: M::NAME,
            input: M::INPUTS[0].name,
            reference: M::INPUTS[0].reference,
            levels: M::LEVELS,
            unknowns: M::UNKNOWNS,
            modes,
            coupled,
        }
    }

    fn surveyor(&self, chosen: &Chosen, at: f64) -> M::Assembly {
        self.0.surveyor(&chosen.modes, &chosen.starts, [at])
    }

    fn survey(&self, assembly: &M::Assembly, at: f64) -> M::Survey {
        M::survey(assembly, [at])
    }

    fn bounds(&self, assembly: &M::Assembly, number: usize) -> Option<Bounds<'_>> {
        Some(M::bounds(assembly, number))
    }

    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<M::Assembly, AssemblyError> {
        self.0.assembled(chosen, at)
    }

    fn check(&self, at: f64) -> Result<(), AssemblyError> {
        self.0.check(at)
    }

    fn coupled(
        &self,
        chosen: &Chosen,
        number: usize,
        at: f64,
    ) -> Option<CoupledParts<M::Programs>> {
        self.0.coupled(&chosen.modes, &chosen.starts, number, [at])
    }
}
