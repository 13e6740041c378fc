//! The points whose paths are drawn.

use std::vec::Vec;

use super::builder::Report;
use super::positioned_picture::{PositionedPicture, point_named};
use super::tables::Saved;
use linkage_core::{Meaning, PointKind};

/// A result and a point of the picture are one if they differ by less, compared with the largest
/// coordinate: the programs of two functions round differently.
const SAME: f64 = 1e-9;

const AXES: [&str; 3] = [".x", ".y", ".z"];

/// Indices of the points whose paths are drawn: those that the report names. Without any name, the
/// tips of links, and the moving points whose positions a function returns.
pub(super) fn traced_points(report: &Report, shown: &PositionedPicture<'_>) -> Vec<usize> {
    let picture = shown.picture;
    let mut found = Vec::new();
    if report.traces.is_empty() {
        let results = returned_paths(report, shown);
        for (index, point) in picture.points.iter().enumerate() {
            let is_returned = || results.iter().any(|path| is_path_of(path, index, shown));
            match point.kind {
                PointKind::Tip => found.push(index),
                PointKind::Joint | PointKind::Loose if is_returned() => found.push(index),
                _ => {}
            }
        }
    }
    for name in &report.traces {
        let index = point_named(picture, name);
        found.extend(index.filter(|index| !found.contains(index)));
    }
    found
}

/// The vectors of lengths that functions return, each by its components over all positions.
fn returned_paths<'a>(report: &'a Report, shown: &PositionedPicture<'_>) -> Vec<Vec<&'a [f64]>> {
    let tables = report.tables.iter();
    tables.flat_map(|table| vectors(table, shown)).collect()
}

fn vectors<'a>(table: &'a Saved, shown: &PositionedPicture<'_>) -> Vec<Vec<&'a [f64]>> {
    let size = shown.picture.dimension;
    let columns: Vec<_> = table.columns().collect();
    let vector = |columns: &[(&linkage_runtime::Column, &'a [f64])]| {
        let (first, _) = columns.first()?;
        let name = first.name.strip_suffix(AXES[0])?;
        let is_component = |(column, axis): (&&linkage_runtime::Column, &str)| {
            column.meaning == Meaning::Value
                && column.unit == shown.unit
                && column.name.strip_suffix(axis) == Some(name)
        };
        let pairs = columns.iter().map(|(column, _)| column).zip(AXES);
        let is_vector = pairs.clone().all(is_component);
        is_vector.then(|| columns.iter().map(|(_, values)| *values).collect())
    };
    columns.windows(size).filter_map(vector).collect()
}

/// Returns true if a path is that of a point of the picture, at all positions at which both exist.
fn is_path_of(path: &[&[f64]], point: usize, shown: &PositionedPicture<'_>) -> bool {
    let at = shown.point(point);
    let all = at.iter().flatten().filter(|x| x.is_finite());
    let size = all.fold(0.0, |size: f64, x| size.max(x.abs()));
    let mut compared = 0;
    for row in 0..shown.rows() {
        let pairs = path
            .iter()
            .zip(at)
            .map(|(path, at)| (path.get(row), at[row]));
        for (x, y) in pairs {
            let Some(&x) = x else { return false };
            if x.is_finite() && y.is_finite() {
                compared += 1;
                if (x - y).abs() > SAME * size {
                    return false;
                }
            }
        }
    }
    compared > 0
}
