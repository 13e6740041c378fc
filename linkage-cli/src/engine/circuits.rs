//! Assemblies that run through the range of the input.

use linkage_runtime::support::{Chosen, CoupledGroup, Levels, Searched, SurveyedUnknown, circuits};
use linkage_runtime::{AssemblyError, Circuits};

use super::Assembly;
use super::coupled::Programs;
use super::revolutions::Revolutions;
use super::winding::Winding;
use crate::mechanism::Mechanism;
use crate::mechanism::forever::forever;

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
        let ([input], false) = (&self.unit.inputs[..], self.unit.groups.is_empty()) else {
            return None;
        };
        let unknowns = self.unit.surveyed.iter().map(|surveyed| {
            let unknown = &self.unit.unknowns[surveyed.unknown];
            SurveyedUnknown {
                name: forever(unknown.name.as_str()),
                unit: match surveyed.angle {
                    true => "",
                    false => forever(unknown.unit.as_str()),
                },
                angle: surveyed.angle,
                numbers: surveyed.numbers,
            }
        });
        let searched = Searched {
            name: self.name,
            input: self.inputs[0].name,
            reference: input.reference,
            levels: forever(self.unit.levels()),
            unknowns: forever(unknowns.collect::<Vec<_>>()),
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
        let turning = Winding {
            mechanism: self.mechanism,
            dimensions: self.dimensions,
            modes: &chosen.modes,
            starts: &chosen.starts,
        };
        let count = self.mechanism.unit.surveying;
        let revolutions = match count {
            0 => Revolutions::at_estimates(self.mechanism),
            _ => {
                let found = turning.wind(count, &[at]);
                found.unwrap_or_else(|_| Revolutions::at_estimates(self.mechanism))
            }
        };
        let Chosen { modes, starts } = chosen.clone();
        self.mechanism
            .prepared(self.dimensions, modes, revolutions, starts)
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
