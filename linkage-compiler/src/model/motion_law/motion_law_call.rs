//! Courses: `rise`, `piecewise`, `spline`, `slope`.

use super::pieces::{resolve_piecewise, resolve_rise};
use super::slope::resolve_slope;
use super::spline::resolve_spline;
use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{CourseWord, Expr, ExprKind};
use crate::syntax::{self};

pub(in crate::model) fn resolve_course(
    operands: Operands,
    sink: &mut Sink,
    word: CourseWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let course = match word {
        CourseWord::Rise => resolve_rise(operands, sink, arguments, span),
        CourseWord::Piecewise => resolve_piecewise(operands, sink, arguments, span),
        CourseWord::Spline => resolve_spline(operands, sink, arguments, span),
        CourseWord::Slope => resolve_slope(operands, sink, arguments, span),
    };
    match course {
        Some((course, ty)) => make_expr(sink, ExprKind::Course(course), ty, span),
        None => error_expr(sink, span),
    }
}
