//! Assemblies that run through the range of the input.

use linkage_runtime::support::{Chosen, CoupledGroup, Levels, Searched, circuits};
use linkage_runtime::{AssemblyError, Circuits};

use crate::assembled::{Assembly, assembled, surveyor, with_starts};
use crate::coupled::Programs;
use crate::mechanism::Mechanism;

/// A mechanism with one input, as the runtime searches it.
struct CircuitSearch<'m, 'd> {
    mechanism: &'m Mechanism,
    dimensions: &'d [f64],
    searched: Searched,
}

/// Every assembly over the range of the input; `None` where there is nothing to search.
pub(crate) fn circuits_of<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
) -> Option<Result<Circuits<Assembly<'m>>, AssemblyError>> {
    let ([input], false) = (
        &mechanism.compiled.inputs[..],
        mechanism.compiled.groups.is_empty(),
    ) else {
        return None;
    };
    let searched = Searched {
        name: mechanism.name,
        input: mechanism.inputs[0].name,
        reference: input.reference,
        levels: mechanism.levels,
        unknowns: mechanism.surveyed,
        modes: mechanism.modes().len(),
        coupled: mechanism.groups.len(),
    };
    let search = CircuitSearch {
        mechanism,
        dimensions,
        searched,
    };
    Some(circuits(&search, &input.cycle()))
}

impl<'m> Levels for CircuitSearch<'m, '_> {
    type Assembly = Assembly<'m>;
    type Survey = Vec<f64>;
    type Programs = Programs<'m>;

    fn searched(&self) -> Searched {
        self.searched
    }

    fn surveyor(&self, chosen: &Chosen, at: f64) -> Assembly<'m> {
        let Chosen { modes, starts } = chosen.clone();
        surveyor(self.mechanism, self.dimensions, modes, starts, &[at])
    }

    fn survey(&self, assembly: &Assembly<'m>, at: f64) -> Vec<f64> {
        assembly.survey(&[at])
    }

    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<Assembly<'m>, AssemblyError> {
        let Chosen { modes, starts } = chosen.clone();
        match self.mechanism.groups.is_empty() {
            true => assembled(self.mechanism, self.dimensions, modes, &[at]),
            false => with_starts(self.mechanism, self.dimensions, modes, &[at], starts),
        }
    }

    fn check(&self, at: f64) -> Result<(), AssemblyError> {
        let all = self.mechanism.assemblies(self.dimensions, &[at]);
        all.map(|_| ())
    }

    fn coupled(
        &self,
        chosen: &Chosen,
        number: usize,
        at: f64,
    ) -> Option<Result<(&'static CoupledGroup, Programs<'m>), AssemblyError>> {
        let Chosen { modes, starts } = chosen;
        let programs = Programs::new(
            self.mechanism,
            self.dimensions,
            modes,
            &[at],
            number,
            starts,
        );
        Some(programs.map(|programs| (&self.mechanism.groups[number], programs)))
    }
}
