//! What a drawing shows beside the mechanism.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::Drawing;
use super::arrows::Vector;
use super::marks::{COMPONENTS, Scatter};
use crate::Meaning;
use crate::report::Mistake;
use crate::report::shown::{drawn_names, point_named};
use crate::report::tables::Saved;

impl<'a> Drawing<'a> {
    /// Shows the lengths of bars on dimension lines, with their names. Links in space have none: they are foreshortened.
    #[must_use]
    pub fn dimensions(mut self, shown: bool) -> Self {
        self.dimensions = shown;
        self
    }

    /// Marks this many points on each path, at equal steps of the input: at equal times, if it runs evenly.
    #[must_use]
    pub fn ticks(mut self, count: usize) -> Self {
        self.ticks = count;
        self
    }

    /// An arrow at a point: a velocity, an acceleration, a force, by the name of a quantity of the report's tables, whose
    /// components are `v.x` and `v.y`. A unit of the quantity is drawn as long as `length` units of the mechanism.
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
        let components = self.components(quantity);
        if components.is_none() {
            self.mistakes.push(Mistake::Unknown {
                kind: "vector",
                name: quantity.to_string(),
                known: self.vector_names(),
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

    /// Draws what tolerances do to traced points, so many times enlarged: ellipses of three standard deviations, from sensitivities
    /// of quantities that are called as the points.
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

    /// Traced points without sensitivities, if ellipses are asked for and none has them.
    pub(super) fn without_tolerances(&self) -> Option<Mistake> {
        self.enlarged?;
        let sensitive = self.report.sensitive();
        let names = self.traces.iter();
        let names: Vec<&str> = names.map(|&k| self.shown.picture.points[k].name).collect();
        let mut points = self.traces.iter().zip(&names);
        let any = points.any(|(&point, name)| Scatter::of(point, name, &sensitive).is_some());
        (!any).then(|| Mistake::Unknown {
            kind: "traced point with sensitivities and tolerances",
            name: names.join(", "),
            known: sensitive.iter().map(|own| own.name.to_string()).collect(),
        })
    }

    /// The columns of a vector's components, and their unit.
    fn components(&self, quantity: &str) -> Option<(Vec<&'a [f64]>, &'static str)> {
        let report = self.report;
        let count = self.shown.picture.dimension;
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

    fn vector_names(&self) -> Vec<String> {
        let columns = self.report.tables.iter().flat_map(Saved::columns);
        let columns = columns.filter(|(column, _)| column.meaning != Meaning::Picture);
        let names = columns.filter_map(|(column, _)| column.name.strip_suffix(".x"));
        names.map(String::from).collect()
    }
}
