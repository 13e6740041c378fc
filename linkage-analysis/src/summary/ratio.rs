//! Time ratio of forward and return stroke.

use super::curve::Curve;
use super::extremes::Kind;

/// The input of the two strokes of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRatio {
    /// The input from the lowest to the highest position.
    pub rise: f64,
    /// The input from the highest to the lowest position.
    pub fall: f64,
}

impl TimeRatio {
    /// The longer over the shorter one: 1 or more.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.rise.max(self.fall) / self.rise.min(self.fall)
    }
}

/// The ratio of [`Curve::time_ratio`].
pub(super) fn time_ratio<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
) -> Option<TimeRatio> {
    let whole = curve.is_cycle() && !curve.has_gaps();
    let position = curve.position();
    let one = |kind: Kind| {
        let mut limits = position.limits().filter(|limit| limit.kind == kind);
        limits.next().filter(|_| limits.next().is_none())
    };
    let (low, high) = (one(Kind::Low)?, one(Kind::High)?);
    let way = high.at - low.at;
    let rise = if way > 0.0 {
        way
    } else {
        way + curve.source.width()
    };
    whole.then_some(TimeRatio {
        rise,
        fall: curve.source.width() - rise,
    })
}
