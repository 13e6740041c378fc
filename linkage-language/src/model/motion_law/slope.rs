//! `slope(course)`: the derivative of a course with respect to its argument.

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{HIGHEST_SLOPE, MotionLaw, MotionLawWord, Type};
use crate::syntax;

pub(in crate::model) fn resolve_slope(
    operands: Operands,
    sink: &mut Sink,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Option<(MotionLaw, Type)> {
    let [operand] = arguments else {
        let found = count(arguments.len(), "argument");
        let fact = format!("`slope` is written with a course, found {found}");
        let help = format!("write `{}`", MotionLawWord::Slope.form());
        sink.error_with_help(span, fact, help);
        return None;
    };
    let value = operands.resolve(sink, operand);
    if value.ty.is_error() {
        return None;
    }
    let Some(course) = operands.scope.values.motion_law_of(&value).cloned() else {
        let fact = "`slope` is taken of a course, found another expression";
        let help = "a course is `piecewise(...)`, `spline(...)`, `rise(...)`, the slope of one, or a name that \
             is one of these and nothing else; derivatives of others are asked for in functions, by `velocity` or `d`";
        sink.error_with_help(operand.span, fact, help);
        return None;
    };
    let Some(slope) = course.slope() else {
        let fact = format!("the slope of a course is taken {HIGHEST_SLOPE} times at most");
        let help = "a limit of linkage; derivatives in functions have no such limit";
        sink.error_with_help(operand.span, fact, help);
        return None;
    };
    let dimensions = (value.ty.dimension()?, slope.argument_type().dimension()?);
    let dimension = dimensions.0.over(dimensions.1)?;
    Some((slope, Type::Scalar(dimension)))
}
