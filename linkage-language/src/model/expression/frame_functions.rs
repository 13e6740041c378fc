//! Frames: their parts, the functions that make and use them, and where they cannot stand.

use super::agreement::refuse_compound;
use super::argument_types::vector_argument;
use super::call_messages::{refuse_argument_type, refuse_count_of_arguments};
use super::missing_units::suspect_unit;
use super::operators::settle_alone;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, Function, Type, type_of_part};
use crate::syntax::Word;

/// The second argument of `point_in` and `coordinates_in`, after the frame.
#[derive(Clone, Copy)]
pub(in crate::model) struct SecondArgument {
    /// The beginning of the sentence about its type.
    pub(in crate::model) rule: &'static str,
    /// The name of the argument.
    pub(in crate::model) word: &'static str,
}

/// `frame(origin, x, z)`, `frame(origin, x)` in the plane
pub(in crate::model) fn frame_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    arguments: &mut [Expr],
    span: SourceSpan,
) -> Option<Type> {
    let function = Function::Frame;
    match arguments {
        [origin, x, z] => {
            point_argument(
                names,
                units,
                sink,
                origin,
                3,
                function,
                "the origin of a frame is",
            )?;
            vector_argument(names, sink, x, function, Some(3))?;
            vector_argument(names, sink, z, function, Some(3))?;
            Some(Type::Frame)
        }
        [origin, x] => {
            if [&*origin, x]
                .iter()
                .any(|vector| vector.ty.components() == Some(3))
            {
                refuse_count_of_arguments(sink, function, arguments.len(), span);
                return None;
            }
            point_argument(
                names,
                units,
                sink,
                origin,
                2,
                function,
                "the origin of a frame is",
            )?;
            vector_argument(names, sink, x, function, Some(2))?;
            Some(Type::PlaneFrame)
        }
        _ => None,
    }
}

/// `point_in(frame, vector)`, `coordinates_in(frame, point)`
pub(in crate::model) fn in_frame_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    function: Function,
    second: SecondArgument,
    arguments: &mut [Expr],
    span: SourceSpan,
) -> Option<Type> {
    let [frame, point] = arguments else {
        return None;
    };
    let name = function.word();
    if !frame.ty.is_frame() && point.ty.is_frame() {
        let (first, frame) = (&frame.ty, &point.ty);
        let fact = format!("the arguments of `{name}` are swapped: found {first} and {frame}");
        let help = format!("write `{name}(frame, {})`", second.word);
        sink.error_with_help(span, fact, help);
        return None;
    }
    if !frame.ty.is_frame() {
        settle_alone(frame);
        let help = "`frame(origin, x, z)` makes a frame";
        return refuse_argument_type(sink, function, "a frame here", frame, help);
    }
    let ty = type_of_part(&frame.ty, 0);
    point_argument(
        names,
        units,
        sink,
        point,
        ty.components().unwrap_or(3),
        function,
        second.rule,
    )?;
    Some(ty)
}

/// A vector of lengths; zeros are lengths here.
fn point_argument(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    argument: &mut Expr,
    components: usize,
    function: Function,
    role: &str,
) -> Option<()> {
    let wanted = Type::Vector(components, Dimension::LENGTH);
    argument.settle(&wanted);
    if refuse_compound(names, sink, argument) {
        return None;
    }
    let (_, dimension) = vector_argument(names, sink, argument, function, Some(components))?;
    if dimension.fits(Dimension::LENGTH) {
        return Some(());
    }
    suspect_unit(units, sink, argument, &wanted);
    let fact = format!("{role} {wanted}, found {}", argument.ty);
    let help = if dimension.is_number_or_angle() {
        "give its components a unit, or multiply it by a length"
    } else {
        "divide by a length"
    };
    let span = sink.span(argument.origin);
    sink.error_with_help(span, fact, help);
    None
}
