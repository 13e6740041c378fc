//! Words and kinds of courses: laws of motion between knots, and splines through points.

use crate::syntax::vocabulary;

vocabulary! {
    /// A law of motion: how something goes from 0 to 1 while `x` does.
    pub enum Law {
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
    /// The ends of a spline.
    pub enum Ends {
        /// Continues with its last continuous derivatives: a cubic spline as a straight line.
        Natural = "natural",
        /// Without slope; it goes on as a constant.
        Clamped = "clamped",
        /// Ends as it began.
        Periodic = "periodic",
    }
}

vocabulary! {
    /// The degree of the pieces of a spline that are not cubic.
    pub enum Degree {
        /// Four derivatives are continuous.
        Quintic = "quintic",
    }
}

vocabulary! {
    /// A word after the points of a spline.
    pub enum SplineWord {
        Ends(Ends),
        Degree(Degree),
    }
}

vocabulary! {
    /// The continuation of a course of laws after its last knot, if the knots span no turn.
    pub enum Repeating {
        /// Continues as from the first knot.
        Periodic = "periodic",
    }
}

/// The pieces of a spline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pieces {
    /// Through points, with continuous curvature.
    Cubic,
    /// Through points, with four continuous derivatives.
    Quintic,
    /// Through points by slopes that are given, with three continuous derivatives.
    QuinticBySlopes,
}

/// The highest derivative of a course that is a course itself.
pub const HIGHEST_SLOPE: u8 = 3;

/// The interpolation between knots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionLawKind {
    /// `rise(x, law)`: one law from 0 to 1, which need not be smooth at its ends.
    Rise,
    /// The law of the later knot; constant beyond the ends.
    Laws,
    Spline(Ends, Pieces),
}

/// The period after which the argument repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repeats {
    Never,
    /// The knots span a turn.
    EachTurn,
    /// The last knot is followed by the first one.
    FromLastToFirst,
}
