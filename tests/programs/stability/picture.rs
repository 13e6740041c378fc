//! Panels of error against distance from the dead point, as SVG.

use std::fmt::Write;

/// The curves of one dyad.
pub(crate) struct Panel {
    pub(crate) title: &'static str,
    pub(crate) curves: Vec<Curve>,
}

/// The errors of one method.
pub(crate) struct Curve {
    pub(crate) name: &'static str,
    /// The distance from the dead point as a power of ten, and the largest error there; infinite
    /// where a position that can be assembled is NaN.
    pub(crate) points: Vec<(f64, f64)>,
}

const WIDTH: f64 = 410.0;
const HEIGHT: f64 = 300.0;
/// Where a panel's axes begin and end.
const LEFT: f64 = 56.0;
const RIGHT: f64 = 388.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 248.0;
/// Powers of ten at the ends of the axes.
const DISTANCES: [f64; 2] = [-1.0, -15.0];
const ERRORS: [f64; 2] = [-3.0, 9.0];
const COLOURS: [&str; 4] = ["#0b6e4f", "#c1440e", "#2c5aa0", "#8a4fa0"];

/// The picture: two panels in a row.
pub(crate) fn svg(panels: &[Panel], limit: f64) -> String {
    let rows = panels.len().div_ceil(2) as f64;
    let (width, height) = (2.0 * WIDTH, rows * HEIGHT + 92.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"system-ui, Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#222\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    legend(&mut svg, &panels[0]);
    for (index, panel) in panels.iter().enumerate() {
        let (column, row) = ((index % 2) as f64, (index / 2) as f64);
        let _ = writeln!(
            svg,
            "<g transform=\"translate({} {})\">",
            column * WIDTH,
            row * HEIGHT + 84.0
        );
        axes(&mut svg, panel.title, limit);
        // The first curve on top of the others.
        for (index, curve) in panel.curves.iter().enumerate().rev() {
            let height = TOP - 5.0 - 5.0 * index as f64;
            draw(&mut svg, curve, COLOURS[index], height);
        }
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    svg
}

fn across(distance: f64) -> f64 {
    let [first, last] = DISTANCES;
    LEFT + (distance - first) / (last - first) * (RIGHT - LEFT)
}

/// The height of an error, as a power of ten; what is beyond the axis lies on its end.
fn up(error: f64) -> f64 {
    let [least, most] = ERRORS;
    BOTTOM - (error.clamp(least, most) - least) / (most - least) * (BOTTOM - TOP)
}

fn legend(svg: &mut String, panel: &Panel) {
    let _ = writeln!(
        svg,
        "<text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"600\">Largest error of a position on \
         the way to the dead point</text>"
    );
    let _ = writeln!(
        svg,
        "<text x=\"16\" y=\"43\" fill=\"#555\">in unit roundoffs of the mechanism's size times the \
         condition number; a dot above a panel: NaN although it can be assembled</text>"
    );
    let mut x = 16.0;
    for (curve, colour) in panel.curves.iter().zip(COLOURS) {
        let _ = writeln!(
            svg,
            "<path d=\"M{x} 64h26\" stroke=\"{colour}\" stroke-width=\"2.2\"/>\
             <text x=\"{}\" y=\"68\">{}</text>",
            x + 32.0,
            curve.name
        );
        x += 58.0 + 6.6 * curve.name.len() as f64;
    }
}

fn axes(svg: &mut String, title: &str, limit: f64) {
    let top = up(limit.log10());
    let _ = writeln!(
        svg,
        "<text x=\"{LEFT}\" y=\"24\" font-weight=\"600\">{title}</text>\n\
         <rect x=\"{LEFT}\" y=\"{top:.1}\" width=\"{}\" height=\"{:.1}\" fill=\"#0b6e4f\" \
         fill-opacity=\"0.1\"/>",
        RIGHT - LEFT,
        BOTTOM - top
    );
    for power in (DISTANCES[1] as i32..=DISTANCES[0] as i32).step_by(2) {
        let x = across(f64::from(power));
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {TOP}V{BOTTOM}\" stroke=\"#e6e6e6\"/>{}",
            power_of_ten(power, x, BOTTOM + 17.0, "middle")
        );
    }
    for power in (-2..=ERRORS[1] as i32).step_by(2) {
        let y = up(f64::from(power));
        let _ = writeln!(
            svg,
            "<path d=\"M{LEFT} {y:.1}H{RIGHT}\" stroke=\"#e6e6e6\"/>{}",
            power_of_ten(power, LEFT - 6.0, y + 4.0, "end")
        );
    }
    let _ = writeln!(
        svg,
        "<path d=\"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}\" fill=\"none\" stroke=\"#888\"/>\n\
         <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"#555\">relative distance from the \
         dead point</text>",
        (LEFT + RIGHT) / 2.0,
        BOTTOM + 34.0
    );
}

fn power_of_ten(power: i32, x: f64, y: f64, anchor: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">10<tspan dy=\"-4\" \
         font-size=\"9\">{power}</tspan></text>"
    )
}

/// The line ends at a NaN, which is a dot at the given height, and goes on after it.
fn draw(svg: &mut String, curve: &Curve, colour: &str, height: f64) {
    let mut path = String::new();
    let mut pen = 'M';
    for &(distance, error) in &curve.points {
        let x = across(distance);
        if error.is_finite() {
            let _ = write!(path, "{pen}{x:.1} {:.1}", up(error.log10()));
            pen = 'L';
        } else {
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{height}\" r=\"2.2\" fill=\"{colour}\"/>"
            );
            pen = 'M';
        }
    }
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.2\" \
         stroke-linejoin=\"round\"/>"
    );
}
