//! All places of a cycle where two shapes are nearest to each other.

use super::case::Case;
use super::nearest::Nearest;
use super::shape::{Feature, Pair, parts, plain};
use crate::components::Components;
use crate::summary::{Curve, Kind, SummaryError, positions};
use alloc::vec::Vec;

#[cfg(feature = "tolerance")]
use crate::tolerance::Tolerances;

/// The places of a cycle where two shapes, points or segments, are nearest to each other.
///
/// ```
/// use linkage_analysis::clearance::Clearance;
/// use std::f64::consts::TAU;
///
/// // A pin on a crank of 40 mm, and a bar of 30 mm that stands upright at x = 50 mm.
/// let pin = |phi: f64| [
///     [40.0 * phi.cos(), 40.0 * phi.sin()],
///     [-40.0 * phi.sin(), 40.0 * phi.cos()],
///     [-40.0 * phi.cos(), -40.0 * phi.sin()],
/// ];
/// let still = |x, y| [[x, y], [0.0; 2], [0.0; 2]];
/// let bar = [still(50.0, 10.0), still(50.0, 40.0)];
/// let clearance = Clearance::new((0.0, TAU), 90, |phi| ([pin(phi)], bar))?;
/// let least = clearance.least();
/// // The lower end of the bar is nearest: in line with the crank.
/// assert!((least.at - (10.0f64 / 50.0).atan()).abs() < 1e-15);
/// assert!((least.distance - (2600f64.sqrt() - 40.0)).abs() < 1e-14 && least.feet == [0.0, 0.0]);
/// # Ok::<(), linkage_analysis::summary::SummaryError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Clearance<const K: usize> {
    minima: Vec<Nearest<K>>,
}

/// The distance that is left in the worst case of the tolerances, to first order.
#[cfg(feature = "tolerance")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guaranteed {
    /// The angle of the shaft.
    pub at: f64,
    /// The distance there without errors.
    pub nominal: f64,
    /// The largest decrease within the tolerances.
    pub error: f64,
    /// The remaining distance.
    pub distance: f64,
}

/// Two minima whose angles differ by less, as a share of the range, and whose distances by less, as
/// a share of them, are one that two cases have found: an end of a segment is the end of its
/// inside.
const SAME: f64 = 1e-9;

impl<const K: usize> Clearance<K> {
    /// Follows two shapes over a range of the shaft's angle, from this many evenly spaced
    /// positions, both ends among them.
    ///
    /// `function` gives both shapes at an angle, each with one point or with the two ends of a
    /// segment; a point is `[p, v, a]`, its position and its first and second derivative by the
    /// angle (`velocity` and `acceleration` of the language), as vectors of the plane or of space.
    ///
    /// The nearest point of a segment may be an end or an inner point. Each of these cases is
    /// followed separately, as a [`Curve`] of half the square of the distance, which is smooth
    /// where the distance itself is not (at 0). The roots are located as those of any curve, and
    /// cases that are not nearest are dropped. Segments of the plane that cross touch: the distance
    /// is 0, and if they cross at one of the positions, the first such position is reported.
    ///
    /// # Errors
    ///
    /// As [`Curve::new`].
    pub fn new<V: Components<K>, const A: usize, const B: usize>(
        range: (f64, f64),
        positions: usize,
        function: impl Fn(f64) -> ([[V; 3]; A], [[V; 3]; B]),
    ) -> Result<Self, SummaryError> {
        Self::followed(range, positions, &function, |u, _| function(u))
    }

    /// Works as [`new`](Self::new) with evaluated positions: `row(i)` returns the shapes at the
    /// `i`th of [`positions`], from a sweep. `function` is then called for roots alone.
    ///
    /// # Errors
    ///
    /// As [`Curve::new`].
    pub fn swept<V: Components<K>, const A: usize, const B: usize>(
        range: (f64, f64),
        positions: usize,
        row: impl Fn(usize) -> ([[V; 3]; A], [[V; 3]; B]),
        function: impl Fn(f64) -> ([[V; 3]; A], [[V; 3]; B]),
    ) -> Result<Self, SummaryError> {
        Self::followed(range, positions, &function, |_, i| row(i))
    }

    fn followed<V: Components<K>, const A: usize, const B: usize>(
        range: (f64, f64),
        count: usize,
        function: impl Fn(f64) -> ([[V; 3]; A], [[V; 3]; B]),
        row: impl Fn(f64, usize) -> ([[V; 3]; A], [[V; 3]; B]),
    ) -> Result<Self, SummaryError> {
        let pair = |(first, second): ([[V; 3]; A], [[V; 3]; B])| Pair {
            first: plain(first),
            second: plain(second),
        };
        let inputs = positions(range, count).enumerate();
        let rows: Vec<Pair<K, A, B>> = inputs.map(|(i, u)| pair(row(u, i))).collect();
        Self::of_rows(range, &rows, |u| pair(function(u)))
    }

    pub(super) fn of_rows<const A: usize, const B: usize>(
        range: (f64, f64),
        rows: &[Pair<K, A, B>],
        function: impl Fn(f64) -> Pair<K, A, B>,
    ) -> Result<Self, SummaryError> {
        const {
            assert!(
                A == 1 || A == 2,
                "a shape is a point or the two ends of a segment"
            );
            assert!(
                B == 1 || B == 2,
                "a shape is a point or the two ends of a segment"
            );
        }
        let mut found: Vec<Nearest<K>> = Vec::new();
        let inside = [Feature::Edge, Feature::Edge];
        for parts in parts(A)
            .iter()
            .flat_map(|a| parts(B).iter().map(|b| [*a, *b]))
        {
            if parts == inside && K < 3 {
                let mut rows_in_order = positions(range, rows.len()).zip(rows);
                let crossing = rows_in_order.find(|(_, row)| Case::new(inside, row).is_nearest());
                found.extend(crossing.map(|(u, row)| Nearest::new(u, Case::new(inside, row))));
                continue;
            }
            let jet = |pair: &Pair<K, A, B>| Case::new(parts, pair).jet();
            let curve = Curve::swept(range, rows.len(), |i| jet(&rows[i]), |u| jet(&function(u)));
            let curve = match curve {
                Ok(curve) => curve,
                // Parallel edges have no inside that is nearest, and one without length is a point.
                Err(_) if parts.contains(&Feature::Edge) => continue,
                Err(error) => return Err(error),
            };
            let points = &curve.position().points;
            let low = points.iter().filter(|point| point.kind == Kind::Low);
            let constant = [curve.position().lowest];
            let alone = constant.iter().filter(|_| points.is_empty());
            for extreme in low.chain(alone) {
                let case = Case::new(parts, &function(extreme.at));
                if case.is_nearest() {
                    found.push(Nearest::new(extreme.at, case));
                }
            }
        }
        found.sort_by(|a, b| a.at.total_cmp(&b.at));
        let width = range.1 - range.0;
        found.dedup_by(|a, b| {
            let distances = (a.distance - b.distance).abs();
            (a.at - b.at).abs() <= SAME * width && distances <= SAME * a.distance.max(b.distance)
        });
        if found.is_empty() {
            Err(SummaryError::NotAssembled {
                positions: rows.len(),
            })
        } else {
            Ok(Self { minima: found })
        }
    }

    /// The nearest place of all; the first one of several that are equally near.
    #[must_use]
    pub fn least(&self) -> &Nearest<K> {
        let nearer = |a, b| if lower(b, a) { b } else { a };
        self.minima.iter().fold(&self.minima[0], nearer)
    }

    /// All local minima of the distance, in order of the angle: also those where
    /// it is larger than elsewhere, which tolerances or another phase may make the least one. In a
    /// range that is no cycle its ends may be among them.
    #[must_use]
    pub fn minima(&self) -> &[Nearest<K>] {
        &self.minima
    }

    /// The distance that remains for all dimensions within their tolerances, to first
    /// order: each minimum is taken with its own sensitivities, since that with the least distance
    /// need not be that with the least rest.
    ///
    /// `sensitivity` gives those of a minimum, by [`Nearest::sensitivity`].
    #[cfg(feature = "tolerance")]
    #[must_use]
    pub fn guaranteed<const P: usize>(
        &self,
        tolerances: &Tolerances<P>,
        sensitivity: impl Fn(&Nearest<K>) -> [f64; P],
    ) -> Guaranteed {
        let left = |nearest: &Nearest<K>| {
            let [error] = tolerances.effects(&sensitivity(nearest)).worst_case();
            Guaranteed {
                at: nearest.at,
                nominal: nearest.distance,
                error,
                distance: nearest.distance - error,
            }
        };
        let mut worst = left(&self.minima[0]);
        for nearest in &self.minima[1..] {
            let next = left(nearest);
            // Not less than or equal: NaN, where the shapes touch, is reported.
            if next.distance.is_nan() || next.distance < worst.distance {
                worst = next;
            }
        }
        worst
    }
}

fn lower<const K: usize>(a: &Nearest<K>, b: &Nearest<K>) -> bool {
    a.distance < b.distance
}
