//! The numbers that the program of a sweep loads, and the columns of its results.

use linkage_compiler::ir::Function;
use linkage_symbolic::blocks::{BLOCK, Rows};
use linkage_symbolic::program::Source;

use crate::compiled::Assembly;
use crate::mechanism::Mechanism;

/// The numbers at the positions of a sweep: slices with one for each position, or one for all.
#[derive(Clone, Debug)]
pub(super) struct Loads<'a> {
    assembly: &'a Assembly<'a>,
    function: &'a Function,
    /// Inputs, then arguments; `None` for those that the function does not take.
    inputs: Vec<Option<&'a [f64]>>,
    dimensions: Vec<&'a [f64]>,
    prepared: Vec<&'a [f64]>,
}

impl<'a> Loads<'a> {
    /// The numbers of an assembly, with the arguments of a function.
    pub(super) fn new(
        assembly: &'a Assembly<'a>,
        function: &'a Function,
        arguments: &[&'a [f64]],
    ) -> Self {
        let compiled = &assembly.mechanism().compiled;
        let mut inputs = vec![None; compiled.inputs.len() + compiled.arguments.len()];
        for (&index, slice) in function.arguments.iter().zip(arguments) {
            inputs[index] = Some(*slice);
        }
        Self {
            assembly,
            function,
            inputs,
            dimensions: assembly.dimensions().chunks(1).collect(),
            prepared: assembly.prepared().chunks(1).collect(),
        }
    }

    /// The mechanism of the assembly.
    pub(super) fn mechanism(&self) -> &Mechanism {
        self.assembly.mechanism()
    }

    /// The same with other dimensions.
    pub(super) fn with_dimensions(mut self, dimensions: &[&'a [f64]]) -> Self {
        self.dimensions = dimensions.to_vec();
        self
    }

    /// The same with other prepared numbers in some slots.
    pub(super) fn with_prepared(mut self, slots: &[usize], numbers: &'a [Vec<f64>]) -> Self {
        for (&slot, numbers) in slots.iter().zip(numbers) {
            self.prepared[slot] = numbers;
        }
        self
    }

    /// The same at positions `from..to` alone.
    pub(super) fn part(&self, from: usize, to: usize) -> Self {
        let part = |slice: &'a [f64]| match slice {
            [_] => slice,
            _ => &slice[from..to],
        };
        Self {
            inputs: self.inputs.iter().map(|slice| slice.map(part)).collect(),
            dimensions: self.dimensions.iter().map(|&slice| part(slice)).collect(),
            ..self.clone()
        }
    }

    /// The dimensions at a position, and the arguments of the function.
    pub(super) fn row(&self, position: usize) -> (Vec<f64>, Vec<f64>) {
        let arguments = self.function.arguments.iter();
        let arguments = arguments.filter_map(|&index| self.inputs[index]);
        let dimensions = self.dimensions.iter();
        (
            dimensions.map(|slice| number(slice, position)).collect(),
            arguments.map(|slice| number(slice, position)).collect(),
        )
    }

    /// Returns true for a source that differs from position to position.
    pub(super) fn varies(&self, source: Source) -> bool {
        match source {
            Source::Parameter(index) => self.dimensions[index].len() != 1,
            Source::Input(index) => self.inputs[index].is_some_and(|slice| slice.len() != 1),
            Source::Prepared(slot) => self.prepared[slot].len() != 1,
            Source::State(..) => true,
            Source::Mode(_)
            | Source::Centre(_)
            | Source::Winding(..)
            | Source::Carried(_)
            | Source::Limit => false,
        }
    }
}

/// The blocks of a sweep.
pub(super) struct Blocks<'a, 'c, const FUSED: bool> {
    loads: &'a Loads<'a>,
    columns: &'a mut [&'c mut [f64]],
    start: usize,
    /// The state of each coupled group, with its floor, number by number.
    states: Vec<Vec<[f64; BLOCK]>>,
}

impl<'a, 'c, const FUSED: bool> Blocks<'a, 'c, FUSED> {
    pub(super) fn new(loads: &'a Loads<'a>, columns: &'a mut [&'c mut [f64]]) -> Self {
        let groups = loads.assembly.mechanism().compiled.coupled.iter();
        let states = groups.map(|group| vec![[f64::NAN; BLOCK]; group.size + 1]);
        Self {
            loads,
            columns,
            start: 0,
            states: states.collect(),
        }
    }
}

/// The number of a slice at a position.
pub(super) fn number(slice: &[f64], position: usize) -> f64 {
    match *slice {
        [only] => only,
        _ => slice[position],
    }
}

/// The numbers of a slice from a position on; behind its end the last one.
#[inline(always)]
fn fill(slice: &[f64], start: usize, block: &mut [f64; BLOCK]) {
    match slice {
        [] => {}
        [only] => *block = [*only; BLOCK],
        [.., last] => match slice[start..].first_chunk() {
            Some(whole) => *block = *whole,
            None => {
                let rest = &slice[start..];
                *block = [*last; BLOCK];
                block[..rest.len()].copy_from_slice(rest);
            }
        },
    }
}

impl<const FUSED: bool> Rows<f64> for Blocks<'_, '_, FUSED> {
    #[inline(always)]
    fn begin(&mut self, start: usize) {
        self.start = start;
        let Loads {
            assembly,
            function,
            inputs,
            ..
        } = self.loads;
        for &number in &function.states {
            let group = &assembly.mechanism().compiled.coupled[number];
            let mut x = vec![[0.0; BLOCK]; group.inputs.len()];
            for (block, &input) in x.iter_mut().zip(&group.inputs) {
                if let Some(slice) = inputs[input] {
                    fill(slice, start, block);
                }
            }
            let mut state = vec![f64::NAN; group.size];
            let mut at = vec![0.0; group.inputs.len()];
            for row in 0..BLOCK {
                for (at, block) in at.iter_mut().zip(&x) {
                    *at = block[row];
                }
                let floor = assembly.starts()[number].look_up::<FUSED>(&at, &mut state);
                let numbers = state.iter().chain([&floor]);
                for (block, number) in self.states[number].iter_mut().zip(numbers) {
                    block[row] = *number;
                }
            }
        }
    }

    #[inline(always)]
    fn load(&mut self, source: Source, block: &mut [f64; BLOCK]) {
        let loads = self.loads;
        let slice = match source {
            Source::Parameter(index) => loads.dimensions[index],
            Source::Input(index) => loads.inputs[index].unwrap_or(&[f64::NAN]),
            Source::Prepared(slot) => loads.prepared[slot],
            Source::State(group, component) => {
                *block = self.states[group][component];
                return;
            }
            Source::Mode(_)
            | Source::Centre(_)
            | Source::Winding(..)
            | Source::Carried(_)
            | Source::Limit => {
                *block = [loads.assembly.constant(source); BLOCK];
                return;
            }
        };
        fill(slice, self.start, block);
    }

    #[inline(always)]
    fn store(&mut self, output: usize, block: &[f64; BLOCK]) {
        let rest = &mut self.columns[output][self.start..];
        match rest.first_chunk_mut() {
            Some(whole) => *whole = *block,
            None => {
                let count = rest.len();
                rest.copy_from_slice(&block[..count]);
            }
        }
    }
}
