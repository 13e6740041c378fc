//! Tables of a report, and finding columns in them.

use std::string::String;
use std::vec::Vec;

use super::Report;
use crate::{Column, Heading, Meaning, Picture, PointKind, Table};

/// A table as the report keeps it.
#[derive(Clone, Debug)]
pub(super) struct Saved {
    pub(super) heading: &'static Heading,
    pub(super) values: Vec<Vec<f64>>,
    pub(super) rows: usize,
}

impl Saved {
    pub(super) fn new(table: &impl Table) -> Self {
        let heading = table.heading();
        let count = heading.columns.len();
        Self {
            heading,
            values: (0..count).map(|i| table.column(i).to_vec()).collect(),
            rows: table.rows(),
        }
    }

    /// Columns with their values.
    pub(super) fn columns(&self) -> impl Iterator<Item = (&'static Column, &[f64])> {
        let columns = self.heading.columns.iter();
        columns.zip(self.values.iter().map(Vec::as_slice))
    }

    /// The name of the column that another one is a derivative of.
    pub(super) fn of(&self, column: &Column) -> Option<&'static str> {
        let of = match column.meaning {
            Meaning::Rate { of, .. } | Meaning::Sensitivity { of, .. } => of,
            Meaning::Value | Meaning::Margin | Meaning::Picture => None,
        };
        of.map(|index| self.heading.columns[index].name)
    }
}

/// The picture of a report, with the places of its points.
#[derive(Clone, Copy)]
pub(super) struct Shown<'a> {
    pub(super) picture: &'static Picture,
    columns: &'a [Vec<f64>],
    pub(super) unit: &'static str,
}

impl<'a> Shown<'a> {
    /// The components of a point, each over all positions.
    pub(super) fn point(&self, index: usize) -> &'a [Vec<f64>] {
        let size = self.picture.dimension;
        &self.columns[size * index..size * (index + 1)]
    }

    /// The components of a direction, each over all positions.
    pub(super) fn direction(&self, index: usize) -> &'a [Vec<f64>] {
        self.point(self.picture.points.len() + index)
    }
}

impl Report {
    pub(super) fn shown(&self) -> Option<Shown<'_>> {
        self.tables.iter().find_map(|table| {
            let columns = table.heading.picture?;
            Some(Shown {
                picture: columns.picture,
                columns: &table.values[columns.first..],
                unit: table.heading.columns.get(columns.first)?.unit,
            })
        })
    }

    /// Indices of the points whose paths are drawn: those that were asked for, otherwise tips.
    pub(super) fn traced(&self, picture: &Picture) -> Vec<usize> {
        let tips = || {
            let points = picture.points.iter().enumerate();
            points.filter(|(_, point)| point.kind == PointKind::Tip)
        };
        match self.traces.as_slice() {
            [] => tips().map(|(index, _)| index).collect(),
            names => names
                .iter()
                .filter_map(|name| point_named(picture, name))
                .collect(),
        }
    }

    /// Names of the tables.
    pub(super) fn functions(&self) -> Vec<String> {
        let names = self.tables.iter().map(|table| table.heading.function);
        names.map(String::from).collect()
    }
}

pub(super) fn point_named(picture: &Picture, name: &str) -> Option<usize> {
    picture.points.iter().position(|point| point.name == name)
}
