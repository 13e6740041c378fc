//! The curve of a quantity over the range of its input.

use super::SummaryError;
use super::cascade::{Solved, solve};
use super::defined_intervals::{advance, defined_intervals, positions};
use super::extremes::Extremes;
use super::interval::Interval;
use super::source::{Node, Source};
use super::zero_threshold::ZeroThreshold;
use alloc::vec::Vec;

/// The curve of a quantity over the range of its input, with all places where it or one of its
/// derivatives is stationary.
///
/// `N` is the number of values of the function: the quantity and its first derivative, or also the
/// second, or also the third (`velocity`, `acceleration` and `jerk` of the language). It determines
/// the figures that are found to the last digits:
///
/// | `N` | found |
/// |---|---|
/// | 2 | limits, dwells around them |
/// | 3 | also the extreme velocities, dwells between limits |
/// | 4 | also the extreme accelerations |
///
/// ```
/// use linkage_analysis::summary::Curve;
/// use std::f64::consts::{FRAC_PI_2, TAU};
///
/// // A Scotch yoke of 40 mm.
/// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
/// let curve = Curve::new((0.0, TAU), 360, yoke)?;
/// let position = curve.position();
/// assert_eq!(position.stroke(), 80.0);
/// assert!((position.highest.at - FRAC_PI_2).abs() < 1e-15);
/// assert_eq!(curve.velocity().largest().value, 40.0);
/// # Ok::<(), linkage_analysis::summary::SummaryError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Curve<const N: usize, F> {
    pub(super) source: Source<N, F>,
    pub(super) solved: Vec<Solved<N>>,
    extremes: Vec<Extremes>,
}

impl<const N: usize, F: Fn(f64) -> [f64; N]> Curve<N, F> {
    /// Follows a quantity over a range of the input, from this many evenly spaced positions, both
    /// ends among them: `function` gives the quantity and its first `N - 1` derivatives by the
    /// input.
    ///
    /// All derivatives have to be exact: roots are located by the derivative above, and to the last
    /// digits. 360 positions for a turn are plenty for a mechanism; the highest derivative may have
    /// features that are narrower than the spacing, and these may be missed if neither its values
    /// nor the differences of the derivative below show them.
    ///
    /// A range of whole turns (2 pi) at whose ends all derivatives agree is a cycle: it has no
    /// ends, and an interval across the seam is a single one. A NaN or infinite value is a
    /// [gap](Self::parts) of the curve. A derivative below 32 units in the last place of its median
    /// counts as zero.
    ///
    /// # Errors
    ///
    /// `Range` for an empty or infinite range, `Positions` for less than two, `NotAssembled` if
    /// there is no position with finite numbers.
    pub fn new(range: (f64, f64), positions: usize, function: F) -> Result<Self, SummaryError> {
        Self::followed(range, positions, function, |function, _, u| function(u))
    }

    /// Works as [`new`](Self::new) with evaluated positions: `row(i)` returns the quantity and its
    /// derivatives at the `i`th of [`positions`](super::positions). A sweep computes them several
    /// times faster than single calls do; `function` is then called for roots alone.
    ///
    /// ```
    /// use linkage_analysis::summary::{Curve, positions};
    ///
    /// let range = (0.0, std::f64::consts::TAU);
    /// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
    /// let rows: Vec<[f64; 3]> = positions(range, 90).map(yoke).collect();
    /// let curve = Curve::swept(range, 90, |i| rows[i], yoke)?;
    /// assert_eq!(curve.position().stroke(), 80.0);
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn swept(
        range: (f64, f64),
        positions: usize,
        mut row: impl FnMut(usize) -> [f64; N],
        function: F,
    ) -> Result<Self, SummaryError> {
        Self::followed(range, positions, function, |_, i, _| row(i))
    }

    fn followed(
        range: (f64, f64),
        count: usize,
        function: F,
        mut row: impl FnMut(&F, usize, f64) -> [f64; N],
    ) -> Result<Self, SummaryError> {
        const { assert!(N >= 2, "a course needs the quantity and its derivative") };
        let (low, high) = range;
        if !((high - low).is_finite() && high > low) {
            return Err(SummaryError::Range {
                from: low,
                to: high,
            });
        }
        if count < 2 {
            return Err(SummaryError::Positions { positions: count });
        }
        let mut source = Source {
            function,
            low,
            high,
            advance: None,
        };
        let rows = positions(range, count).enumerate();
        let node = |(i, u)| Node {
            u,
            jet: row(&source.function, i, u),
        };
        let nodes: Vec<Node<N>> = rows.map(node).collect();
        if !nodes.iter().any(Node::is_finite) {
            return Err(SummaryError::NotAssembled { positions: count });
        }
        source.advance = advance(&nodes);
        let threshold = ZeroThreshold::new(&nodes, source.width());
        let defined_intervals = defined_intervals(&source, &nodes, &threshold);
        let solved = solve(&source, &threshold, defined_intervals);
        let extremes = (0..N - 1)
            .map(|k| Extremes::new(&source, &threshold, &solved, k))
            .collect();
        Ok(Self {
            source,
            solved,
            extremes,
        })
    }

    /// Limits and stroke of the quantity itself.
    #[must_use]
    pub fn position(&self) -> &Extremes {
        &self.extremes[0]
    }

    /// Extremes of the first derivative. Times the speed of the input they are those of the true
    /// velocity.
    ///
    /// It needs the second derivative: with `N = 2` it does not compile.
    #[must_use]
    pub fn velocity(&self) -> &Extremes {
        const { assert!(N >= 3, "extreme velocities need the second derivative") };
        &self.extremes[1]
    }

    /// Extremes of the second derivative. Times the square of the speed they are those of the true
    /// acceleration, at constant speed.
    ///
    /// It needs the third derivative: with `N < 4` it does not compile.
    #[must_use]
    pub fn acceleration(&self) -> &Extremes {
        const { assert!(N >= 4, "extreme accelerations need the third derivative") };
        &self.extremes[2]
    }

    /// Extremes of the `k`th derivative, as far as the one above it was given.
    #[doc(hidden)]
    #[must_use]
    pub fn extremes_of(&self, k: usize) -> Option<&Extremes> {
        self.extremes.get(k)
    }

    /// The range, its lower end first.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        (self.source.low, self.source.high)
    }

    /// Returns true if the range is a cycle: whole turns, after which the quantity and its
    /// derivatives return to their values.
    #[must_use]
    pub fn is_cycle(&self) -> bool {
        self.source.advance == Some(0.0)
    }

    /// The quantity at both ends of the range.
    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.source.low, self.source.high].map(|u| (self.source.function)(u)[0])
    }

    /// The intervals in which the quantity and all its derivatives are finite, in order of the
    /// input: the whole range if there is no gap. The borders of gaps are found by bisection. A gap
    /// that is narrower than the spacing of the positions is found if the search for roots meets
    /// it.
    #[must_use]
    pub fn parts(&self) -> Vec<Interval> {
        let part = |part: &Solved<N>| {
            let nodes = &part.interval.nodes;
            let (from, to) = (nodes[0].u, nodes[nodes.len() - 1].u);
            if part.interval.whole {
                Interval::whole(&self.source)
            } else {
                Interval::between(&self.source, from, to)
            }
        };
        let mut parts: Vec<Interval> = self.solved.iter().map(part).collect();
        parts.sort_by(|a, b| a.from.total_cmp(&b.from));
        parts
    }

    /// Returns true if there is a position in the range that is not finite.
    #[must_use]
    pub fn has_gaps(&self) -> bool {
        let found: f64 = self.parts().iter().map(|part| part.range).sum();
        self.solved.len() > 1 || found < self.source.width()
    }
}
