//! Tables of named points: CSV with a name and three numbers in a line, or YAML with lists of three
//! numbers.

use std::borrow::Cow;

use saphyr_parser::{Event, Parser};

use crate::csv_lines::line_number;
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{Decimal, decimal, with_point};
use crate::placement::Vector;

/// More points than any suspension has.
const MOST_POINTS: usize = 500;

/// Lists within lists more often than this are no table.
const DEEPEST: usize = 16;

/// The largest coordinate.
const LARGEST: f64 = 1e7;

/// A point with its name in the file, in lower case with underscores.
pub(super) struct NamedPoint {
    pub(super) name: String,
    pub(super) at: Vector,
}

/// A table, and what of it is no point.
#[derive(Default)]
pub(super) struct Table {
    pub(super) points: Vec<NamedPoint>,
    /// The most decimals of a coordinate.
    pub(super) decimals: usize,
    pub(super) others: Vec<String>,
}

impl Table {
    fn add(&mut self, name: &str, numbers: &[Decimal]) -> Result<(), ImportError> {
        let word = word(name);
        let [x, y, z] = *numbers else {
            self.others.push(shown(name));
            return Ok(());
        };
        if self.points.iter().any(|point| point.name == word) {
            return Err(ImportError::new(format!(
                "there are two points `{}`",
                shown(&word)
            )));
        }
        if self.points.len() >= MOST_POINTS {
            return Err(ImportError::new(format!(
                "the table has more than {MOST_POINTS} points"
            )));
        }
        self.points.push(NamedPoint {
            name: word,
            at: [x, y, z].map(|number| number.value),
        });
        let decimals = numbers.iter().map(|number| number.decimals);
        self.decimals = decimals.fold(self.decimals, usize::max);
        Ok(())
    }
}

/// A name in lower case, with single underscores between its words.
pub(super) fn word(name: &str) -> String {
    let mut word = String::new();
    for letter in name.trim().chars() {
        match letter.is_alphanumeric() {
            true => word.extend(letter.to_lowercase()),
            false if !word.ends_with('_') && !word.is_empty() => word.push('_'),
            false => {}
        }
    }
    word.trim_end_matches('_').to_owned()
}

fn coordinate(text: &str, name: &str) -> Result<Decimal, ImportError> {
    let number = decimal(text, &format!("a coordinate of `{}`", shown(name)))?;
    match number.value.abs() < LARGEST {
        true => Ok(number),
        false => Err(ImportError::new(format!(
            "a coordinate of `{}` is too large",
            shown(name)
        ))),
    }
}

/// Reads CSV. A first line without numbers is a heading.
pub(super) fn csv(text: &str) -> Result<Table, ImportError> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let separator = match lines.next() {
        Some(line) if line.contains(';') => b';',
        Some(line) if line.contains('\t') => b'\t',
        _ => b',',
    };
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .delimiter(separator)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut table = Table::default();
    for (index, record) in reader.records().enumerate() {
        let record =
            record.map_err(|error| ImportError::new(format!("the CSV is broken: {error}")))?;
        let fields: Vec<&str> = record.iter().collect();
        let is_number = |text: &str| text.parse::<f64>().is_ok();
        let numbers: Vec<Cow<str>> = fields
            .iter()
            .map(|text| with_point(text, separator))
            .collect();
        let ([name, _, _, _, rest @ ..], [_, x, y, z, ..]) = (&fields[..], &numbers[..]) else {
            if let ([name, ..], [_, x, y]) = (&fields[..], &numbers[..])
                && is_number(x)
                && is_number(y)
            {
                let error = ImportError::new(format!(
                    "the point `{}` has two coordinates instead of three",
                    shown(name)
                ));
                return Err(error.in_line(line_number(text, &record)));
            }
            table.others.push(shown(&fields.join(" ")));
            continue;
        };
        if index == 0 && ![x, y, z].iter().any(|text| is_number(text)) {
            continue;
        }
        let in_line = |error: ImportError| error.in_line(line_number(text, &record));
        let numbers = [x, y, z].map(|text| coordinate(text, name).map_err(in_line));
        let [x, y, z] = numbers;
        table.add(name, &[x?, y?, z?]).map_err(in_line)?;
        if rest.iter().any(|field| !field.is_empty()) {
            table
                .others
                .push(format!("further columns of {}", shown(name)));
        }
    }
    Ok(table)
}

/// A list or a map of YAML that is open.
struct Open {
    /// The name of what is within it.
    path: String,
    /// `None` for a list.
    key: Option<Option<String>>,
    numbers: Vec<Decimal>,
    /// Coordinates by their names.
    by_axis: [Option<Decimal>; 3],
}

/// Reads YAML (or JSON): lists of three numbers, or maps of x, y and z. Names of maps around a point
/// are in front of its name.
pub(super) fn yaml(text: &str) -> Result<Table, ImportError> {
    let mut parser = Parser::new_from_str(text);
    let mut table = Table::default();
    let mut open: Vec<Open> = Vec::new();
    while let Some(event) = parser.next_event() {
        let (event, _) =
            event.map_err(|error| ImportError::new(format!("the YAML is broken: {error}")))?;
        match event {
            Event::Alias(_) => {
                return Err(ImportError::new(
                    "the YAML repeats a part by its name (`*`), which is not read",
                ));
            }
            Event::SequenceStart(..) | Event::MappingStart(..) => {
                if open.len() >= DEEPEST {
                    return Err(ImportError::new("lists of the YAML are nested too deeply"));
                }
                let path = match open.last_mut() {
                    None => String::new(),
                    Some(around) => path(around),
                };
                let is_map = matches!(event, Event::MappingStart(..));
                open.push(Open {
                    path,
                    key: is_map.then_some(None),
                    numbers: Vec::new(),
                    by_axis: [None; 3],
                });
            }
            Event::Scalar(text, ..) => {
                if let Some(inner) = open.last_mut() {
                    scalar(inner, &text, &mut table)?;
                }
            }
            Event::SequenceEnd | Event::MappingEnd => {
                if let Some(closed) = open.pop() {
                    match closed.by_axis {
                        [Some(x), Some(y), Some(z)] => table.add(&closed.path, &[x, y, z])?,
                        _ if closed.numbers.is_empty() => {}
                        _ => table.add(&closed.path, &closed.numbers)?,
                    }
                }
            }
            _ => {}
        }
    }
    Ok(table)
}

/// The name of a list or map within another one.
fn path(around: &mut Open) -> String {
    let key = match &mut around.key {
        Some(key) => key.take().unwrap_or_default(),
        None => String::new(),
    };
    match (around.path.is_empty(), key.is_empty()) {
        (true, _) => key,
        (false, true) => around.path.clone(),
        (false, false) => format!("{}_{key}", around.path),
    }
}

/// A key, a value or a number of a list.
fn scalar(inner: &mut Open, text: &str, table: &mut Table) -> Result<(), ImportError> {
    if let Some(None) = inner.key {
        inner.key = Some(Some(text.to_owned()));
        return Ok(());
    }
    let is_list = inner.key.is_none();
    let key = match &mut inner.key {
        Some(key) => key.take().unwrap_or_default(),
        None => String::new(),
    };
    let is_number = text.trim().parse::<f64>().is_ok();
    let axis = ["x", "y", "z"]
        .iter()
        .position(|axis| key.eq_ignore_ascii_case(axis));
    let name = if is_list { inner.path.clone() } else { key };
    match (is_list, is_number, axis) {
        (true, true, _) if inner.numbers.len() < MOST_POINTS => {
            inner.numbers.push(coordinate(text, &name)?);
        }
        (false, true, Some(axis)) => inner.by_axis[axis] = Some(coordinate(text, &name)?),
        _ => table
            .others
            .push(format!("{}: {}", shown(&name), shown(text))),
    }
    Ok(())
}
