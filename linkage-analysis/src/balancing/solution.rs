//! The results of balancing.

use core::fmt;

use linkage_core::format::rounded;
use linkage_core::math::double::sqrt;

/// The size of a quantity over the cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Figures {
    /// The root of its mean square length.
    pub rms: f64,
    /// Its largest length.
    pub peak: f64,
}

impl Figures {
    pub(super) fn divided_by(self, length: f64) -> Self {
        Self {
            rms: self.rms / length,
            peak: self.peak / length,
        }
    }

    /// Those of two quantities together.
    pub(super) fn and(self, other: Self) -> Self {
        let (large, small) = (self.rms.max(other.rms), self.rms.min(other.rms));
        let ratio = if large == 0.0 { 0.0 } else { small / large };
        Self {
            rms: large * sqrt(1.0 + ratio * ratio),
            peak: self.peak.max(other.peak),
        }
    }
}

/// Masses that balance, and the remaining forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const N: usize> {
    /// The masses, in units of those that the effects were given for.
    pub values: [f64; N],
    /// Without them.
    pub before: Figures,
    /// With them.
    pub after: Figures,
    /// The lower bound of the minimised figure for any masses: by [`peak`](super::Balance::peak)
    /// the peak, proven independently of the search; by
    /// [`mean_square`](super::Balance::mean_square) the root mean square, which is that of `after`.
    pub bound: f64,
}

/// One line: root mean square and peak, before and after.
impl<const N: usize> fmt::Display for Solution<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (before, after) = (self.before, self.after);
        let [rms, peak] = [(before.rms, after.rms), (before.peak, after.peak)]
            .map(|(from, to)| (rounded(from), rounded(to)));
        let ((rms_before, rms_after), (peak_before, peak_after)) = (rms, peak);
        write!(
            f,
            "rms {rms_before} to {rms_after}, peak {peak_before} to {peak_after}"
        )
    }
}
