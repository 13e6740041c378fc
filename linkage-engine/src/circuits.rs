//! Assemblies that run through the range of the input.

use linkage_runtime::support::{Chosen, CoupledGroup, Levels, Searched, circuits};
use linkage_runtime::{AssemblyError, Circuits};

use crate::assembly::Assembly;
use crate::coupled::Programs;
use crate::mechanism::Mechanism;

/// A mechanism with one input, as the runtime searches it.
struct CircuitSearch<'m> {
    mechanism: &'m Mechanism,
    dimensions: &'m [f64],
    searched: Searched,
}

impl Mechanism {
    /// Every assembly over the range of the input; `None` for a mechanism without groups or with
    /// another number of inputs than one.
    ///
    /// # Errors
    ///
    /// As the method `circuits` of the macro's struct.
    pub fn circuits<'m>(
        &'m self,
        dimensions: &'m [f64],
    ) -> Option<Result<Circuits<Assembly<'m>>, AssemblyError>> {
        let ([input], false) = (&self.compiled.inputs[..], self.compiled.groups.is_empty()) else {
            return None;
        };
        let searched = Searched {
            name: self.name,
            input: self.inputs[0].name,
            reference: input.reference,
            levels: self.levels,
            unknowns: self.surveyed,
            modes: self.modes().len(),
            coupled: self.groups.len(),
        };
        let search = CircuitSearch {
            mechanism: self,
            dimensions,
            searched,
        };
        Some(circuits(&search, &input.cycle()))
    }
}

impl<'m> Levels for CircuitSearch<'m> {
    type Assembly = Assembly<'m>;
    type Survey = Vec<f64>;
    type Programs = Programs<'m>;

    fn searched(&self) -> Searched {
        self.searched
    }

    fn surveyor(&self, chosen: &Chosen, at: f64) -> Assembly<'m> {
        let Chosen { modes, starts } = chosen.clone();
        self.mechanism
            .surveyor(self.dimensions, modes, starts, &[at])
    }

    fn survey(&self, assembly: &Assembly<'m>, at: f64) -> Vec<f64> {
        assembly.survey(&[at])
    }

    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<Assembly<'m>, AssemblyError> {
        let Chosen { modes, starts } = chosen.clone();
        match self.mechanism.groups.is_empty() {
            true => self.mechanism.assembled(self.dimensions, modes, &[at]),
            false => self
                .mechanism
                .with_starts(self.dimensions, modes, &[at], starts),
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
