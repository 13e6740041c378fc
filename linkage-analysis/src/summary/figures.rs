//! The figures of a curve that are computed from its stretches.

use core::fmt;

use super::band::within;
use super::crossings::{Crossing, crossings};
use super::curve::Curve;
use super::dwell::{Dwell, dwells, longest_dwell};
use super::events::{CurveEvent, events};
use super::interval::Interval;
use super::print::{describe, describe_dwells};
use super::ratio::{TimeRatio, time_ratio};
use super::transmission::{Transmission, transmission_angle};
use alloc::vec::Vec;

impl<const N: usize, F: Fn(f64) -> [f64; N]> Curve<N, F> {
    /// The intervals in which the quantity changes by no more than `band`, each as long as it can
    /// be made by moving it to and fro; in order of the input. Of those that overlap, only the
    /// longest is there.
    ///
    /// Such an interval has a limit of the quantity, or an end of the curve, as the highest or the
    /// lowest of its values. Or it passes through the whole band with the same speed at both its
    /// ends, as around an inflection or a short way back (a pilgrim step): for these the second
    /// derivative is needed (`N` of 3 or more). The ends are roots of the quantity less the band's
    /// bounds.
    ///
    /// So [`longest_dwell`](Self::longest_dwell) is the longest interval of the input in which the
    /// quantity stays within `band`. Without a positive band there are no dwells.
    ///
    /// ```
    /// use linkage_analysis::summary::Curve;
    ///
    /// // 1 - cos 10 deg beside each limit of a cosine.
    /// let jet = |x: f64| [x.cos(), -x.sin(), -x.cos()];
    /// let curve = Curve::new((0.0, std::f64::consts::TAU), 360, jet)?;
    /// let dwells = curve.dwells(1.0 - 10f64.to_radians().cos());
    /// let degrees = |x: f64| x.to_degrees().round();
    /// let ends = dwells.iter().map(|dwell| [dwell.interval.from, dwell.interval.to]);
    /// let places = ends.map(|ends| ends.map(degrees));
    /// assert_eq!(places.collect::<Vec<_>>(), [[170.0, 190.0], [350.0, 10.0]]);
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    #[must_use]
    pub fn dwells(&self, band: f64) -> Vec<Dwell> {
        dwells(self, band)
    }

    /// The longest interval of the input in which the quantity changes by no more than `band`. See
    /// [`dwells`](Self::dwells).
    #[must_use]
    pub fn longest_dwell(&self, band: f64) -> Option<Dwell> {
        longest_dwell(self, band)
    }

    /// The inputs at which the quantity crosses a value, in order: roots of the quantity less that
    /// value, where it goes from one side of it to the other. A touch is no crossing, but one of
    /// the [limits](super::Extremes::limits).
    ///
    /// The example finds all inputs at which a position is reached:
    ///
    /// ```
    /// use linkage_analysis::summary::Curve;
    ///
    /// let lift = |x: f64| [5.0 - 5.0 * x.cos(), 5.0 * x.sin(), 5.0 * x.cos()];
    /// let curve = Curve::new((0.0, std::f64::consts::TAU), 90, lift)?;
    /// let [up, down] = curve.crossings(7.5)[..] else { panic!("once up, once down") };
    /// assert!((up.at.to_degrees() - 120.0).abs() < 1e-13 && up.jet[1] > 0.0);
    /// assert!((down.at.to_degrees() - 240.0).abs() < 1e-13 && down.jet[1] < 0.0);
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    #[must_use]
    pub fn crossings(&self, value: f64) -> Vec<Crossing<N>> {
        crossings(self, value)
    }

    /// The intervals of the input in which the quantity is between `low` and `high`, in order of
    /// the input. In a cycle, one that goes across the seam is a single interval. Their ends are
    /// roots of the quantity less a bound.
    #[must_use]
    pub fn within(&self, low: f64, high: f64) -> Vec<Interval> {
        within(self, low, high)
    }

    /// The marks of a cycle without gaps, in the order in which they follow each other, beginning
    /// anywhere.
    pub(crate) fn events(&self, levels: &[f64]) -> Vec<CurveEvent<N>> {
        events(self, levels)
    }

    /// The input of the forward and of the return stroke. `None` if the range is no cycle or has
    /// gaps, or if the quantity has not exactly one highest and one lowest position in it.
    #[must_use]
    pub fn time_ratio(&self) -> Option<TimeRatio> {
        time_ratio(self)
    }

    /// For an angle between two links, in radians: the least and the greatest transmission angle,
    /// which is the acute one of the angles between their lines, 0 to pi/2.
    ///
    /// It is extreme where the given angle is stationary, at ends of the curve, and where the links
    /// are in line or perpendicular: there it is 0 or pi/2 exactly.
    ///
    /// ```
    /// use linkage_analysis::summary::Curve;
    /// use std::f64::consts::{FRAC_PI_3, TAU};
    ///
    /// let between = |phi: f64| [1.2 + 0.5 * phi.sin(), 0.5 * phi.cos()];
    /// let [least, greatest] = Curve::new((0.0, TAU), 360, between)?.transmission_angle();
    /// assert!((least.angle - 0.7).abs() < 1e-15);
    /// assert_eq!(greatest.angle, std::f64::consts::FRAC_PI_2);
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    #[must_use]
    pub fn transmission_angle(&self) -> [Transmission; 2] {
        transmission_angle(self)
    }

    /// The summary in lines, with six digits: limits, stroke, extreme velocities and accelerations
    /// as far as derivatives were given, time ratio, gaps.
    ///
    /// `unit` is the quantity's unit, `input` the input's (`"mm"`, `"rad"`, or empty). Angles are
    /// printed in degrees, derivatives as they are, in `mm/rad` for example.
    ///
    /// ```
    /// use linkage_analysis::summary::Curve;
    ///
    /// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
    /// let curve = Curve::new((0.0, std::f64::consts::TAU), 360, yoke)?;
    /// assert_eq!(
    ///     curve.describe("mm", "rad").to_string(),
    ///     "lowest          -40 mm at 270 deg\n\
    ///      highest         40 mm at 90 deg\n\
    ///      stroke          80 mm\n\
    ///      least velocity  -40 mm/rad at 180 deg\n\
    ///      most velocity   40 mm/rad at 0 deg\n\
    ///      time ratio      1, rises in 180 deg, falls in 180 deg\n"
    /// );
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    pub fn describe<'a>(&'a self, unit: &'a str, input: &'a str) -> impl fmt::Display + 'a {
        describe(self, unit, input)
    }

    /// The [`dwells`](Self::dwells) in lines, one for each, with the units of
    /// [`describe`](Self::describe).
    ///
    /// ```
    /// use linkage_analysis::summary::Curve;
    ///
    /// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
    /// let curve = Curve::new((0.0, std::f64::consts::TAU), 360, yoke)?;
    /// assert_eq!(
    ///     curve.describe_dwells(20.0, "mm", "rad").to_string(),
    ///     "dwell           120 deg from 30 deg to 150 deg, 20 mm to 40 mm\n\
    ///      dwell           120 deg from 210 deg to 330 deg, -40 mm to -20 mm\n"
    /// );
    /// # Ok::<(), linkage_analysis::summary::SummaryError>(())
    /// ```
    pub fn describe_dwells<'a>(
        &'a self,
        band: f64,
        unit: &'a str,
        input: &'a str,
    ) -> impl fmt::Display + 'a {
        describe_dwells(self, band, unit, input)
    }
}
