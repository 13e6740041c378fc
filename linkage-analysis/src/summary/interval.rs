//! Intervals of the input.

use super::source::{Node, Source};

/// An interval of the input. In a cycle it may go across the seam: then `to` is below `from`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Its beginning.
    pub from: f64,
    /// Its end.
    pub to: f64,
    /// Length of the interval, across the seam if it goes there.
    pub range: f64,
}

impl Interval {
    /// The interval from one input to another, which may be beyond the range.
    pub(super) fn between<const N: usize, F: Fn(f64) -> [f64; N]>(
        source: &Source<N, F>,
        from: f64,
        to: f64,
    ) -> Self {
        let in_range = |u: f64| {
            let jet = [0.0; N];
            source.in_range(Node { u, jet }).u
        };
        let start = in_range(from);
        let range = to - from;
        // The end of the range is no place before its beginning.
        let end = in_range(to);
        Self {
            from: start,
            to: if end <= source.low && range > 0.0 {
                source.high
            } else {
                end
            },
            range,
        }
    }

    /// The whole range.
    pub(super) fn whole<const N: usize, F: Fn(f64) -> [f64; N]>(source: &Source<N, F>) -> Self {
        Self {
            from: source.low,
            to: source.high,
            range: source.width(),
        }
    }
}
