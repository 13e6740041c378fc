//! Sweeps whose parts are computed one by one, into columns of the caller.

use std::borrow::Cow;

use linkage_compiler::ir::Function;
use linkage_runtime::Heading;
use linkage_symbolic::Binding;
use linkage_symbolic::blocks::{BLOCK, BlockProgram};
use linkage_symbolic::program::Source;

use super::positions::positions;
use super::run::run;
use super::slices::Loads;
use crate::columns::{rows, split};
use crate::compiled::Assembly;
use crate::mechanism::Mechanism;

/// Mechanisms that are prepared at once.
const PREPARED: usize = 16 * BLOCK;

/// Positions from which on a program is prepared again for arguments that stand still.
const MANY: usize = 4096;

/// A function at many positions, or of many mechanisms, before it is computed.
///
/// Parts of it can be computed in any order and by several threads at once, and the numbers are
/// those of the whole sweep. So a program can stop between two parts, or show how far it is.
///
/// ```
/// use linkage_engine::Mechanism;
///
/// let text = "
///     pub struct Crank { unit mm; param r = 30mm; input phi = 0deg; let pin = polar(r, phi); }
///     impl Crank { pub fn motion(phi) -> Motion { pin } }";
/// let mechanism = Mechanism::compile(text)?;
/// let assembly = mechanism.assemble(&mechanism.dimensions())?;
/// let angles = [0.0, 0.5, 1.0];
/// let sweep = assembly.sweep_in_parts(mechanism.function("motion")?, &[&angles]);
/// let (mut x, mut y) = ([0.0; 3], [0.0; 3]);
/// for (from, (x, y)) in x.chunks_mut(2).zip(y.chunks_mut(2)).enumerate() {
///     sweep.fill(2 * from, vec![x, y]);
/// }
/// assert_eq!((x[0], y[0]), (30.0, 0.0));
/// assert_eq!(x[2..], assembly.sweep(0, &[&angles])["pin.x"][2..]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Sweep<'a> {
    assembly: &'a Assembly<'a>,
    function: &'a Function,
    heading: &'static Heading,
    positions: usize,
    loads: Loads<'a>,
    programs: Programs<'a>,
}

/// The programs that each part runs.
enum Programs<'a> {
    /// One mechanism at many positions.
    Positions(Cow<'a, BlockProgram>),
    /// Many mechanisms: the program that prepares these slots, and the one that loads them.
    Sets {
        preparing: BlockProgram,
        slots: Vec<usize>,
        program: BlockProgram,
    },
}

impl Assembly<'_> {
    /// Prepares what [`sweep`](Self::sweep) computes.
    ///
    /// # Panics
    ///
    /// As [`sweep`](Self::sweep).
    #[must_use]
    pub fn sweep_in_parts<'a>(&'a self, function: usize, arguments: &[&'a [f64]]) -> Sweep<'a> {
        let mechanism = self.mechanism();
        let heading = mechanism.headings()[function];
        let positions = positions(heading.function, heading.arguments, arguments);
        let compiled = &mechanism.compiled.functions[function];
        let loads = Loads::new(self, compiled, arguments);
        let stands_still = arguments.iter().any(|slice| slice.len() == 1);
        let program = match positions >= MANY && stands_still {
            true => {
                let program = &compiled.called.program;
                Cow::Owned(BlockProgram::new(program, |source| loads.varies(source)))
            }
            false => Cow::Borrowed(block_program(mechanism, function)),
        };
        Sweep {
            assembly: self,
            function: compiled,
            heading,
            positions,
            loads,
            programs: Programs::Positions(program),
        }
    }

    /// Prepares what [`sweep_sets`](Self::sweep_sets) computes.
    ///
    /// # Panics
    ///
    /// As [`sweep_sets`](Self::sweep_sets).
    #[must_use]
    pub fn sweep_sets_in_parts<'a>(
        &'a self,
        function: usize,
        parameters: &[&'a [f64]],
        arguments: &[&'a [f64]],
    ) -> Sweep<'a> {
        let mechanism = self.mechanism();
        let heading = mechanism.headings()[function];
        let names = mechanism
            .parameters()
            .iter()
            .map(|parameter| parameter.name);
        let names: Vec<&str> = names.chain(heading.arguments.iter().copied()).collect();
        let all = [parameters, arguments].concat();
        let positions = positions(heading.function, &names, &all);
        let compiled = &mechanism.compiled.functions[function];
        let body = compiled.beside.as_ref().unwrap_or(&compiled.called);
        let loads = Loads::new(self, compiled, arguments).with_dimensions(parameters);
        let (prepare, slots) = mechanism.compiled.preparing(&body.program);
        let preparing = BlockProgram::new(&prepare, |source| loads.varies(source));
        let program = BlockProgram::new(&body.program, |source| {
            matches!(source, Source::Prepared(_)) || loads.varies(source)
        });
        Sweep {
            assembly: self,
            function: compiled,
            heading,
            positions,
            loads,
            programs: Programs::Sets {
                preparing,
                slots,
                program,
            },
        }
    }
}

impl Sweep<'_> {
    /// Returns name, arguments and columns of the function.
    #[must_use]
    pub fn heading(&self) -> &'static Heading {
        self.heading
    }

    /// Returns the number of positions.
    #[must_use]
    pub fn positions(&self) -> usize {
        self.positions
    }

    /// Computes the positions from `from` on, as many as each slice has room for: a slice for each
    /// column of the function.
    ///
    /// # Panics
    ///
    /// If there is another number of slices, they differ in length, or they end after the sweep.
    pub fn fill(&self, from: usize, columns: Vec<&mut [f64]>) {
        let count = rows(&columns);
        let wanted = self.heading.columns.len();
        assert_eq!(columns.len(), wanted, "a slice for each column");
        let is_alike = columns.iter().all(|column| column.len() == count);
        assert!(is_alike, "slices of one length");
        assert!(from + count <= self.positions, "positions of the sweep");
        match &self.programs {
            Programs::Positions(program) => {
                let loads = self.loads.part(from, from + count);
                run(
                    program,
                    self.function.called.compares_sines,
                    &loads,
                    columns,
                );
            }
            Programs::Sets {
                preparing,
                slots,
                program,
            } => {
                let mut rest = columns;
                for first in (from..from + count).step_by(PREPARED) {
                    let last = (first + PREPARED).min(from + count);
                    let (part, others) = split(rest, last - first);
                    rest = others;
                    let loads = self.loads.part(first, last);
                    self.fill_sets(preparing, slots, program, &loads, part);
                }
            }
        }
    }

    /// Computes mechanisms that are prepared together.
    fn fill_sets(
        &self,
        preparing: &BlockProgram,
        slots: &[usize],
        program: &BlockProgram,
        loads: &Loads<'_>,
        columns: Vec<&mut [f64]>,
    ) {
        let mut numbers = vec![vec![0.0; rows(&columns)]; slots.len()];
        let slices = numbers.iter_mut().map(Vec::as_mut_slice);
        run(preparing, true, loads, slices.collect());
        let loads = loads.clone().with_prepared(slots, &numbers);
        let function = self.function;
        let body = function.beside.as_ref().unwrap_or(&function.called);
        let columns = run(program, body.compares_sines, &loads, columns);
        if !function.states.is_empty() {
            self.follow_missing(&loads, columns);
        }
    }

    /// Computes rows that are not a number again, with coupled groups that are followed from the
    /// dimensions of the assembly. Where the way is blocked they stay as they are.
    fn follow_missing(&self, loads: &Loads<'_>, mut columns: Vec<&mut [f64]>) {
        let function = self.function;
        let body = function.beside.as_ref().unwrap_or(&function.called);
        for row in 0..rows(&columns) {
            if !columns.iter().any(|column| column[row].is_nan()) {
                continue;
            }
            let (dimensions, arguments) = loads.row(row);
            let mut at = self.assembly.mechanism().reference();
            for (&index, x) in function.arguments.iter().zip(&arguments) {
                // Others are no inputs.
                if let Some(input) = at.get_mut(index) {
                    *input = *x;
                }
            }
            if let Some(found) = self.assembly.at_dimensions(&dimensions, &at) {
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
