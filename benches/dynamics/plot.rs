//! The picture: a frame for each problem, time to the right, error upwards, both logarithmic.

use crate::comparison::{Method, Panel, Run};
use std::fmt::Write;

const WIDTH: f64 = 960.0;
/// Top and bottom of both frames, left ends, and their width.
const TOP: f64 = 84.0;
const BOTTOM: f64 = 470.0;
const LEFT: [f64; 2] = [72.0, 540.0];
const FRAME: f64 = 396.0;
/// Exponents of times in s and of errors.
const TIMES: [i32; 2] = [-6, 1];
const ERRORS: [i32; 2] = [-14, 0];
const COLUMNS: usize = 3;
const LINE: f64 = 20.0;
const OURS: &str = "#0067a8";
const OTHERS: [&str; 12] = [
    "#c85000", "#806000", "#00805f", "#a8488a", "#555555", "#7a4fc4", "#b0203a", "#4d8b00",
    "#d08a00", "#2f7f9f", "#9a5b3c", "#101010",
];

/// Returns the picture; `about` is the last line.
pub(crate) fn svg(panels: &[Panel; 2], about: &str) -> String {
    let names = names(panels);
    let rows = names.len().div_ceil(COLUMNS);
    let end = BOTTOM + 60.0 + LINE * rows as f64;
    let height = end + 40.0;
    let mut svg = format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" font-family="system-ui, Helvetica, Arial, sans-serif" font-size="13" fill="#222">
<title>Motion under forces: time to a given error</title>
<rect width="{WIDTH}" height="{height}" rx="8" fill="#fdfdfb" stroke="#bbb"/>
<text x="24" y="32" font-size="18" font-weight="600">Motion under forces: time to a given error</text>
"##
    );
    for (panel, left) in panels.iter().zip(LEFT) {
        axes(&mut svg, left);
        text(&mut svg, [left, TOP - 12.0], "start", panel.title);
        for method in &panel.methods {
            draw(&mut svg, left, method, look(&names, method));
        }
    }
    for (index, method) in names.iter().enumerate() {
        let x = 32.0 + 308.0 * (index % COLUMNS) as f64;
        let y = BOTTOM + 62.0 + LINE * (index / COLUMNS) as f64;
        let (colour, width) = look(&names, method);
        let _ = writeln!(
            svg,
            r#"<path d="M{x} {}h24" stroke="{colour}" stroke-width="{width}"{}/>"#,
            y - 4.5,
            dashes(method),
        );
        text(&mut svg, [x + 32.0, y], "start", &method.name);
    }
    let about = about.replace('`', "");
    let _ = writeln!(
        svg,
        r##"<text x="24" y="{}" font-size="12" fill="#555">{about}</text>
</svg>"##,
        end + 20.0
    );
    svg
}

/// Each method once, ours first.
fn names(panels: &[Panel; 2]) -> Vec<&Method> {
    let mut names: Vec<&Method> = Vec::new();
    for method in panels.iter().flat_map(|panel| &panel.methods) {
        if names.iter().all(|known| known.name != method.name) {
            names.push(method);
        }
    }
    names.sort_by_key(|method| !method.is_ours);
    names
}

/// Colour and width of a method's line.
fn look(names: &[&Method], method: &Method) -> (&'static str, f64) {
    if method.is_ours {
        return (OURS, 3.0);
    }
    let others = names.iter().filter(|known| !known.is_ours);
    let index = others.take_while(|known| known.name != method.name).count();
    (OTHERS[index % OTHERS.len()], 1.8)
}

/// Our methods share a colour.
fn dashes(method: &Method) -> &'static str {
    match method.name.as_str() {
        "ours, Conservative" => r#" stroke-dasharray="7 4""#,
        "ours, Problem, implicit" => r#" stroke-dasharray="2 3""#,
        _ => "",
    }
}

fn draw(svg: &mut String, left: f64, method: &Method, (colour, width): (&str, f64)) {
    let least = 10_f64.powi(ERRORS[0]);
    let point = |run: &Run| [x(left, run.seconds), y(run.error.max(least))];
    let inside = |run: &Run| run.error <= 10_f64.powi(ERRORS[1]);
    let points: Vec<[f64; 2]> = method
        .front()
        .iter()
        .filter(|run| inside(run))
        .map(point)
        .collect();
    let mut path = String::new();
    for (index, [x, y]) in points.iter().enumerate() {
        let command = if index == 0 { "M" } else { "L" };
        let _ = write!(path, "{command}{x:.1} {y:.1}");
    }
    let _ = writeln!(
        svg,
        r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"{}/>"#,
        dashes(method)
    );
    for [x, y] in points {
        let _ = writeln!(
            svg,
            r#"<circle cx="{x:.1}" cy="{y:.1}" r="{width}" fill="{colour}"/>"#
        );
    }
}

fn axes(svg: &mut String, left: f64) {
    for exponent in TIMES[0]..=TIMES[1] {
        let at = x(left, 10_f64.powi(exponent));
        grid(svg, [at, TOP, at, BOTTOM]);
        text(svg, [at, BOTTOM + 18.0], "middle", time_name(exponent));
    }
    for exponent in (ERRORS[0]..=ERRORS[1]).step_by(2) {
        let at = y(10_f64.powi(exponent));
        grid(svg, [left, at, left + FRAME, at]);
        text(svg, [left - 8.0, at + 4.5], "end", &format!("1e{exponent}"));
    }
}

fn x(left: f64, seconds: f64) -> f64 {
    let [low, high] = TIMES.map(f64::from);
    let part = (seconds.log10() - low) / (high - low);
    left + FRAME * part.clamp(0.0, 1.0)
}

fn y(error: f64) -> f64 {
    let [low, high] = ERRORS.map(f64::from);
    let part = (error.log10() - low) / (high - low);
    BOTTOM + (TOP - BOTTOM) * part.clamp(0.0, 1.0)
}

fn time_name(exponent: i32) -> &'static str {
    [
        "1 µs", "10 µs", "0.1 ms", "1 ms", "10 ms", "0.1 s", "1 s", "10 s",
    ][(exponent - TIMES[0]) as usize]
}

fn grid(svg: &mut String, [x1, y1, x2, y2]: [f64; 4]) {
    let _ = writeln!(
        svg,
        r##"<line x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}" stroke="#e4e4e0"/>"##
    );
}

fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, content: &str) {
    let _ = writeln!(
        svg,
        r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{content}</text>"#
    );
}
