//! The sections of a payload: settings, joints, links, forces, and a tail of corrections.

use crate::document::{LengthUnit, MOST_JOINTS, MOST_LINKS};
use crate::error::ImportError;
use crate::names::shown;

use super::corrections;
use super::page_drawing::{Drawing, PageForce, PageJoint, PageLink};
use super::record::{Record, digit, whole};

/// The first characters of links: whether they are roots, and not parts of welded links.
const ROOTS: &str = "YAMG0123";
const PARTS: &str = "Namg4567";

/// Reads all sections.
pub(super) fn read(body: &str) -> Result<Drawing, ImportError> {
    let mut sections = body.split('.');
    let mut drawing = Drawing::default();
    settings(&mut sections, &mut drawing)?;
    for text in sections.by_ref().take_while(|text| !text.is_empty()) {
        drawing.joints.push(joint(text)?);
        if drawing.joints.len() > MOST_JOINTS {
            return Err(ImportError::new(format!("more than {MOST_JOINTS} joints")));
        }
    }
    for text in sections.by_ref().take_while(|text| !text.is_empty()) {
        drawing.links.push(link(text)?);
        if drawing.links.len() > MOST_LINKS {
            return Err(ImportError::new(format!("more than {MOST_LINKS} links")));
        }
    }
    for text in sections.by_ref().take_while(|text| !text.is_empty()) {
        drawing.forces.push(force(text)?);
    }
    // The object that is selected comes first, then the tail.
    let _selected = sections.next();
    // Numbers of the tail have points.
    let rest: Vec<&str> = sections.collect();
    for entry in rest.join(".").split(',') {
        corrections::read(entry, &mut drawing)?;
    }
    if drawing.joints.is_empty() {
        return Err(ImportError::new("the address has no joints"));
    }
    Ok(drawing)
}

fn settings<'t>(
    sections: &mut impl Iterator<Item = &'t str>,
    drawing: &mut Drawing,
) -> Result<(), ImportError> {
    let mut section = || {
        sections
            .next()
            .filter(|text| !text.is_empty())
            .ok_or_else(|| {
                ImportError::new("the address has no settings: it is not one of PMKS+ pages")
            })
    };
    let wrong = |text: &str| {
        ImportError::new(format!(
            "the settings `{}` of the address cannot be read",
            shown(text)
        ))
    };
    // The sense of motors is the lowest flag.
    let flags = section()?;
    let last = flags.chars().next_back().and_then(digit);
    drawing.is_clockwise = last.ok_or_else(|| wrong(flags))? & 1 != 0;
    let _scale = section()?;
    let numbers = section()?;
    let speed = numbers.split(',').next().unwrap_or_default();
    drawing.speed = whole(speed).ok_or_else(|| wrong(numbers))?;
    let words = section()?;
    drawing.unit = match words.chars().next() {
        Some('0') => Some(LengthUnit::Inch),
        Some('1') => Some(LengthUnit::Centimetre),
        Some('2') => Some(LengthUnit::Metre),
        _ => return Err(wrong(words)),
    };
    drawing.force_unit = match words.chars().nth(2) {
        Some('0') => Some("lbf"),
        Some('1') => Some("N"),
        _ => None,
    };
    Ok(())
}

fn joint(text: &str) -> Result<PageJoint, ImportError> {
    let (flags, text) = first(text)?;
    let flag = |bit: usize| flags >> bit & 1 != 0;
    let mut record = Record::new(text);
    let mut joint = PageJoint {
        id: record.text().to_owned(),
        name: record.text().to_owned(),
        position: [record.decimal()?, record.decimal()?],
        angle: record.optional()?,
        is_slide: flag(0),
        is_input: flag(1),
        is_grounded: flag(2),
        is_welded: flag(3),
        is_sealed: flag(5),
        ..PageJoint::default()
    };
    let carrier = [record.text(), record.text(), record.text()];
    if carrier.iter().all(|token| !token.is_empty()) {
        joint.carrier = Some(carrier.map(str::to_owned));
    } else if carrier.iter().any(|token| !token.is_empty()) {
        return Err(ImportError::new(format!(
            "the slot of joint `{}` has no link or lacks a joint",
            shown(&joint.id)
        )));
    }
    joint.speed = record.optional()?;
    joint.mass = record.optional()?;
    if joint.id.is_empty() {
        return Err(ImportError::new("a joint of the address has no name"));
    }
    Ok(joint)
}

/// Returns the value of the first character, and the rest.
fn first(text: &str) -> Result<(usize, &str), ImportError> {
    let mut letters = text.chars();
    let flags = letters.next().and_then(digit).ok_or_else(|| {
        ImportError::new(format!(
            "the record `{}` of the address cannot be read",
            shown(text)
        ))
    })?;
    Ok((flags, letters.as_str()))
}

fn link(text: &str) -> Result<PageLink, ImportError> {
    let mut letters = text.chars();
    let kind = letters.next().unwrap_or_default();
    let block = letters.next().unwrap_or_default();
    if !(ROOTS.contains(kind) || PARTS.contains(kind)) || !"RP".contains(block) {
        return Err(ImportError::new(format!(
            "the record `{}` of the address is no link",
            shown(text)
        )));
    }
    let mut record = Record::new(letters.as_str());
    let mut link = PageLink {
        id: record.text().to_owned(),
        name: record.text().to_owned(),
        is_root: ROOTS.contains(kind),
        is_block: block == 'P',
        mass: record.optional()?,
        inertia: record.optional()?,
        centre: [record.optional()?, record.optional()?],
        ..PageLink::default()
    };
    let _colour = record.text();
    for list in [&mut link.joints, &mut link.parts] {
        loop {
            match record.text() {
                "" => break,
                id => list.push(id.to_owned()),
            }
        }
    }
    Ok(link)
}

fn force(text: &str) -> Result<PageForce, ImportError> {
    let (flags, text) = first(text)?;
    let mut record = Record::new(text);
    let (id, link) = (record.text().to_owned(), record.text().to_owned());
    let _name = record.text();
    Ok(PageForce {
        id,
        link,
        start: [record.decimal()?, record.decimal()?],
        end: [record.decimal()?, record.decimal()?],
        size: record.decimal()?,
        turns: flags & 1 != 0,
        points_away: flags & 2 != 0,
    })
}
