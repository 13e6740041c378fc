//! A course in lines to be read.

use super::course::Course;
use super::extremes::{Extreme, Extremes};
use super::interval::Interval;
use crate::words::{printed, rounded, settled};
use core::fmt;

/// Roundoff of a position, as a share of the range.
const ROUNDOFF: f64 = 1e-12;

/// A unit that numbers are printed in.
#[derive(Clone, Copy)]
struct Unit<'a>(&'a str);

impl Unit<'_> {
    /// The number with its unit: radians as degrees.
    fn print(self, value: f64) -> impl fmt::Display {
        printed(move |f| match self.0 {
            "rad" => write!(f, "{} deg", rounded(value.to_degrees())),
            "" => write!(f, "{}", rounded(value)),
            unit => write!(f, "{} {unit}", rounded(value)),
        })
    }
}

impl<const N: usize, F: Fn(f64) -> [f64; N]> Course<N, F> {
    /// The summary in lines, with six digits: limits, stroke, extreme velocities and accelerations as far as derivatives were given, time ratio, gaps.
    ///
    /// `unit` is the quantity's unit, `input` the input's (`"mm"`, `"rad"`, or empty). Angles are printed in degrees, derivatives as
    /// they are, in `mm/rad` for example.
    ///
    /// ```
    /// use linkage_runtime::summary::Course;
    ///
    /// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
    /// let course = Course::of((0.0, std::f64::consts::TAU), 360, yoke)?;
    /// assert_eq!(
    ///     course.describe("mm", "rad").to_string(),
    ///     "lowest          -40 mm at 270 deg\n\
    ///      highest         40 mm at 90 deg\n\
    ///      stroke          80 mm\n\
    ///      least velocity  -40 mm/rad at 180 deg\n\
    ///      most velocity   40 mm/rad at 0 deg\n\
    ///      time ratio      1, rises in 180 deg, falls in 180 deg\n"
    /// );
    /// # Ok::<(), linkage_runtime::summary::SummaryError>(())
    /// ```
    pub fn describe<'a>(&'a self, unit: &'a str, input: &'a str) -> impl fmt::Display + 'a {
        printed(move |f| self.print(f, Unit(unit), Unit(input)))
    }

    fn print(&self, f: &mut fmt::Formatter<'_>, unit: Unit<'_>, input: Unit<'_>) -> fmt::Result {
        let position = self.position();
        let (low, high) = self.range();
        let width = high - low;
        for (name, extreme) in [("lowest", position.lowest), ("highest", position.highest)] {
            let at = settled(extreme.at, ROUNDOFF, width);
            let (value, at) = (unit.print(extreme.value), input.print(at));
            writeln!(f, "{name:14}  {value} at {at}")?;
        }
        writeln!(f, "{:14}  {}", "stroke", unit.print(position.stroke()))?;
        let per = |power: &'static str| {
            printed(move |f| match (unit.0, input.0) {
                (_, "") => f.write_str(unit.0),
                ("", input) => write!(f, "1/{input}{power}"),
                (unit, input) => write!(f, "{unit}/{input}{power}"),
            })
        };
        if let Some(velocity) = self.extremes_of(1) {
            extremes(f, "velocity", velocity, &per(""), (input, width))?;
        }
        if let Some(acceleration) = self.extremes_of(2) {
            extremes(f, "accel.", acceleration, &per("^2"), (input, width))?;
        }
        if let Some(time) = self.time_ratio() {
            let (rise, fall) = (input.print(time.rise), input.print(time.fall));
            let ratio = rounded(time.ratio());
            writeln!(
                f,
                "{:14}  {ratio}, rises in {rise}, falls in {fall}",
                "time ratio"
            )?;
        }
        if self.has_gaps() {
            for Interval { from, to, .. } in self.parts() {
                let (from, to) = (input.print(from), input.print(to));
                writeln!(f, "{:14}  {from} to {to}", "only from")?;
            }
        }
        Ok(())
    }
}

/// Least and greatest value of a derivative.
fn extremes(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    extremes: &Extremes,
    unit: &impl fmt::Display,
    (input, range): (Unit<'_>, f64),
) -> fmt::Result {
    for (which, Extreme { at, value, .. }) in
        [("least", extremes.lowest), ("most", extremes.highest)]
    {
        let width = 13 - which.len();
        let at = settled(at, ROUNDOFF, range);
        let (value, at) = (rounded(value), input.print(at));
        writeln!(f, "{which} {name:width$}  {value} {unit} at {at}")?;
    }
    Ok(())
}
