//! Comparison of samples with the linear analysis.

use core::fmt;

use super::statistics::{Estimate, Statistics};
use crate::components::norm;
use crate::tolerance::Effects;
use linkage_core::format::rounded;

/// One number of a study next to the result of the linear analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The value of the mechanism with nominal dimensions.
    pub nominal: f64,
    /// The mean of the samples minus the nominal value, with its 95 % interval: an effect of second
    /// order, 0 in the linear analysis, where every zone is symmetrically about its nominal
    /// value.
    pub shift: Estimate,
    /// The standard deviation of the samples, with its 95 % interval.
    pub sampled: Estimate,
    /// The standard deviation by the linear analysis, for the distributions of the study.
    pub linear: f64,
    /// The largest distance of a sample from the nominal value.
    pub farthest: f64,
    /// The worst case by the linear analysis.
    pub worst_case: f64,
    /// The number of samples that could not be assembled.
    pub missing: usize,
}

impl Agreement {
    /// The numbers of a study next to the linear analysis. `deviations` are those of the parameters
    /// for a tolerance of 1.
    pub(super) fn all<const N: usize, const K: usize>(
        effects: &Effects<N, K>,
        deviations: &[f64; N],
        nominal: [f64; K],
        statistics: impl Fn(usize) -> Statistics,
    ) -> [Self; K] {
        let worst_case = effects.worst_case();
        core::array::from_fn(|k| {
            let statistics = statistics(k);
            let parts: [f64; N] = core::array::from_fn(|i| effects.effects()[i][k] * deviations[i]);
            let from_nominal = |x: f64| x - nominal[k];
            Self {
                nominal: nominal[k],
                shift: Estimate {
                    value: from_nominal(statistics.mean.value),
                    low: from_nominal(statistics.mean.low),
                    high: from_nominal(statistics.mean.high),
                },
                sampled: statistics.deviation,
                linear: norm(&parts),
                farthest: from_nominal(statistics.max).max(-from_nominal(statistics.min)),
                worst_case: worst_case[k],
                missing: statistics.missing,
            }
        })
    }

    /// The standard deviation of the samples over that of the linear analysis.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.sampled.value / self.linear
    }

    /// True if both standard deviations agree within `part` (0.01 for one per cent) beyond the
    /// interval of the samples, and every sample could be assembled.
    #[must_use]
    pub fn within(&self, part: f64) -> bool {
        self.missing == 0
            && self.linear >= self.sampled.low - part * self.linear
            && self.linear <= self.sampled.high + part * self.linear
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "nominal value                 {}", rounded(self.nominal))?;
        writeln!(f, "mean minus nominal            {}", self.shift)?;
        writeln!(f, "standard deviation, sampled   {}", self.sampled)?;
        writeln!(f, "standard deviation, linear    {}", rounded(self.linear))?;
        writeln!(f, "sampled over linear           {}", rounded(self.ratio()))?;
        writeln!(
            f,
            "farthest sample               {}",
            rounded(self.farthest)
        )?;
        writeln!(
            f,
            "worst case, linear            {}",
            rounded(self.worst_case)
        )?;
        writeln!(f, "not assembled                 {}", self.missing)
    }
}
