//! Programs with the arithmetic of generated code.

use linkage_compiler::unit::Generated;
use linkage_runtime::generated::{Single, inlined, single};
use linkage_runtime::{Enclosure, FUSED};
use linkage_symbolic::interpret::run_by;
use linkage_symbolic::program::{Program, Source};

/// A program and where it finds what it loads.
struct Run<'a, L> {
    program: &'a Program,
    load: L,
}

/// The outputs of a program, with the instructions of the build.
pub(super) fn by_build(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    inlined(&Run { program, load }, [] as [f64; 0])
}

/// The outputs of a program, with fused multiply-add if the machine has it.
pub(super) fn by_machine(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    single(&Run { program, load }, [] as [f64; 0])
}

/// The outputs of a program over a box.
pub(super) fn over_states(program: &Program, load: impl Fn(Source) -> Enclosure) -> Vec<Enclosure> {
    run_by::<Generated<Enclosure, FUSED>>(program, load)
}

impl<L: Fn(Source) -> f64> Single<f64, Vec<f64>, 0> for Run<'_, L> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) -> Vec<f64> {
        run_by::<Generated<f64, FUSED>>(self.program, &self.load)
    }
}
