//! The largest values of derivatives that count as zero.

use super::source::Node;
use alloc::vec::Vec;

/// Rounding of a derivative, relative to its size.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// For the quantity and each derivative: up to which size it is rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct ZeroThreshold<const N: usize>([f64; N]);

impl<const N: usize> ZeroThreshold<N> {
    /// Determines the thresholds from the positions over a range of this width; at least one must
    /// be finite.
    ///
    /// The size of a derivative is its median, since some positions may be next to a dead point. A
    /// derivative that could not change any of the lower ones over the whole range beyond their
    /// rounding is nothing but rounding.
    pub(super) fn new(nodes: &[Node<N>], width: f64) -> Self {
        let mut threshold = [0.0; N];
        let mut power = 1.0;
        let mut lower: f64 = 0.0;
        for (k, threshold) in threshold.iter_mut().enumerate() {
            let finite = nodes.iter().filter(|node| node.is_finite());
            let mut sizes: Vec<f64> = finite.map(|node| node.jet[k].abs()).collect();
            sizes.sort_by(f64::total_cmp);
            let effect = sizes.last().map_or(0.0, |largest| largest * power);
            *threshold = if k > 0 && effect <= ROUNDING * lower {
                f64::INFINITY
            } else {
                ROUNDING * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
            };
            lower = lower.max(effect);
            power *= width;
        }
        Self(threshold)
    }

    /// The sign of the `k`th derivative: 0 if it is no different from zero.
    pub(super) fn sign(&self, node: &Node<N>, k: usize) -> i8 {
        let value = node.jet[k];
        if value.abs() <= self.0[k] {
            0
        } else if value > 0.0 {
            1
        } else {
            -1
        }
    }

    /// The least ratio of a derivative to its threshold, over all derivatives that are more than
    /// rounding.
    pub(super) fn clearness(&self, node: &Node<N>) -> f64 {
        let levels = self.0.iter().zip(&node.jet).skip(1);
        levels
            .filter(|(threshold, _)| threshold.is_finite())
            .map(|(threshold, value)| match value.abs() {
                0.0 => 0.0,
                size => size / threshold,
            })
            .fold(f64::INFINITY, f64::min)
    }
}
