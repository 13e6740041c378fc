//! The header of a table of joints: its columns, and the unit of its coordinates.

use std::collections::BTreeMap;

use csv::StringRecord;

use crate::document::{Document, FRAME, LengthUnit};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::with_point;

const COLUMNS: [&str; 5] = ["name", "kind", "x", "y", "links"];
const OTHER_COLUMNS: [&str; 2] = ["along", "input"];

/// A table that is being read.
pub(super) struct Table {
    pub(super) document: Document,
    columns: BTreeMap<String, usize>,
    pub(super) joints: BTreeMap<String, usize>,
    pub(super) links: BTreeMap<String, usize>,
    pub(super) decimals: usize,
    pub(super) separator: u8,
    pub(super) has_points: bool,
    pub(super) has_commas: bool,
}

impl Table {
    /// Returns a cell of a row, empty if the table has no such column.
    pub(super) fn cell<'t>(&self, row: &'t StringRecord, name: &str) -> &'t str {
        let column = self.columns.get(name);
        column.and_then(|column| row.get(*column)).unwrap_or("")
    }

    /// Returns the joint of a name.
    pub(super) fn joint(&self, name: &str) -> Result<usize, ImportError> {
        let joint = self.joints.get(name).copied();
        joint.ok_or_else(|| ImportError::new(format!("there is no joint `{}`", shown(name))))
    }
}

/// Returns the name of a column: its title up to a unit.
fn column_name(title: &str) -> &str {
    let is_end = |letter: char| "([/".contains(letter) || letter.is_whitespace();
    title.split(is_end).next().unwrap_or_default()
}

/// Returns the first column that the header lacks.
pub(super) fn missing_column(header: &StringRecord) -> Option<&'static str> {
    let titles: Vec<String> = header.iter().map(str::to_ascii_lowercase).collect();
    let is_missing = |name: &&str| titles.iter().all(|title| column_name(title) != *name);
    COLUMNS.into_iter().find(|name| is_missing(name))
}

/// Returns true if one of the first two rows is a name and three numbers.
pub(super) fn has_points(text: &str, separator: u8) -> bool {
    let rows = text
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'));
    rows.take(2).any(|row| {
        let cells: Vec<&str> = row.split(char::from(separator)).map(str::trim).collect();
        let is_number = |cell: &&str| with_point(cell, separator).parse::<f64>().is_ok();
        let [name, coordinates @ ..] = &cells[..] else {
            return false;
        };
        coordinates.len() == 3 && coordinates.iter().all(is_number) && !is_number(name)
    })
}

/// Reads the header: the names of columns, and the unit behind `x`.
pub(super) fn table(header: &StringRecord, separator: u8) -> Result<Table, ImportError> {
    let mut columns = BTreeMap::new();
    let mut unit = None;
    let mut warnings = Vec::new();
    for (index, title) in header.iter().enumerate() {
        let title = title.to_ascii_lowercase();
        let (name, rest) = title.split_at(column_name(&title).len());
        let named = rest.trim_matches(|letter: char| !letter.is_ascii_alphabetic());
        if !named.is_empty() {
            let found = LengthUnit::named(named).ok_or_else(|| {
                ImportError::new(format!(
                    "the unit `{}` is not known\nhelp: units are mm, cm, m and inch",
                    shown(named)
                ))
            })?;
            if unit.is_some_and(|unit| unit != found) {
                return Err(ImportError::new("the columns have different units"));
            }
            unit = Some(found);
        }
        if !COLUMNS.contains(&name) && !OTHER_COLUMNS.contains(&name) {
            warnings.push(format!(
                "the column `{}` is not known and left out",
                shown(&title)
            ));
        }
        columns.insert(name.to_owned(), index);
    }
    let mut document = Document::new("a table of joints", unit.unwrap_or(LengthUnit::Millimetre));
    document.warnings = warnings;
    if unit.is_none() {
        document.warnings.push(
            "the table has no unit: millimetres are taken; a title like `x (cm)` names another one"
                .to_owned(),
        );
    }
    Ok(Table {
        document,
        columns,
        joints: BTreeMap::new(),
        links: BTreeMap::from(["frame", "ground"].map(|name| (name.to_owned(), FRAME))),
        decimals: 0,
        separator,
        has_points: false,
        has_commas: false,
    })
}
