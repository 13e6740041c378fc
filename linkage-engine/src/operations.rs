//! Programs with the arithmetic of generated code.

use linkage_compiler::ir::{Body, Generated};
use linkage_runtime::support::{Dispatch, dispatch, inlined};
use linkage_runtime::{Enclosure, FUSED};
use linkage_symbolic::interpret::run_by;
use linkage_symbolic::program::{Program, Source};

/// The rounding of multiply-adds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum MultiplyAdds {
    /// As in generated code: once where it has the instruction, else twice.
    #[default]
    Generated,
    /// Once on every machine.
    Fused,
    /// Twice on every machine.
    Separate,
}

impl MultiplyAdds {
    /// The value of a function, with the instructions of the build.
    pub(crate) fn by_build<R>(self, function: &impl Dispatch<f64, R, 0>) -> R {
        match self {
            Self::Generated => inlined(function, []),
            Self::Fused => function.at::<true>([]),
            Self::Separate => function.at::<false>([]),
        }
    }

    /// The value of a function, with fused multiply-add if the machine has it.
    pub(crate) fn by_machine<R>(self, function: &impl Dispatch<f64, R, 0>) -> R {
        match self {
            Self::Generated => dispatch(function, []),
            Self::Fused => function.at::<true>([]),
            Self::Separate => function.at::<false>([]),
        }
    }
}

/// A program with the numbers that it loads. The sines of a call may be rounded differently if it
/// is `ALONE`.
struct Run<'a, L, const ALONE: bool> {
    program: &'a Program,
    load: L,
}

/// The outputs of a program, with the instructions of the build.
pub(crate) fn by_build(
    multiply_adds: MultiplyAdds,
    program: &Program,
    load: impl Fn(Source) -> f64,
) -> Vec<f64> {
    multiply_adds.by_build(&Run::<_, false> { program, load })
}

/// The outputs of a function, as its calls compute them.
pub(crate) fn called(
    multiply_adds: MultiplyAdds,
    body: &Body,
    load: impl Fn(Source) -> f64,
) -> Vec<f64> {
    let program = &body.program;
    match body.compares_sines {
        true => multiply_adds.by_machine(&Run::<_, false> { program, load }),
        false => multiply_adds.by_machine(&Run::<_, true> { program, load }),
    }
}

/// The outputs of a program over a box.
pub(crate) fn over_states(program: &Program, load: impl Fn(Source) -> Enclosure) -> Vec<Enclosure> {
    run_by::<Generated<Enclosure, FUSED>>(program, load)
}

impl<L: Fn(Source) -> f64, const ALONE: bool> Dispatch<f64, Vec<f64>, 0> for Run<'_, L, ALONE> {
    #[inline(always)]
    fn at<const FUSED: bool>(&self, []: [f64; 0]) -> Vec<f64> {
        run_by::<Generated<f64, FUSED, ALONE>>(self.program, &self.load)
    }
}
