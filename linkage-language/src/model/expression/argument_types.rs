//! Types of the arguments of functions.

use super::agreement::common_type;
use super::bare_numbers::refuse_bare_angle;
use super::call_messages::refuse_argument_type;
use super::operators::settle_alone;
use super::plane_and_space::vector_help;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, Function, Type};
use crate::syntax::Word;

pub(in crate::model) fn scalar_argument(
    sink: &mut Sink,
    argument: &mut Expr,
    function: Function,
) -> Option<Dimension> {
    settle_alone(argument);
    match argument.ty {
        Type::Scalar(dimension) => Some(dimension),
        _ => {
            let help = "take a component `.x` or the length `norm(v)`";
            refuse_argument_type(sink, function, "a scalar here", argument, help)
        }
    }
}

/// An angle or a number.
pub(in crate::model) fn angle_argument(
    sink: &mut Sink,
    argument: &mut Expr,
    function: Function,
) -> Option<()> {
    settle_alone(argument);
    match argument.ty {
        Type::Scalar(dimension) if dimension.is_number_or_angle() => {
            if function.angle_argument().is_some() {
                refuse_bare_argument(sink, function, argument);
            }
            Some(())
        }
        Type::Scalar(_) => {
            let help = "give angles in `deg` or `rad`, or divide by a length for a number";
            refuse_argument_type(sink, function, "an angle or a number here", argument, help)
        }
        _ => {
            let help = "`angle(v)` is the angle of a plane vector";
            refuse_argument_type(sink, function, "an angle or a number here", argument, help)
        }
    }
}

pub(in crate::model) fn vector_argument(
    names: &Names,
    sink: &mut Sink,
    argument: &mut Expr,
    function: Function,
    wanted: Option<usize>,
) -> Option<(usize, Dimension)> {
    settle_alone(argument);
    let words = match wanted {
        Some(2) => "a plane vector",
        Some(_) => "a space vector",
        None => "a vector",
    };
    match argument.ty {
        Type::Vector(count, dimension) if wanted.is_none_or(|wanted| wanted == count) => {
            Some((count, dimension))
        }
        _ => {
            let help = vector_help(names, function, argument, wanted);
            refuse_argument_type(sink, function, &format!("{words} here"), argument, &help)
        }
    }
}

pub(in crate::model) fn arguments_alike(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    arguments: &mut [Expr],
    function: Function,
) -> Option<Type> {
    let mut values: Vec<&mut Expr> = arguments.iter_mut().collect();
    let ty = common_type(
        names,
        units,
        sink,
        &mut values,
        &format!("the arguments of `{}`", function.word()),
    )
    .settled();
    values.into_iter().for_each(|argument| argument.settle(&ty));
    (!ty.is_error()).then_some(ty)
}

pub(in crate::model) fn scalar_arguments_alike(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    arguments: &mut [Expr],
    function: Function,
) -> Option<Type> {
    let ty = arguments_alike(names, units, sink, arguments, function)?;
    for argument in arguments {
        scalar_argument(sink, argument, function)?;
    }
    Some(ty)
}

/// Reports `sin(30)`.
pub(in crate::model) fn refuse_bare_argument(sink: &mut Sink, function: Function, argument: &Expr) {
    refuse_bare_angle(
        sink,
        argument,
        &format!("the angle of `{}`", function.word()),
    );
}
