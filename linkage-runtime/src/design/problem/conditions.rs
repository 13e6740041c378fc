//! Which conditions do not hold, and which are in the way.

use alloc::string::String;
use alloc::vec::Vec;

use super::super::normal::Normal;
use super::Problem;
use crate::Dimensions;

/// A condition that is violated by less than this part of what the bounds' widths do to it holds: the last step met it to second
/// order.
const HOLDS: f64 = 1e-9;

/// One that has less to spare than this part of it is in the way: descents end that near to it.
const ACTIVE: f64 = 1e-6;

impl<M: Dimensions<N> + Copy, A, const N: usize> Problem<'_, M, A, N> {
    /// Whether all conditions hold.
    pub(crate) fn meets(&self, at: &Normal) -> bool {
        self.broken(at).is_empty()
    }

    /// The numbers of the wishes whose conditions do not hold.
    pub(crate) fn broken(&self, at: &Normal) -> Vec<usize> {
        self.conditions(at, |value, size| value < -HOLDS * size)
    }

    /// The titles of the conditions that are met with nothing to spare.
    pub(crate) fn active(&self, at: &Normal) -> Vec<String> {
        let active = self.conditions(at, |value, size| value <= ACTIVE * size);
        active.into_iter().map(|k| self.wishes[k].title()).collect()
    }

    /// The numbers of the wishes with a condition whose value, and what the bounds' widths do to it, are so.
    fn conditions(&self, at: &Normal, so: impl Fn(f64, f64) -> bool) -> Vec<usize> {
        let widths = self.widths();
        let wishes = self.wishes.iter().enumerate();
        let conditions = wishes.filter(|(_, wish)| wish.is_condition());
        let owners = conditions.flat_map(|(k, wish)| (0..wish.rows()).map(move |_| k));
        let is_so = |(_, (value, slopes)): &(usize, &(f64, Vec<f64>))| {
            let size: f64 = slopes.iter().zip(&widths).map(|(s, w)| (s * w).abs()).sum();
            so(*value, size)
        };
        let rows = owners.zip(&at.conditions).filter(is_so);
        let mut found: Vec<usize> = rows.map(|(owner, _)| owner).collect();
        found.dedup();
        found
    }
}
