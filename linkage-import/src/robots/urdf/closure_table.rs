//! A table of the joints that close the loops of a URDF, which is a tree.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::placed_links::PlacedLinks;
use crate::csv_lines::line_number;
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, with_point};
use crate::placement::Vector;
use crate::robots::attribute_numbers::axis_of;
use crate::robots::model::{ClosingJoint, Closure, Robot};

/// The largest coordinate, in metres.
const LARGEST: f64 = 1e9;

/// The columns of coordinates: of the first link, of the second one, and of the axis.
const POINT: [&str; 3] = ["x1", "y1", "z1"];
const OTHER: [&str; 3] = ["x2", "y2", "z2"];
const AXIS: [&str; 3] = ["axis_x", "axis_y", "axis_z"];
const TEXTS: [&str; 4] = ["name", "kind", "link1", "link2"];

/// A line of the table with the columns of its heading.
struct Line<'t> {
    columns: &'t [String],
    record: &'t StringRecord,
    separator: u8,
}

/// Adds the closures of a table.
pub(super) fn add(robot: &mut Robot, text: &str, placed: &PlacedLinks) -> Result<(), ImportError> {
    let text = text.trim_start_matches('\u{feff}');
    let heading = text.lines().find(|line| !line.starts_with('#'));
    let separator = match heading.unwrap_or_default() {
        heading if heading.contains(';') => b';',
        heading if heading.contains('\t') => b'\t',
        _ => b',',
    };
    let mut reader = ReaderBuilder::new()
        .delimiter(separator)
        .comment(Some(b'#'))
        .flexible(true)
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let broken =
        |error: csv::Error| ImportError::new(format!("the table of closures is broken: {error}"));
    let columns = reader.headers().map_err(broken)?.iter();
    let columns: Vec<String> = columns.map(str::to_ascii_lowercase).collect();
    for needed in ["kind", "link1", "link2"].iter().chain(&POINT) {
        if !columns.iter().any(|column| column == needed) {
            return Err(ImportError::new(format!(
                "the table of closures has no column `{needed}`\nhelp: its columns are {}, {}, {}, {}",
                TEXTS.join(", "),
                POINT.join(", "),
                OTHER.join(", "),
                AXIS.join(", ")
            )));
        }
    }
    for column in &columns {
        let known = TEXTS.iter().chain(&POINT).chain(&OTHER).chain(&AXIS);
        if !known.into_iter().any(|known| known == column) {
            robot.leave_out(&format!("column {column} of closures"));
        }
    }
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(broken)?;
        let line = Line {
            columns: &columns,
            record: &record,
            separator,
        };
        let closure = closure(&line, index, placed)
            .map_err(|error| error.in_line(line_number(text, &record)))?;
        robot.close(closure)?;
    }
    Ok(())
}

impl Line<'_> {
    /// The text of a column, empty if the line has none.
    fn text(&self, column: &str) -> &str {
        let index = self.columns.iter().position(|name| name == column);
        index
            .and_then(|index| self.record.get(index))
            .unwrap_or_default()
    }

    /// The numbers of three columns, none if all are empty.
    fn vector(&self, columns: [&str; 3]) -> Result<Option<Vector>, ImportError> {
        if columns.iter().all(|column| self.text(column).is_empty()) {
            return Ok(None);
        }
        let mut vector = [0.0; 3];
        for (number, column) in vector.iter_mut().zip(columns) {
            let text = with_point(self.text(column), self.separator);
            *number = decimal(&text, &format!("`{column}`"))?.value;
            if number.abs() > LARGEST {
                return Err(ImportError::new(format!(
                    "`{column}` is `{}`, which is too large",
                    shown(&text)
                )));
            }
        }
        Ok(Some(vector))
    }
}

fn closure(line: &Line, index: usize, placed: &PlacedLinks) -> Result<Closure, ImportError> {
    let name = match line.text("name") {
        "" => format!("closure_{}", index + 1),
        name => name.to_owned(),
    };
    let link = |column: &str| {
        placed.get(line.text(column)).ok_or_else(|| {
            ImportError::new(format!(
                "`{column}` is `{}`, and the file has no such link",
                shown(line.text(column))
            ))
        })
    };
    let [(first, on_first), (second, on_second)] = [link("link1")?, link("link2")?];
    if first == second {
        return Err(ImportError::new(format!(
            "the links `{}` and `{}` do not move against each other",
            shown(line.text("link1")),
            shown(line.text("link2"))
        )));
    }
    let point = line.vector(POINT)?.ok_or_else(|| {
        ImportError::new("`x1`, `y1` and `z1` are empty: the point of the joint on `link1`")
    })?;
    let at = on_first.point(point);
    let other = line.vector(OTHER)?;
    let other = other.map_or(at, |other| on_second.point(other));
    let axis = || {
        let axis = line.vector(AXIS)?.ok_or_else(|| {
            ImportError::new(
                "`axis_x`, `axis_y` and `axis_z` are empty: the axis in the coordinates of `link1`",
            )
        })?;
        axis_of(on_first.direction(axis), &name)
    };
    let closing = match line.text("kind") {
        "ball" => ClosingJoint::Point,
        "hinge" => ClosingJoint::Hinge(axis()?),
        "slide" => ClosingJoint::Slide(axis()?),
        "weld" => ClosingJoint::Weld,
        kind => {
            return Err(ImportError::new(format!(
                "there is no kind `{}`; there are `ball`, `hinge`, `slide` and `weld`",
                shown(kind)
            )));
        }
    };
    Ok(Closure {
        bodies: [*first, *second],
        at: [at, other],
        closing,
        name,
    })
}
