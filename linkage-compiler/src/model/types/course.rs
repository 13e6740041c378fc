//! Courses: numbers that are given along another one, by laws of motion between knots or as splines through points.

use super::super::types::{Expr, Type};
use crate::diagnostic::OriginId;
use crate::syntax::vocabulary;

vocabulary! {
    /// A law of motion: how something goes from 0 to 1 while `x` does.
    pub(crate) enum Law {
        /// The straight line.
        Line = "line",
        /// `3 x^2 - 2 x^3`
        Cubic = "cubic",
        /// `10 x^3 - 15 x^4 + 6 x^5`
        Poly345 = "poly345",
        /// `35 x^4 - 84 x^5 + 70 x^6 - 20 x^7`
        Poly4567 = "poly4567",
        /// `(1 - cos(pi x)) / 2`
        Harmonic = "harmonic",
        /// `x - sin(2 pi x) / (2 pi)`
        Cycloidal = "cycloidal",
        /// Sines of two periods as acceleration.
        ModifiedSine = "modified_sine",
        /// Quarters of sines and constants as acceleration.
        ModifiedTrapezoid = "modified_trapezoid",
    }
}

vocabulary! {
    /// How a spline ends.
    pub(crate) enum Ends {
        /// It goes on as its last derivatives that are continuous say: a cubic one as a straight line.
        Natural = "natural",
        /// Without slope; it goes on as a constant.
        Clamped = "clamped",
        /// As it began.
        Periodic = "periodic",
    }
}

vocabulary! {
    /// Of which degree the pieces of a spline are, if they are not cubic.
    pub(crate) enum Degree {
        /// Four derivatives are continuous.
        Quintic = "quintic",
    }
}

vocabulary! {
    /// What stands behind the points of a spline.
    pub(crate) enum SplineWord {
        Ends(Ends),
        Degree(Degree),
    }
}

vocabulary! {
    /// How a course of laws goes on behind its last knot where the knots span no turn.
    pub(crate) enum Repeating {
        /// As from the first one.
        Periodic = "periodic",
    }
}

/// What the pieces of a spline are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pieces {
    /// Through points, with continuous curvature.
    Cubic,
    /// Through points, with four continuous derivatives.
    Quintic,
    /// Through points by slopes that are given, with three continuous derivatives.
    QuinticBySlopes,
}

/// A number along `argument`, or its slope.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    pub(crate) argument: Box<Expr>,
    /// At least two.
    pub(crate) knots: Vec<Knot>,
    pub(crate) kind: CourseKind,
    /// How the argument repeats.
    pub(crate) repeats: Repeats,
    /// Which derivative by the argument it is.
    pub(crate) order: u8,
}

/// The highest derivative of a course that is a course itself.
pub(crate) const HIGHEST_SLOPE: u8 = 3;

/// How it goes from knot to knot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CourseKind {
    /// `rise(x, law)`: one law from 0 to 1, which nobody asks to be smooth at its ends.
    Rise,
    /// By the law of the later knot; beyond the ends it stays where it is.
    Laws,
    Spline(Ends, Pieces),
}

/// After what the argument begins anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Repeats {
    Never,
    /// The knots span a turn.
    EachTurn,
    /// From the last knot on it goes as from the first one.
    FromLastToFirst,
}

/// Where something is known.
#[derive(Clone, Debug)]
pub(crate) struct Knot {
    pub(crate) place: Expr,
    pub(crate) value: Expr,
    /// The slope there, of a spline.
    pub(crate) slope: Option<Expr>,
    /// The law that leads to it.
    pub(crate) law: Option<Law>,
    /// Whether speed and acceleration may jump here.
    pub(crate) may_jump: bool,
    pub(crate) origin: OriginId,
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for Knot {
    fn eq(&self, other: &Self) -> bool {
        let words = |own: &Self| (own.law, own.may_jump);
        let numbers = |own: &Self| (own.place.clone(), own.value.clone(), own.slope.clone());
        numbers(self) == numbers(other) && words(self) == words(other)
    }
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for Course {
    fn eq(&self, other: &Self) -> bool {
        let all = |own: &Self| (own.kind, own.repeats, own.order);
        self.argument == other.argument && self.knots == other.knots && all(self) == all(other)
    }
}

impl Course {
    /// Of what its argument and the places of its knots are.
    pub(crate) fn argument_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|own| matches!(own.place.ty, Type::Scalar(own) if own.angle));
        angle.map_or(&*self.argument, |own| &own.place).ty.clone()
    }

    /// Of what its values are, were it not differentiated.
    pub(crate) fn value_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|own| matches!(own.value.ty, Type::Scalar(own) if own.angle));
        angle.unwrap_or(&self.knots[0]).value.ty.clone()
    }

    /// The same course of other expressions, from elsewhere.
    pub(crate) fn map(
        &self,
        expression: impl Fn(&Expr) -> Expr,
        origin: impl Fn(OriginId) -> OriginId,
    ) -> Self {
        let knot = |own: &Knot| Knot {
            place: expression(&own.place),
            value: expression(&own.value),
            slope: own.slope.as_ref().map(&expression),
            origin: origin(own.origin),
            ..own.clone()
        };
        Self {
            argument: Box::new(expression(&self.argument)),
            knots: self.knots.iter().map(knot).collect(),
            ..*self
        }
    }

    /// The expressions that it is made of, as they are read.
    pub(crate) fn operands(&self) -> Vec<&Expr> {
        let mut all = vec![&*self.argument];
        let knots = self.knots.iter();
        all.extend(knots.flat_map(|own| [&own.place, &own.value].into_iter().chain(&own.slope)));
        all
    }
}
