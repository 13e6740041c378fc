//! Optional marks: dimension lines, positions at equal steps of the input, ellipses of tolerance.

use std::format;
use std::vec::Vec;

use super::geometry::moved;
use super::options::Drawing;
use super::rows;
use super::scatter::{Scatter, ellipse};
use super::sheet::Sheet;
use super::vector::head;
use crate::accuracy;
use linkage_core::format::rounded;
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Distance of a dimension line from its link, and how far its end lines go on.
const APART: f64 = 6.0;
const BEYOND: f64 = 1.2;
/// On paper, shorter links have no room for a dimension.
const LEAST: f64 = 12.0;

/// A bar with a dimension line.
struct Measured {
    name: &'static str,
    ends: [[f64; 2]; 2],
    way: [f64; 2],
    /// On paper.
    length: f64,
    line: [[f64; 2]; 2],
}

/// Bars with room for a dimension line, from left to right, so that words stand upright. In space
/// they would be foreshortened.
fn measured(drawing: &Drawing<'_>, sheet: &Sheet<'_>, row: usize) -> Vec<Measured> {
    let picture = drawing.shown.picture;
    let shown = drawing.dimensions && picture.dimension == 2;
    let bars = picture.links.iter().filter(|_| shown);
    let bars = bars.filter_map(|link| {
        let [from, to] = link.points else { return None };
        let (a, b) = (sheet.point(*from, row)?, sheet.point(*to, row)?);
        let (a, b) = if b[0] < a[0] { (b, a) } else { (a, b) };
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let way = [0, 1].map(|k| (b[k] - a[k]) / length);
        let line = [a, b].map(|at| moved(at, way, 0.0, APART));
        (length >= LEAST).then_some(Measured {
            name: link.name,
            ends: [a, b],
            way,
            length,
            line,
        })
    });
    bars.collect()
}

/// Returns the lines that names should keep away from: dimension lines and vectors.
pub(super) fn marks(drawing: &Drawing<'_>, sheet: &Sheet<'_>, row: usize) -> Vec<[[f64; 2]; 2]> {
    let lines = measured(drawing, sheet, row)
        .into_iter()
        .map(|measured| measured.line);
    let vectors = drawing.vectors.iter().filter_map(|vector| {
        let from = sheet.point(vector.point, row)?;
        Some([from, sheet.beside(vector.point, vector.step(row), row)?])
    });
    lines.chain(vectors).collect()
}

/// Lengths of bars with their names.
pub(super) fn dimension_lines(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    for bar in measured(drawing, sheet, row) {
        let Measured {
            name,
            ends,
            way,
            length,
            line: [start, end],
        } = bar;
        let group = Element::new("g").class("dimension").set("data-name", name);
        svg.group(group, |svg| {
            for at in ends {
                let [near, far] = [1.5, APART + BEYOND].map(|left| moved(at, way, 0.0, left));
                svg.add(Element::line(near, far).stroke(Colour::Muted, 0.2));
            }
            svg.add(Element::line(start, end).stroke(Colour::Muted, 0.2));
            head(svg, start, end, Colour::Muted);
            head(svg, end, start, Colour::Muted);
            let value = rounded(length / sheet.factor);
            let words = format!("{name} = {value} {}", drawing.shown.unit);
            let [x, y] = moved(start, way, 0.5 * length, 0.9);
            let turn = way[1].atan2(way[0]).to_degrees();
            let text = Element::text([x, y], 2.9).anchor("middle");
            let text = text.set("transform", format!("rotate({turn:.3} {x:.3} {y:.3})"));
            let text = text.stroke(Colour::Paper, 0.9).set("paint-order", "stroke");
            svg.words(text.fill(Colour::Muted), &words);
        });
    }
}

/// Points on the paths at equal steps of the input: equal times, if it runs evenly.
pub(super) fn even_points(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>) {
    for &point in &drawing.traces {
        for row in rows::even_rows(drawing, drawing.ticks) {
            if let Some(at) = sheet.point(point, row) {
                let dot = Element::circle(at, 0.75).class("tick").fill(Colour::Paper);
                svg.add(dot.stroke(Colour::Curve(drawing.point_hue(point)), 0.4));
            }
        }
    }
}

/// Ellipses of three standard deviations at traced points, enlarged: at the position that is shown,
/// and at those on the paths.
pub(super) fn ellipses(drawing: &Drawing<'_>, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
    let sensitive = accuracy::sensitive(drawing.report);
    let Some(enlarged) = drawing.enlarged else {
        return;
    };
    for &point in &drawing.traces {
        let name = drawing.shown.picture.points[point].name;
        let Some(scatter) = Scatter::new(point, name, &sensitive) else {
            continue;
        };
        for row in [row]
            .into_iter()
            .chain(rows::even_rows(drawing, drawing.ticks))
        {
            let Some(at) = sheet.point(scatter.point, row) else {
                continue;
            };
            let effects = scatter.effects(row);
            let effects = effects
                .into_iter()
                .map(|effect| sheet.step(effect.map(|x| enlarged * x)));
            let Some([half, other, turn]) = ellipse(effects) else {
                continue;
            };
            let [x, y] = at;
            let shape = Element::new("ellipse").class("tolerance");
            let shape = shape.set("data-name", name);
            let shape = shape
                .number("cx", x)
                .number("cy", y)
                .number("rx", half)
                .number("ry", other);
            let shape = shape.set(
                "transform",
                format!("rotate({:.4} {x:.4} {y:.4})", turn.to_degrees()),
            );
            let shape = shape
                .fill(Colour::Curve(drawing.point_hue(point)))
                .number("fill-opacity", 0.2);
            svg.add(shape.stroke(Colour::Curve(drawing.point_hue(point)), 0.3));
        }
    }
}
