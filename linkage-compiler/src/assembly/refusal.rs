//! Messages about a group that cannot be assembled at the reference inputs.

use crate::assembly::degenerate;
use crate::diagnostic::OriginId;
use crate::message_format::loop_list;
use crate::model::Dimension;
use crate::solve::Solved;
use crate::structure::Form;

use super::assembler::{Assembly, SINGULAR};
use crate::checks;

/// The advice for a part of a loop that has no value.
pub(super) const WITHIN_RANGE: &str =
    "choose a reference input or dimensions at which it has a value";

/// Squares of larger numbers overflow.
const LARGEST: f64 = 1e154;

/// Why a group has no position.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// An input value of the group is not finite, or everything fits.
    NotFinite,
    /// The distance by which the group misses.
    Open(f64),
    /// A dead point.
    Singular,
}

pub(super) fn refuse<'m>(assembly: &mut Assembly<'_, 'm>, solved: &Solved<'m>, verdict: Verdict) {
    let origin = assembly.algebra.mechanism.loops[solved.group.loops[0]].origin;
    let loops = loop_list(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    if let Some((fact, help)) = degenerate::degenerate(assembly, solved) {
        let fact = format!("{loops} cannot be solved for {unknowns}{position}: {fact}");
        assembly.reporter.error_with_help(origin, fact, help);
        return;
    }
    if assembly.size > LARGEST && !matches!(verdict, Verdict::Open(_)) {
        let size = assembly.words.scalar(Dimension::LENGTH, assembly.size);
        let fact = format!(
            "{loops} ({unknowns}) cannot be solved{position}: the mechanism has a length of {size}, and the square of a number above \
                 {LARGEST:e} is beyond the largest one"
        );
        let help = "choose a length unit in which the numbers are smaller";
        assembly.reporter.error_with_help(origin, fact, help);
        return;
    }
    let without_value = match verdict {
        Verdict::NotFinite => loops_without_value(assembly, &solved.group.loops),
        Verdict::Open(_) | Verdict::Singular => None,
    };
    if let Some((part, fact)) = without_value {
        let fact = format!("{loops} ({unknowns}) cannot be solved{position}: {fact}");
        assembly.reporter.error_with_help(part, fact, WITHIN_RANGE);
        return;
    }
    let (fact, help) = match verdict {
        Verdict::NotFinite => (
            format!(
                "{loops} ({unknowns}) cannot be solved{position}: what is known of it is not a finite number"
            ),
            format!(
                "look for {}a division by zero, or a root or an arc function out of its range",
                match has_guides(assembly, solved) {
                    true => "guides that are parallel, ",
                    false => "",
                }
            ),
        ),
        Verdict::Open(gap) => {
            let miss = assembly.words.gap(solved, gap);
            let number = solved
                .gap_dimension(assembly.algebra.mechanism)
                .half_lengths
                == 0;
            let what = if number { "dimension" } else { "length" };
            let other = match position.is_empty() {
                true => "",
                false => ", or give a reference input at which the links reach each other",
            };
            (
                format!("{loops} ({unknowns}) cannot close{position}: misses by {miss}"),
                format!("change a {what}{other}"),
            )
        }
        Verdict::Singular => (
            format!(
                "{loops} ({unknowns}) {} singular{position}, a dead point{}: its margin is below {SINGULAR:e}",
                if solved.group.loops.len() == 1 {
                    "is"
                } else {
                    "are"
                },
                shape(assembly, &solved.group.form)
            ),
            "choose a reference input or lengths away from the dead point".to_owned(),
        ),
    };
    assembly.reporter.error_with_help(origin, fact, help);
}

/// Returns the part of some loops that has no finite value at the reference inputs, and its origin.
pub(super) fn loops_without_value(
    assembly: &Assembly<'_, '_>,
    loops: &[usize],
) -> Option<(OriginId, String)> {
    let inputs = &assembly.nominal.inputs;
    checks::without_value(assembly.algebra.mechanism, assembly.nominal, inputs, loops)
}

/// True for an angle that is found across the guides of its loop.
fn has_guides<'m>(assembly: &Assembly<'_, 'm>, solved: &Solved<'m>) -> bool {
    let first_loop = &assembly.algebra.mechanism.loops[solved.group.loops[0]];
    let [left, right] = [&first_loop.left, &first_loop.right].map(|side| side.ty.components());
    let alone = matches!(
        solved.group.form,
        Form::Trigonometric { .. } | Form::Linear { .. }
    );
    alone && left.max(right) == Some(3)
}

/// Describes the shape of a group in space at its dead point.
fn shape<'m>(assembly: &Assembly<'_, 'm>, form: &Form<'m>) -> String {
    match form {
        Form::LinkToRotor { angle, .. } => format!(
            " where the link lies in one plane with the axis of {}",
            degenerate::angle_name(assembly, *angle)
        ),
        Form::LinkToSlide { slide, .. } => format!(
            " where the link is perpendicular to the guide of {}",
            degenerate::symbol_name(assembly, *slide)
        ),
        Form::Point { spheres, .. } if spheres.len() == 3 => {
            " where the point lies in the plane of the three centres".to_owned()
        }
        Form::Point { .. }
        | Form::TwoRotors { .. }
        | Form::RotorAndSlide { .. }
        | Form::SlideOnRotor { .. }
        | Form::TwoSlides { .. }
        | Form::Trigonometric { .. }
        | Form::Quadratic { .. }
        | Form::Linear { .. }
        | Form::ThreeSlides { .. }
        | Form::Relation { .. }
        | Form::Parallel { .. }
        | Form::Coupled(_) => String::new(),
    }
}
