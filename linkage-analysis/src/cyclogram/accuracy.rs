//! Effects of dimensions on the angles at which motions begin and end.

use super::{Cause, Member};
use alloc::vec::Vec;

#[cfg(feature = "tolerance")]
use super::CyclogramError;
#[cfg(feature = "tolerance")]
use crate::tolerance::{Effects, Tolerances};

impl Member {
    /// Adds the sensitivities of all events: the derivatives of their angles by the parameters, in
    /// radians for a unit of the parameter.
    ///
    /// `value` gives those of the quantity, `sensitivity(y)`, `velocity` those of its derivative,
    /// `sensitivity(velocity(y))`; the latter is called only where the member turns back outside
    /// its bands, and needs a curve with a second derivative. With `y'` for derivatives by the
    /// shaft's angle, the implicit function theorem gives:
    ///
    /// | event | derivative of its angle by `p` |
    /// |---|---|
    /// | bound of `Band::Between` | `-(dy/dp) / y'` |
    /// | bound of `Top`, `Bottom` | `-(dy/dp - dy*/dp) / y'`, with the limit `y*` |
    /// | turn | `-(dy'/dp) / y''` |
    ///
    /// The limit `y*` is the one from which the band is measured. Its position may shift, which its
    /// value does not notice.
    #[must_use]
    pub fn sensitivities<const P: usize>(
        mut self,
        value: impl Fn(f64) -> [f64; P],
        velocity: impl Fn(f64) -> [f64; P],
    ) -> Self {
        let references: Vec<[f64; P]> = self
            .references
            .iter()
            .map(|limit| limit.map_or([0.0; P], &value))
            .collect();
        self.sensitivities.clear();
        self.sensitivities.reserve(P * self.events.len());
        for event in &self.events {
            let shift: [f64; P] = match event.cause {
                Cause::Bound { band } => {
                    let here = value(event.at);
                    core::array::from_fn(|p| (references[band][p] - here[p]) / event.slope)
                }
                Cause::Turn => velocity(event.at).map(|rate| -rate / event.bend),
            };
            self.sensitivities.extend(shift);
        }
        self.shifts.clear();
        self
    }

    /// The derivatives of the angle of the event of this index by the parameters, in the order of
    /// the arrays that [`sensitivities`](Self::sensitivities) was given; `None` if it was not
    /// called, or without parameters.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    #[must_use]
    pub fn sensitivity(&self, event: usize) -> Option<&[f64]> {
        assert!(event < self.events.len(), "there is no event {event}");
        let count = self.sensitivities.len() / self.events.len();
        (count > 0).then(|| &self.sensitivities[event * count..][..count])
    }

    /// The shift of the event of this index, in radians, by the tolerances in the worst case, to
    /// first order; `None` unless they were given.
    ///
    /// # Panics
    ///
    /// If tolerances were given, and there is no such event.
    #[must_use]
    pub fn shift(&self, event: usize) -> Option<f64> {
        (!self.shifts.is_empty()).then(|| self.shifts[event])
    }

    /// Adds the effects of tolerances on the events in the worst case, which tables then contain.
    ///
    /// # Errors
    ///
    /// `Parameters` without [`sensitivities`](Self::sensitivities), or if those are by another
    /// number of parameters.
    #[cfg(feature = "tolerance")]
    pub fn tolerances<const P: usize>(
        mut self,
        tolerances: &Tolerances<P>,
    ) -> Result<Self, CyclogramError> {
        let shift = |event| Ok(self.effects(event, tolerances)?.worst_case()[0]);
        self.shifts = (0..self.events.len())
            .map(shift)
            .collect::<Result<_, _>>()?;
        Ok(self)
    }

    /// The effect of each tolerance on the angle of the event of this index.
    ///
    /// # Errors
    ///
    /// As [`tolerances`](Self::tolerances).
    ///
    /// # Panics
    ///
    /// If there is no such event.
    #[cfg(feature = "tolerance")]
    pub fn effects<const P: usize>(
        &self,
        event: usize,
        tolerances: &Tolerances<P>,
    ) -> Result<Effects<P, 1>, CyclogramError> {
        let sensitivities = self.sensitivity(event);
        match sensitivities.and_then(|sensitivities| <[f64; P]>::try_from(sensitivities).ok()) {
            Some(sensitivities) => Ok(tolerances.effects(&sensitivities)),
            None => Err(CyclogramError::Parameters {
                member: self.name.clone(),
                tolerances: P,
                sensitivities: sensitivities.map(<[f64]>::len),
            }),
        }
    }
}
