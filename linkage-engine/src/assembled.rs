//! The values of the functions of an assembled mechanism.

use linkage_compiler::ir::{Body, Function, Surveyed};
use linkage_runtime::support::{
    AssemblyData, Compiled as _, CoreOf, Grouped, InitialState, assemble_there, check_range_of,
};
use linkage_runtime::{AssemblyMode, Estimate, NotFollowed, RangeReport, Scalar};
use linkage_symbolic::program::Source;

use crate::assembly_follower::Follower;
use crate::compiled::{Assembly, Compiled, numbers};
use crate::mechanism::Mechanism;
use crate::mechanism::forever::forever;
use crate::numbers::States;
use crate::operations::{by_build, called};
use crate::results::Results;

impl<'m> Assembly<'m> {
    /// The mode of each group that has two.
    #[must_use]
    pub fn modes(&self) -> &[AssemblyMode] {
        &self.core().modes
    }

    /// The dimensions that it was assembled with.
    #[must_use]
    pub fn dimensions(&self) -> &[f64] {
        &self.core().dimensions.dimensions
    }

    /// Checks the declared range. A mechanism without groups has no findings.
    ///
    /// It returns the same as the method `check_range` of the macro's assembly.
    #[must_use]
    pub fn check_range(&self) -> RangeReport {
        check_range_of::<Compiled<'m>>(self)
    }

    /// Returns the share of the ranges of the inputs in which groups without a closed form are
    /// assembled, from 0 to 1: elsewhere results are NaN, because the links do not reach each other
    /// there or a dead point is near. Of several groups the one that serves least counts; without
    /// such a group over several inputs it is 1.
    #[must_use]
    pub fn served(&self) -> f64 {
        let coupled = &self.mechanism().compiled.coupled;
        let groups = coupled.iter().zip(self.starts());
        let shares = groups.map(|(group, start)| match start {
            InitialState::Grid(grid) if group.inputs.len() > 1 => grid.served(),
            _ => 1.0,
        });
        shares.fold(1.0, f64::min)
    }

    /// Returns a follower at these inputs, where the assembly must serve: at the reference inputs, if
    /// no range is declared.
    ///
    /// # Errors
    ///
    /// Where the assembly does not serve.
    ///
    /// # Panics
    ///
    /// If there is another number of inputs.
    pub fn follower<'a>(&'a self, inputs: &[f64]) -> Result<Follower<'a>, NotFollowed> {
        Follower::new(self, inputs)
    }

    /// The results of a function, by its number: one for each of its columns.
    ///
    /// # Panics
    ///
    /// If there is no such function or it takes another number of arguments.
    #[must_use]
    pub fn call(&self, function: usize, arguments: &[f64]) -> Vec<f64> {
        let function = &self.mechanism().compiled.functions[function];
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
        let mechanism = self.mechanism();
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
        } = self.mechanism();
        let mut inputs = vec![f64::NAN; compiled.inputs.len() + compiled.arguments.len()];
        for (&index, x) in function.arguments.iter().zip(arguments) {
            inputs[index] = *x;
        }
        let states = self.states(&inputs);
        match body.is_worth_a_call() {
            true => {
                let states = states.by_machine();
                let numbers = numbers(self.core(), &inputs, &states);
                called(*multiply_adds, body, |source| numbers.load(source))
            }
            false => {
                let states = states.by_build();
                let numbers = numbers(self.core(), &inputs, &states);
                by_build(*multiply_adds, &body.program, |source| numbers.load(source))
            }
        }
    }

    /// Returns the values of the unknowns at these inputs.
    #[must_use]
    pub fn unknowns(&self, inputs: &[f64]) -> Vec<Estimate> {
        let unit = &self.mechanism().compiled;
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
            .split_off(1 + self.mechanism().compiled.groups.len())
    }

    /// Returns the gap by which each group misses closing at these inputs, in the unit of its loops:
    /// 0 for a group that closes, NaN after one that does not.
    #[must_use]
    pub fn gaps(&self, inputs: &[f64]) -> Vec<f64> {
        let (compiled, modes, prepared) = self.core().loaded();
        let x = compiled.arguments(self.starts(), &inputs.to_vec());
        compiled.gaps(modes, prepared, x).as_ref().to_vec()
    }

    /// The least margin of all groups, the slack of every group, the numbers of the unknowns.
    fn survey(&self, inputs: &[f64]) -> Vec<f64> {
        let core = self.core();
        let x = core.dimensions.arguments(self.starts(), &inputs.to_vec());
        Compiled::survey::<false>(core, x)
    }

    pub(crate) fn mechanism(&self) -> &'m Mechanism {
        self.core().dimensions.mechanism
    }

    /// Returns the turns of the continuous angles, as exported sweeps over dimensions take them: for
    /// each angle its centre, then its winding with each input.
    #[must_use]
    pub fn turns(&self) -> Vec<f64> {
        let compiled = &self.mechanism().compiled;
        let inputs = compiled.inputs.len();
        let angle = |angle| {
            let windings = (0..inputs).map(move |input| Source::Winding(angle, input));
            std::iter::once(Source::Centre(angle)).chain(windings)
        };
        let sources = (0..compiled.angles.len()).flat_map(angle);
        sources.map(|source| self.constant(source)).collect()
    }

    /// The numbers that depend on the dimensions alone.
    pub(crate) fn prepared(&self) -> &[f64] {
        &self.core().prepared
    }

    /// The tables of coupled groups.
    pub(crate) fn starts(&self) -> &Vec<InitialState> {
        AssemblyData::starts(&self.data)
    }

    /// Returns a number that no position and no dimension changes.
    pub(crate) fn constant(&self, source: Source) -> f64 {
        numbers(self.core(), &[], &[]).load(source)
    }

    /// The assembly of other dimensions that is good at these inputs alone; `None` where it cannot
    /// be followed.
    pub(crate) fn at_dimensions(&self, dimensions: &[f64], at: &[f64]) -> Option<Self> {
        let compiled = Compiled::new(self.mechanism(), dimensions);
        assemble_there(&compiled, self, &at.to_vec())
    }

    pub(crate) fn core(&self) -> &CoreOf<Compiled<'m>> {
        AssemblyData::core(&self.data)
    }

    /// The origin of the states of coupled groups.
    pub(crate) fn states<'a>(&'a self, inputs: &'a [f64]) -> States<'a> {
        States {
            mechanism: self.mechanism(),
            starts: self.starts(),
            inputs,
        }
    }
}
