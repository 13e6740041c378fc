//! Types of calls of functions, from the types of their arguments.

use super::argument_types::{
    angle_argument, arguments_alike, scalar_argument, scalar_arguments_alike, vector_argument,
};
use super::call_messages::refuse_swapped;
use super::frame_functions::{SecondArgument, frame_type, in_frame_type};
use super::operators::check_power_range;
use super::plane_and_space::check_one_space;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, Function, Type};

/// The type of a call with the right number of sound arguments.
pub(in crate::model) fn result_type(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    function: Function,
    arguments: &mut [Expr],
    span: SourceSpan,
) -> Option<Type> {
    match function {
        Function::Polar => {
            let swapped = is_angle(&arguments[0]) && is_length(&arguments[1]);
            let swapped = swapped.then_some("polar(length, angle)");
            refuse_swapped(sink, function, arguments, swapped, span)?;
            let length = scalar_argument(sink, &mut arguments[0], function)?;
            angle_argument(sink, &mut arguments[1], function)?;
            Some(Type::Vector(2, length))
        }
        Function::Dir => {
            angle_argument(sink, &mut arguments[0], function)?;
            Some(Type::Vector(2, Dimension::NUMBER))
        }
        Function::Rotate => {
            let swapped = is_angle(&arguments[0]).then(|| match &arguments[1].ty {
                Type::Vector(3, _) | Type::Zero(3) => Some("turn(vector, axis, angle)"),
                Type::Vector(..) => Some("rotate(vector, angle)"),
                _ => None,
            });
            refuse_swapped(sink, function, arguments, swapped.flatten(), span)?;
            let (_, dimension) =
                vector_argument(names, sink, &mut arguments[0], function, Some(2))?;
            angle_argument(sink, &mut arguments[1], function)?;
            Some(Type::Vector(2, dimension))
        }
        Function::Turn => {
            let swapped =
                matches!(arguments[2].ty, Type::Vector(..)) && arguments[..2].iter().any(is_angle);
            let swapped = swapped.then_some("turn(vector, axis, angle)");
            refuse_swapped(sink, function, arguments, swapped, span)?;
            let (_, dimension) =
                vector_argument(names, sink, &mut arguments[0], function, Some(3))?;
            vector_argument(names, sink, &mut arguments[1], function, Some(3))?;
            angle_argument(sink, &mut arguments[2], function)?;
            Some(Type::Vector(3, dimension))
        }
        Function::Dot | Function::Cross => {
            check_one_space(names, sink, function, &arguments[0], &arguments[1])?;
            let (count, left) = vector_argument(names, sink, &mut arguments[0], function, None)?;
            let (_, right) =
                vector_argument(names, sink, &mut arguments[1], function, Some(count))?;
            let spatial = function == Function::Cross && count == 3;
            let dimension = left.times(right).map(Dimension::of_arithmetic);
            let ty = dimension.map(|dimension| {
                if spatial {
                    Type::Vector(3, dimension)
                } else {
                    Type::Scalar(dimension)
                }
            });
            check_power_range(sink, ty, span)
        }
        Function::Norm => {
            let (_, dimension) = vector_argument(names, sink, &mut arguments[0], function, None)?;
            Some(Type::Scalar(dimension))
        }
        Function::Unit => {
            let (count, _) = vector_argument(names, sink, &mut arguments[0], function, None)?;
            Some(Type::Vector(count, Dimension::NUMBER))
        }
        Function::Angle => {
            vector_argument(names, sink, &mut arguments[0], function, Some(2))?;
            Some(Type::Scalar(Dimension::ANGLE))
        }
        Function::Distance => {
            check_one_space(names, sink, function, &arguments[0], &arguments[1])?;
            let ty = arguments_alike(names, units, sink, arguments, function)?;
            for argument in &mut *arguments {
                vector_argument(names, sink, argument, function, None)?;
            }
            Some(Type::Scalar(ty.dimension()?))
        }
        Function::TriangleAngle | Function::Atan2 => {
            scalar_arguments_alike(names, units, sink, arguments, function)?;
            Some(Type::Scalar(Dimension::ANGLE))
        }
        Function::Hypot | Function::Min | Function::Max => {
            scalar_arguments_alike(names, units, sink, arguments, function)
        }
        Function::Abs => scalar_argument(sink, &mut arguments[0], function).map(Type::Scalar),
        Function::Sin | Function::Cos | Function::Tan => {
            angle_argument(sink, &mut arguments[0], function)?;
            Some(Type::NUMBER)
        }
        Function::Asin | Function::Acos | Function::Atan => {
            angle_argument(sink, &mut arguments[0], function)?;
            Some(Type::Scalar(Dimension::ANGLE))
        }
        Function::Sqrt => {
            let root = scalar_argument(sink, &mut arguments[0], function)?;
            let root = root.of_arithmetic().root();
            check_power_range(sink, root.map(Type::Scalar), span)
        }
        Function::Frame => frame_type(names, units, sink, arguments, span),
        Function::PointIn => {
            let second = SecondArgument {
                rule: "coordinates in a frame are",
                word: "vector",
            };
            in_frame_type(names, units, sink, function, second, arguments, span)
        }
        Function::CoordinatesIn => {
            let second = SecondArgument {
                rule: "a point is",
                word: "point",
            };
            in_frame_type(names, units, sink, function, second, arguments, span)
        }
    }
}

pub(in crate::model) fn is_angle(argument: &Expr) -> bool {
    matches!(argument.ty, Type::Scalar(dimension) if dimension.is_number_or_angle())
}

pub(in crate::model) fn is_length(argument: &Expr) -> bool {
    matches!(argument.ty, Type::Scalar(_)) && !is_angle(argument)
}
