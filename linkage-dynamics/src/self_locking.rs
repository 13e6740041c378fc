//! Self-locking: the ranges of an input in which friction holds the loads.

use crate::sign_changes::{change_of_sign, samples};

/// A range of the input in which a mechanism locks itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LockedRange {
    /// Least input of the range: where locking begins, or the end of the searched range.
    pub start: f64,
    /// Largest input of the range.
    pub end: f64,
}

/// Finds the ranges of the input in which a mechanism locks itself: its loads cannot move it, since
/// friction takes more power than they deliver.
///
/// The argument `efficiency` is that of the reversed flow of power, the quantity `efficiency()` for
/// the motion in which the loads drive, often at the speed -1. It is not positive where the mechanism
/// locks itself. The range is divided into `parts`, and each change of the sign between neighbours is
/// located to the last digit. Two changes within one part are not found. Positions without an
/// efficiency (NaN), where friction jams, belong to no range.
///
/// ```
/// use linkage_dynamics::self_locking;
///
/// // A slide on an incline with the coefficient 0.2, over the angle of the incline.
/// let found = self_locking(|lean: f64| 1.0 - 0.2 / lean.tan(), [0.01, 1.0], 100);
/// assert_eq!(found.len(), 1);
/// assert_eq!(found[0].start, 0.01);
/// assert!((found[0].end - 0.2_f64.atan()).abs() < 1e-15);
/// ```
#[must_use]
pub fn self_locking(
    efficiency: impl Fn(f64) -> f64,
    range: [f64; 2],
    parts: usize,
) -> Vec<LockedRange> {
    let samples = samples(&efficiency, range, parts);
    let mut found = Vec::new();
    let mut open: Option<LockedRange> = None;
    for (index, &(input, value)) in samples.iter().enumerate() {
        let is_locked = value <= 0.0;
        let change = index
            .checked_sub(1)
            .and_then(|before| change_of_sign(&efficiency, samples[before], (input, value)));
        open = match open {
            Some(range) if is_locked => Some(LockedRange {
                end: input,
                ..range
            }),
            Some(range) => {
                found.push(LockedRange {
                    end: change.unwrap_or(range.end),
                    ..range
                });
                None
            }
            None if is_locked => Some(LockedRange {
                start: change.unwrap_or(input),
                end: input,
            }),
            None => None,
        };
    }
    found.extend(open);
    found
}

#[cfg(test)]
mod tests {
    use super::{LockedRange, self_locking};

    #[test]
    fn ranges_end_at_changes_of_the_sign_and_where_friction_jams() {
        let roots = [-2.0, 1.0, 1.5];
        let cubic = |x: f64| roots.iter().map(|root| x - root).product::<f64>();
        let found = self_locking(cubic, [-4.0, 4.0], 33);
        assert_eq!(found.len(), 2);
        let ends = [[-4.0, -2.0], [1.0, 1.5]];
        for (LockedRange { start, end }, expected) in found.into_iter().zip(ends) {
            assert!((start - expected[0]).abs() < 1e-15, "{start}");
            assert!((end - expected[1]).abs() < 1e-15, "{end}");
        }
        // NaN between 2 and 3, then locked up to the end.
        let jams = |x: f64| {
            if (2.0..3.0).contains(&x) {
                f64::NAN
            } else {
                1.5 - x
            }
        };
        let found = self_locking(jams, [0.0, 4.0], 8);
        let starts: Vec<[f64; 2]> = found.iter().map(|range| [range.start, range.end]).collect();
        assert_eq!(starts, [[1.5, 1.5], [3.0, 4.0]]);
        assert!(self_locking(|_| 0.3, [0.0, 1.0], 4).is_empty());
    }
}
