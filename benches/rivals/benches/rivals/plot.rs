//! The picture: time to the right, error that is reached upwards, both logarithmic; a line for each method.

use std::fmt::Write;

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 600.0;
/// Left, top, right and bottom of the frame.
const FRAME: [f64; 4] = [92.0, 132.0, 936.0, 490.0];
/// Exponents of the times, in seconds, and of the errors: from a tenth of a millisecond, and from where all methods begin.
const TIMES: [i32; 2] = [-4, 0];
const ERRORS: [i32; 2] = [-8, 6];
/// Errors per power of ten: as many points of a line.
const FINE: i32 = 8;
/// The colours of the picture of run times, and three more.
const COLOURS: [&str; 8] = [
    "#0067a8", "#c85000", "#806000", "#00805f", "#a8488a", "#555555", "#7a4fc4", "#b0203a",
];

/// A method with its time to each error; infinite where it does not come.
pub(crate) struct Line<'a> {
    pub(crate) name: &'a str,
    pub(crate) points: Vec<(f64, f64)>,
}

/// The errors of a line's points, the largest first.
pub(crate) fn errors() -> impl Iterator<Item = f64> {
    let [low, high] = ERRORS.map(|exponent| FINE * exponent);
    (low..=high)
        .rev()
        .map(|part| 10_f64.powf(f64::from(part) / f64::from(FINE)))
}

/// The picture; `about` stands below it.
pub(crate) fn svg(lines: &[Line<'_>], about: &[&str]) -> String {
    let [left, top, right, bottom] = FRAME;
    let mut svg = format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" font-family="system-ui, Helvetica, Arial, sans-serif" font-size="13" fill="#222">
<title>Time to a given error: a path of five points</title>
<rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#fdfdfb" stroke="#bbb"/>
<text x="24" y="32" font-size="18" font-weight="600">Time to a given error: a path of five points</text>
"##
    );
    for exponent in TIMES[0]..=TIMES[1] {
        let at = x(10_f64.powi(exponent));
        grid(&mut svg, [at, top, at, bottom]);
        text(&mut svg, [at, bottom + 18.0], "middle", time_name(exponent));
    }
    for exponent in (ERRORS[0]..=ERRORS[1]).step_by(2) {
        let at = y(10_f64.powi(exponent));
        grid(&mut svg, [left, at, right, at]);
        text(
            &mut svg,
            [left - 8.0, at + 4.5],
            "end",
            &format!("1e{exponent}"),
        );
    }
    for (k, (line, colour)) in lines.iter().zip(COLOURS).enumerate() {
        // Two columns of names.
        let place = [32.0 + 440.0 * (k % 2) as f64, 54.0 + 20.0 * (k / 2) as f64];
        let _ = writeln!(
            svg,
            r#"<path d="M{} {}h24" stroke="{colour}" stroke-width="3"/>"#,
            place[0],
            place[1] - 4.5
        );
        text(&mut svg, [place[0] + 32.0, place[1]], "start", line.name);
        draw(&mut svg, line, colour);
    }
    let errors = "To the right: time. Upwards: how far the sum of squares is above the least one, as a part of it. A line ends where half of the seeds stop.";
    for (k, words) in [errors].iter().chain(about).enumerate() {
        let _ = writeln!(
            svg,
            r##"<text x="24" y="{}" font-size="12" fill="#555">{words}</text>"##,
            532 + 20 * k
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// Straight down where an improvement leaps over several errors.
fn draw(svg: &mut String, line: &Line<'_>, colour: &str) {
    let reached = line.points.iter().filter(|(time, _)| time.is_finite());
    let mut path = String::new();
    let mut last: Option<[f64; 2]> = None;
    for &(time, error) in reached {
        let at = [x(time), y(error)];
        if let Some([_, before]) = last {
            let _ = write!(path, "L{:.1} {before:.1}", at[0]);
        }
        let command = if last.is_none() { "M" } else { "L" };
        let _ = write!(path, "{command}{:.1} {:.1}", at[0], at[1]);
        last = Some(at);
    }
    let Some([end_x, end_y]) = last else { return };
    let _ = writeln!(
        svg,
        r##"<path d="{path}" fill="none" stroke="{colour}" stroke-width="2.5" stroke-linejoin="round"/>
<circle cx="{end_x:.1}" cy="{end_y:.1}" r="5" fill="{colour}" stroke="#fff"/>"##
    );
}

fn x(time: f64) -> f64 {
    let [low, high] = TIMES.map(f64::from);
    let part = ((time.log10() - low) / (high - low)).clamp(0.0, 1.0);
    FRAME[0] + part * (FRAME[2] - FRAME[0])
}

fn y(error: f64) -> f64 {
    let [low, high] = ERRORS.map(f64::from);
    let part = ((error.log10() - low) / (high - low)).clamp(0.0, 1.0);
    FRAME[3] + part * (FRAME[1] - FRAME[3])
}

fn time_name(exponent: i32) -> &'static str {
    ["0.1 ms", "1 ms", "10 ms", "0.1 s", "1 s"][(exponent - TIMES[0]) as usize]
}

fn grid(svg: &mut String, [x1, y1, x2, y2]: [f64; 4]) {
    let _ = writeln!(
        svg,
        r##"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="#e4e4e0"/>"##
    );
}

fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, words: &str) {
    let _ = writeln!(
        svg,
        r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{words}</text>"#
    );
}
