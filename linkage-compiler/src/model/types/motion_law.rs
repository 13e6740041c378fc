//! Words and kinds of courses: laws of motion between knots, and splines through points.

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

/// The highest derivative of a course that is a course itself.
pub(crate) const HIGHEST_SLOPE: u8 = 3;

/// How it goes from knot to knot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionLawKind {
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
