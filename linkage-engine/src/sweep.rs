//! Functions at many positions, and of many mechanisms.

mod slices;

use std::cell::RefCell;
use std::num::NonZero;
use std::sync::OnceLock;
use std::thread;

use linkage_compiler::ir::{Function, Generated};
use linkage_runtime::support::Dispatch;
use linkage_symbolic::Binding;
use linkage_symbolic::blocks::{BLOCK, BlockProgram};
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::columns::{Columns, rows, split};
use crate::compiled::Assembly;
use crate::mechanism::Mechanism;
use slices::{Blocks, Loads, number};

/// Mechanisms that are prepared at once.
const PREPARED: usize = 16 * BLOCK;

/// Positions from which on a program is prepared again for arguments that stand still.
const MANY: usize = 4096;

impl Assembly<'_> {
    /// Computes a function, by its number, at many positions. Each argument of the function is a
    /// slice with a value for each position, or with one value for all of them.
    ///
    /// Numbers are those of the macro's sweeps, to the last bit, except for the sines of sweeps of
    /// a few positions.
    ///
    /// # Panics
    ///
    /// If there is no such function, it takes another number of arguments, or slices differ in
    /// length.
    #[must_use]
    pub fn sweep(&self, function: usize, arguments: &[&[f64]]) -> Columns {
        let mut columns = Columns::default();
        self.sweep_into(function, arguments, &mut columns);
        columns
    }

    /// Computes the same into columns that are there: allocates for results only if they are too
    /// small.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    pub fn sweep_into(&self, function: usize, arguments: &[&[f64]], columns: &mut Columns) {
        self.fill(function, arguments, 1, columns);
    }

    /// Computes the same on all cores.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    pub fn sweep_parallel_into(
        &self,
        function: usize,
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill(function, arguments, cores(), columns);
    }

    /// Computes the same by a [`call`](Self::call) for each position: the columns have the bits of
    /// single calls.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    #[must_use]
    pub fn calls(&self, function: usize, arguments: &[&[f64]]) -> Columns {
        let heading = self.mechanism().headings()[function];
        let positions = positions(heading.function, heading.arguments, arguments);
        let mut columns = Columns::default();
        columns.fill(heading, positions, 1, |from, mut columns| {
            for row in 0..rows(&columns) {
                let slices = arguments.iter();
                let given: Vec<f64> = slices.map(|slice| number(slice, from + row)).collect();
                let numbers = self.call(function, &given);
                for (column, number) in columns.iter_mut().zip(numbers) {
                    column[row] = number;
                }
            }
        });
        columns
    }

    /// Computes a function for many mechanisms, each at inputs of its own. Each scalar parameter is
    /// a slice with a value for each mechanism, or with one value for all of them; so is each
    /// argument of the function.
    ///
    /// All are assembled in the modes of this assembly, and their angles count turns from those of
    /// this one. Coupled groups are followed straight from the dimensions of this one, at the
    /// position. Where one cannot be assembled at its position, the results are NaN.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep); if there is another number of parameters.
    #[must_use]
    pub fn sweep_sets(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
    ) -> Columns {
        let mut columns = Columns::default();
        self.sweep_sets_into(function, parameters, arguments, &mut columns);
        columns
    }

    /// Computes the same into columns that are there.
    ///
    /// # Panics
    ///
    /// As [`sweep_sets`](Self::sweep_sets).
    pub fn sweep_sets_into(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill_sets(function, parameters, arguments, 1, columns);
    }

    /// Computes the same on all cores.
    ///
    /// # Panics
    ///
    /// As [`sweep_sets`](Self::sweep_sets).
    pub fn sweep_sets_parallel_into(
        &self,
        function: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        columns: &mut Columns,
    ) {
        self.fill_sets(function, parameters, arguments, cores(), columns);
    }

    fn fill(&self, number: usize, arguments: &[&[f64]], threads: usize, columns: &mut Columns) {
        let mechanism = self.mechanism();
        let heading = mechanism.headings()[number];
        let positions = positions(heading.function, heading.arguments, arguments);
        let function = &mechanism.compiled.functions[number];
        let body = &function.called;
        let loads = Loads::new(self, function, arguments);
        let fill = |program: &BlockProgram, columns: &mut Columns| {
            columns.fill(heading, positions, threads, |from, columns| {
                let to = from + rows(&columns);
                let loads = loads.part(from, to);
                run(program, body.compares_sines, &loads, columns);
            });
        };
        let stands_still = arguments.iter().any(|slice| slice.len() == 1);
        match positions >= MANY && stands_still {
            true => {
                let program = BlockProgram::new(&body.program, |source| loads.varies(source));
                fill(&program, columns);
            }
            false => fill(block_program(mechanism, number), columns),
        }
    }

    fn fill_sets(
        &self,
        number: usize,
        parameters: &[&[f64]],
        arguments: &[&[f64]],
        threads: usize,
        columns: &mut Columns,
    ) {
        let mechanism = self.mechanism();
        let heading = mechanism.headings()[number];
        let names = mechanism
            .parameters()
            .iter()
            .map(|parameter| parameter.name);
        let names: Vec<&str> = names.chain(heading.arguments.iter().copied()).collect();
        let all = [parameters, arguments].concat();
        let positions = positions(heading.function, &names, &all);
        let function = &mechanism.compiled.functions[number];
        let body = function.beside.as_ref().unwrap_or(&function.called);
        let loads = Loads::new(self, function, arguments).with_dimensions(parameters);
        let (prepare, slots) = prepare(&mechanism.compiled.prepare, &body.program);
        let preparing = BlockProgram::new(&prepare, |source| loads.varies(source));
        let program = BlockProgram::new(&body.program, |source| {
            matches!(source, Source::Prepared(_)) || loads.varies(source)
        });
        columns.fill(heading, positions, threads, |start, columns| {
            let end = start + rows(&columns);
            let mut rest = columns;
            for from in (start..end).step_by(PREPARED) {
                let to = (from + PREPARED).min(end);
                let (part, others) = split(rest, to - from);
                rest = others;
                let loads = loads.part(from, to);
                let mut numbers = vec![vec![0.0; to - from]; slots.len()];
                let slices = numbers.iter_mut().map(Vec::as_mut_slice);
                run(&preparing, true, &loads, slices.collect());
                let loads = loads.with_prepared(&slots, &numbers);
                let part = run(&program, body.compares_sines, &loads, part);
                if !function.states.is_empty() {
                    self.follow_missing(function, &loads, part);
                }
            }
        });
    }

    /// Computes rows that are not a number again, with coupled groups that are followed from the
    /// dimensions of this assembly. Where the way is blocked they stay as they are.
    fn follow_missing(&self, function: &Function, loads: &Loads<'_>, mut columns: Vec<&mut [f64]>) {
        let mechanism = self.mechanism();
        let body = function.beside.as_ref().unwrap_or(&function.called);
        for row in 0..rows(&columns) {
            if !columns.iter().any(|column| column[row].is_nan()) {
                continue;
            }
            let (dimensions, arguments) = loads.row(row);
            let mut at = mechanism.reference();
            for (&index, x) in function.arguments.iter().zip(&arguments) {
                // Others are no inputs.
                if let Some(input) = at.get_mut(index) {
                    *input = *x;
                }
            }
            if let Some(found) = self.at_dimensions(&dimensions, &at) {
                let numbers = found.call_body(function, body, &arguments);
                for (column, number) in columns.iter_mut().zip(numbers) {
                    column[row] = number;
                }
            }
        }
    }
}

/// The program of a function all of whose arguments differ from position to position.
fn block_program(mechanism: &Mechanism, function: usize) -> &BlockProgram {
    mechanism.block_programs[function].get_or_init(|| {
        let program = &mechanism.compiled.functions[function].called.program;
        BlockProgram::new(program, |source| source.binding() == Binding::Call)
    })
}

/// The number of threads that run at once; to ask the system for it takes longer than a sweep.
fn cores() -> usize {
    static CORES: OnceLock<usize> = OnceLock::new();
    *CORES.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
}

/// The number of positions that the slices are for.
fn positions(function: &str, names: &[&str], slices: &[&[f64]]) -> usize {
    assert_eq!(
        slices.len(),
        names.len(),
        "`{function}` takes {} slices: `{}`",
        names.len(),
        names.join("`, `")
    );
    let mut lengths = slices.iter().map(|slice| slice.len()).enumerate();
    let longest = lengths.find(|(_, length)| *length != 1);
    let (first, positions) = longest.unwrap_or((0, usize::from(!names.is_empty())));
    for (name, slice) in names.iter().zip(slices) {
        assert!(
            slice.len() == positions || slice.len() == 1,
            "`{function}`: `{}` has {positions} elements, `{name}` has {}",
            names[first],
            slice.len()
        );
    }
    positions
}

/// The program that prepares the slots that another one loads, and these slots.
fn prepare(all: &Program, body: &Program) -> (Program, Vec<usize>) {
    let loaded = body
        .instructions
        .iter()
        .filter_map(|instruction| match instruction {
            Instruction::Load(Source::Prepared(slot)) => Some(*slot),
            _ => None,
        });
    let mut slots: Vec<usize> = loaded.collect();
    slots.sort_unstable();
    slots.dedup();
    let mut program = all.clone();
    program.outputs = slots.iter().map(|&slot| all.outputs[slot]).collect();
    (program.without_unused(), slots)
}

/// Runs a program at all positions of its loads; returns the columns, filled.
fn run<'c>(
    program: &BlockProgram,
    compares_sines: bool,
    loads: &Loads<'_>,
    columns: Vec<&'c mut [f64]>,
) -> Vec<&'c mut [f64]> {
    let columns = RefCell::new(columns);
    let run = Run {
        program,
        loads,
        columns: &columns,
    };
    let multiply_adds = loads.mechanism().multiply_adds;
    match compares_sines {
        true => multiply_adds.by_machine(&Rounded::<false>(run)),
        false => multiply_adds.by_machine(&Rounded::<true>(run)),
    }
    columns.into_inner()
}

/// A program at many positions.
struct Run<'a, 'c> {
    program: &'a BlockProgram,
    loads: &'a Loads<'a>,
    columns: &'a RefCell<Vec<&'c mut [f64]>>,
}

/// The same, with sines that may be rounded in another way if it is `ALONE`.
struct Rounded<'a, 'c, const ALONE: bool>(Run<'a, 'c>);

impl<const ALONE: bool> Dispatch<f64, (), 0> for Rounded<'_, '_, ALONE> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) {
        let Run {
            program,
            loads,
            columns,
        } = &self.0;
        let mut columns = columns.borrow_mut();
        let rows = rows(&columns);
        let mut blocks = Blocks::<FUSED>::new(loads, &mut columns);
        program.run::<Generated<f64, FUSED, ALONE, true>>(rows, &mut blocks);
    }
}
