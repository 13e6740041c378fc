//! The summary of a report: figures of the cycle.

use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

use super::SummaryRow;
use super::builder::Report;
use super::figures::Figures;
use linkage_analysis::summary::{Curve, Dwell, Minimum};
use linkage_formats::units::per_second;

const NAMES: [[&str; 2]; 3] = [
    ["lowest", "highest"],
    ["least velocity", "greatest velocity"],
    ["least acceleration", "greatest acceleration"],
];

impl Report {
    /// Figures of the cycle.
    #[must_use]
    pub fn summary(mut self, rows: impl IntoIterator<Item = SummaryRow>) -> Self {
        self.summary.extend(rows);
        self
    }

    /// Limits, stroke, extreme velocities and accelerations and the time ratio of a quantity, from
    /// its [`Curve`] over the range. `unit` is the unit of the quantity. With a
    /// [`speed`](Self::speed), also the true velocities and, for a constant speed, accelerations.
    /// Extreme derivatives at the border of a gap are left out.
    #[must_use]
    pub fn course<const N: usize, F: Fn(f64) -> [f64; N]>(
        mut self,
        quantity: impl Into<String>,
        unit: impl Into<String>,
        course: &Curve<N, F>,
    ) -> Self {
        let figures = Figures::new(quantity.into(), unit.into(), course);
        self.figures.push(figures);
        self
    }

    /// The extreme transmission angles, from the course of the angle between two links.
    #[must_use]
    pub fn transmission<const N: usize, F: Fn(f64) -> [f64; N]>(
        self,
        angle: impl Into<String>,
        course: &Curve<N, F>,
    ) -> Self {
        let angle = angle.into();
        let [least, greatest] = course.transmission_angle();
        let row = |what: &str, angle: &str, found: linkage_analysis::summary::Transmission| {
            SummaryRow::new(angle, what, found.angle, "rad").at_input(found.at)
        };
        let rows = [
            row("smallest transmission angle", &angle, least),
            row("greatest transmission angle", &angle, greatest),
        ];
        self.summary(rows)
    }

    /// A dwell of a quantity: where it begins and ends, how long it lasts, and how much the
    /// quantity moves to and fro.
    #[must_use]
    pub fn dwell(
        self,
        quantity: impl Into<String>,
        unit: impl Into<String>,
        dwell: &Dwell,
    ) -> Self {
        let (quantity, unit, input) = (quantity.into(), unit.into(), self.input.unit);
        let interval = dwell.interval;
        let row = |what: &str, value: f64, unit: &str| {
            SummaryRow::new(quantity.as_str(), what, value, unit)
        };
        let rows = [
            row("dwell, from", interval.from, input).at_input(interval.from),
            row("dwell, to", interval.to, input).at_input(interval.to),
            row("dwell, range", interval.range, input),
            row("dwell, band", dwell.highest - dwell.lowest, &unit),
            row("dwell, ripple", dwell.ripple, &unit),
        ];
        self.summary(rows)
    }

    /// The smallest margin over the range.
    #[must_use]
    pub fn margin(self, least: &Minimum) -> Self {
        self.summary([SummaryRow::new("margin", "smallest", least.value, "").at_input(least.at)])
    }
}

/// All figures: those of courses, then the others.
pub(super) fn summary_rows(report: &Report) -> Vec<SummaryRow> {
    let of_courses = report
        .figures
        .iter()
        .flat_map(|figure| course_rows(report, figure));
    of_courses.chain(report.summary.iter().cloned()).collect()
}

fn course_rows(report: &Report, figures: &Figures) -> Vec<SummaryRow> {
    let mut rows = Vec::new();
    for (order, extremes) in (0_u32..).zip(&figures.extremes) {
        let [least, greatest] = NAMES[order as usize];
        let mut pair = |what: String, factor: f64, unit: &str| {
            // A negative speed exchanges the least and the greatest.
            let (low, high) = match factor < 0.0 {
                true => (extremes.highest, extremes.lowest),
                false => (extremes.lowest, extremes.highest),
            };
            for (name, extreme) in [(least, low), (greatest, high)] {
                // Beside a dead point derivatives grow without bounds.
                if order > 0 && figures.is_beside_a_gap(extreme.at) {
                    continue;
                }
                let what = format!("{what}{name}");
                let value = factor * extreme.value;
                rows.push(
                    SummaryRow::new(figures.quantity.as_str(), what, value, unit)
                        .at_input(extreme.at),
                );
            }
        };
        pair(
            String::new(),
            1.0,
            &derivative_unit(report, &figures.unit, order),
        );
        let speed = report
            .speed
            .filter(|speed| order == 1 || speed.epsilon == 0.0);
        if let (Some(speed), true) = (speed, order > 0) {
            let factor = speed.omega.powi(order as i32);
            pair(
                "true ".to_owned(),
                factor,
                &per_second(&figures.unit, order),
            );
        }
        if order == 0 {
            let stroke = extremes.stroke();
            rows.push(SummaryRow::new(
                figures.quantity.as_str(),
                "stroke",
                stroke,
                figures.unit.as_str(),
            ));
        }
    }
    if let Some(time) = figures.time {
        let row = |what: &str, value: f64, unit: &str| {
            SummaryRow::new(figures.quantity.as_str(), what, value, unit)
        };
        rows.push(row("rises in", time.rise, report.input.unit));
        rows.push(row("falls in", time.fall, report.input.unit));
        rows.push(row("time ratio", time.ratio(), ""));
    }
    rows
}

/// The unit of a derivative by the input.
fn derivative_unit(report: &Report, unit: &str, order: u32) -> String {
    let numerator = if unit.is_empty() { "1" } else { unit };
    match (order, report.input.unit) {
        (0, _) => unit.to_owned(),
        (_, "") => unit.to_owned(),
        (1, input) => format!("{numerator}/{input}"),
        (_, input) => format!("{numerator}/{input}^{order}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkage_runtime::Input;

    fn report() -> Report {
        let input = Input {
            name: "phi",
            unit: "rad",
            reference: 0.0,
            range: None,
        };
        Report::new("yoke", &input, &input.positions(3))
    }

    fn yoke(phi: f64) -> [f64; 4] {
        let (sin, cos) = phi.sin_cos();
        [40.0 * sin, 40.0 * cos, -40.0 * sin, -40.0 * cos]
    }

    fn value(rows: &[SummaryRow], what: &str) -> (f64, String, Option<f64>) {
        let row = rows.iter().find(|row| row.what == what).expect(what);
        (row.value, row.unit.clone(), row.at)
    }

    #[test]
    fn courses_become_rows() {
        let course = Curve::new((0.0, core::f64::consts::TAU), 90, yoke).expect("a course");
        let rows = summary_rows(&report().speed(-10.0, 0.0).course("y", "mm", &course));
        let quarter = core::f64::consts::FRAC_PI_2;
        assert_eq!(value(&rows, "stroke"), (80.0, "mm".to_owned(), None));
        let (upper, _, at) = value(&rows, "highest");
        assert!(upper == 40.0 && (at.expect("a place") - quarter).abs() < 1e-14);
        assert_eq!(value(&rows, "greatest velocity").1, "mm/rad");
        // The other way round it is fastest where the derivative is least.
        let (fastest, unit, at) = value(&rows, "true greatest velocity");
        assert_eq!((fastest, unit.as_str()), (400.0, "mm/s"));
        assert!((at.expect("a place") - 2.0 * quarter).abs() < 1e-14);
        let (hardest, unit, at) = value(&rows, "true greatest acceleration");
        assert_eq!((hardest, unit.as_str()), (4000.0, "mm/s^2"));
        assert!((at.expect("a place") - 3.0 * quarter).abs() < 1e-14);
        assert_eq!(value(&rows, "time ratio").0, 1.0);
    }

    #[test]
    fn derivatives_at_the_border_of_a_gap_are_left_out() {
        // Cannot be assembled beyond 2, where it turns back with an infinite slope.
        let reach = |x: f64| {
            [
                -(2.0 - x).sqrt(),
                0.5 / (2.0 - x).sqrt(),
                0.25 / (2.0 - x).powf(1.5),
            ]
        };
        let course = Curve::new((0.0, 3.0), 90, reach).expect("a course");
        let rows = summary_rows(&report().course("y", "mm", &course));
        assert_eq!(value(&rows, "lowest").0, -core::f64::consts::SQRT_2);
        assert!(rows.iter().all(|row| row.what != "greatest velocity"));
    }

    #[test]
    fn accelerations_at_a_changing_speed_are_left_out() {
        let course = Curve::new((0.0, core::f64::consts::TAU), 90, yoke).expect("a course");
        let rows = summary_rows(&report().course("y", "mm", &course).speed(10.0, 1.0));
        assert_eq!(value(&rows, "true greatest velocity").0, 400.0);
        assert!(
            rows.iter()
                .all(|row| row.what != "true greatest acceleration")
        );
    }
}
