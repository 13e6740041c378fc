//! A mechanism with its dimensions, as the runtime assembles it: its programs are interpreted.

use linkage_compiler::ir::Generated;
use linkage_runtime::support::{
    AssemblyData, Core, CoreOf, DataOf, Description, GroupData, GroupProgram, Grouped,
    InitialState, PlainGroups, Revolutions, RevolutionsOf, RowNumbersMut, pairs,
};
use linkage_runtime::{AssemblyMode, Enclosure, Scalar};
use linkage_symbolic::interpret::run_by;
use linkage_symbolic::program::{Program, Source};

use crate::mechanism::Mechanism;
use crate::numbers::{AllRevolutions, Numbers, States};
use crate::operations::{MultiplyAdds, by_build, over_states};

/// A mechanism with its dimensions.
#[derive(Clone, Debug)]
pub(crate) struct Compiled<'m> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) dimensions: Vec<f64>,
}

/// The data of an assembly, in types that shorten with the borrow of the mechanism.
pub(crate) type Data<'m> = AssemblyData<
    Core<Compiled<'m>, Vec<AssemblyMode>, AllRevolutions, Vec<f64>>,
    Vec<InitialState>,
>;

/// An assembled mechanism.
#[derive(Clone, Debug)]
pub struct Assembly<'m> {
    pub(crate) data: Data<'m>,
}

/// The inputs, and the state of each coupled group there with its floor.
pub(crate) struct Arguments {
    inputs: Vec<f64>,
    states: Vec<Vec<f64>>,
}

impl<'m> Compiled<'m> {
    pub(crate) fn new(mechanism: &'m Mechanism, dimensions: &[f64]) -> Self {
        Self {
            mechanism,
            dimensions: dimensions.to_vec(),
        }
    }
}

static NO_REVOLUTIONS: AllRevolutions = Revolutions {
    centres: Vec::new(),
    windings: Vec::new(),
};

/// The numbers of an assembly.
pub(crate) fn numbers<'a>(
    core: &'a CoreOf<Compiled<'_>>,
    inputs: &'a [f64],
    states: &'a [Vec<f64>],
) -> Numbers<'a> {
    Numbers {
        dimensions: &core.dimensions.dimensions,
        modes: &core.modes,
        revolutions: &core.revolutions,
        prepared: &core.prepared,
        inputs,
        states,
    }
}

impl<'m> linkage_runtime::support::Compiled for Compiled<'m> {
    type Scalar = f64;
    type Plain = Self;
    type Assembly = Assembly<'m>;
    type Modes = Vec<AssemblyMode>;
    type Inputs = Vec<f64>;
    type Centres = Vec<f64>;
    type Windings = Vec<Vec<f64>>;
    type Prepared = Vec<f64>;
    type States = Vec<InitialState>;
    type Arguments = Arguments;

    fn description(&self) -> &Description {
        &self.mechanism.description
    }

    fn assembly(data: DataOf<Self>) -> Assembly<'m> {
        Assembly { data }
    }

    fn data<'a>(assembly: &'a Assembly<'m>) -> &'a DataOf<Self> {
        &assembly.data
    }

    fn dimensions(&self) -> impl AsRef<[f64]> {
        &self.dimensions
    }

    fn with_dimensions(&self, dimension: impl Fn(usize) -> f64) -> Self {
        Self {
            mechanism: self.mechanism,
            dimensions: (0..self.dimensions.len()).map(dimension).collect(),
        }
    }

    fn plain(&self, dimension: impl Fn(usize) -> f64) -> Self {
        self.with_dimensions(dimension)
    }

    fn arguments(&self, states: &Vec<InitialState>, inputs: &Vec<f64>) -> Arguments {
        let states = States {
            mechanism: self.mechanism,
            starts: states,
            inputs,
        };
        Arguments {
            states: states.by_build(),
            inputs: inputs.clone(),
        }
    }

    fn prepare<const FUSED: bool>(
        &self,
        modes: &Vec<AssemblyMode>,
        revolutions: &RevolutionsOf<Self>,
        slots: &mut impl RowNumbersMut<f64>,
    ) {
        let numbers = self.numbers(modes, revolutions);
        let load = |source| numbers.load(source);
        let program = &self.mechanism.compiled.prepare;
        let prepared = match self.mechanism.multiply_adds {
            MultiplyAdds::Generated => run_by::<Generated<f64, FUSED>>(program, load),
            MultiplyAdds::Fused => run_by::<Generated<f64, true>>(program, load),
            MultiplyAdds::Separate => run_by::<Generated<f64, false>>(program, load),
        };
        for (slot, value) in prepared.into_iter().enumerate() {
            slots.put(slot, value);
        }
    }

    fn gaps(
        &self,
        modes: &Vec<AssemblyMode>,
        prepared: &Vec<f64>,
        x: Arguments,
    ) -> impl AsRef<[f64]> {
        self.run(&self.mechanism.compiled.gaps, modes, prepared, &x)
    }

    fn directions(
        &self,
        modes: &Vec<AssemblyMode>,
        prepared: &Vec<f64>,
        x: Arguments,
    ) -> impl AsRef<[[f64; 2]]> {
        let program = &self.mechanism.compiled.directions;
        pairs(&self.run(program, modes, prepared, &x))
    }

    fn bearings(&self, modes: &Vec<AssemblyMode>) -> impl AsRef<[[f64; 2]]> {
        let numbers = self.numbers(modes, &NO_REVOLUTIONS);
        let bearings = &self.mechanism.compiled.bearings;
        let multiply_adds = self.mechanism.multiply_adds;
        pairs(&by_build(multiply_adds, bearings, |source| {
            numbers.load(source)
        }))
    }
}

impl Compiled<'_> {
    /// The outputs of a program of an assembly, by the instructions of the build. Revolutions are in
    /// the prepared numbers.
    fn run(
        &self,
        program: &Program,
        modes: &[AssemblyMode],
        prepared: &[f64],
        x: &Arguments,
    ) -> Vec<f64> {
        let numbers = Numbers {
            prepared,
            inputs: &x.inputs,
            states: &x.states,
            ..self.numbers(modes, &NO_REVOLUTIONS)
        };
        let multiply_adds = self.mechanism.multiply_adds;
        by_build(multiply_adds, program, |source| numbers.load(source))
    }

    /// The numbers that no input and nothing prepared changes.
    fn numbers<'a>(
        &'a self,
        modes: &'a [AssemblyMode],
        revolutions: &'a AllRevolutions,
    ) -> Numbers<'a> {
        Numbers {
            dimensions: &self.dimensions,
            modes,
            revolutions,
            prepared: &[],
            inputs: &[],
            states: &[],
        }
    }
}

impl Grouped for Compiled<'_> {
    const COUPLED: bool = true;
    type Lane = Vec<InitialState>;
    type Survey = Vec<f64>;

    fn group_data(&self) -> &GroupData {
        &self.mechanism.group_data
    }

    fn states(&self, lanes: &[Vec<InitialState>]) -> Vec<InitialState> {
        lanes[0].clone()
    }

    /// Computes all numbers, whatever is asked for.
    fn survey<const SLACKS: bool>(core: &CoreOf<Self>, x: Arguments) -> Vec<f64> {
        let (compiled, modes, prepared) = core.loaded();
        compiled.run(&compiled.mechanism.compiled.survey, modes, prepared, &x)
    }

    fn state_mut(x: &mut Arguments, number: usize) -> &mut [f64] {
        // Without its floor.
        x.states[number]
            .split_last_mut()
            .map_or(&mut [], |(_, state)| state)
    }
}

impl PlainGroups for Compiled<'_> {
    fn run<R>(
        core: &CoreOf<Self>,
        number: usize,
        program: GroupProgram,
        x: Arguments,
        read: impl FnOnce(&[f64]) -> R,
    ) -> R {
        let (compiled, modes, prepared) = core.loaded();
        let group = &compiled.mechanism.compiled.coupled[number];
        let program = match program {
            GroupProgram::System => &group.system,
            GroupProgram::Correct => &group.correct,
            GroupProgram::Placed => &group.placed,
            GroupProgram::Estimate => &group.estimate,
            GroupProgram::Missed => &group.missed,
        };
        read(&compiled.run(program, modes, prepared, &x))
    }

    fn residuals(
        core: &CoreOf<Self>,
        number: usize,
        x: Arguments,
        state: &[Enclosure],
    ) -> Vec<Enclosure> {
        let numbers = numbers(core, &x.inputs, &x.states);
        let program = &core.dimensions.mechanism.compiled.coupled[number].residuals;
        over_states(program, |source| match source {
            Source::State(group, component) if group == number => state[component],
            _ => Enclosure::from_f64(numbers.load(source)),
        })
    }
}
