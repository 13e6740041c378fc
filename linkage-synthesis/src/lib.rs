//! Exact synthesis: all mechanisms that meet as many conditions as they have dimensions.
//!
//! Tasks of the plane are poses of a body ([`Dyads`], [`CentreCurve`]), functions of four-bars
//! ([`Functions`]), and five or nine points of a path ([`five_points`], [`nine_points`]).
//! [`solutions`] lists all solutions of other equations by monodromy. Solutions are certified.
//!
//! Users reach all items through the facade crate `linkage`, in its module `design::exact`.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod ball;
mod burmester;
mod certificate;
mod dense;
mod dyad;
mod error;
mod five_points;
mod four_bar;
mod function;
mod guides;
mod long;
mod nine_points;
mod path;
mod polynomial;
mod real;
mod solutions;
mod task;
#[cfg(test)]
mod tests;
mod verify;

pub use burmester::{CentreCurve, CentrePoint, Dyads};
pub use error::Unsolved;
pub use five_points::{FivePoints, five_points};
pub use four_bar::{FourBar, GrashofType, Passage, Visit};
pub use function::{FunctionFourBar, Functions, GivenStart, Pair};
pub use guides::{Dyad, Pivots};
pub use nine_points::{
    NinePoints, NinePointsPart, NinePointsSearch, PathFourBar, TRIPLES, Triple, nine_points,
    nine_points_reporting,
};
pub use solutions::{Equations, Number, Solution, Solutions, Trace, solutions, solutions_traced};

use linkage_core::numeric::complex::Complex;

/// Arcs from general constants, or stored ones, to the given ones: angles without pattern. The
/// first arc finds all solutions except by accident; agreement of several arcs confirms them.
const ARCS: [f64; 3] = [2.1937, -1.3291, 0.8713];

/// The pose of a body in the plane: the place of the origin of its frame, and its angle (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Place of the origin of the body's frame.
    pub point: [f64; 2],
    /// Angle of the body's frame, rad.
    pub angle: f64,
}

impl Pose {
    /// A pose.
    #[must_use]
    pub const fn new(point: [f64; 2], angle: f64) -> Self {
        Self { point, angle }
    }

    /// Returns the place of a point of the body.
    #[must_use]
    pub fn place(&self, point: [f64; 2]) -> [f64; 2] {
        (Complex::from(self.point) + Complex::polar(self.angle) * point.into()).into()
    }

    /// Returns the point of the body that is at a place.
    #[must_use]
    pub fn point_at(&self, position: [f64; 2]) -> [f64; 2] {
        let way = Complex::from(position) - self.point.into();
        (Complex::polar(-self.angle) * way).into()
    }
}
