//! The picture of a report, with the places of its points.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::builder::Report;
use linkage_core::{Guide, GuideOn, Picture, PicturePoint, PointKind};
use linkage_runtime::Column;

/// The picture of a report, with the places of its points.
#[derive(Clone, Copy, Debug)]
pub(super) struct PositionedPicture<'a> {
    pub(super) picture: &'static Picture,
    columns: &'a [Vec<f64>],
    pub(super) unit: &'static str,
    named: &'static [Column],
}

impl<'a> PositionedPicture<'a> {
    pub(super) fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    /// The components of a point, each over all positions.
    pub(super) fn point(&self, index: usize) -> &'a [Vec<f64>] {
        let size = self.picture.dimension;
        &self.columns[size * index..size * (index + 1)]
    }

    /// The name of a point's first column.
    pub(super) fn column_name(&self, index: usize) -> &'static str {
        self.named[self.picture.dimension * index].name
    }

    /// The components of a direction, each over all positions.
    pub(super) fn direction(&self, index: usize) -> &'a [Vec<f64>] {
        self.point(self.picture.points.len() + index)
    }

    pub(super) fn point_at(&self, point: usize, row: usize) -> [f64; 3] {
        components(self.point(point), row)
    }

    pub(super) fn way(&self, direction: usize, row: usize) -> [f64; 3] {
        components(self.direction(direction), row)
    }

    pub(super) fn is_assembled(&self, row: usize) -> bool {
        let points = 0..self.picture.points.len();
        points
            .flat_map(|point| self.point_at(point, row))
            .all(f64::is_finite)
    }

    /// The shortest and the longest way of a guide's slider from its origin over the range; 0 where
    /// nothing is finite.
    pub(super) fn travel(&self, guide: &Guide) -> [f64; 2] {
        let rows = 0..self.rows();
        let ways = rows.map(|row| {
            let (from, to) = (
                self.point_at(guide.origin, row),
                self.point_at(guide.slider, row),
            );
            let direction = self.way(guide.direction, row);
            (0..3)
                .map(|k| (to[k] - from[k]) * direction[k])
                .sum::<f64>()
        });
        let ways = ways.filter(|way| way.is_finite());
        let [low, high] = ways.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], way| {
            [low.min(way), high.max(way)]
        });
        if low > high { [0.0; 2] } else { [low, high] }
    }

    /// Returns the ends of a guide's line, as distances from its origin: the range of the slider,
    /// extended to the origin where the line belongs to a link that has it.
    pub(super) fn rail(&self, guide: &Guide) -> [f64; 2] {
        let [low, high] = self.travel(guide);
        let links = self.picture.links;
        let from_origin = match guide.on {
            GuideOn::Frame => false,
            GuideOn::Link(link) => links[link].points.contains(&guide.origin),
            GuideOn::Itself => true,
        };
        if from_origin {
            [low.min(0.0), high.max(0.0)]
        } else {
            [low, high]
        }
    }
}

pub(super) fn find_picture(report: &Report) -> Option<PositionedPicture<'_>> {
    report.tables.iter().find_map(|table| {
        let columns = table.heading.picture?;
        Some(PositionedPicture {
            picture: columns.picture,
            columns: &table.values[columns.first..],
            unit: table.heading.columns.get(columns.first)?.unit,
            named: table.heading.columns.get(columns.first..)?,
        })
    })
}

/// Returns the notes of the report and those of the picture.
pub(super) fn all_notes(report: &Report) -> Vec<String> {
    let shown = find_picture(report);
    let missing = shown.map_or_else(Vec::new, |shown| told_of_missing(shown.picture));
    report.notes.iter().cloned().chain(missing).collect()
}

/// Returns true if there is a picture, and a position at which all of it can be drawn.
pub(super) fn is_drawable(report: &Report) -> bool {
    find_picture(report).is_some_and(|shown| (0..shown.rows()).any(|row| shown.is_assembled(row)))
}

/// Returns the notes about loops that are not drawn, and about points that no link carries.
pub(super) fn told_of_missing(picture: &Picture) -> Vec<String> {
    let undrawn = told_of_undrawn_loops(picture);
    undrawn
        .into_iter()
        .chain(told_of_loose_points(picture))
        .collect()
}

fn told_of_undrawn_loops(picture: &Picture) -> Option<String> {
    let numbers: Vec<String> = picture.undrawn.iter().map(ToString::to_string).collect();
    match &numbers[..] {
        [] => None,
        [one] => Some(format!(
            "Loop {one} is not drawn: it is not known where in space it lies."
        )),
        [first @ .., last] => Some(format!(
            "Loops {} and {last} are not drawn: it is not known where in space they lie.",
            first.join(", ")
        )),
    }
}

fn told_of_loose_points(picture: &Picture) -> Option<String> {
    let loose = picture.points.iter();
    let loose = loose.filter(|point| point.kind == PointKind::Loose);
    let names: Vec<&str> = loose.map(|point| point.name).collect();
    (!names.is_empty()).then(|| format!("No link of the picture carries {}.", names.join(", ")))
}

/// The index of a point that is drawn.
pub(super) fn point_named(picture: &Picture, name: &str) -> Option<usize> {
    let mut points = picture.points.iter();
    points.position(|point| point.name == name && is_drawn(point))
}

/// The names of all points that are drawn.
pub(super) fn drawn_names(picture: &Picture) -> Vec<String> {
    let drawn = picture.points.iter().filter(|point| is_drawn(point));
    drawn.map(|point| String::from(point.name)).collect()
}

fn is_drawn(point: &PicturePoint) -> bool {
    point.kind != PointKind::Construction
}

fn components(columns: &[Vec<f64>], row: usize) -> [f64; 3] {
    let mut v = [0.0; 3];
    for (to, column) in v.iter_mut().zip(columns) {
        *to = column[row];
    }
    v
}
