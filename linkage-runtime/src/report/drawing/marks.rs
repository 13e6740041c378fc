//! What can be asked for beside the mechanism: dimension lines, positions at equal steps of the input, ellipses of tolerance.

use std::format;
use std::vec::Vec;

use super::Drawing;
use super::arrows::head;
use super::geometry::moved;
use super::sheet::Sheet;
use crate::format::rounded;
use crate::report::accuracy::Sensitive;
use crate::report::colour::Colour;
use crate::report::svg::{Element, Svg};

/// Distance of a dimension line from its link, and how far its end lines go on.
const APART: f64 = 6.0;
const BEYOND: f64 = 1.2;
/// On paper, shorter links have no room for a dimension.
const LEAST: f64 = 12.0;
/// Components of points and their quantities.
pub(super) const COMPONENTS: [&str; 3] = ["x", "y", "z"];

/// What tolerances do to a traced point: by component and dimension, its sensitivities times tolerances.
pub(super) struct Scatter<'a> {
    pub(super) point: usize,
    components: Vec<Option<&'a Sensitive<'a>>>,
}

/// A bar with a dimension line.
struct Measured {
    name: &'static str,
    ends: [[f64; 2]; 2],
    way: [f64; 2],
    /// On paper.
    length: f64,
    line: [[f64; 2]; 2],
}

impl<'a> Scatter<'a> {
    /// `None` if no component of the point has sensitivities.
    pub(super) fn of(point: usize, name: &str, sensitive: &'a [Sensitive<'a>]) -> Option<Self> {
        let component = |axis: &&str| {
            let name = format!("{name}.{axis}");
            sensitive.iter().find(|own| own.name == name)
        };
        let components: Vec<_> = COMPONENTS.iter().map(component).collect();
        let is_known = components.iter().any(Option::is_some);
        is_known.then_some(Self { point, components })
    }

    /// What each dimension does, as a vector.
    fn effects(&self, row: usize) -> Vec<[f64; 3]> {
        let mut all: Vec<(&str, [f64; 3])> = Vec::new();
        for (axis, own) in self.components.iter().enumerate() {
            for (name, effect) in own.iter().flat_map(|own| own.at(row)) {
                match all.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, effects)) => effects[axis] = effect,
                    None => {
                        let mut effects = [0.0; 3];
                        effects[axis] = effect;
                        all.push((name, effects));
                    }
                }
            }
        }
        all.into_iter().map(|(_, effects)| effects).collect()
    }
}

impl Drawing<'_> {
    /// Bars with room for a dimension line, from left to right, so that words stand upright. In space they would be foreshortened.
    fn measured(&self, sheet: &Sheet<'_>, row: usize) -> Vec<Measured> {
        let picture = self.shown.picture;
        let shown = self.dimensions && picture.dimension == 2;
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

    /// What names should keep away from: dimension lines and vectors.
    pub(super) fn marks(&self, sheet: &Sheet<'_>, row: usize) -> Vec<[[f64; 2]; 2]> {
        let lines = self.measured(sheet, row).into_iter().map(|own| own.line);
        let vectors = self.vectors.iter().filter_map(|vector| {
            let from = sheet.point(vector.point, row)?;
            Some([from, sheet.beside(vector.point, vector.step(row), row)?])
        });
        lines.chain(vectors).collect()
    }

    /// Lengths of bars with their names.
    pub(super) fn dimension_lines(&self, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
        for own in self.measured(sheet, row) {
            let Measured {
                name,
                ends,
                way,
                length,
                line: [start, end],
            } = own;
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
                let words = format!("{name} = {value} {}", self.shown.unit);
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
    pub(super) fn even_points(&self, svg: &mut Svg, sheet: &Sheet<'_>) {
        for &point in &self.traces {
            for row in self.even_rows(self.ticks) {
                if let Some(at) = sheet.point(point, row) {
                    let dot = Element::circle(at, 0.75).class("tick").fill(Colour::Paper);
                    svg.add(dot.stroke(Colour::Curve(self.hue(point)), 0.4));
                }
            }
        }
    }

    /// Ellipses of three standard deviations at traced points, enlarged: at the position that is shown, and at those on the paths.
    pub(super) fn ellipses(&self, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
        let sensitive = self.report.sensitive();
        let Some(enlarged) = self.enlarged else {
            return;
        };
        for &point in &self.traces {
            let name = self.shown.picture.points[point].name;
            let Some(scatter) = Scatter::of(point, name, &sensitive) else {
                continue;
            };
            for row in [row].into_iter().chain(self.even_rows(self.ticks)) {
                let Some(at) = sheet.point(scatter.point, row) else {
                    continue;
                };
                let effects = scatter.effects(row);
                let effects = effects
                    .into_iter()
                    .map(|own| sheet.step(own.map(|x| enlarged * x)));
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
                    .fill(Colour::Curve(self.hue(point)))
                    .number("fill-opacity", 0.2);
                svg.add(shape.stroke(Colour::Curve(self.hue(point)), 0.3));
            }
        }
    }
}

/// Half axes of the ellipse of independent errors, the larger first, and the angle of that one on paper.
fn ellipse(effects: impl Iterator<Item = [f64; 2]>) -> Option<[f64; 3]> {
    let [xx, xy, yy] = effects.fold([0.0; 3], |[xx, xy, yy], [x, y]| {
        [xx + x * x, xy + x * y, yy + y * y]
    });
    let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    let axes = [(mean + half).sqrt(), (mean - half).max(0.0).sqrt()];
    let turn = 0.5 * (2.0 * xy).atan2(xx - yy);
    mean.is_finite().then_some([axes[0], axes[1], turn])
}

#[cfg(test)]
mod tests {
    use super::ellipse;

    #[test]
    fn ellipses_are_those_of_their_errors() {
        // One error alone is a stretch along itself.
        let [long, short, turn] = ellipse([[3.0, 4.0]].into_iter()).unwrap();
        assert!((long - 5.0).abs() < 1e-12 && short < 1e-6);
        assert!((turn - 4f64.atan2(3.0)).abs() < 1e-12);
        // Two across each other are its half axes, however they are turned.
        let (s, c) = 0.7f64.sin_cos();
        let [long, short, turn] =
            ellipse([[2.0 * c, 2.0 * s], [-0.5 * s, 0.5 * c]].into_iter()).unwrap();
        assert!((long - 2.0).abs() < 1e-12 && (short - 0.5).abs() < 1e-12);
        assert!((turn - 0.7).abs() < 1e-12);
    }
}
