//! Closing the loops, and evaluating functions.

use linkage_compiler::ir::{Body, Function, Surveyed};
use linkage_runtime::support::{
    InitialState, Which, close, finite as check_finite, initial_states_of,
};
use linkage_runtime::{AssemblyError, AssemblyMode, Estimate, Scalar};
use linkage_symbolic::program::{Program, Source};

use crate::coupled::Programs;
use crate::mechanism::Mechanism;
use crate::mechanism::forever::forever;
use crate::numbers::{Numbers, States};
use crate::operations::{by_build, called};
use crate::results::Results;
use crate::revolutions::Revolutions;
use crate::winding::Winding;

/// An assembled mechanism.
#[derive(Clone, Debug)]
pub struct Assembly<'m> {
    mechanism: &'m Mechanism,
    dimensions: Vec<f64>,
    modes: Vec<AssemblyMode>,
    starts: Vec<InitialState>,
    revolutions: Revolutions,
    prepared: Vec<f64>,
}

impl<'m> Assembly<'m> {
    /// The mode of each group that has two.
    #[must_use]
    pub fn modes(&self) -> &[AssemblyMode] {
        &self.modes
    }

    /// The dimensions that it was assembled with.
    #[must_use]
    pub fn dimensions(&self) -> &[f64] {
        &self.dimensions
    }

    /// Returns the share of the ranges of the inputs in which groups without a closed form are
    /// assembled, from 0 to 1: elsewhere results are NaN, because the links do not reach each other
    /// there or a dead point is near. Of several groups the one that serves least counts; without
    /// such a group over several inputs it is 1.
    #[must_use]
    pub fn served(&self) -> f64 {
        let groups = self.mechanism.compiled.coupled.iter().zip(&self.starts);
        let shares = groups.map(|(group, start)| match start {
            InitialState::Grid(grid) if group.inputs.len() > 1 => grid.served(),
            _ => 1.0,
        });
        shares.fold(1.0, f64::min)
    }

    /// The results of a function, by its number: one for each of its columns.
    ///
    /// # Panics
    ///
    /// If there is no such function or it takes another number of arguments.
    #[must_use]
    pub fn call(&self, function: usize, arguments: &[f64]) -> Vec<f64> {
        let function = &self.mechanism.compiled.functions[function];
        assert_eq!(arguments.len(), function.arguments.len(), "its arguments");
        self.call_body(function, &function.called, arguments)
    }

    /// The results of a function, by its name, with the names of its fields.
    ///
    /// # Panics
    ///
    /// If no function has that name, or it takes another number of arguments.
    #[must_use]
    pub fn results(&self, function: &str, arguments: &[f64]) -> Results<'m> {
        let mechanism = self.mechanism;
        let number = mechanism.function(function);
        let number = number.unwrap_or_else(|error| panic!("{error}"));
        Results {
            function: &mechanism.compiled.functions[number],
            numbers: self.call(number, arguments),
        }
    }

    /// The results of one of the programs of a function.
    pub(crate) fn call_body(
        &self,
        function: &Function,
        body: &Body,
        arguments: &[f64],
    ) -> Vec<f64> {
        let Mechanism {
            compiled,
            multiply_adds,
            ..
        } = self.mechanism;
        let mut inputs = vec![f64::NAN; compiled.inputs.len() + compiled.arguments.len()];
        for (&index, x) in function.arguments.iter().zip(arguments) {
            inputs[index] = *x;
        }
        let states = self.states(&inputs);
        match body.is_worth_a_call() {
            true => {
                let states = states.by_machine();
                let numbers = self.numbers(&inputs, &states);
                called(*multiply_adds, body, |source| numbers.load(source))
            }
            false => {
                let states = states.by_build();
                let numbers = self.numbers(&inputs, &states);
                by_build(*multiply_adds, &body.program, |source| numbers.load(source))
            }
        }
    }

    /// Returns the values of the unknowns at these inputs.
    #[must_use]
    pub fn unknowns(&self, inputs: &[f64]) -> Vec<Estimate> {
        let unit = &self.mechanism.compiled;
        let numbers = self.survey(inputs);
        let mut next = numbers[1 + unit.groups.len()..].iter().copied();
        let estimate = |surveyed: &Surveyed| {
            let numbers: Vec<f64> = next.by_ref().take(surveyed.numbers).collect();
            let unknown = &unit.unknowns[surveyed.unknown];
            Estimate {
                name: forever(unknown.name.as_str()),
                unit: forever(unknown.unit.as_str()),
                angle: surveyed.angle,
                numbers: match numbers[..] {
                    [cosine, sine] if surveyed.angle => vec![Scalar::atan2(sine, cosine)],
                    _ => numbers,
                },
            }
        };
        unit.surveyed.iter().map(estimate).collect()
    }

    /// Returns the numbers that distinguish assemblies at these inputs: cosine and sine, or length,
    /// of every unknown.
    #[must_use]
    pub fn places(&self, inputs: &[f64]) -> Vec<f64> {
        self.survey(inputs)
            .split_off(1 + self.mechanism.compiled.groups.len())
    }

    /// The least margin of all groups, the slack of every group, the numbers of the unknowns.
    pub(crate) fn survey(&self, inputs: &[f64]) -> Vec<f64> {
        let states = self.states(inputs).by_build();
        let numbers = self.numbers(inputs, &states);
        self.run(&self.mechanism.compiled.survey, numbers)
    }

    /// Returns the closure error of each group at these inputs.
    pub(crate) fn gaps(&self, inputs: &[f64]) -> Vec<f64> {
        let states = self.states(inputs).by_build();
        let numbers = self.numbers(inputs, &states);
        self.run(&self.mechanism.compiled.gaps, numbers)
    }

    fn run(&self, program: &Program, numbers: Numbers<'_>) -> Vec<f64> {
        by_build(self.mechanism.multiply_adds, program, |source| {
            numbers.load(source)
        })
    }

    pub(crate) fn mechanism(&self) -> &'m Mechanism {
        self.mechanism
    }

    /// The numbers that depend on the dimensions alone.
    pub(crate) fn prepared(&self) -> &[f64] {
        &self.prepared
    }

    /// The turns of its angles.
    pub(crate) fn revolutions(&self) -> &Revolutions {
        &self.revolutions
    }

    /// The tables of coupled groups.
    pub(crate) fn starts(&self) -> &[InitialState] {
        &self.starts
    }

    /// The state of each coupled group at these inputs, without its floor.
    pub(crate) fn states_at(&self, inputs: &[f64]) -> Vec<Vec<f64>> {
        let mut states = self.states(inputs).by_build();
        for state in &mut states {
            state.pop();
        }
        states
    }

    /// Returns a number that no position and no dimension changes.
    pub(crate) fn constant(&self, source: Source) -> f64 {
        self.numbers(&[], &[]).load(source)
    }

    /// Returns true if all groups close at these inputs.
    fn close(&self, inputs: &[f64]) -> Result<(), AssemblyError> {
        let gaps = self.gaps(inputs);
        let Mechanism {
            name,
            structure,
            gap_units,
            ..
        } = self.mechanism;
        close(name, structure.groups, gap_units, &gaps)
    }

    /// The origin of the states of coupled groups.
    fn states<'a>(&'a self, inputs: &'a [f64]) -> States<'a> {
        States {
            mechanism: self.mechanism,
            starts: &self.starts,
            inputs,
        }
    }

    fn numbers<'a>(&'a self, inputs: &'a [f64], states: &'a [Vec<f64>]) -> Numbers<'a> {
        Numbers {
            dimensions: &self.dimensions,
            modes: &self.modes,
            revolutions: &self.revolutions,
            prepared: &self.prepared,
            inputs,
            states,
        }
    }
}

/// The assembly in these modes that the start estimates choose.
pub(crate) fn assembled<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    modes: Vec<AssemblyMode>,
    at: &[f64],
) -> Result<Assembly<'m>, AssemblyError> {
    finite(mechanism, dimensions)?;
    let mut all = starts(mechanism, dimensions, &modes, at, Which::Nearest)?;
    with_starts(mechanism, dimensions, modes, at, all.swap_remove(0))
}

/// All assemblies in these modes: coupled groups have further ones.
pub(crate) fn all_assembled<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    modes: Vec<AssemblyMode>,
    at: &[f64],
) -> Result<Vec<Assembly<'m>>, AssemblyError> {
    finite(mechanism, dimensions)?;
    let mut found = Vec::new();
    let mut missed = None;
    for starts in starts(mechanism, dimensions, &modes, at, Which::All)? {
        match with_starts(mechanism, dimensions, modes.clone(), at, starts) {
            Ok(assembly) => found.push(assembly),
            // Others may let closed forms behind the coupled groups close.
            Err(error @ AssemblyError::CannotClose { .. }) => missed = Some(error),
            Err(error) => return Err(error),
        }
    }
    match missed {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
}

/// Prepares the coupled groups for the wanted assemblies; for a mechanism without any, returns
/// one list of none.
fn starts(
    mechanism: &Mechanism,
    dimensions: &[f64],
    modes: &[AssemblyMode],
    at: &[f64],
    wanted: Which<'_>,
) -> Result<Vec<Vec<InitialState>>, AssemblyError> {
    let nothing = vec![InitialState::Nothing; mechanism.groups.len()];
    let found = initial_states_of(
        mechanism.groups,
        nothing.clone(),
        at,
        wanted,
        |number, starts| Programs::new(mechanism, dimensions, modes, at, number, starts),
    );
    found.map_err(|error| {
        // A group with a closed form that does not close before a coupled one is needed.
        let revolutions = Revolutions::at_estimates(mechanism);
        let closed =
            prepared(mechanism, dimensions, modes.to_vec(), revolutions, nothing).close(at);
        match closed {
            Err(first @ AssemblyError::CannotClose { .. }) => first,
            _ => error,
        }
    })
}

pub(crate) fn with_starts<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    modes: Vec<AssemblyMode>,
    at: &[f64],
    starts: Vec<InitialState>,
) -> Result<Assembly<'m>, AssemblyError> {
    let turning = Winding {
        mechanism,
        dimensions,
        modes: &modes,
        starts: &starts,
    };
    let found = turning.wind(mechanism.angles.len(), at);
    let revolutions = match &found {
        Ok(revolutions) => revolutions.clone(),
        Err(_) => Revolutions::at_estimates(mechanism),
    };
    let assembly = prepared(mechanism, dimensions, modes, revolutions, starts);
    assembly.close(at)?;
    match found {
        Ok(_) => Ok(assembly),
        Err(unknown) => Err(AssemblyError::NoWinding {
            mechanism: mechanism.name,
            unknown,
        }),
    }
}

/// An assembly that need not close.
pub(crate) fn prepared<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    modes: Vec<AssemblyMode>,
    revolutions: Revolutions,
    starts: Vec<InitialState>,
) -> Assembly<'m> {
    let turning = Winding {
        mechanism,
        dimensions,
        modes: &modes,
        starts: &starts,
    };
    let prepared = turning.prepare(&revolutions);
    Assembly {
        mechanism,
        dimensions: dimensions.to_vec(),
        modes,
        starts,
        revolutions,
        prepared,
    }
}

/// An assembly that need not close, for surveys at these inputs.
pub(crate) fn surveyor<'m>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    modes: Vec<AssemblyMode>,
    starts: Vec<InitialState>,
    at: &[f64],
) -> Assembly<'m> {
    let turning = Winding {
        mechanism,
        dimensions,
        modes: &modes,
        starts: &starts,
    };
    let found = match mechanism.compiled.surveying {
        0 => None,
        count => turning.wind(count, at).ok(),
    };
    let revolutions = found.unwrap_or_else(|| Revolutions::at_estimates(mechanism));
    prepared(mechanism, dimensions, modes, revolutions, starts)
}

pub(crate) fn finite(mechanism: &Mechanism, dimensions: &[f64]) -> Result<(), AssemblyError> {
    let groups = mechanism.compiled.groups.iter();
    let needed: Vec<usize> = groups.flat_map(|group| group.parameters.clone()).collect();
    check_finite(mechanism.name, mechanism.parameters, &needed, dimensions)
}
