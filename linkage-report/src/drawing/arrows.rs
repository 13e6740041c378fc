//! Arrows: motions of inputs, vectors at points.

use std::format;
use std::vec::Vec;

use super::geometry::{moved, wrapped};
use super::options::Drawing;
use super::sheet::Sheet;
use super::sizes::BLOCK;
use super::vector::head;
use linkage_core::DriveOn;
use linkage_core::format::rounded;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Radius of the arrow about a driven pivot, and where on its circle it begins and ends, seen from
/// the link.
const RADIUS: f64 = 6.5;
const ARC: [f64; 2] = [0.35, 1.75];
/// Pieces of that arc.
const PIECES: usize = 12;
/// Half the length of the arrow beside a driven slider.
const PUSH: f64 = 5.0;
/// On paper, a vector that is shorter has no direction.
const SHORT: f64 = 0.05;

/// The arc beside a driven link, from where it begins to its head.
fn arc(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    [centre, end]: [usize; 2],
    row: usize,
) -> Option<Vec<[f64; 2]>> {
    let angle = |row: usize| {
        let (a, b) = (sheet.point(centre, row)?, sheet.point(end, row)?);
        Some((a[1] - b[1]).atan2(b[0] - a[0]))
    };
    let at = sheet.point(centre, row)?;
    let start = angle(row)?;
    // To the left, unless the next position says something else.
    let other = if row + 1 < drawing.shown.rows() {
        row + 1
    } else {
        row - row.min(1)
    };
    let turned = angle(other).map_or(0.0, |angle| wrapped(angle - start));
    let turned = if other < row { -turned } else { turned };
    let sense = if turned < 0.0 { -1.0 } else { 1.0 };
    let on_circle = |share: f64| {
        let angle = start + sense * (ARC[0] + share * (ARC[1] - ARC[0]));
        [at[0] + RADIUS * angle.cos(), at[1] - RADIUS * angle.sin()]
    };
    let shares = (0..=PIECES).map(|i| i as f64 / PIECES as f64);
    Some(shares.map(on_circle).collect())
}

/// The ends of the arrow beside a driven slider.
fn push(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    guide: usize,
    row: usize,
) -> Option<Vec<[f64; 2]>> {
    let guide = &drawing.shown.picture.guides[guide];
    let at = sheet.point(guide.slider, row)?;
    let way = sheet.direction(guide.direction, row)?;
    let beside = BLOCK[1] + 2.2;
    let ends = [-PUSH, PUSH].map(|along| moved(at, way, along, beside));
    Some(Vec::from(ends))
}

/// Returns the lines of arrows at driven links, in the sense of growing inputs.
pub(super) fn drive_lines(
    drawing: &Drawing<'_>,
    sheet: &Sheet<'_>,
    row: usize,
) -> Vec<Vec<[f64; 2]>> {
    let drives = drawing.shown.picture.drives.iter();
    let lines = drives.filter_map(|drive| match drive.on {
        DriveOn::Turn(ends) => arc(drawing, sheet, ends, row),
        DriveOn::Slide(guide) => push(drawing, sheet, guide, row),
    });
    lines.collect()
}

pub(super) fn drives(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for line in drive_lines(drawing, sheet, row) {
        svg.group(Element::new("g").class("drive"), |svg| {
            svg.add(Element::polyline(line.iter().copied()).stroke(Colour::Ink, 0.5));
            if let [.., from, to] = line[..] {
                head(svg, from, to, Colour::Ink);
            }
        });
    }
}

/// Quantities as arrows at their points, with their sizes.
pub(super) fn vectors(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for (order, vector) in drawing.vectors.iter().enumerate() {
        let step = vector.step(row);
        let ends = (
            sheet.point(vector.point, row),
            sheet.beside(vector.point, step, row),
        );
        let (Some(from), Some(to)) = ends else {
            continue;
        };
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        if length < SHORT {
            continue;
        }
        let hue = drawing.hues.named(&vector.name);
        let colour = Colour::Curve(hue.unwrap_or(drawing.traces.len() + order));
        let group = Element::new("g")
            .class("vector")
            .set("data-name", &vector.name);
        svg.group(group, |svg| {
            svg.add(Element::line(from, to).stroke(colour, 0.6));
            head(svg, from, to, colour);
            let size = vector
                .value_at(row)
                .iter()
                .map(|x| x * x)
                .sum::<f64>()
                .sqrt();
            let words = format!("{} = {} {}", vector.name, rounded(size), vector.unit);
            let way = [0, 1].map(|k| (to[k] - from[k]) / length);
            let at = [to[0] + 1.6 * way[0], to[1] + 1.6 * way[1] + 1.1];
            let anchor = if way[0] < 0.0 { "end" } else { "start" };
            let text = Element::text(at, 3.0).anchor(anchor).fill(colour);
            let text = text.stroke(Colour::Paper, 0.9).set("paint-order", "stroke");
            svg.words(text, words.trim_end());
        });
    }
}
