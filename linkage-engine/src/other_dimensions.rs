//! The same assembly for other dimensions.

use linkage_runtime::support::{
    CoupledParts, DimensionPath, InitialState, Level, explained_by, follow_path, prepared_over_in,
    state_here,
};
use linkage_runtime::{AssemblyError, Group};

use crate::assembled::{Assembly, assembled, finite, prepared, surveyor, with_starts};
use crate::coupled::Programs;
use crate::mechanism::Mechanism;

/// Assembles other dimensions in the assembly of `from`.
pub(crate) fn continued<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    from: &Assembly<'_>,
) -> Result<Assembly<'m>, AssemblyError> {
    let at = mechanism.reference();
    let modes = from.modes().to_vec();
    let result = match (
        mechanism.compiled.groups.is_empty(),
        mechanism.groups.is_empty(),
    ) {
        (true, _) => assembled(mechanism, dimensions, modes, &at),
        (false, true) => follow(mechanism, dimensions, from, &at)
            .and_then(|_| assembled(mechanism, dimensions, modes, &at)),
        (false, false) => follow(mechanism, dimensions, from, &at).and_then(|states| {
            let nothing = vec![InitialState::Nothing; mechanism.groups.len()];
            let starts =
                prepared_over_in(mechanism.groups, nothing, &at, &states, |number, starts| {
                    Programs::new(mechanism, dimensions, &modes, &at, number, starts)
                })?;
            with_starts(mechanism, dimensions, modes.clone(), &at, starts)
        }),
    };
    explained_by(result, mechanism.parameters, dimensions)
}

/// An assembly with other dimensions that is good at these inputs alone: its coupled groups are
/// followed there. It need not close, and its angles count turns from those of `from`.
pub(crate) fn followed_at<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    from: &Assembly<'_>,
    at: &[f64],
) -> Option<Assembly<'m>> {
    let states = follow(mechanism, dimensions, from, at).ok()?;
    let mut starts = vec![InitialState::Nothing; mechanism.groups.len()];
    for (number, (group, state)) in mechanism.groups.iter().zip(&states).enumerate() {
        let programs = Programs::new(mechanism, dimensions, from.modes(), at, number, &starts);
        let x: Vec<f64> = group.inputs.iter().map(|input| at[input.index]).collect();
        starts[number] = state_here(&mut programs.ok()?, &x, state)?;
    }
    let modes = from.modes().to_vec();
    Some(prepared(
        mechanism,
        dimensions,
        modes,
        from.revolutions().clone(),
        starts,
    ))
}

/// The states of coupled groups at the end of the way from the dimensions of an assembly.
fn follow(
    mechanism: &Mechanism,
    dimensions: &[f64],
    from: &Assembly<'_>,
    at: &[f64],
) -> Result<Vec<Vec<f64>>, AssemblyError> {
    finite(mechanism, dimensions)?;
    let path = Path {
        mechanism,
        from,
        to: dimensions,
        at,
    };
    follow_path(&path, from.states_at(at))
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
        let surveyor = surveyor(self.mechanism, &dimensions, modes, starts, self.at);
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
