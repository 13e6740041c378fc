//! One panel: the curves of a unit with their axes.

use std::vec::Vec;

use super::axes::Axis;
use super::curve::{Band, Curve};
use super::legend::Entry;
use super::missing::{Rows, hatching, pieces};
use super::stroke::{dashed, shade};
use linkage_formats::colour::Colour;
use linkage_formats::svg::{Element, Svg};

/// Left end of panels: the place for numbers and title.
pub(super) const LEFT: f64 = 86.0;
/// Between panels.
pub(super) const SPACE: f64 = 18.0;

/// Curves of one unit.
pub(super) struct Panel<'a> {
    pub(super) abscissa: &'a [f64],
    pub(super) curves: Vec<&'a Curve>,
    pub(super) gaps: Vec<Rows>,
}

/// The area of a panel.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

/// The map from numbers to places in a frame.
struct Places<'a> {
    frame: Frame,
    x: &'a Axis,
    y: &'a Axis,
}

impl Places<'_> {
    fn x(&self, x: f64) -> f64 {
        self.frame.left + self.x.scale.part(x) * (self.frame.right - self.frame.left)
    }

    fn y(&self, y: f64) -> f64 {
        self.frame.bottom - self.y.scale.part(y) * (self.frame.bottom - self.frame.top)
    }
}

impl Panel<'_> {
    pub(super) fn takes(&self, curve: &Curve) -> bool {
        let first = self.curves[0];
        first.section == curve.section && first.quantity.unit == curve.quantity.unit
    }

    /// Returns the entries that the title does not make clear: curves if there are several, and
    /// bands.
    pub(super) fn legend(&self) -> Vec<Entry<'_>> {
        let mut entries = Vec::new();
        let several = self.curves.len() > 1 || !self.curves[0].bands.is_empty();
        for (index, curve) in self.curves.iter().enumerate().filter(|_| several) {
            let name = curve.quantity.name.as_str();
            let bands = curve.bands.iter().map(|band| Some(band.kind));
            let (style, width) = (curve.style(index), curve.width());
            entries.extend([None].into_iter().chain(bands).map(|band| Entry {
                name,
                style,
                width,
                band,
            }));
        }
        entries
    }

    pub(super) fn draw(&self, svg: &mut Svg, frame: Frame, x: &Axis, last: bool) {
        let names: Vec<&str> = self
            .curves
            .iter()
            .map(|c| c.quantity.name.as_str())
            .collect();
        let unit = &self.curves[0].quantity.unit;
        let height = frame.bottom - frame.top;
        let y = Axis::ordinate(&names, unit, self.extremes(), height);
        let places = Places { frame, x, y: &y };
        svg.group(Element::new("g").class("panel"), |svg| {
            self.shade_gaps(svg, &places);
            places.grid(svg, last);
            for (index, curve) in self.curves.iter().enumerate() {
                for band in &curve.bands {
                    self.band(svg, &places, index, curve, band);
                }
            }
            for (index, curve) in self.curves.iter().enumerate() {
                self.curve(svg, &places, index, curve);
            }
        });
    }

    /// All numbers that must be in the panel.
    fn extremes(&self) -> impl Iterator<Item = f64> {
        self.curves.iter().flat_map(|curve| {
            let values = &curve.quantity.values;
            let bands = curve.bands.iter().flat_map(move |band| {
                let pairs = values.iter().zip(&band.half);
                pairs.flat_map(|(x, half)| [x - half, x + half])
            });
            values.iter().copied().chain(bands)
        })
    }

    fn shade_gaps(&self, svg: &mut Svg, places: &Places<'_>) {
        let last_row = self.abscissa.len() - 1;
        let middle = |a: usize, b: usize| 0.5 * (self.abscissa[a] + self.abscissa[b]);
        for &(first, last) in &self.gaps {
            let ends = [
                middle(first.saturating_sub(1), first),
                middle(last, (last + 1).min(last_row)),
            ];
            let [a, b] = ends.map(|end| places.x(end));
            svg.add(
                Element::new("rect")
                    .class("gap")
                    .number("x", a.min(b))
                    .number("y", places.frame.top)
                    .number("width", (b - a).abs())
                    .number("height", places.frame.bottom - places.frame.top)
                    .fill(Colour::Gap),
            );
            let corners = [
                [a.min(b), places.frame.top],
                [a.max(b), places.frame.bottom],
            ];
            svg.add(
                Element::new("path")
                    .class("hatch")
                    .set("d", hatching(corners[0], corners[1]))
                    .set("fill", "none")
                    .stroke(Colour::Frame, 0.6),
            );
        }
    }

    fn curve(&self, svg: &mut Svg, places: &Places<'_>, index: usize, curve: &Curve) {
        let style = curve.style(index);
        let colour = style.colour();
        let quantity = &curve.quantity;
        let at = |row: usize| [places.x(self.abscissa[row]), places.y(quantity.values[row])];
        let group = Element::new("g").class("curve");
        svg.group(group.set("data-name", &quantity.name), |svg| {
            for piece in pieces(&quantity.values) {
                match piece.len() {
                    1 => svg.add(Element::circle(at(piece.start), 1.6).fill(colour)),
                    _ => {
                        let line = Element::polyline(piece.map(at)).stroke(colour, curve.width());
                        svg.add(dashed(line, style));
                    }
                }
            }
        });
    }

    fn band(&self, svg: &mut Svg, places: &Places<'_>, index: usize, curve: &Curve, band: &Band) {
        let values = curve.quantity.values.iter().zip(&band.half);
        let widths: Vec<f64> = values.map(|(x, half)| x + half).collect();
        let edge = |sign: f64| {
            move |row: usize| {
                let y = curve.quantity.values[row] + sign * band.half[row];
                [places.x(self.abscissa[row]), places.y(y)]
            }
        };
        for piece in pieces(&widths) {
            let upper = piece.clone().map(edge(1.0));
            let lower = piece.rev().map(edge(-1.0));
            let polygon = Element::polygon(upper.chain(lower)).class("band");
            svg.add(
                polygon
                    .fill(curve.style(index).colour())
                    .number("fill-opacity", shade(band.kind)),
            );
        }
    }
}

impl Places<'_> {
    /// Grid, frame, numbers and titles; those of the abscissa below the last panel only.
    fn grid(&self, svg: &mut Svg, last: bool) {
        let Frame {
            left,
            right,
            top,
            bottom,
        } = self.frame;
        let number = |at: [f64; 2]| Element::text(at, 12.0).fill(Colour::Ink);
        for &tick in &self.x.scale.ticks {
            let x = self.x(tick);
            svg.add(Element::line([x, top], [x, bottom]).stroke(Colour::Grid, 1.0));
            if last {
                svg.add(Element::line([x, bottom], [x, bottom + 5.0]).stroke(Colour::Frame, 1.0));
                let words = number([x, bottom + 19.0]).anchor("middle").class("tick");
                svg.words(words, &self.x.scale.label(tick));
            }
        }
        for &tick in &self.y.scale.ticks {
            let y = self.y(tick);
            let colour = if tick == 0.0 {
                Colour::Frame
            } else {
                Colour::Grid
            };
            svg.add(Element::line([left, y], [right, y]).stroke(colour, 1.0));
            svg.add(Element::line([left - 5.0, y], [left, y]).stroke(Colour::Frame, 1.0));
            let words = number([left - 9.0, y + 4.0]).anchor("end").class("tick");
            svg.words(words, &self.y.scale.label(tick));
        }
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let frame = Element::polygon(corners).set("fill", "none");
        svg.add(frame.stroke(Colour::Frame, 1.0));

        let title = |at: [f64; 2]| Element::text(at, 13.0).anchor("middle").fill(Colour::Ink);
        let middle = 0.5 * (top + bottom);
        let turned = std::format!("rotate(-90 18 {})", linkage_formats::svg::short(middle));
        let upright = title([18.0, middle]).class("axis").set("transform", turned);
        svg.words(upright, &self.y.title);
        if last {
            let across = title([0.5 * (left + right), bottom + 41.0]).class("axis");
            svg.words(across, &self.x.title);
        }
    }
}
