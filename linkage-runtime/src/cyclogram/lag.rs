//! The lag of one event after another.

use super::{Cyclogram, Moment, Motion};
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

impl Cyclogram {
    /// Turn of the shaft from an event `a` to the next `b`.
    ///
    /// ```
    /// use linkage_runtime::cyclogram::{Band, Cyclogram, Motion, Member};
    /// use linkage_runtime::summary::Curve;
    ///
    /// let member = |name: &str, lead: f64| -> Result<Member, Box<dyn std::error::Error>> {
    ///     let lift = |x: f64| [(x + lead).sin(), (x + lead).cos(), -(x + lead).sin()];
    ///     let curve = Curve::new((0.0, std::f64::consts::TAU), 90, lift)?;
    ///     Ok(Member::new(name, &curve, &[Band::Top(0.5)])?.unit("mm"))
    /// };
    /// let machine = Cyclogram::new([member("hook", 0.0)?, member("eye", 20f64.to_radians())?])?;
    /// let hook = machine.begin("hook", Motion::Dwell(0)).expect("it dwells");
    /// let eye = machine.end("eye", Motion::Dwell(0)).expect("it dwells");
    /// let lag = machine.after(&hook, &eye);
    /// assert!((lag.angle - 100f64.to_radians()).abs() < 1e-14);
    /// assert_eq!(
    ///     lag.to_string(),
    ///     "eye's dwell (top 0.5 mm) ends 100.0000 deg after hook's dwell (top 0.5 mm) begins"
    /// );
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn after<'a>(&self, a: &Moment<'a>, b: &Moment<'a>) -> Lag<'a> {
        let cycle = self.width();
        let angle = (b.event.at - a.event.at) % cycle;
        Lag {
            from: *a,
            to: *b,
            angle: if angle < 0.0 { angle + cycle } else { angle },
        }
    }

    /// The first event of the cycle at which the member of this name begins a motion; `None` if
    /// there is no such member, or it never does that.
    #[must_use]
    pub fn begin(&self, member: &str, motion: Motion) -> Option<Moment<'_>> {
        self.moments()
            .find(|moment| moment.member.name() == member && moment.event.begins == motion)
    }

    /// The same where it ends a motion.
    #[must_use]
    pub fn end(&self, member: &str, motion: Motion) -> Option<Moment<'_>> {
        self.moments()
            .find(|moment| moment.member.name() == member && moment.event.ends == motion)
    }
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
