//! Extreme values of a quantity over the cycle: by exact roots of its derivative, with slopes by
//! the envelope theorem.
//!
//! At a limit the derivative by the input is zero: that the place shifts with the dimensions does
//! not matter, to first order, and the derivatives by the parameters are those at the place.

use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use super::{Curve, Figure, Motion, Piece, Pieces};
use linkage_analysis::summary::{Extremes, Kind};

/// The highest value of a quantity over the cycle.
pub struct Highest<'a, A, const N: usize>(pub Curve<'a, A, N>);

/// The lowest value of a quantity over the cycle: a margin or a transmission angle that should not
/// be below a limit.
pub struct Lowest<'a, A, const N: usize>(pub Curve<'a, A, N>);

/// The value of a quantity over the cycle that is farthest from zero, without its sign: the peak of
/// a torque, the largest acceleration.
pub struct Peak<'a, A, const N: usize>(pub Curve<'a, A, N>);

/// The highest value of a quantity over the cycle less the lowest one.
pub struct Stroke<'a, A, const N: usize>(pub Curve<'a, A, N>);

/// The places of one kind, ends of the range among them; the extreme one is there even if the
/// quantity does not vary.
pub(super) fn places(extremes: &Extremes, kind: Kind) -> Vec<(f64, f64)> {
    let limits = extremes.points.iter().filter(|point| point.kind == kind);
    let mut places: Vec<(f64, f64)> = limits.map(|point| (point.at, point.value)).collect();
    if places.is_empty() {
        let extreme = if kind == Kind::High {
            extremes.highest
        } else {
            extremes.lowest
        };
        places.push((extreme.at, extreme.value));
    }
    places
}

fn limits<A, const N: usize>(
    curve: &Curve<'_, A, N>,
    motion: &Motion<'_, A>,
    kinds: &[(Kind, f64)],
) -> Option<Vec<Piece<N>>> {
    let course = curve.course(motion)?;
    let piece =
        |(at, value): (f64, f64), sign: f64| curve.piece(motion, at, value).times(sign, 0.0);
    let of = |&(kind, sign): &(Kind, f64)| {
        places(course.position(), kind)
            .into_iter()
            .map(move |extreme| piece(extreme, sign))
            .collect::<Vec<_>>()
    };
    Some(kinds.iter().flat_map(of).collect())
}

impl<A, const N: usize> Figure<A, N> for Highest<'_, A, N> {
    fn title(&self) -> String {
        "highest value".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        Some(Pieces::Largest(limits(
            &self.0,
            motion,
            &[(Kind::High, 1.0)],
        )?))
    }
}

impl<A, const N: usize> Figure<A, N> for Lowest<'_, A, N> {
    fn title(&self) -> String {
        "lowest value".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        Some(Pieces::Smallest(limits(
            &self.0,
            motion,
            &[(Kind::Low, 1.0)],
        )?))
    }
}

impl<A, const N: usize> Figure<A, N> for Peak<'_, A, N> {
    fn title(&self) -> String {
        "peak".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        Some(Pieces::Largest(limits(
            &self.0,
            motion,
            &[(Kind::High, 1.0), (Kind::Low, -1.0)],
        )?))
    }
}

impl<A, const N: usize> Figure<A, N> for Stroke<'_, A, N> {
    fn title(&self) -> String {
        "stroke".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        let course = self.0.course(motion)?;
        let [highs, lows] = [Kind::High, Kind::Low].map(|kind| {
            let piece = |(at, value)| self.0.piece(motion, at, value);
            places(course.position(), kind)
                .into_iter()
                .map(piece)
                .collect::<Vec<_>>()
        });
        let mut pieces = vec![];
        for high in &highs {
            pieces.extend(lows.iter().map(|low| Piece {
                key: high.key,
                value: high.value - low.value,
                parameters: core::array::from_fn(|k| high.parameters[k] - low.parameters[k]),
                auxiliary: Vec::new(),
            }));
        }
        Some(Pieces::Largest(pieces))
    }
}
