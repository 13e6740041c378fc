//! Values of clauses: scalars, points, vectors.

use super::super::names::Resolver;
use super::super::plane_and_space::vector_components;
use super::super::types::{Dimension, Expr, Type};
use super::CONTEXT;
use crate::syntax;

impl Resolver<'_> {
    /// A scalar of a dimension.
    pub(super) fn scalar_clause(
        &mut self,
        expr: &syntax::Expr,
        wanted: Dimension,
        word: &str,
        example: &str,
    ) -> Expr {
        let value = self.expression(expr, CONTEXT);
        self.scalar_value(value, wanted, word, example)
    }

    /// A resolved scalar of a dimension; zero fits.
    pub(super) fn scalar_value(
        &mut self,
        mut value: Expr,
        wanted: Dimension,
        word: &str,
        example: &str,
    ) -> Expr {
        value.settle(&Type::Scalar(wanted));
        match &value.ty {
            Type::Scalar(found) if found.fits(wanted) => value,
            _ => self.wrong_clause(value, word, &wanted.to_string(), example),
        }
    }

    /// The point where something is; it moves with the mechanism alone.
    pub(super) fn point_clause(&mut self, expr: &syntax::Expr) -> Expr {
        let mut value = self.vector_clause(expr, Some(Dimension::LENGTH), "at", "(0, 0)");
        self.refuse_argument(&mut value, "a point");
        value
    }

    /// The guide of a slide, an axis: of any length.
    pub(super) fn direction_clause(&mut self, expr: &syntax::Expr, word: &str) -> Expr {
        let mut value = self.vector_clause(expr, None, word, "dir(phi)");
        self.refuse_argument(&mut value, "a direction");
        value
    }

    /// A vector of a dimension, if one is given, and of as many components as all points have.
    pub(super) fn vector_clause(
        &mut self,
        expr: &syntax::Expr,
        wanted: Option<Dimension>,
        word: &str,
        example: &str,
    ) -> Expr {
        let value = self.expression(expr, CONTEXT);
        self.vector_value(value, wanted, word, example)
    }

    pub(super) fn vector_value(
        &mut self,
        mut value: Expr,
        wanted: Option<Dimension>,
        word: &str,
        example: &str,
    ) -> Expr {
        let count = vector_components(&value);
        if let Some(count) = count {
            value.settle(&Type::Vector(count, wanted.unwrap_or(Dimension::NUMBER)));
        }
        match (count, value.ty.dimension()) {
            (Some(count), Some(found)) if wanted.is_none_or(|wanted| found.fits(wanted)) => {
                self.in_space_of_bodies(value, count, word)
            }
            _ => {
                let count = self.mechanics.components.or(count);
                if let Some(dimension) = wanted {
                    self.suspect(&value, &Type::Scalar(dimension));
                }
                let wanted = match (count, wanted) {
                    (Some(count), Some(wanted)) => Type::Vector(count, wanted).to_string(),
                    (None, Some(wanted)) => format!("a vector, each component {wanted}"),
                    (_, None) => "a vector".to_owned(),
                };
                self.wrong_clause(value, word, &wanted, example)
            }
        }
    }

    /// The first vector decides whether the mechanics is one of the plane or of space.
    fn in_space_of_bodies(&mut self, value: Expr, count: usize, word: &str) -> Expr {
        let all = *self.mechanics.components.get_or_insert(count);
        if all == count {
            return value;
        }
        let (all, help) = match all {
            2 => (
                "in the plane",
                "leave out the third component: `(v.x, v.y)`".to_owned(),
            ),
            _ => ("in space", self.lifted(&value)),
        };
        let fact = format!(
            "`{word}` takes {}, but the bodies before it are {all}",
            value.ty
        );
        let span = self.origins.span(value.origin);
        self.diagnostics.error_with_help(span, fact, help);
        self.failed(span)
    }

    pub(super) fn wrong_clause(
        &mut self,
        value: Expr,
        word: &str,
        wanted: &str,
        example: &str,
    ) -> Expr {
        let span = self.origins.span(value.origin);
        if value.ty.is_error() {
            return value;
        }
        let fact = format!("`{word}` takes {wanted}, found {}", value.ty);
        let help = self
            .hidden_unit(&value)
            .unwrap_or_else(|| format!("write it like `{example}`"));
        self.diagnostics.error_with_help(span, fact, help);
        self.failed(span)
    }
}
