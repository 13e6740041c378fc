//! Tables of joints as CSV: `name,kind,x,y,links`, with a line for each joint.
//!
//! `links` are names between spaces; `frame` or `ground` is the fixed link. Kinds are `pin`,
//! `motor` (a pin whose second link is driven against the first one), `slot` (a pin in a slot of
//! the first link) and `block` (the same, and the second link does not turn in the slot). A column
//! `along` has the direction of a slot: degrees, or two joints of the link. A column `input` marks
//! the slots that are driven. Rows of the kind `cylinder` have no position: their links are two
//! joints.

use csv::{ReaderBuilder, StringRecord};

use crate::csv_lines::line_number;
use crate::document::{Document, MOST_JOINTS};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, half_digit, with_point};

mod connections;
mod header;
mod single_links;

use connections::connect;
use header::{Table, has_points, missing_column, table};
use single_links::JointLinks;

/// Reads a table.
pub(crate) fn read(content: &[u8]) -> Result<Document, ImportError> {
    let text = String::from_utf8_lossy(content);
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().next().unwrap_or_default();
    let separators = [b';', b'\t'].into_iter();
    let mut separators = separators.filter(|sign| first.contains(char::from(*sign)));
    let separator = separators.next().unwrap_or(b',');
    let mut reader = ReaderBuilder::new()
        .delimiter(separator)
        .trim(csv::Trim::All)
        .flexible(true)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let header = reader.headers().map_err(broken)?.clone();
    if let Some(missing) = missing_column(&header) {
        let help = match has_points(text, separator) {
            true => "its rows are points of a suspension, which `--format hard-points` reads",
            false => "its first line is `name,kind,x,y,links`",
        };
        return Err(ImportError::new(format!(
            "the table has no column `{missing}`\nhelp: {help}"
        )));
    }
    let mut table = table(&header, separator)?;
    let in_line = |row: &StringRecord, error: ImportError| error.in_line(line_number(text, row));
    let mut rows = Vec::new();
    for row in reader.records() {
        rows.push(row.map_err(broken)?);
        if rows.len() > MOST_JOINTS {
            return Err(ImportError::new(format!("more than {MOST_JOINTS} rows")));
        }
    }
    for row in &rows {
        check_length(row, header.len()).map_err(|error| in_line(row, error))?;
        joint(&mut table, row).map_err(|error| in_line(row, error))?;
    }
    if table.has_points && table.has_commas {
        return Err(ImportError::new(
            "some numbers of the table have decimal points, and others have commas",
        ));
    }
    if table.has_commas {
        let remark = "The file has decimal commas: here they are points.";
        table.document.remarks.push(remark.to_owned());
    }
    if table.document.joints.is_empty() {
        return Err(ImportError::new("the table has no joints"));
    }
    for row in &rows {
        connect(&mut table, row).map_err(|error| in_line(row, error))?;
    }
    let warnings = single_links::warnings(&links_by_joint(&table, &rows), text);
    table.document.warnings.extend(warnings);
    table.document.band = half_digit(table.decimals);
    table.document.remarks.push(format!(
        "Coordinates have {} decimals at most: half of the last one is taken as their rounding.",
        table.decimals
    ));
    Ok(table.document)
}

/// Returns the links that each row names, but not the joints of cylinders.
fn links_by_joint<'t>(table: &Table, rows: &'t [StringRecord]) -> Vec<JointLinks<'t>> {
    let is_joint = |row: &&StringRecord| !table.cell(row, "kind").eq_ignore_ascii_case("cylinder");
    let joints = rows.iter().filter(is_joint);
    let joints = joints.map(|row| JointLinks {
        row,
        joint: table.cell(row, "name"),
        links: table.cell(row, "links").split_whitespace().collect(),
    });
    joints.collect()
}

/// Refuses a row with more cells than the heading: commas of its numbers have separated them.
fn check_length(row: &StringRecord, columns: usize) -> Result<(), ImportError> {
    if row.iter().skip(columns).all(str::is_empty) {
        return Ok(());
    }
    Err(ImportError::new(format!(
        "the row has {} cells, and the heading {columns}\nhelp: numbers have decimal points, or \
         decimal commas where `;` separates the columns",
        row.len()
    )))
}

fn broken(error: csv::Error) -> ImportError {
    ImportError::new(format!("the table cannot be read: {error}"))
}

fn joint(table: &mut Table, row: &StringRecord) -> Result<(), ImportError> {
    let name = table.cell(row, "name").to_owned();
    if table.cell(row, "kind") == "cylinder" {
        return Ok(());
    }
    let mut position = [0.0; 2];
    for (value, column) in position.iter_mut().zip(["x", "y"]) {
        let cell = table.cell(row, column);
        let [has_point, has_comma] = ['.', ','].map(|sign| cell.contains(sign));
        let number = decimal(
            &with_point(cell, table.separator),
            &format!("{column} of `{}`", shown(&name)),
        )?;
        table.has_points |= has_point;
        table.has_commas |= has_comma;
        *value = number.value;
        table.decimals = table.decimals.max(number.decimals);
    }
    let index = table.document.add_joint(&name, position);
    if name.is_empty() || table.joints.insert(name.clone(), index).is_some() {
        return Err(ImportError::new(format!(
            "two joints are called `{}`",
            shown(&name)
        )));
    }
    Ok(())
}
