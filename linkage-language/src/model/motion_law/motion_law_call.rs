//! Courses: `rise`, `piecewise`, `spline`, `slope`.

use super::pieces::{resolve_piecewise, resolve_rise};
use super::slope::resolve_slope;
use super::spline::resolve_spline;
use crate::diagnostic::SourceSpan;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, ExprKind, MotionLawWord};
use crate::syntax::{self};

pub(in crate::model) fn resolve_motion_law(
    operands: Operands,
    sink: &mut Sink,
    word: MotionLawWord,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let course = match word {
        MotionLawWord::Rise => resolve_rise(operands, sink, arguments, span),
        MotionLawWord::Piecewise => resolve_piecewise(operands, sink, arguments, span),
        MotionLawWord::Spline => resolve_spline(operands, sink, arguments, span),
        MotionLawWord::Slope => resolve_slope(operands, sink, arguments, span),
    };
    match course {
        Some((course, ty)) => make_expr(sink, ExprKind::MotionLaw(course), ty, span),
        None => error_expr(sink, span),
    }
}
