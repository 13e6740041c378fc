//! The drawing in the docs of a mechanism: its picture at the reference inputs, as SVG.
//!
//! It has the colour of the text around it, and so fits light and dark pages. Points have their
//! names, links show theirs under the pointer. Wheels are not drawn, because their radii follow
//! from the motion.

mod paper;
mod rails;

use std::fmt::Write;

use paper::{BACKGROUND, Sheet, escaped, number, polyline};
use rails::ArcSlot;

use linkage_compiler::ir::{Guide, GuideOn, GuideShape, Picture, PointKind};

/// The longest drawing in bytes: a machine of a hundred links has none.
const LONGEST: usize = 8_000;

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
    // Plates with slots are below the slots, and these are below the bars with their pins.
    let (slotted, others): (Vec<usize>, Vec<usize>) =
        (0..picture.links.len()).partition(|link| arcs_on(picture, *link).next().is_some());
    let draw = |link: usize| {
        let corners = hull(outline(picture, &sheet, link));
        self::link(&picture.links[link].name, &corners)
    };
    svg.extend(slotted.into_iter().map(draw));
    for guide in &picture.guides {
        svg.push_str(&rails::guide(&sheet, guide));
    }
    svg.extend(others.into_iter().map(draw));
    for (point, &position) in picture.points.iter().zip(&sheet.points) {
        svg.push_str(&self::point(point.kind, position));
    }
    svg.push_str(&names(picture, &sheet));
    svg.push_str("</svg></div>");
    (svg.len() <= LONGEST).then_some(svg)
}

/// The curved slots of a link.
fn arcs_on(picture: &Picture, link: usize) -> impl Iterator<Item = &Guide> + Clone {
    let guides = picture.guides.iter();
    guides.filter(move |guide| guide.shape == GuideShape::Arc && guide.on == GuideOn::Link(link))
}

/// Points around which a link is drawn: its points, and in place of the centres of its curved
/// slots, unless something turns there, the slots.
fn outline(picture: &Picture, sheet: &Sheet, link: usize) -> Vec<[f64; 2]> {
    let arcs = arcs_on(picture, link);
    let is_centre = |point: &usize| {
        let is_drawn = picture.points[*point].kind != PointKind::Construction;
        !is_drawn && arcs.clone().any(|guide| guide.origin == *point)
    };
    let points = picture.links[link].points.iter();
    let points = points.filter(|point| !is_centre(point));
    let points = points.map(|&point| sheet.points[point]);
    let slots = arcs.clone().map(|guide| ArcSlot::new(sheet, guide));
    points
        .chain(slots.flat_map(|slot| slot.middle_line()))
        .collect()
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
