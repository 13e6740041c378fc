//! Time ratio of forward and return stroke.

use super::course::Course;
use super::extremes::Kind;

/// How the input of a cycle is divided between the two strokes.
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

impl<const N: usize, F: Fn(f64) -> [f64; N]> Course<N, F> {
    /// How the input is divided between a forward and a return stroke. `None` if the range is no cycle or has gaps,
    /// or if the quantity has not exactly one highest and one lowest position in it.
    #[must_use]
    pub fn time_ratio(&self) -> Option<TimeRatio> {
        let whole = self.is_cycle() && !self.has_gaps();
        let position = self.position();
        let one = |kind: Kind| {
            let mut limits = position.limits().filter(|limit| limit.kind == kind);
            limits.next().filter(|_| limits.next().is_none())
        };
        let (low, high) = (one(Kind::Low)?, one(Kind::High)?);
        let way = high.at - low.at;
        let rise = if way > 0.0 {
            way
        } else {
            way + self.source.width()
        };
        whole.then_some(TimeRatio {
            rise,
            fall: self.source.width() - rise,
        })
    }
}
