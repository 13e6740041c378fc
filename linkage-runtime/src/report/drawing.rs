//! The mechanism to scale.

mod arrows;
mod caption;
mod cover;
mod dxf;
mod fixed;
mod geometry;
mod legend;
mod marks;
mod moving;
mod names;
mod options;
mod parts;
mod room;
mod sheet;
mod signs;
mod wheels;

use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use super::hues::Hues;
use super::shown::{Shown, drawn_names, point_named};
use super::svg::{Element, Svg};
use super::{Mistake, Report, ReportError};
use arrows::Vector;
use sheet::Sheet;
pub(super) use sheet::View;
pub(super) use wheels::Wheels;

/// A drawing of a mechanism at one position, to scale, as a picture: links as bars, links of three and more points as
/// plates, pivots and guides of the frame hatched, sliders, cylinders, gears as pitch circles, arrows at what the inputs move, the paths of
/// points over the whole range, further positions as ghosts, a scale bar. What no link carries is a dashed circle.
///
/// A mechanism in space is seen along a given direction, from far away; lengths across it are to scale. Its joints have signs: a
/// sleeve for a pin, a ball, a cross for a universal joint, a long sleeve for a cylindrical one.
#[derive(Clone, Debug)]
pub struct Drawing<'a> {
    report: &'a Report,
    shown: Shown<'a>,
    traces: Vec<usize>,
    hues: Hues,
    position: Option<f64>,
    ghosts: usize,
    scale: Option<f64>,
    names: bool,
    dimensions: bool,
    ticks: usize,
    vectors: Vec<Vector<'a>>,
    /// How much larger than they are ellipses of tolerance are drawn, if they are.
    enlarged: Option<f64>,
    /// How long a cycle takes, if it moves.
    seconds: Option<f64>,
    view: View,
    mistakes: Vec<Mistake>,
}

impl Report {
    /// A drawing of the mechanism.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if no table has the columns of a picture.
    pub fn drawing(&self) -> Result<Drawing<'_>, ReportError> {
        self.check()?;
        let shown = self.shown().ok_or_else(|| Mistake::NoPicture {
            wanted: String::from("a drawing"),
            functions: self.functions(),
        })?;
        let view = View::new(shown.picture.dimension);
        Ok(Drawing {
            report: self,
            shown,
            traces: self.traced(shown.picture),
            hues: self.hues(),
            position: None,
            ghosts: 0,
            scale: None,
            names: true,
            dimensions: false,
            ticks: 0,
            vectors: Vec::new(),
            enlarged: None,
            seconds: None,
            view: self
                .view
                .map_or(view, |[azimuth, elevation]| view.from(azimuth, elevation)),
            mistakes: Vec::new(),
        })
    }
}

impl Drawing<'_> {
    /// Shows the position of the report that is nearest to this input, in its unit. Without it: nearest to the input's
    /// reference, among those that can be assembled.
    #[must_use]
    pub fn position(mut self, input: f64) -> Self {
        self.position = Some(input);
        self
    }

    /// Shows this many further positions faintly, evenly spread over the range.
    #[must_use]
    pub fn ghosts(mut self, count: usize) -> Self {
        self.ghosts = count;
        self
    }

    /// Draws the path of a point, beside those that the report traces.
    #[must_use]
    pub fn trace(mut self, point: &str) -> Self {
        let picture = self.shown.picture;
        match point_named(picture, point) {
            Some(index) if self.traces.contains(&index) => {}
            Some(index) => self.traces.push(index),
            None => self.mistakes.push(Mistake::Unknown {
                kind: "point",
                name: point.to_string(),
                known: drawn_names(picture),
            }),
        }
        self
    }

    /// The scale: 1 is the true size when the picture is printed, 0.5 half of it. Without it, the largest round scale at
    /// which the drawing fits onto a sheet.
    #[must_use]
    pub fn scale(mut self, scale: f64) -> Self {
        if scale > 0.0 && scale.is_finite() {
            self.scale = Some(scale);
        } else {
            self.mistakes.push(Mistake::Scale { scale });
        }
        self
    }

    /// Whether points have their names beside them; they do unless it is turned off.
    #[must_use]
    pub fn names(mut self, shown: bool) -> Self {
        self.names = shown;
        self
    }

    /// The direction from which a mechanism in space is seen: the angle about z, from x, and that above the plane of x and
    /// y, both in radians. It changes nothing in the plane.
    #[must_use]
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Self {
        self.view = self.view.from(azimuth, elevation);
        self
    }

    /// The drawing as SVG; its unit is a millimetre on paper.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] for a point that is not there, a scale that is none, and if the mechanism cannot be
    /// assembled at the position that is wanted, or at all.
    pub fn svg(&self) -> Result<String, ReportError> {
        let row = self.possible_row()?;
        match self.seconds {
            Some(seconds) => self.film(seconds),
            None => Ok(self.drawn(row, row).finish()),
        }
    }

    /// Writes the drawing, by the ending of the file's name, as SVG, [DXF](Self::dxf) or (with feature `png`) PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        let path = path.as_ref();
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("dxf") => super::write::file(path, self.dxf()?),
            _ => super::write::picture(path, &self.svg()?),
        }
    }

    /// The row of the position that is shown, if nothing was asked for that is not there.
    fn possible_row(&self) -> Result<usize, ReportError> {
        let mut mistakes = self.mistakes.clone();
        mistakes.extend(self.without_tolerances());
        match self.row() {
            Ok(row) if mistakes.is_empty() => return Ok(row),
            Ok(_) => {}
            Err(mistake) => mistakes.push(mistake),
        }
        Err(ReportError::Mistakes(mistakes))
    }

    /// The row of the position that is shown.
    fn row(&self) -> Result<usize, Mistake> {
        let input = &self.report.input;
        let wanted = self.position.unwrap_or(input.reference);
        let positions = self.report.positions.iter().enumerate();
        let mut rows: Vec<(usize, f64)> = positions
            .map(|(row, x)| (row, (x - wanted).abs()))
            .collect();
        rows.sort_by(|a, b| a.1.total_cmp(&b.1));
        let candidates = if self.position.is_some() {
            1
        } else {
            rows.len()
        };
        let mut rows = rows.into_iter().take(candidates).map(|(row, _)| row);
        rows.find(|row| self.shown.is_assembled(*row))
            .ok_or_else(|| Mistake::NotAssembled {
                input: input.name.to_string(),
                unit: input.unit,
                at: self.position,
            })
    }

    /// The colour of what belongs to a point: that of its curves in plots.
    fn hue(&self, point: usize) -> usize {
        let name = self.shown.picture.points[point].name;
        self.hues.named(name).unwrap_or(point)
    }

    /// So many rows, at all ends of equal parts of the range; the last one repeats the first where the range closes.
    fn even_rows(&self, count: usize) -> Vec<usize> {
        let last = self.report.positions.len() - 1;
        let parts = match self.report.is_periodic() {
            true => count.max(1),
            false => count.saturating_sub(1).max(1),
        };
        let row = |i: usize| (last * i + parts / 2) / parts;
        (0..count).map(row).collect()
    }

    /// The drawing at a row; plates have the corners that they have at the row `form`.
    fn drawn(&self, row: usize, form: usize) -> Svg {
        let sheet = Sheet::new(self);
        let [width, height] = sheet.size;
        let mut svg = Svg::new(width, height, "mm", &self.report.title);
        if self.ghosts > 0 {
            svg.group(
                Element::new("g").class("ghosts").number("opacity", 0.45),
                |svg| {
                    for ghost in self.even_rows(self.ghosts) {
                        self.ghost(svg, &sheet, ghost);
                    }
                },
            );
        }
        self.axes(&mut svg, &sheet, row);
        self.wheels(&mut svg, &sheet, row);
        self.links(&mut svg, &sheet, row, form);
        // In front of plates, which would hide them.
        self.pivots(&mut svg, &sheet, row);
        for guide in self.shown.picture.guides {
            self.frame_guide(&mut svg, &sheet, guide, row);
        }
        self.cylinders(&mut svg, &sheet, row);
        self.sliders(&mut svg, &sheet, row);
        for &point in &self.traces {
            self.path(&mut svg, &sheet, point, self.hue(point));
        }
        self.even_points(&mut svg, &sheet);
        if self.seconds.is_none() {
            self.ellipses(&mut svg, &sheet, row);
        }
        self.joint_signs(&mut svg, &sheet, row);
        self.points(&mut svg, &sheet, row);
        if self.seconds.is_none() {
            self.of_one_position(&mut svg, &sheet, row);
        }
        self.caption(&mut svg, &sheet, row);
        self.legend(&mut svg, &sheet);
        svg
    }

    /// What says something of this position: words and arrows, which would jump about if it moved.
    fn of_one_position(&self, svg: &mut Svg, sheet: &Sheet<'_>, row: usize) {
        self.drives(svg, sheet, row);
        self.dimension_lines(svg, sheet, row);
        self.vectors(svg, sheet, row);
        if self.names {
            self.point_names(svg, sheet, row);
        }
    }
}
