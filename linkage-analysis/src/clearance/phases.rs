//! Two members on one shaft, of which one can be turned ahead.

use super::PhaseError;
use super::minima::Clearance;
use super::nearest::{Nearest, foot_point};
use super::probe::{Limits, Line, Probe};
use super::shape::{Jet, Pair, plain};
use crate::components::{Components, norm};
use crate::summary::{SummaryError, positions};
use alloc::vec::Vec;
use core::marker::PhantomData;

/// Two members on one shaft, the second of which leads by a phase: at the shaft's angle `x` it
/// is where it is at `x + phase` without one.
///
/// ```
/// use linkage_analysis::clearance::Phases;
/// use std::f64::consts::{PI, TAU};
///
/// // Two yokes that move along lines 10 mm apart.
/// let yoke = |x: f64, height: f64| {
///     [[40.0 * x.sin(), height], [40.0 * x.cos(), 0.0], [-40.0 * x.sin(), 0.0]]
/// };
/// let phases = Phases::new((0.0, TAU), 90, |x| [yoke(x, 0.0)], |x| [yoke(x, 10.0)])?;
/// // They pass each other at any phase.
/// let best = phases.best((-PI, PI))?;
/// assert!((best.distance - 10.0).abs() < 1e-12);
/// # Ok::<(), linkage_analysis::clearance::PhaseError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Phases<V, const K: usize, const A: usize, const B: usize, F, G> {
    first: F,
    second: G,
    range: (f64, f64),
    /// The rows of both members, one for each position.
    rows: Vec<Pair<K, A, B>>,
    pub(super) limits: Limits,
    vectors: PhantomData<fn() -> V>,
}

/// The difference of a point or derivative between both ends of a cycle that counts as rounding, as
/// a share of its largest value.
const REPEATS: f64 = 1e-9;

/// The assumed factor of speed and acceleration between two positions, compared with the fastest
/// position. With 90 positions, a harmonic as high as the tenth of the shaft's turn loses no more
/// than a twentieth between two of them.
const BETWEEN: f64 = 1.25;

/// The distance of a phase from a multiple of the spacing that counts as rounding, as a share of
/// the spacing.
const ON_GRID: f64 = 1e-13;

impl<V, const K: usize, const A: usize, const B: usize, F, G> Phases<V, K, A, B, F, G>
where
    V: Components<K>,
    F: Fn(f64) -> [[V; 3]; A],
    G: Fn(f64) -> [[V; 3]; B],
{
    /// Follows both members over a cycle of the shaft, from this many evenly spaced positions, both
    /// ends among them: each function gives the points of its member, as [`Clearance::new`] takes
    /// them, at its own angle, without a phase. Neither is ever called outside the range.
    ///
    /// # Errors
    ///
    /// `Curve` for an empty range or less than two positions, `Gap` if a member cannot be assembled
    /// at a position, `NoCycle` if it does not end where it began.
    pub fn new(
        range: (f64, f64),
        positions: usize,
        first: F,
        second: G,
    ) -> Result<Self, PhaseError> {
        let (from, to) = range;
        if !((to - from).is_finite() && to > from) {
            return Err(SummaryError::Range { from, to }.into());
        }
        if positions < 2 {
            return Err(SummaryError::Positions { positions }.into());
        }
        let row = |u: f64| Pair {
            first: plain(first(u)),
            second: plain(second(u)),
        };
        let rows: Vec<Pair<K, A, B>> = self::positions(range, positions).map(row).collect();
        repeats(range, rows.iter().map(|row| &row.first[..]), false)?;
        repeats(range, rows.iter().map(|row| &row.second[..]), true)?;
        let largest = |order: usize| {
            let points = rows.iter().flat_map(|row| &row.second);
            let sizes = points.map(|point| norm(&point[order]));
            BETWEEN * sizes.fold(0.0, f64::max)
        };
        let limits = Limits {
            speed: largest(1),
            acceleration: largest(2),
        };
        Ok(Self {
            first,
            second,
            range,
            rows,
            limits,
            vectors: PhantomData,
        })
    }

    /// The clearance at a phase.
    ///
    /// # Errors
    ///
    /// As [`Clearance::new`].
    pub fn clearance(&self, phase: f64) -> Result<Clearance<K>, SummaryError> {
        let pair = |u: f64| Pair {
            first: plain((self.first)(u)),
            second: self.turned(u + phase),
        };
        let count = self.rows.len() - 1;
        let steps = phase / self.width() * count as f64;
        let whole = (steps + 0.5f64.copysign(steps)) as i64;
        let rows: Vec<Pair<K, A, B>> = if (steps - whole as f64).abs() < ON_GRID {
            // Both members are at positions of theirs.
            let ahead = whole.rem_euclid(count as i64) as usize;
            let second = |i: usize| self.rows[(i + ahead) % count].second;
            let row = |(i, row): (usize, &Pair<K, A, B>)| Pair {
                first: row.first,
                second: second(i),
            };
            self.rows.iter().enumerate().map(row).collect()
        } else {
            let inputs = positions(self.range, self.rows.len()).zip(&self.rows);
            let row = |(u, row): (f64, &Pair<K, A, B>)| Pair {
                first: row.first,
                second: self.turned(u + phase),
            };
            inputs.map(row).collect()
        };
        Clearance::of_rows(self.range, &rows, pair)
    }

    pub(super) fn probe(&self, phase: f64) -> Result<Probe<K>, SummaryError> {
        let clearance = self.clearance(phase)?;
        let lines: Vec<Line> = clearance
            .minima()
            .iter()
            .map(|nearest| self.line(nearest, phase))
            .collect();
        let lower = |a: usize, b: usize| if lines[b].q < lines[a].q { b } else { a };
        Ok(Probe {
            phase,
            least: (0..lines.len()).fold(0, lower),
            lines,
            clearance,
        })
    }

    fn line(&self, nearest: &Nearest<K>, phase: f64) -> Line {
        let shape = self.turned(nearest.at + phase);
        let order = |k: usize| {
            let points: [[f64; K]; B] = core::array::from_fn(|i| shape[i][k]);
            foot_point(&points, nearest.feet[1])
        };
        let [slope, bend] = nearest.case.by_phase(&core::array::from_fn(order));
        Line {
            q: nearest.case.jet()[0],
            slope,
            bend,
        }
    }

    pub(super) fn width(&self) -> f64 {
        self.range.1 - self.range.0
    }

    pub(super) fn positions(&self) -> usize {
        self.rows.len()
    }

    /// The second member at an angle that may be beyond the range.
    fn turned(&self, angle: f64) -> [Jet<K>; B] {
        let (low, high) = self.range;
        let mut angle = angle;
        while angle > high {
            angle -= self.width();
        }
        while angle < low {
            angle += self.width();
        }
        plain((self.second)(angle))
    }
}

/// Checks that a member is assembled everywhere, and ends where it began.
fn repeats<'a, const K: usize>(
    range: (f64, f64),
    rows: impl ExactSizeIterator<Item = &'a [Jet<K>]> + Clone,
    second: bool,
) -> Result<(), PhaseError> {
    let finite = |shape: &&[Jet<K>]| {
        shape
            .as_flattened()
            .as_flattened()
            .iter()
            .all(|x| x.is_finite())
    };
    let missing = rows.len() - rows.clone().filter(finite).count();
    if missing > 0 {
        let inputs = positions(range, rows.len()).zip(rows);
        let gap = inputs.into_iter().find(|(_, shape)| !finite(shape));
        let at = gap.map_or(f64::NAN, |(at, _)| at);
        return Err(PhaseError::Gap {
            second,
            at,
            missing,
        });
    }
    let (Some(start), Some(end)) = (rows.clone().next(), rows.clone().last()) else {
        return Ok(());
    };
    let mut off: f64 = 0.0;
    for (i, (a, b)) in start.iter().zip(end).enumerate() {
        for order in 0..3 {
            let size = rows.clone().map(|shape| norm(&shape[i][order]));
            let size = size.fold(0.0, f64::max);
            let change = norm(&super::shape::difference(&a[order], &b[order]));
            if change > REPEATS * size {
                off = off.max(change);
            }
        }
    }
    if off > 0.0 {
        Err(PhaseError::NoCycle { second, range, off })
    } else {
        Ok(())
    }
}
