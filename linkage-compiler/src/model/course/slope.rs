//! `slope(course)`: a course differentiated by what it is given along.

use super::super::functions::CourseWord;
use super::super::names::Resolver;
use super::super::place::Context;
use super::super::types::{Course, Expr, ExprKind, HIGHEST_SLOPE, Name, Type};
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::count;
use crate::syntax;

impl Course {
    /// Its derivative by its argument; `None` for more of them than a course has.
    pub(in super::super) fn slope(&self) -> Option<Self> {
        let order = self.order + 1;
        (order <= HIGHEST_SLOPE).then(|| Self {
            order,
            ..self.clone()
        })
    }
}

impl Resolver<'_> {
    pub(super) fn slope(
        &mut self,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Option<(Course, Type)> {
        let [of] = arguments else {
            let found = count(arguments.len(), "argument");
            let fact = format!("`slope` is written with a course, found {found}");
            let help = format!("write `{}`", CourseWord::Slope.form());
            self.diagnostics.error_with_help(span, fact, help);
            return None;
        };
        let value = self.expression(of, context);
        if value.ty.is_error() {
            return None;
        }
        let Some(course) = self.course_of(&value).cloned() else {
            let fact = "`slope` is taken of a course, found another expression";
            let help = "a course is `piecewise(...)`, `spline(...)`, `rise(...)`, the slope of one, or a name that \
                 is one of these and nothing else; derivatives of others are asked for in functions, by `velocity` or `d`";
            self.diagnostics.error_with_help(of.span, fact, help);
            return None;
        };
        let Some(slope) = course.slope() else {
            let fact = format!("the slope of a course is taken {HIGHEST_SLOPE} times at most");
            let help = "a limit of linkage; derivatives in functions have no such limit";
            self.diagnostics.error_with_help(of.span, fact, help);
            return None;
        };
        let dimensions = (value.ty.dimension()?, slope.argument_type().dimension()?);
        let dimension = dimensions.0.over(dimensions.1)?;
        Some((slope, Type::Scalar(dimension)))
    }

    /// The course that a value is, under a name, too.
    pub(in super::super) fn course_of<'v>(&'v self, value: &'v Expr) -> Option<&'v Course> {
        match &value.kind {
            ExprKind::Course(course) => Some(course),
            ExprKind::Name(Name::Let(index)) => self.courses_of_lets.get(*index)?.as_ref(),
            _ => None,
        }
    }
}
