//! Contents and options of a drawing.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::scatter::COMPONENTS;
use super::vector::Vector;
use super::view::View;
use crate::builder::Report;
use crate::palette::Palette;
use crate::positioned_picture::{PositionedPicture, drawn_names, point_named};
use crate::tables::Saved;
use crate::traced_points::traced_points;
use crate::{check, palette, positioned_picture, tables};
use linkage_core::Meaning;
use linkage_formats::{Mistake, ReportError};

/// A drawing of a mechanism at one position, to scale, as a picture: links as bars, links of three
/// and more points as plates, pivots and guides of the frame hatched, sliders, cylinders, gears as
/// pitch circles, arrows at driven links, the paths of points over the whole range, further
/// positions as ghosts, a scale bar. A point that no link carries is a dashed circle.
///
/// A mechanism in space is seen along a given direction, from far away; lengths across it are to
/// scale. Its joints have signs: a sleeve for a pin, a ball, a cross for a universal joint, a long
/// sleeve for a cylindrical one.
#[derive(Clone, Debug)]
pub struct Drawing<'a> {
    pub(super) report: &'a Report,
    pub(super) shown: PositionedPicture<'a>,
    pub(super) traces: Vec<usize>,
    pub(super) hues: Palette,
    pub(super) position: Option<f64>,
    pub(super) ghosts: usize,
    pub(super) scale: Option<f64>,
    pub(super) names: bool,
    pub(super) dimensions: bool,
    pub(super) ticks: usize,
    pub(super) vectors: Vec<Vector<'a>>,
    /// The enlargement of ellipses of tolerance, if they are drawn.
    pub(super) enlarged: Option<f64>,
    /// The duration of a cycle, if the drawing moves.
    pub(super) seconds: Option<f64>,
    pub(super) view: View,
    pub(super) mistakes: Vec<Mistake>,
}

impl<'a> Drawing<'a> {
    /// Returns a drawing of the mechanism with the default options.
    pub(crate) fn new(report: &'a Report) -> Result<Self, ReportError> {
        check::check(report)?;
        let shown = positioned_picture::find_picture(report).ok_or_else(|| Mistake::NoPicture {
            wanted: String::from("a drawing"),
            functions: tables::function_names(&report.tables),
        })?;
        let view = View::new(shown.picture.dimension);
        Ok(Self {
            report,
            shown,
            traces: traced_points(report, &shown),
            hues: palette::palette(report),
            position: None,
            ghosts: 0,
            scale: None,
            names: true,
            dimensions: false,
            ticks: 0,
            vectors: Vec::new(),
            enlarged: None,
            seconds: None,
            view: report
                .view
                .map_or(view, |[azimuth, elevation]| view.from(azimuth, elevation)),
            mistakes: Vec::new(),
        })
    }

    /// Shows the position of the report that is nearest to this input, in its unit. Without it:
    /// nearest to the input's reference, among those that can be assembled.
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

    /// The scale: 1 is the true size when the picture is printed, 0.5 half of it. Without it, the
    /// largest round scale at which the drawing fits onto a sheet.
    #[must_use]
    pub fn scale(mut self, scale: f64) -> Self {
        if scale > 0.0 && scale.is_finite() {
            self.scale = Some(scale);
        } else {
            self.mistakes.push(Mistake::Scale { scale });
        }
        self
    }

    /// Turns the names of points on or off. They are on by default.
    #[must_use]
    pub fn names(mut self, shown: bool) -> Self {
        self.names = shown;
        self
    }

    /// The direction from which a mechanism in space is seen: the angle about z, from x, and that
    /// above the plane of x and y, both in radians. It changes nothing in the plane.
    #[must_use]
    pub fn view(mut self, azimuth: f64, elevation: f64) -> Self {
        self.view = self.view.from(azimuth, elevation);
        self
    }

    /// Lets the mechanism run over the range of the report, again and again, in so many seconds:
    /// onward where it begins again as it ended, else there and back. Any browser shows it, a
    /// reader of a page beside the text, too; where SVG does not move, it stands at the first
    /// position.
    ///
    /// It shows links, joints, guides, paths and ghosts. Names, dimensions, vectors, ellipses and
    /// the arrows of inputs belong to one position and are left out. It is for mechanisms of the
    /// plane: the page of a report moves those in space.
    #[must_use]
    pub fn moving(mut self, seconds: f64) -> Self {
        let planar = self.shown.picture.dimension == 2;
        self.mistakes
            .extend((!planar).then_some(Mistake::MovesInSpace));
        if !(seconds > 0.0 && seconds.is_finite()) {
            self.mistakes.push(Mistake::Seconds { seconds });
        }
        self.seconds = Some(seconds);
        self
    }

    /// Shows the lengths of bars on dimension lines, with their names. Links in space have none:
    /// they are foreshortened.
    #[must_use]
    pub fn dimensions(mut self, shown: bool) -> Self {
        self.dimensions = shown;
        self
    }

    /// Marks this many points on each path, at equal steps of the input: at equal times, if it runs
    /// evenly.
    #[must_use]
    pub fn ticks(mut self, count: usize) -> Self {
        self.ticks = count;
        self
    }

    /// An arrow at a point: a velocity, an acceleration, a force, by the name of a quantity of the
    /// report's tables, whose components are `v.x` and `v.y`. A unit of the quantity is drawn as
    /// long as `length` units of the mechanism.
    #[must_use]
    pub fn vector(mut self, point: &str, quantity: &str, length: f64) -> Self {
        let picture = self.shown.picture;
        let index = point_named(picture, point);
        if index.is_none() {
            self.mistakes.push(Mistake::Unknown {
                kind: "point",
                name: point.to_string(),
                known: drawn_names(picture),
            });
        }
        let components = vector_components(&self, quantity);
        if components.is_none() {
            self.mistakes.push(Mistake::Unknown {
                kind: "vector",
                name: quantity.to_string(),
                known: vector_names(&self),
            });
        }
        if !length.is_finite() {
            self.mistakes.push(Mistake::NotFinite {
                what: format!("the length of a unit of `{quantity}`"),
                value: length,
            });
        }
        if let (Some(point), Some((components, unit))) = (index, components) {
            self.vectors.push(Vector {
                point,
                name: quantity.to_string(),
                components,
                unit,
                length,
            });
        }
        self
    }

    /// Draws the effects of tolerances on traced points, enlarged by this factor: ellipses of three
    /// standard deviations, from sensitivities of quantities that have the names of the points.
    #[must_use]
    pub fn tolerances(mut self, enlarged: f64) -> Self {
        if !enlarged.is_finite() {
            self.mistakes.push(Mistake::NotFinite {
                what: String::from("the enlargement of tolerances"),
                value: enlarged,
            });
        }
        self.enlarged = Some(enlarged);
        self
    }

    /// Returns the colour of everything that belongs to a point: that of its curves in plots.
    pub(super) fn point_hue(&self, point: usize) -> usize {
        let name = self.shown.picture.points[point].name;
        self.hues.named(name).unwrap_or(point)
    }
}

/// The columns of a vector's components, and their unit.
fn vector_components<'a>(
    drawing: &Drawing<'a>,
    quantity: &str,
) -> Option<(Vec<&'a [f64]>, &'static str)> {
    let report = drawing.report;
    let count = drawing.shown.picture.dimension;
    let of_table = |table: &'a Saved| {
        let components = COMPONENTS[..count].iter();
        let columns = components.map(|axis| {
            let name = format!("{quantity}.{axis}");
            let mut columns = table.columns();
            columns.find(|(column, _)| column.name == name)
        });
        let columns: Option<Vec<_>> = columns.collect();
        let columns = columns?;
        let unit = columns.first()?.0.unit;
        Some((
            columns.into_iter().map(|(_, values)| values).collect(),
            unit,
        ))
    };
    report.tables.iter().find_map(of_table)
}

fn vector_names(drawing: &Drawing<'_>) -> Vec<String> {
    let columns = drawing.report.tables.iter().flat_map(Saved::columns);
    let columns = columns.filter(|(column, _)| column.meaning != Meaning::Picture);
    let names = columns.filter_map(|(column, _)| column.name.strip_suffix(".x"));
    names.map(String::from).collect()
}
