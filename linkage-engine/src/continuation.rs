//! The same assembly for other dimensions.

use linkage_runtime::support::{
    CoupledParts, DimensionPath, InitialState, Level, explained_by, follow_path, prepared_over_in,
    state_here,
};
use linkage_runtime::{AssemblyError, Group};

use crate::assembly::Assembly;
use crate::coupled::Programs;
use crate::mechanism::Mechanism;

impl Mechanism {
    /// Assembles other dimensions in the assembly of `from`, which is followed along the straight
    /// way to them, at the reference inputs, in steps too small to leave it.
    ///
    /// # Errors
    ///
    /// `Blocked` where the assembly ends on the way; those of [`assemble`](Self::assemble) for
    /// these dimensions.
    pub fn assemble_from(
        &self,
        dimensions: &[f64],
        from: &Assembly<'_>,
    ) -> Result<Assembly<'_>, AssemblyError> {
        let at = self.reference();
        let modes = from.modes().to_vec();
        let result = match (self.compiled.groups.is_empty(), self.groups.is_empty()) {
            (true, _) => self.assembled(dimensions, modes, &at),
            (false, true) => self
                .follow(dimensions, from, &at)
                .and_then(|_| self.assembled(dimensions, modes, &at)),
            (false, false) => self.follow(dimensions, from, &at).and_then(|states| {
                let nothing = vec![InitialState::Nothing; self.groups.len()];
                let starts =
                    prepared_over_in(self.groups, nothing, &at, &states, |number, starts| {
                        Programs::new(self, dimensions, &modes, &at, number, starts)
                    })?;
                self.with_starts(dimensions, modes.clone(), &at, starts)
            }),
        };
        explained_by(result, self.parameters, dimensions)
    }

    /// An assembly with other dimensions that is good at these inputs alone: its coupled groups are
    /// followed there. It need not close, and its angles count turns from those of `from`.
    pub(crate) fn followed_at(
        &self,
        dimensions: &[f64],
        from: &Assembly<'_>,
        at: &[f64],
    ) -> Option<Assembly<'_>> {
        let states = self.follow(dimensions, from, at).ok()?;
        let mut starts = vec![InitialState::Nothing; self.groups.len()];
        for (number, (group, state)) in self.groups.iter().zip(&states).enumerate() {
            let programs = Programs::new(self, dimensions, from.modes(), at, number, &starts);
            let x: Vec<f64> = group.inputs.iter().map(|input| at[input.index]).collect();
            starts[number] = state_here(&mut programs.ok()?, &x, state)?;
        }
        let modes = from.modes().to_vec();
        Some(self.prepared(dimensions, modes, from.revolutions().clone(), starts))
    }

    /// The states of coupled groups at the end of the way from the dimensions of an assembly.
    fn follow(
        &self,
        dimensions: &[f64],
        from: &Assembly<'_>,
        at: &[f64],
    ) -> Result<Vec<Vec<f64>>, AssemblyError> {
        self.finite(dimensions)?;
        let path = Path {
            mechanism: self,
            from,
            to: dimensions,
            at,
        };
        follow_path(&path, from.states_at(at))
    }
}

/// The straight path from the dimensions of an assembly to others.
struct Path<'a> {
    mechanism: &'a Mechanism,
    from: &'a Assembly<'a>,
    to: &'a [f64],
    at: &'a [f64],
}

impl Path<'_> {
    /// The dimensions at some share of the path.
    fn dimensions(&self, share: f64) -> Vec<f64> {
        if share == 1.0 {
            return self.to.to_vec();
        }
        let pairs = self.from.dimensions().iter().zip(self.to);
        pairs.map(|(from, to)| from + share * (to - from)).collect()
    }
}

impl<'a> DimensionPath for Path<'a> {
    type Survey = Vec<f64>;
    type Programs = Programs<'a>;

    fn name(&self) -> &'static str {
        self.mechanism.name
    }

    fn levels(&self) -> &'static [Level] {
        self.mechanism.levels
    }

    fn groups(&self) -> &'static [Group] {
        self.mechanism.structure.groups
    }

    fn inputs(&self) -> &[f64] {
        self.at
    }

    fn survey(&self, share: f64, initial_states: &[InitialState]) -> Vec<f64> {
        let dimensions = self.dimensions(share);
        let (modes, starts) = (self.from.modes().to_vec(), initial_states.to_vec());
        let surveyor = self.mechanism.surveyor(&dimensions, modes, starts, self.at);
        surveyor.survey(self.at)
    }

    fn coupled(
        &self,
        share: f64,
        starts: &[InitialState],
        number: usize,
    ) -> Option<CoupledParts<Programs<'a>>> {
        let dimensions = self.dimensions(share);
        let modes = self.from.modes();
        let programs = Programs::new(self.mechanism, &dimensions, modes, self.at, number, starts);
        Some(programs.map(|programs| (&self.mechanism.groups[number], programs)))
    }
}
