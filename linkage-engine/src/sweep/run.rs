//! Programs at many positions.

use std::cell::RefCell;

use linkage_compiler::ir::Generated;
use linkage_runtime::support::Dispatch;
use linkage_symbolic::blocks::BlockProgram;

use super::slices::{Blocks, Loads};
use crate::columns::rows;

/// Runs a program at all positions of its loads; returns the columns, filled.
pub(super) fn run<'c>(
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
