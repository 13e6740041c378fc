//! Tables of joints as CSV: `name,kind,x,y,links`, with a line for each joint.
//!
//! `links` are names between spaces; `frame` or `ground` is the fixed link. Kinds are `pin`,
//! `motor` (a pin whose second link is driven against the first one), `slot` (a pin in a slot of
//! the first link) and `block` (the same, and the second link does not turn in the slot). A column
//! `along` has the direction of a slot: degrees, or two joints of the link. A column `input` marks
//! the slots that are driven. Rows of the kind `cylinder` have no position: their links are two
//! joints.

use std::collections::BTreeMap;

use csv::{ReaderBuilder, StringRecord};

use crate::csv_lines::line_number;
use crate::document::{Document, FRAME, Input, InputKind, LengthUnit, MOST_JOINTS, Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{decimal, half_digit, with_point};

mod single_links;

use single_links::JointLinks;

const COLUMNS: [&str; 5] = ["name", "kind", "x", "y", "links"];
const OTHER_COLUMNS: [&str; 2] = ["along", "input"];

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

struct Table {
    document: Document,
    columns: BTreeMap<String, usize>,
    joints: BTreeMap<String, usize>,
    links: BTreeMap<String, usize>,
    decimals: usize,
    separator: u8,
    has_points: bool,
    has_commas: bool,
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

/// Returns the name of a column: its title up to a unit.
fn column_name(title: &str) -> &str {
    let is_end = |letter: char| "([/".contains(letter) || letter.is_whitespace();
    title.split(is_end).next().unwrap_or_default()
}

/// Returns the first column that the header lacks.
fn missing_column(header: &StringRecord) -> Option<&'static str> {
    let titles: Vec<String> = header.iter().map(str::to_ascii_lowercase).collect();
    let is_missing = |name: &&str| titles.iter().all(|title| column_name(title) != *name);
    COLUMNS.into_iter().find(|name| is_missing(name))
}

/// Returns true if one of the first two rows is a name and three numbers.
fn has_points(text: &str, separator: u8) -> bool {
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
fn table(header: &StringRecord, separator: u8) -> Result<Table, ImportError> {
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

impl Table {
    fn cell<'t>(&self, row: &'t StringRecord, name: &str) -> &'t str {
        let column = self.columns.get(name);
        column.and_then(|column| row.get(*column)).unwrap_or("")
    }

    fn joint(&self, name: &str) -> Result<usize, ImportError> {
        let joint = self.joints.get(name).copied();
        joint.ok_or_else(|| ImportError::new(format!("there is no joint `{}`", shown(name))))
    }
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

fn connect(table: &mut Table, row: &StringRecord) -> Result<(), ImportError> {
    let name = table.cell(row, "name").to_owned();
    let kind = table.cell(row, "kind").to_ascii_lowercase();
    let names = table.cell(row, "links").split_whitespace();
    let names: Vec<String> = names.map(str::to_owned).collect();
    if kind == "cylinder" {
        return cylinder(table, &name, &names);
    }
    let pin = table.joint(&name)?;
    let mut links = Vec::new();
    for name in names {
        let document = &mut table.document;
        let link = table
            .links
            .entry(name)
            .or_insert_with_key(|name| document.add_link(name.clone(), Vec::new()));
        links.push(*link);
    }
    let is_slot = kind == "slot" || kind == "block";
    for link in links.iter().skip(usize::from(is_slot)) {
        table.document.attach(pin, *link);
    }
    match &kind[..] {
        "" | "pin" | "r" => Ok(()),
        "motor" => motor(table, &name, pin, &links),
        "slot" | "block" => slot(table, row, pin, &links, kind == "block"),
        other => Err(ImportError::new(format!(
            "`{}` is of the kind `{}`\nhelp: kinds are pin, motor, slot, block and cylinder",
            shown(&name),
            shown(other)
        ))),
    }
}

/// Drives the second link against the first one. The fixed link never turns: it is the first.
fn motor(table: &mut Table, name: &str, pivot: usize, links: &[usize]) -> Result<(), ImportError> {
    let (base, link) = match *links {
        [turned, FRAME, ..] if turned != FRAME => {
            table.document.warnings.push(format!(
                "the motor `{}` names the fixed link second: the angle of `{}` is taken, which has \
                 the opposite sign",
                shown(name),
                shown(&table.document.links[turned].name)
            ));
            (FRAME, turned)
        }
        [base, link, ..] => (base, link),
        _ => {
            return Err(ImportError::new(format!(
                "the motor `{}` needs two links, the fixed one first",
                shown(name)
            )));
        }
    };
    table.document.inputs.push(Input {
        kind: InputKind::Crank { link, pivot, base },
        travel: None,
        speed: None,
        rate: None,
    });
    Ok(())
}

fn slot(
    table: &mut Table,
    row: &StringRecord,
    pin: usize,
    links: &[usize],
    is_block: bool,
) -> Result<(), ImportError> {
    let name = shown(table.cell(row, "name"));
    let along = table.cell(row, "along");
    if along.is_empty() {
        return Err(ImportError::new(format!(
            "the slot `{name}` has no `along`\nhelp: it is the direction in degrees, or two joints \
             of the link that has the slot"
        )));
    }
    let path = if let Some((first, second)) = along.split_once(char::is_whitespace) {
        SlotPath::Joints(table.joint(first)?, table.joint(second.trim())?)
    } else {
        let angle = decimal(
            &with_point(along, table.separator),
            &format!("`along` of `{name}`"),
        )?
        .value;
        SlotPath::Direction(
            angle.to_radians(),
            format!("{}deg", crate::number::plain(angle)),
            None,
        )
    };
    let (Some(guide), block) = (links.first().copied(), links.get(1).copied()) else {
        return Err(ImportError::new(format!(
            "the slot `{name}` needs its link"
        )));
    };
    if is_block && block.is_none() {
        return Err(ImportError::new(format!(
            "the block `{name}` needs two links"
        )));
    }
    table.document.slots.push(Slot {
        pin,
        guide,
        path,
        block: block.filter(|_| is_block),
    });
    if !table.cell(row, "input").is_empty() {
        table.document.inputs.push(Input {
            kind: InputKind::Position {
                slot: table.document.slots.len() - 1,
            },
            travel: None,
            speed: None,
            rate: None,
        });
    }
    Ok(())
}

fn cylinder(table: &mut Table, name: &str, joints: &[String]) -> Result<(), ImportError> {
    let [first, second] = joints else {
        return Err(ImportError::new(format!(
            "the cylinder `{}` needs two joints in the column `links`",
            shown(name)
        )));
    };
    let ends = vec![table.joint(first)?, table.joint(second)?];
    let link = table.document.add_link(name, ends);
    table.document.inputs.push(Input {
        kind: InputKind::Length { link },
        travel: None,
        speed: None,
        rate: None,
    });
    Ok(())
}
