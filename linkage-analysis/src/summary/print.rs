//! A curve in lines to be read.

use super::curve::Curve;
use super::extremes::{Extreme, Extremes};
use super::interval::Interval;
use core::fmt;
use linkage_core::format::{printed, rounded, settled};

/// Roundoff of a position, as a share of the range.
const ROUNDOFF: f64 = 1e-12;

/// A unit that numbers are printed in.
#[derive(Clone, Copy)]
struct PrintUnit<'a>(&'a str);

impl PrintUnit<'_> {
    /// The number with its unit: radians as degrees.
    fn print(self, value: f64) -> impl fmt::Display {
        printed(move |f| match self.0 {
            "rad" => write!(f, "{} deg", rounded(value.to_degrees())),
            "" => write!(f, "{}", rounded(value)),
            unit => write!(f, "{} {unit}", rounded(value)),
        })
    }
}

/// The lines of [`Curve::describe`].
pub(super) fn describe<'a, const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &'a Curve<N, F>,
    unit: &'a str,
    input: &'a str,
) -> impl fmt::Display + 'a {
    printed(move |f| print(curve, f, PrintUnit(unit), PrintUnit(input)))
}

/// The lines of [`Curve::describe_dwells`].
pub(super) fn describe_dwells<'a, const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &'a Curve<N, F>,
    band: f64,
    unit: &'a str,
    input: &'a str,
) -> impl fmt::Display + 'a {
    let (unit, input) = (PrintUnit(unit), PrintUnit(input));
    printed(move |f| {
        let (first, last) = curve.range();
        let at = |x: f64| input.print(settled(x, ROUNDOFF, last - first));
        for dwell in curve.dwells(band) {
            let Interval {
                from, to, range, ..
            } = dwell.interval;
            let (from, to, range) = (at(from), at(to), input.print(range));
            let (low, high) = (unit.print(dwell.lowest), unit.print(dwell.highest));
            writeln!(
                f,
                "{:14}  {range} from {from} to {to}, {low} to {high}",
                "dwell"
            )?;
        }
        Ok(())
    })
}

fn print<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    f: &mut fmt::Formatter<'_>,
    unit: PrintUnit<'_>,
    input: PrintUnit<'_>,
) -> fmt::Result {
    let position = curve.position();
    let (low, high) = curve.range();
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
    if let Some(velocity) = curve.extremes_of(1) {
        extremes(f, "velocity", velocity, &per(""), (input, width))?;
    }
    if let Some(acceleration) = curve.extremes_of(2) {
        extremes(f, "accel.", acceleration, &per("^2"), (input, width))?;
    }
    if let Some(time) = curve.time_ratio() {
        let (rise, fall) = (input.print(time.rise), input.print(time.fall));
        let ratio = rounded(time.ratio());
        writeln!(
            f,
            "{:14}  {ratio}, rises in {rise}, falls in {fall}",
            "time ratio"
        )?;
    }
    if curve.has_gaps() {
        for Interval { from, to, .. } in curve.parts() {
            let (from, to) = (input.print(from), input.print(to));
            writeln!(f, "{:14}  {from} to {to}", "only from")?;
        }
    }
    Ok(())
}

/// Least and greatest value of a derivative.
fn extremes(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    extremes: &Extremes,
    unit: &impl fmt::Display,
    (input, range): (PrintUnit<'_>, f64),
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
