//! Where a quantity passes a value.

use super::course::Course;
use super::stations::{passage, stations};
use alloc::vec::Vec;

/// A place where a quantity passes a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage<const N: usize> {
    /// The input.
    pub at: f64,
    /// The quantity and its derivatives there, as the course's function gives them.
    pub jet: [f64; N],
}

impl<const N: usize, F: Fn(f64) -> [f64; N]> Course<N, F> {
    /// Where the quantity passes a value, in order of the input: roots of the quantity less that value, where it goes
    /// from one side of it to the other. Where it only touches the value it does not pass: that is one of the
    /// [limits](super::Extremes::limits).
    ///
    /// So it tells at which inputs a wanted position is reached, all of them:
    ///
    /// ```
    /// use linkage_runtime::summary::Course;
    ///
    /// let lift = |x: f64| [5.0 - 5.0 * x.cos(), 5.0 * x.sin(), 5.0 * x.cos()];
    /// let course = Course::of((0.0, std::f64::consts::TAU), 90, lift)?;
    /// let [up, down] = course.passages(7.5)[..] else { panic!("once up, once down") };
    /// assert!((up.at.to_degrees() - 120.0).abs() < 1e-13 && up.jet[1] > 0.0);
    /// assert!((down.at.to_degrees() - 240.0).abs() < 1e-13 && down.jet[1] < 0.0);
    /// # Ok::<(), linkage_runtime::summary::SummaryError>(())
    /// ```
    #[must_use]
    pub fn passages(&self, value: f64) -> Vec<Passage<N>> {
        // Over the seam of a cycle over which the quantity advances, it is higher by that.
        let advance = self.source.advance.unwrap_or(0.0);
        let mut found = Vec::new();
        for part in &self.solved {
            for pair in stations(part).windows(2) {
                let [a, b] = [&pair[0].node, &pair[1].node];
                let mut pass = |level: f64, is_here: &dyn Fn(f64) -> bool| {
                    if (a.jet[0] < level) == (b.jet[0] < level) {
                        return;
                    }
                    let node = passage(&self.source, a, b, level);
                    if is_here(node.u) {
                        let node = self.source.in_range(node);
                        let (at, jet) = (node.u, node.jet);
                        found.push(Passage { at, jet });
                    }
                };
                if advance == 0.0 {
                    pass(value, &|_| true);
                } else {
                    pass(value, &|u| u < self.source.high);
                    pass(value + advance, &|u| u >= self.source.high);
                }
            }
        }
        found.sort_by(|a, b| a.at.total_cmp(&b.at));
        found
    }
}
