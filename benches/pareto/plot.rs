//! The picture: time to the right, error upwards, both logarithmic.

use crate::labels::{Area, HEIGHT, place};
use crate::methods::Family;
use crate::{Outcome, Panel};
use std::fmt::Write;

const WIDTH: f64 = 960.0;
const BOTTOM: f64 = 700.0;
const FRAME: Area = Area {
    left: 92.0,
    top: 104.0,
    right: 936.0,
    bottom: 596.0,
};
/// Height of the strip below the break, for errors far below the roundoff of `f64`.
const STRIP: f64 = 64.0;
/// Errors below this lie in the strip.
const BREAK: f64 = 1e-3;
/// Width of a character of a label, on average.
const CHARACTER: f64 = 7.0;

/// The picture of a panel.
pub(crate) fn svg(panel: &Panel, about: &str) -> String {
    let about = about.replace('`', "");
    let scales = Scales::new(&panel.outcomes);
    let mut svg = format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {BOTTOM}" width="{WIDTH}" height="{BOTTOM}" font-family="system-ui, Helvetica, Arial, sans-serif" font-size="13" fill="#222">
<title>Run time against error: {title}</title>
<rect width="{WIDTH}" height="{BOTTOM}" rx="8" fill="#fdfdfb" stroke="#bbb"/>
<text x="24" y="32" font-size="18" font-weight="600">Run time against error: {title}</text>
"##,
        title = panel.title.to_lowercase(),
    );
    legend(&mut svg, panel);
    scales.draw(&mut svg, panel.unit);
    points(&mut svg, panel, &scales);
    let _ = write!(
        svg,
        r##"<text x="24" y="662" font-size="12" fill="#555">Crank-rocker with a coupler point. Marker: largest error over all positions and median time; line: down to the median error, quartiles of time.</text>
<text x="24" y="682" font-size="12" fill="#555">{about}</text>
</svg>
"##
    );
    svg
}

/// From numbers to the plane.
struct Scales {
    /// Logarithms of the limits.
    time: [f64; 2],
    error: [f64; 2],
    strip: Option<[f64; 2]>,
}

impl Scales {
    fn new(outcomes: &[Outcome]) -> Self {
        let limits = |numbers: &[f64]| {
            let logs = || numbers.iter().map(|x| x.log10());
            [
                logs().fold(f64::INFINITY, f64::min),
                logs().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        let times: Vec<f64> = outcomes.iter().map(|o| o.times.spread().median).collect();
        let errors = outcomes
            .iter()
            .flat_map(|o| [o.errors.maximum, o.errors.median]);
        let errors = errors.filter(|error| *error > 0.0 && error.is_finite());
        let (main, small): (Vec<f64>, Vec<f64>) = errors.partition(|error| *error >= BREAK);
        let [fast, slow] = limits(&times);
        let whole = |[low, high]: [f64; 2]| [low.floor(), high.ceil()];
        Self {
            time: [fast - 0.1, slow + 0.15],
            error: whole(limits(&main)),
            strip: (!small.is_empty()).then(|| whole(limits(&small))),
        }
    }

    fn x(&self, time: f64) -> f64 {
        let part = (time.log10() - self.time[0]) / (self.time[1] - self.time[0]);
        FRAME.left + part * (FRAME.right - FRAME.left)
    }

    /// What is no number at some position lies at the upper edge.
    fn y(&self, error: f64) -> f64 {
        if !error.is_finite() {
            return FRAME.top;
        }
        let ([low, high], bottom, top) = match self.strip {
            Some(strip) if error < BREAK => (strip, FRAME.bottom - 8.0, FRAME.bottom - STRIP + 8.0),
            Some(_) => (self.error, FRAME.bottom - STRIP - 10.0, FRAME.top),
            None => (self.error, FRAME.bottom, FRAME.top),
        };
        bottom + (error.log10() - low) / (high - low) * (top - bottom)
    }

    fn draw(&self, svg: &mut String, unit: &str) {
        let Area {
            left,
            top,
            right,
            bottom,
        } = FRAME;
        let line = |svg: &mut String, x1: f64, y1: f64, x2: f64, y2: f64, colour: &str| {
            let _ = writeln!(
                svg,
                r#"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="{colour}"/>"#
            );
        };
        for exponent in -1..7 {
            for digit in [1.0, 2.0, 5.0] {
                let time = digit * 10f64.powi(exponent);
                if (self.time[0]..self.time[1]).contains(&time.log10()) {
                    let x = self.x(time);
                    line(svg, x, top, x, bottom, "#e4e4e0");
                    text(svg, x, bottom + 18.0, "middle", &format!("{time}"));
                }
            }
        }
        let strip = self.strip.map(|[low, high]| (low as i32, high as i32, 1));
        let main = (self.error[0] as i32, self.error[1] as i32, 2);
        for (low, high, step) in strip.into_iter().chain([main]) {
            for exponent in (low..=high).filter(|exponent| exponent % step == 0) {
                let y = self.y(10f64.powi(exponent));
                line(svg, left, y, right, y, "#e4e4e0");
                let power = format!(r#"10<tspan dy="-5" font-size="10">{exponent}</tspan>"#);
                text(svg, left - 8.0, y + 4.0, "end", &power);
            }
        }
        line(svg, left, bottom, right, bottom, "#555");
        let cut = if self.strip.is_some() {
            bottom - STRIP
        } else {
            bottom
        };
        line(svg, left, top, left, cut - 8.0, "#555");
        if self.strip.is_some() {
            line(svg, left, cut + 2.0, left, bottom, "#555");
            // Two strokes across the axis, where the scale is broken.
            for y in [cut + 2.0, cut - 8.0] {
                line(svg, left - 5.0, y + 3.0, left + 5.0, y - 3.0, "#555");
            }
        }
        text(
            svg,
            f64::midpoint(left, right),
            bottom + 36.0,
            "middle",
            "time per position, ns",
        );
        let _ = writeln!(
            svg,
            r#"<text transform="translate(28 {:.1}) rotate(-90)" text-anchor="middle">error, in 2<tspan dy="-5" font-size="10">-53</tspan><tspan dy="5"> × {unit}</tspan></text>"#,
            f64::midpoint(top, bottom)
        );
    }
}

fn legend(svg: &mut String, panel: &Panel) {
    let present = |family: &Family| panel.outcomes.iter().any(|o| o.family == *family);
    for (index, family) in Family::ALL.into_iter().filter(present).enumerate() {
        let x = 32.0 + 240.0 * (index % 3) as f64;
        let y = 56.0 + 22.0 * (index / 3) as f64;
        marker(svg, family, x, y);
        text(svg, x + 14.0, y + 4.5, "start", family.title());
    }
}

fn points(svg: &mut String, panel: &Panel, scales: &Scales) {
    let place_of = |outcome: &Outcome| {
        [
            scales.x(outcome.times.spread().median),
            scales.y(outcome.errors.maximum),
        ]
    };
    let points: Vec<([f64; 2], f64)> = panel
        .outcomes
        .iter()
        .map(|outcome| {
            (
                place_of(outcome),
                CHARACTER * outcome.name.len() as f64 + 4.0,
            )
        })
        .collect();
    let inner = Area {
        bottom: FRAME.bottom - 2.0,
        ..FRAME
    };
    let obstacles: Vec<Area> = panel
        .outcomes
        .iter()
        .flat_map(|outcome| lines(outcome, scales))
        .collect();
    let areas = place(&points, &obstacles, &inner);
    for ((point, _), area) in points.iter().zip(&areas) {
        let [x, y] = area.nearest(*point);
        if f64::hypot(x - point[0], y - point[1]) > 16.0 {
            let _ = writeln!(
                svg,
                r##"<line x1="{:.1}" y1="{:.1}" x2="{x:.1}" y2="{y:.1}" stroke="#999" stroke-width="0.8"/>"##,
                point[0], point[1]
            );
        }
    }
    for ((outcome, ([x, y], _)), area) in panel.outcomes.iter().zip(&points).zip(&areas) {
        let (_, colour) = look(outcome.family);
        for Area {
            left,
            top,
            right,
            bottom,
        } in lines(outcome, scales)
        {
            let _ = writeln!(
                svg,
                r##"<path d="M{left:.1} {top:.1}L{right:.1} {bottom:.1}" stroke="{colour}"/>"##
            );
        }
        marker(svg, outcome.family, *x, *y);
        let middle = f64::midpoint(area.left, area.right);
        let name = format!(r#"<tspan fill="{colour}">{}</tspan>"#, outcome.name);
        text(svg, middle, area.bottom - HEIGHT * 0.28, "middle", &name);
    }
}

/// Down to the median error, and the quartiles of time: rectangles of almost no width.
fn lines(outcome: &Outcome, scales: &Scales) -> [Area; 2] {
    let spread = outcome.times.spread();
    let [low, x, high] = [spread.low, spread.median, spread.high]
        .map(|time| scales.x(time).clamp(FRAME.left, FRAME.right));
    let y = scales.y(outcome.errors.maximum);
    let typical = scales.y(outcome.errors.median.max(f64::MIN_POSITIVE));
    [
        Area {
            left: x,
            top: y,
            right: x + 0.1,
            bottom: typical,
        },
        Area {
            left: low,
            top: y,
            right: high,
            bottom: y + 0.1,
        },
    ]
}

/// Shape (a path around the origin) and colour; they differ for those who see no colours, too.
fn look(family: Family) -> (&'static str, &'static str) {
    match family {
        Family::Generated => ("M-6 0A6 6 0 1 0 6 0A6 6 0 1 0 -6 0Z", "#0067a8"),
        Family::Closed => ("M-5 -5H5V5H-5Z", "#333333"),
        Family::Dual => ("M0 -6.5L6 5H-6Z", "#c85000"),
        Family::Textbook => ("M0 -7L6 0L0 7L-6 0Z", "#a8488a"),
        Family::Newton => ("M0 6.5L6 -5H-6Z", "#00805f"),
        Family::Differences => (
            "M-6 -4L-4 -6L0 -2L4 -6L6 -4L2 0L6 4L4 6L0 2L-4 6L-6 4L-2 0Z",
            "#806000",
        ),
    }
}

fn marker(svg: &mut String, family: Family, x: f64, y: f64) {
    let (shape, colour) = look(family);
    let _ = writeln!(
        svg,
        r##"<path transform="translate({x:.1} {y:.1})" d="{shape}" fill="{colour}" stroke="#fff"/>"##
    );
}

fn text(svg: &mut String, x: f64, y: f64, anchor: &str, content: &str) {
    let _ = writeln!(
        svg,
        r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{content}</text>"#
    );
}
