//! The drawing in the docs of a mechanism: its picture at the reference inputs, as SVG.
//!
//! It has the colour of the text around it, and so fits light and dark pages. Points have their
//! names, links show theirs under the pointer. Wheels are not drawn, because their radii follow
//! from the motion.

use std::fmt::Write;

use linkage_compiler::ir::{Guide, GuideOn, GuideShape, Picture, PointKind};

/// The largest size in pixels, with the margin for pivots and names.
const SIZE: [f64; 2] = [400.0, 260.0];
const MARGIN: f64 = 34.0;

/// The longest drawing in bytes: a machine of a hundred links has none.
const LONGEST: usize = 8_000;

/// The background of the page for rustdoc, which shows through pins.
const BACKGROUND: &str = "var(--main-background-color,#fff)";

/// Half the length of a rail and half its gauge, in pixels.
const RAIL: [f64; 2] = [32.0, 6.0];
/// Half the length and half the width of a block.
const BLOCK: [f64; 2] = [10.0, 5.0];
/// The share of a cylinder's barrel between its pins.
const BARREL: f64 = 0.6;

/// A unit vector that is shorter on the paper points at the reader.
const SHORTEST: f64 = 0.1;

/// The width of a letter and the height of a line of names.
const LETTER: [f64; 2] = [6.5, 12.0];

/// Returns the drawing as a line of HTML, with `title` for those who do not see it; `None` if it is
/// too long, or if there is nothing to see.
pub(super) fn html(picture: &Picture, title: &str) -> Option<String> {
    let sheet = Sheet::new(picture)?;
    let [width, height] = sheet.size;
    let mut svg = format!(
        "<div><svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" \
         viewBox=\"0 0 {} {}\" width=\"{}\" style=\"max-width:100%\" fill=\"none\" \
         stroke=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\">",
        escaped(title),
        number(width),
        number(height),
        number(width),
    );
    for guide in &picture.guides {
        svg.push_str(&self::guide(&sheet, guide));
    }
    for link in &picture.links {
        let places = link.points.iter().map(|&point| sheet.points[point]);
        svg.push_str(&self::link(&link.name, &hull(places.collect())));
    }
    for (point, &position) in picture.points.iter().zip(&sheet.points) {
        svg.push_str(&self::point(point.kind, position));
    }
    svg.push_str(&names(picture, &sheet));
    svg.push_str("</svg></div>");
    (svg.len() <= LONGEST).then_some(svg)
}

/// Places and directions on the paper, in pixels from its upper left corner.
struct Sheet {
    points: Vec<[f64; 2]>,
    directions: Vec<[f64; 2]>,
    size: [f64; 2],
}

impl Sheet {
    /// `None` if a point is nowhere, or if all are in one place.
    fn new(picture: &Picture) -> Option<Self> {
        let flat: Vec<[f64; 2]> = picture
            .reference
            .iter()
            .map(|position| projected(position))
            .collect();
        if flat.is_empty() || !flat.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        let (points, directions) = flat.split_at(picture.points.len());
        let drawn = picture.points.iter().zip(points);
        let drawn = drawn.filter(|(point, _)| point.kind != PointKind::Construction);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (_, position) in drawn {
            for axis in 0..2 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let scales = [0, 1].map(|axis| (SIZE[axis] - 2.0 * MARGIN) / (high[axis] - low[axis]));
        let scale = scales[0].min(scales[1]);
        if !(scale > 0.0 && scale.is_finite()) {
            return None;
        }
        let on_paper =
            |position: &[f64; 2]| [0, 1].map(|axis| MARGIN + scale * (position[axis] - low[axis]));
        Some(Self {
            points: points.iter().map(on_paper).collect(),
            directions: directions.to_vec(),
            size: [0, 1].map(|axis| 2.0 * MARGIN + scale * (high[axis] - low[axis])),
        })
    }
}

/// A vector on the paper, whose second axis points down. Space is seen from above, between two of
/// its axes, as in reports.
fn projected(vector: &[f64]) -> [f64; 2] {
    match *vector {
        [x, y, z] => {
            let (sa, ca) = (-60f64).to_radians().sin_cos();
            let (se, ce) = 25f64.to_radians().sin_cos();
            [-sa * x + ca * y, se * (ca * x + sa * y) - ce * z]
        }
        [x, y] => [x, -y],
        _ => [f64::NAN; 2],
    }
}

/// The corners of the smallest convex outline, in order: both ends of points on a line.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut corners = half_hull(points.iter().copied());
    corners.extend(half_hull(points.iter().rev().copied()));
    corners
}

/// The corners on one side of sorted points, without the last one.
fn half_hull(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for position in points {
        while let [.., a, b] = corners[..] {
            let turn = (b[0] - a[0]) * (position[1] - b[1]) - (b[1] - a[1]) * (position[0] - b[0]);
            // A corner is at least a pixel off the line between its neighbours.
            if turn > (position[0] - a[0]).hypot(position[1] - a[1]) {
                break;
            }
            corners.pop();
        }
        corners.push(position);
    }
    corners.pop();
    corners
}

fn link(name: &str, corners: &[[f64; 2]]) -> String {
    let plate = match corners.len() {
        0..=2 => "\" stroke-width=\"4\"",
        _ => "Z\" stroke-width=\"2\" fill=\"currentColor\" fill-opacity=\".15\"",
    };
    let name = escaped(name);
    format!(
        "<path d=\"{}{plate}><title>{name}</title></path>",
        polyline(corners)
    )
}

/// Rails with a block on them, a slotted lever, or a cylinder.
fn guide(sheet: &Sheet, guide: &Guide) -> String {
    let [origin, position] = [guide.origin, guide.slider].map(|point| sheet.points[point]);
    let [x, y] = sheet.directions[guide.direction];
    let length = x.hypot(y);
    // Seen along its line.
    if length < SHORTEST || length.is_nan() {
        return String::new();
    }
    let along = [x / length, y / length];
    let corner = |way: f64, side: f64| {
        [
            position[0] + way * along[0] - side * along[1],
            position[1] + way * along[1] + side * along[0],
        ]
    };
    let name = escaped(&guide.name);
    let mut svg = format!("<g stroke-width=\"1.5\"><title>{name}</title>");
    let mut draw = |points: &[[f64; 2]], more: &str| {
        // Writing into a string does not fail.
        let _ = write!(svg, "<path d=\"{}{more}/>", polyline(points));
    };
    let [half, gauge] = RAIL;
    let [long, wide] = BLOCK;
    if guide.shape == GuideShape::Cylinder {
        let end = [0, 1].map(|axis| origin[axis] + BARREL * (position[axis] - origin[axis]));
        draw(
            &[origin, end],
            "\" stroke-width=\"11\" stroke-opacity=\".4\" stroke-linecap=\"butt\"",
        );
        draw(&[origin, position], "\" stroke-width=\"3\"");
    } else {
        if guide.on == GuideOn::Itself {
            draw(
                &[origin, corner(half, 0.0), corner(-half, 0.0)],
                "\" stroke-width=\"3\"",
            );
        } else {
            for side in [gauge, -gauge] {
                draw(&[corner(-half, side), corner(half, side)], "\"");
            }
        }
        let corners = [(-long, -wide), (long, -wide), (long, wide), (-long, wide)];
        let block = corners.map(|(way, side)| corner(way, side));
        draw(&block, &format!("Z\" fill=\"{BACKGROUND}\""));
    }
    svg.push_str("</g>");
    svg
}

/// A pin, on a pivot if it belongs to the frame; a dot for a point of one link.
fn point(kind: PointKind, [x, y]: [f64; 2]) -> String {
    let [x, y] = [x, y].map(number);
    let pin = format!(
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\" stroke-width=\"1.5\" fill=\"{BACKGROUND}\"/>"
    );
    match kind {
        PointKind::Ground => {
            format!("<path d=\"M{x} {y}l-8 14h16zm-13 14h26\" stroke-width=\"1.5\"/>{pin}")
        }
        PointKind::Joint => pin,
        PointKind::Tip | PointKind::Loose => {
            format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"2.5\" fill=\"currentColor\"/>")
        }
        PointKind::Construction => String::new(),
    }
}

/// The names of points that have one in the program, as far as they do not lie on each other.
fn names(picture: &Picture, sheet: &Sheet) -> String {
    let [letter, line] = LETTER;
    // A border of the background keeps them legible across links.
    let mut svg = format!(
        "<g font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\" stroke=\"{BACKGROUND}\" \
         stroke-width=\"3\" paint-order=\"stroke\">"
    );
    let mut taken: Vec<[f64; 3]> = Vec::new();
    for (point, &[x, y]) in picture.points.iter().zip(&sheet.points) {
        // Points without a name are called after the links that meet there.
        let is_name = !point.name.contains(['/', ' ']);
        if point.kind == PointKind::Construction || !is_name {
            continue;
        }
        let width = letter * point.name.chars().count() as f64;
        let left = (x + 7.0).min(sheet.size[0] - width);
        let base = y - 7.0;
        let is_free = taken.iter().all(|&[from, to, other]| {
            left > to || left + width < from || (base - other).abs() > line
        });
        if is_free {
            taken.push([left, left + width, base]);
            let [left, base] = [left, base].map(number);
            let name = escaped(&point.name);
            let _ = write!(svg, "<text x=\"{left}\" y=\"{base}\">{name}</text>");
        }
    }
    svg.push_str("</g>");
    svg
}

fn polyline(points: &[[f64; 2]]) -> String {
    let corners = points.iter().map(|position| position.map(number).join(" "));
    format!("M{}", corners.collect::<Vec<_>>().join("L"))
}

/// A tenth of a pixel.
fn number(x: f64) -> String {
    let text = format!("{x:.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
