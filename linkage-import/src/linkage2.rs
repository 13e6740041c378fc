//! Files `.linkage2` of the program Linkage.
//!
//! Positions are stored with six decimals in 1/96 inch, whatever unit the file names: the unit is
//! that of the display. There are no lengths. Positive speeds turn clockwise.

use std::collections::BTreeMap;

use crate::document::{Document, FRAME, LengthUnit};
use crate::error::ImportError;
use crate::names::{in_comment, shown};
use crate::number::{decimal, half_digit, plain, rounded};
use crate::xml::{self, XmlElement};

mod attributes;
mod fastened;
mod limits;
mod motors;
mod sheet;

use sheet::{Sheet, identifier, is_mechanism, is_true, named};

/// The digits after the point that the program writes.
const DECIMALS: usize = 6;
const UNITS_PER_INCH: f64 = 96.0;
const MILLIMETRES_PER_INCH: f64 = 25.4;

/// Reads a file.
pub(crate) fn read(content: &[u8]) -> Result<Document, ImportError> {
    let text = String::from_utf8_lossy(content);
    let root = xml::read(text.trim_start_matches('\u{feff}'))?;
    if root.name != "linkage2" {
        return Err(ImportError::new(format!(
            "the root of the XML is `{}`, not `linkage2`",
            shown(&root.name)
        )));
    }
    let (unit, scale) = unit(&root);
    let mut document = Document::new("a file of the program Linkage", unit);
    document.band = half_digit(DECIMALS) * scale;
    document.remarks.push(format!(
        "The file has positions with {DECIMALS} decimals in 1/96 inch, whatever unit it names, and \
         no lengths."
    ));
    let mut sheet = Sheet {
        root: &root,
        document,
        scale,
        joints: BTreeMap::new(),
        bodies: Vec::new(),
    };
    scale_factor(&mut sheet)?;
    attributes::name_unknown(&root, &mut sheet.document);
    connectors(&mut sheet)?;
    fastened::read(&mut sheet)?;
    limits::read(&mut sheet)?;
    motors::read(&mut sheet)?;
    Ok(sheet.document)
}

/// Returns the unit of the display, and the length of a unit of the file in it.
fn unit(root: &XmlElement) -> (LengthUnit, f64) {
    let mut programs = root.named("program");
    let units = programs.find_map(|program| program.attribute("units"));
    if units.is_some_and(|units| units.eq_ignore_ascii_case("inches")) {
        (LengthUnit::Inch, 1.0 / UNITS_PER_INCH)
    } else {
        (
            LengthUnit::Millimetre,
            MILLIMETRES_PER_INCH / UNITS_PER_INCH,
        )
    }
}

/// The scale factor is written with decimals and read as an integer by the program: it is named,
/// and lengths are those without it.
fn scale_factor(sheet: &mut Sheet) -> Result<(), ImportError> {
    let mut programs = sheet.root.named("program");
    let Some(text) = programs.find_map(|program| program.attribute("scalefactor")) else {
        return Ok(());
    };
    let factor = decimal(text, "`scalefactor`")?.value;
    if factor != 1.0 {
        sheet.document.warnings.push(format!(
            "the scale factor {} is not used, and the program itself reads only its whole part: \
             confirm the largest distance",
            plain(factor)
        ));
    }
    Ok(())
}

/// Reads the connectors of the mechanism.
fn connectors(sheet: &mut Sheet) -> Result<(), ImportError> {
    let mut drawn = 0;
    let mut tracers = Vec::new();
    for connector in sheet.root.named("connector") {
        if !is_mechanism(connector) {
            drawn += 1;
            continue;
        }
        let id = identifier(connector)?;
        if sheet.joints.contains_key(&id) {
            return Err(ImportError::new(format!("two connectors have the id {id}")));
        }
        let coordinate = |name: &str| -> Result<f64, ImportError> {
            let text = connector.attribute(name).ok_or_else(|| {
                ImportError::new(format!("connector {id} has no attribute `{name}`"))
            })?;
            let value = decimal(text, &format!("`{name}` of connector {id}"))?.value;
            Ok(rounded(value * sheet.scale, sheet.document.band))
        };
        let position = [coordinate("x")?, coordinate("y")?];
        let name = named(connector).unwrap_or_else(|| format!("c{id}"));
        let joint = sheet.document.add_joint(&name, position);
        sheet.joints.insert(id, joint);
        // An input holds its connector as an anchor does.
        if is_true(connector, "anchor") || is_true(connector, "input") {
            sheet.document.attach(joint, FRAME);
        }
        if is_true(connector, "draw") {
            tracers.push(in_comment(&name));
        }
    }
    if sheet.joints.is_empty() {
        return Err(ImportError::new("the file has no connectors"));
    }
    if !tracers.is_empty() {
        let tracers = tracers.join(", ");
        let remark = format!("The program draws the paths of {tracers}.");
        sheet.document.remarks.push(remark);
    }
    if drawn > 0 {
        sheet.document.remarks.push(format!(
            "{drawn} connectors of drawing layers are no part of the mechanism and left out."
        ));
    }
    Ok(())
}
