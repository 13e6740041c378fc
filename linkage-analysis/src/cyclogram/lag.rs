//! The lag of one event after another.

use super::Moment;
use alloc::vec::Vec;
use core::fmt;

#[cfg(feature = "tolerance")]
use super::CyclogramError;
#[cfg(feature = "tolerance")]
use crate::tolerance::{Effects, Tolerances};

/// The lag of one event of a machine after another, of the same member or of two. Printed, it is a
/// sentence.
#[derive(Clone, Copy, Debug)]
pub struct Lag<'a> {
    /// The event that is counted from.
    pub from: Moment<'a>,
    /// The one that comes after it.
    pub to: Moment<'a>,
    /// Turn of the shaft between the two, in radians: from 0 to less than a cycle.
    pub angle: f64,
}

impl Lag<'_> {
    /// The derivatives of its angle with respect to the parameters: those of the later event less
    /// those of the earlier one, so that a common shift has no effect. `None` unless both members
    /// have [sensitivities](super::Member::sensitivities) to the same parameters.
    #[must_use]
    pub fn sensitivity(&self) -> Option<Vec<f64>> {
        let from = self.from.member.sensitivity(self.from.index)?;
        let to = self.to.member.sensitivity(self.to.index)?;
        let both = to.iter().zip(from);
        (from.len() == to.len()).then(|| both.map(|(to, from)| to - from).collect())
    }

    /// The effect of each tolerance on its angle. Both events have the same parts, so that the
    /// effect is no more than the sum of the two. The worst case is `worst_case()`.
    ///
    /// # Errors
    ///
    /// `Parameters` of a member without sensitivities, or with those by another number of
    /// parameters.
    #[cfg(feature = "tolerance")]
    pub fn effects<const P: usize>(
        &self,
        tolerances: &Tolerances<P>,
    ) -> Result<Effects<P, 1>, CyclogramError> {
        let effects = |moment: &Moment<'_>| moment.member.effects(moment.index, tolerances);
        Ok(effects(&self.to)?.relative_to(&effects(&self.from)?))
    }
}

/// A text such as `eye's dwell (top 0.5 mm) begins 12.3000 deg after hook's return begins`.
impl fmt::Display for Lag<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = self.angle.to_degrees();
        write!(f, "{} {degrees:.4} deg after {}", self.to, self.from)
    }
}
