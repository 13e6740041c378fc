//! The data of the page of a comparison.

use serde_json::{Value, json};
use std::string::{String, ToString};
use std::vec::Vec;

use super::front::front;
use super::picture::Drawn;
use super::{Compared, Comparison};
use crate::{plots, positioned_picture};
use linkage_core::Meaning;

/// A page has no more positions of each design: two for each degree of a turn that a drawing of
/// some hundred pixels shows would be no better.
const MOST: usize = 361;
/// Curves are rounded to this part of their range, or a little less: finer than a screen shows
/// them.
const STEPS: f64 = 100_000.0;

impl Comparison<'_> {
    /// Returns everything as JSON. A number that is not finite is `null`.
    pub(super) fn value(&self) -> Value {
        let rows = self.rows();
        let first = self.designs.first().map(|design| design.report);
        let input = first.map(|report| {
            let values: Vec<f64> = rows.iter().map(|&row| report.positions[row]).collect();
            json!({ "name": report.input.name, "unit": report.input.unit, "values": values })
        });
        let drawn: Vec<Option<Drawn<'_>>> = self
            .designs
            .iter()
            .map(|design| Drawn::new(design.report))
            .collect();
        let extent = extent(&drawn, &rows);
        let size = extent
            .iter()
            .map(|[low, high]| high - low)
            .fold(0.0, f64::max);
        let designs = self.designs.iter().zip(&drawn).map(|(design, drawn)| {
            json!({
                "name": design.name,
                "about": design.report.about,
                "page": design.page,
                "picture": drawn.as_ref().map(|drawn| drawn.value(&rows, size)),
                "curves": self.columns().iter().map(|name| curve(design, name, &rows)).collect::<Vec<_>>(),
            })
        });
        json!({
            "title": self.title,
            "about": self.about,
            "input": input,
            "extent": extent,
            "unit": first.and_then(positioned_picture::find_picture).map(|shown| shown.unit),
            "designs": designs.collect::<Vec<_>>(),
            "curves": self.columns().iter().filter_map(|name| {
                let (_, unit, _) = first.and_then(|report| plots::find_series(report, name))?;
                // A unit after the name is not repeated.
                let bare = name.split(" [").next().unwrap_or(name);
                Some(json!({ "name": bare, "unit": unit }))
            }).collect::<Vec<_>>(),
            "figures": self.figures().iter().map(|(name, unit)| {
                let values: Vec<_> = self.designs.iter().map(|design| figure(design, name)).collect();
                json!({ "name": name, "unit": unit, "values": values })
            }).collect::<Vec<_>>(),
            "dimensions": self.dimensions(),
            "front": self.front_value(),
        })
    }

    /// The positions that are shown: evenly spread, both ends among them.
    fn rows(&self) -> Vec<usize> {
        let count = self
            .designs
            .first()
            .map_or(0, |design| design.report.positions.len());
        match count {
            0..=MOST => (0..count).collect(),
            _ => (0..MOST).map(|k| k * (count - 1) / (MOST - 1)).collect(),
        }
    }

    /// The columns whose curves are shown.
    pub(super) fn columns(&self) -> Vec<String> {
        if !self.curves.is_empty() {
            return self.curves.clone();
        }
        let first = self.designs.first().into_iter();
        let tables = first.flat_map(|design| &design.report.tables);
        let columns = tables.flat_map(|table| table.columns());
        let values = columns.filter(|(column, _)| column.meaning == Meaning::Value);
        let mut names: Vec<String> = Vec::new();
        for (column, _) in values {
            // Functions may have the same quantity.
            if !names.iter().any(|name| name == column.name) {
                names.push(column.name.to_string());
            }
        }
        names
    }

    /// Names and units of the figures that any design has.
    pub(super) fn figures(&self) -> Vec<(String, String)> {
        let mut all: Vec<(String, String)> = Vec::new();
        for (name, _, unit) in self.designs.iter().flat_map(Compared::all_figures) {
            if !all.iter().any(|(other, _)| *other == name) {
                all.push((name, unit));
            }
        }
        all
    }

    /// The dimensions that are not the same in all designs.
    fn dimensions(&self) -> Vec<Value> {
        let mut all: Vec<(&str, &str)> = Vec::new();
        for dimension in self
            .designs
            .iter()
            .flat_map(|design| &design.report.dimensions)
        {
            let column = (dimension.parameter.name, dimension.parameter.unit);
            if !all.contains(&column) {
                all.push(column);
            }
        }
        let row = |&(name, unit): &(&str, &str)| {
            let values: Vec<Option<f64>> = self
                .designs
                .iter()
                .map(|design| {
                    let mut dimensions = design.report.dimensions.iter();
                    dimensions
                        .find(|dimension| {
                            dimension.parameter.name == name && dimension.parameter.unit == unit
                        })
                        .map(|dimension| dimension.value)
                })
                .collect();
            let differ = values.iter().any(|value| *value != values[0]);
            differ.then(|| json!({ "name": name, "unit": unit, "values": values }))
        };
        all.iter().filter_map(row).collect()
    }

    /// The objectives, by the indices of their figures, and which designs are best.
    fn front_value(&self) -> Option<Value> {
        if self.aims.is_empty() {
            return None;
        }
        let figures = self.figures();
        let value = |design: &Compared<'_>| -> Vec<f64> {
            let aims = self.aims.iter();
            aims.map(|aim| {
                let value = figure(design, &aim.figure).unwrap_or(f64::NAN);
                if aim.most { -value } else { value }
            })
            .collect()
        };
        let values: Vec<Vec<f64>> = self.designs.iter().map(value).collect();
        let aims = self.aims.iter().map(|aim| {
            let figure = figures.iter().position(|(name, _)| *name == aim.figure);
            json!({ "figure": figure, "most": aim.most })
        });
        Some(json!({ "aims": aims.collect::<Vec<_>>(), "best": front(&values) }))
    }
}

fn figure(design: &Compared<'_>, name: &str) -> Option<f64> {
    let mut all = design.all_figures().into_iter();
    all.find(|(figure, ..)| figure == name)
        .map(|(_, value, _)| value)
}

fn curve(design: &Compared<'_>, name: &str, rows: &[usize]) -> Option<Vec<f64>> {
    let (_, _, values) = plots::find_series(design.report, name)?;
    let finite = || values.iter().copied().filter(|x| x.is_finite());
    let range = finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min);
    // A constant has all its digits.
    let digits = match range > 0.0 {
        true => (STEPS / range).log10().ceil(),
        false => return Some(rows.iter().map(|&row| values[row]).collect()),
    };
    let step = 10f64.powf(digits.abs());
    let rounded = |x: f64| match digits >= 0.0 {
        true => (x * step).round() / step,
        false => (x / step).round() * step,
    };
    Some(rows.iter().map(|&row| rounded(values[row])).collect())
}

/// The lowest and highest place each way of all drawings; a square of 1 without one.
fn extent(drawn: &[Option<Drawn<'_>>], rows: &[usize]) -> [[f64; 2]; 2] {
    let all = drawn.iter().flatten().map(|drawn| drawn.extent(rows));
    let joined =
        all.reduce(|a, b| core::array::from_fn(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])]));
    match joined {
        Some(extent) if extent.iter().flatten().all(|x| x.is_finite()) => extent,
        _ => [[0.0, 1.0]; 2],
    }
}
