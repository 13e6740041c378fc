//! The time ratio of forward and return stroke.

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use super::{Curve, Figure, Motion, Piece, PieceKey, Pieces};
use linkage_analysis::summary::Kind;

type Rates<'a, A, const N: usize> = Box<dyn Fn(&A, f64) -> [f64; N] + Send + Sync + 'a>;

/// The division of the input of a turn between the two strokes of a quantity: its rise over its
/// fall.
///
/// The places of the limits are roots of the velocity; with a parameter they move by the velocity's
/// derivative by it over the acceleration, with the opposite sign.
pub struct TimeRatio<'a, A, const N: usize> {
    curve: Curve<'a, A, N>,
    rates: Rates<'a, A, N>,
}

impl<'a, A, const N: usize> TimeRatio<'a, A, N> {
    /// Builds the ratio of a quantity; `rates` gives the derivatives of its velocity by the
    /// parameters, `sensitivity(velocity(q))`.
    pub fn new(
        curve: Curve<'a, A, N>,
        rates: impl Fn(&A, f64) -> [f64; N] + Send + Sync + 'a,
    ) -> Self {
        Self {
            curve,
            rates: Box::new(rates),
        }
    }
}

impl<A, const N: usize> Figure<A, N> for TimeRatio<'_, A, N> {
    fn title(&self) -> String {
        "time ratio".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        let course = self.curve.course(motion)?;
        let strokes = course.time_ratio()?;
        let slopes = |kind: Kind| {
            let limit = course
                .position()
                .limits()
                .find(|limit| limit.kind == kind)?;
            let [_, _, acceleration] = self.curve.jet(motion.assembly, limit.at);
            Some((self.rates)(motion.assembly, limit.at).map(|rate| -rate / acceleration))
        };
        let (high, low) = (slopes(Kind::High)?, slopes(Kind::Low)?);
        let value = strokes.rise / strokes.fall;
        // The fall is shorter by as much as the rise is longer.
        let factor = (1.0 + value) / strokes.fall;
        let parameters = core::array::from_fn(|k| factor * (high[k] - low[k]));
        Some(Pieces::Largest(vec![Piece {
            key: PieceKey::Nth(0),
            value,
            parameters,
            auxiliary: Vec::new(),
        }]))
    }
}
