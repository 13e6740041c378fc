//! Expressions of Pyslvs: `M[J[R, color[Green], P[0.0, 0.0], L[ground, link_1]], ...]`.
//!
//! `P` and `RP` joints have the link with the slot first. The links behind it have the pin: with
//! `P` none of them turns in the slot, so that they are one body. Angles are in degrees. The
//! program writes four decimals and cuts zeros at their end. Expressions have no inputs.

use std::collections::BTreeMap;

use crate::document::{Document, FRAME, LengthUnit, MOST_JOINTS, Slot, SlotPath};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::{Decimal, decimal, half_digit};

/// The digits after the point that the program writes.
const DECIMALS: usize = 4;

/// Reads an expression.
pub(crate) fn read(content: &[u8]) -> Result<Document, ImportError> {
    let text = String::from_utf8_lossy(content);
    let text = without_comments(&text);
    let mut cursor = Cursor { rest: text.trim() };
    // In files of programs, the expression is a text between quotes, in pieces on several lines.
    let joined = text.replace(['"', '\''], " ");
    let is_inside = !cursor.rest.starts_with("M[");
    if is_inside {
        let start = joined
            .find("M[")
            .ok_or_else(|| ImportError::new("the file has no expression: `M[` is missing"))?;
        cursor.rest = &joined[start..];
    }
    let mut document = Document::new("an expression of Pyslvs", LengthUnit::Millimetre);
    document.warnings.push(
        "expressions have no unit: millimetres are taken, confirm the largest distance".to_owned(),
    );
    let mut sheet = Sheet {
        links: BTreeMap::from([("ground".to_owned(), FRAME)]),
        one_body: Vec::new(),
        decimals: 0,
        document,
    };
    cursor.expect("M[")?;
    while !cursor.takes("]") {
        joint(&mut cursor, &mut sheet)?;
        if !cursor.takes(",") {
            cursor.expect("]")?;
            break;
        }
    }
    let around = |letter: char| letter.is_alphanumeric();
    let before = joined.split("M[").next().unwrap_or_default();
    if cursor.rest.contains(around) || (is_inside && before.contains(around)) {
        sheet.document.warnings.push(
            "the text around the expression is not read: inputs of a project are there".to_owned(),
        );
    }
    unite(&mut sheet);
    if sheet.document.joints.is_empty() {
        return Err(ImportError::new("the expression has no joints"));
    }
    // The program cuts zeros, so that no number tells its digits alone.
    sheet.document.band = half_digit(sheet.decimals.max(DECIMALS));
    sheet.document.remarks.push(format!(
        "Coordinates have {} decimals, and zeros at their end are cut.",
        sheet.decimals.max(DECIMALS)
    ));
    Ok(sheet.document)
}

struct Sheet {
    links: BTreeMap<String, usize>,
    /// Pairs of links that do not turn against each other.
    one_body: Vec<[usize; 2]>,
    decimals: usize,
    document: Document,
}

/// Replaces comments, `# ...` and `#[ ... #]`, by spaces.
fn without_comments(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some(start) = rest.find('#') {
        plain.push_str(&rest[..start]);
        plain.push(' ');
        let comment = &rest[start..];
        let end = if comment.starts_with("#[") {
            comment.find("#]").map(|end| end + 2)
        } else {
            comment.find('\n')
        };
        rest = &comment[end.unwrap_or(comment.len())..];
    }
    plain + rest
}

/// A text of which the beginning is taken.
struct Cursor<'t> {
    rest: &'t str,
}

impl<'t> Cursor<'t> {
    fn takes(&mut self, word: &str) -> bool {
        self.rest = self.rest.trim_start();
        let rest = self.rest.strip_prefix(word);
        if let Some(rest) = rest {
            self.rest = rest;
        }
        rest.is_some()
    }

    fn expect(&mut self, word: &str) -> Result<(), ImportError> {
        if self.takes(word) {
            return Ok(());
        }
        let here: String = self.rest.chars().take(30).collect();
        let here = if here.is_empty() {
            "the end".to_owned()
        } else {
            format!("`{}`", shown(&here))
        };
        Err(ImportError::new(format!(
            "the expression has {here} where `{word}` is expected"
        )))
    }

    /// Takes all up to one of the letters.
    fn until(&mut self, ends: &[char]) -> &'t str {
        self.rest = self.rest.trim_start();
        let end = self.rest.find(ends).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word.trim()
    }

    fn number(&mut self, name: &str) -> Result<Decimal, ImportError> {
        decimal(self.until(&[',', ']']), name)
    }
}

fn joint(cursor: &mut Cursor, sheet: &mut Sheet) -> Result<(), ImportError> {
    cursor.expect("J[")?;
    let index = sheet.document.joints.len();
    if index >= MOST_JOINTS {
        return Err(ImportError::new(format!("more than {MOST_JOINTS} joints")));
    }
    let kind = cursor.until(&[',', ']']);
    if !["R", "P", "RP"].contains(&kind) {
        return Err(ImportError::new(format!(
            "joint {index} is of the kind `{}`; there are R, P and RP",
            shown(kind)
        )));
    }
    cursor.expect(",")?;
    let mut angle = None;
    if cursor.takes("A[") {
        angle = Some(cursor.number(&format!("the angle of joint {index}"))?.value);
        cursor.expect("]")?;
        cursor.expect(",")?;
    }
    if cursor.takes("color[") {
        // A name, or three numbers in brackets.
        cursor.until(&[']']);
        cursor.expect("]")?;
        cursor.expect(",")?;
    }
    cursor.expect("P[")?;
    let x = cursor.number(&format!("x of joint {index}"))?;
    cursor.expect(",")?;
    let y = cursor.number(&format!("y of joint {index}"))?;
    cursor.expect("]")?;
    cursor.expect(",")?;
    sheet.decimals = sheet.decimals.max(x.decimals).max(y.decimals);
    let pin = sheet
        .document
        .add_joint(format!("p{index}"), [x.value, y.value]);
    let links = names(cursor, sheet)?;
    cursor.expect("]")?;
    if kind == "R" {
        for link in links {
            sheet.document.attach(pin, link);
        }
        return Ok(());
    }
    slide(sheet, pin, kind, angle, &links)
}

/// Reads `L[...]` and returns its links.
fn names(cursor: &mut Cursor, sheet: &mut Sheet) -> Result<Vec<usize>, ImportError> {
    cursor.expect("L[")?;
    let mut links = Vec::new();
    while !cursor.takes("]") {
        let name = cursor.until(&[',', ']']);
        if name.is_empty() || name.contains('[') {
            return Err(ImportError::new("a link of the expression has no name"));
        }
        let document = &mut sheet.document;
        let link = *sheet
            .links
            .entry(name.to_owned())
            .or_insert_with(|| document.add_link(name, Vec::new()));
        links.push(link);
        if !cursor.takes(",") {
            cursor.expect("]")?;
            break;
        }
    }
    Ok(links)
}

fn slide(
    sheet: &mut Sheet,
    pin: usize,
    kind: &str,
    angle: Option<f64>,
    links: &[usize],
) -> Result<(), ImportError> {
    let document = &mut sheet.document;
    let (Some(angle), Some((guide, others))) = (angle, links.split_first()) else {
        return Err(ImportError::new(format!(
            "the sliding joint {pin} has no angle or no link"
        )));
    };
    for link in others {
        document.attach(pin, *link);
    }
    let block = others.first().copied().filter(|_| kind == "P");
    if let (Some(first), "P") = (block, kind) {
        let pairs = others.iter().skip(1).map(|other| [first, *other]);
        sheet.one_body.extend(pairs);
    }
    document.slots.push(Slot {
        pin,
        guide: *guide,
        path: SlotPath::Direction(
            angle.to_radians(),
            format!("{}deg", crate::number::plain(angle)),
            None,
        ),
        block,
    });
    Ok(())
}

/// Moves the joints of links to those that are one body with them.
fn unite(sheet: &mut Sheet) {
    let document = &mut sheet.document;
    for [first, other] in std::mem::take(&mut sheet.one_body) {
        if other == FRAME || first == other {
            continue;
        }
        for joint in std::mem::take(&mut document.links[other].joints) {
            document.attach(joint, first);
        }
        for slot in &mut document.slots {
            for link in slot.block.iter_mut().chain([&mut slot.guide]) {
                if *link == other {
                    *link = first;
                }
            }
        }
        let [first, other] = [first, other].map(|link| shown(&document.links[link].name));
        document.remarks.push(format!(
            "`{first}` and `{other}` do not turn in the same slot: they are one body."
        ));
    }
}
