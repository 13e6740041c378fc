//! The program of a function as its stages, which calls and sweeps run.

use linkage_symbolic::passes::stages::{Stage, memory};
use linkage_symbolic::program::Value;
use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

use super::body::{self, Runs};
use super::load::{Places, stage_loader};
use super::outline::{Function, Outline};
use super::{attribute, code};
use linkage_compiler::ir::Body;

/// The programs that a function can have.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Version {
    /// The one of calls.
    Called,
    /// The one for dimensions, derivatives or digits that tables do not know.
    Beside,
    /// The one at the position of a follower, whose states are solutions.
    Settled,
}

impl Version {
    /// The one for dimensions, derivatives and digits that tables do not know.
    pub(super) fn refining(function: &Function) -> Self {
        match function.beside {
            true => Self::Beside,
            false => Self::Called,
        }
    }

    /// The part that the version has in names of items.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Called => "",
            Self::Beside => "_beside",
            Self::Settled => "_settled",
        }
    }
}

/// The type that stands for a program of a function.
pub(super) fn name(function: &Function, version: Version) -> Ident {
    let (name, word) = (function.name, version.word());
    format_ident!("__{name}{word}_stages", span = Span::call_site())
}

/// The runtime's `Staged` of a program, and each of its stages.
pub(super) fn items(
    outline: &Outline,
    function: &Function,
    body: &Body,
    version: Version,
) -> TokenStream {
    let runs = match body.compares_sines {
        true => Runs::InRows,
        false => Runs::InRowsOrAlone,
    };
    let staged = Staged {
        outline,
        function,
        name: code::text(&name(function, version)),
        core: code::text(&outline.core),
        everywhere: attribute::everywhere(function.attributes),
        runs,
    };
    let Staged {
        name,
        core,
        everywhere,
        ..
    } = &staged;
    let visibility = code::text(outline.visibility);
    let count = Places::of_function(outline, function).width();
    let width = function.width();
    let memory = memory(&body.stages);
    let run = (0..body.stages.len()).map(|number| format!("__stages.stage::<{number}>();"));
    let run: String = run.collect();
    let stages = body.stages.iter().enumerate();
    let stages = stages.map(|(number, stage)| staged.stage(number, stage));
    let stages: String = stages.collect();
    code::tokens(&format!(
        "{everywhere} #[doc(hidden)] {visibility} struct {name};
        {everywhere} impl<T: __p::Scalar> __p::Staged<T, {core}<T>, {count}, {width}> for {name} {{
            const WIDE: __p::bool = !::core::cfg!(debug_assertions);
            type Memory<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, {memory}>;
            #[inline(always)]
            fn run(__stages: &mut impl __p::RunStages<T, {core}<T>, Self>) {{ {run} }}
        }}
        {stages}"
    ))
}

/// A program whose stages are printed.
struct Staged<'a> {
    outline: &'a Outline<'a>,
    function: &'a Function<'a>,
    name: String,
    core: String,
    everywhere: String,
    runs: Runs,
}

impl Staged<'_> {
    /// From the arguments that the stage reads and the values that earlier stages keep to the
    /// values that it keeps for later stages, and results.
    fn stage(&self, number: usize, stage: &Stage) -> String {
        let Self {
            outline,
            function,
            name,
            core,
            everywhere,
            runs,
        } = self;
        let Stage {
            program,
            taken,
            kept,
            results,
        } = stage;
        let places = Places::of_function(outline, function);
        let load = stage_loader(outline, &places, taken);
        let statements = body::statements(program, *runs, &load);
        let (next, finished) = program.outputs.split_at(kept.len());
        let put = |method: &str, values: &[Value], numbers: &[usize]| {
            let values = numbers.iter().copied().zip(values.iter().copied());
            body::puts(method, values)
        };
        let keep = put("__row.keep", next, kept);
        let finish = put("__row.finish", finished, results);
        let write = results.iter();
        let write = write.map(|result| format!("__rows.write({result});"));
        let write = match results.is_empty() {
            true => String::new(),
            false => format!(
                "#[inline(always)] fn write(__rows: &mut impl __p::FinishedRows) {{ {} }}",
                write.collect::<String>()
            ),
        };
        format!(
            "{everywhere} impl<T: __p::Scalar> __p::Stage<T, {core}<T>, {number}> for {name} {{
                #[inline(always)]
                fn row<const __FUSED: __p::bool, const __ROWS: __p::bool>(
                    __core: &{core}<T>,
                    __row: &mut impl __p::StageRow<T>,
                ) {{ {statements} {keep} {finish} }}
                {write}
            }}"
        )
    }
}
