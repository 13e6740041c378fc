//! Inputs for files that name none, and inputs that the user names.

use crate::document::{Document, FRAME, Input, InputKind};
use crate::error::ImportError;
use crate::mobility::mobility;
use crate::names::shown;

/// Takes the inputs that the user names: a pivot and another joint of the link that turns, or a
/// joint that has a slot. Without them, doubts about those of the file become warnings.
pub(crate) fn named(document: &mut Document, pairs: &[String]) -> Result<(), ImportError> {
    let doubts = std::mem::take(&mut document.doubts);
    if pairs.is_empty() {
        document.warnings.extend(doubts);
        return Ok(());
    }
    document.inputs.clear();
    for pair in pairs {
        let kind = match pair.split_once(',') {
            Some((pivot, other)) => crank(document, pair, [pivot, other])?,
            None => slide(document, pair)?,
        };
        document.inputs.push(Input {
            kind,
            travel: None,
            speed: None,
            rate: None,
        });
    }
    Ok(())
}

/// Returns the link that turns about the first joint of a pair and has the second one.
fn crank(document: &Document, pair: &str, names: [&str; 2]) -> Result<InputKind, ImportError> {
    let pivot = joint(document, names[0].trim())?;
    let other = joint(document, names[1].trim())?;
    let links = document.links_of(pivot);
    let is_turned =
        |link: &&usize| **link != FRAME && document.links[**link].joints.contains(&other);
    let link = links.iter().find(is_turned).copied();
    let base = links.iter().find(|base| Some(**base) != link).copied();
    let (Some(link), Some(base)) = (link, base) else {
        return Err(ImportError::new(format!(
            "no link turns about the first joint of `{}` and has the second one",
            shown(pair)
        )));
    };
    Ok(InputKind::Crank { link, pivot, base })
}

/// Returns the position of a joint in its slot.
fn slide(document: &Document, name: &str) -> Result<InputKind, ImportError> {
    let pin = joint(document, name.trim())?;
    let mut slots = document.slots.iter();
    let slot = slots.position(|slot| slot.pin == pin).ok_or_else(|| {
        ImportError::new(format!(
            "the input `{}` is no pair, and the joint has no slot\nhelp: give a pivot and another \
             joint of the link that turns, with a comma between them, or a joint that has a slot",
            shown(name)
        ))
    })?;
    Ok(InputKind::Position { slot })
}

fn joint(document: &Document, name: &str) -> Result<usize, ImportError> {
    let mut joints = document.joints.iter();
    joints.position(|joint| joint.name == name).ok_or_else(|| {
        let names = document.joints.iter().filter(|joint| !joint.is_derived);
        let names: Vec<String> = names.take(40).map(|joint| shown(&joint.name)).collect();
        ImportError::new(format!(
            "there is no joint `{}`; there are {}",
            shown(name),
            names.join(", ")
        ))
    })
}

/// The greatest number of inputs that are tried.
const MOST_TRIED: usize = 40;

/// Chooses cranks, then slots of the frame, until nothing is free. A warning names each.
pub(crate) fn missing(document: &mut Document) {
    if !document.inputs.is_empty() {
        return;
    }
    let mut chosen: Vec<InputKind> = Vec::new();
    let Some(mut free) = mobility(document, &chosen) else {
        return;
    };
    for candidate in candidates(document).into_iter().take(MOST_TRIED) {
        if free == 0 {
            break;
        }
        chosen.push(candidate);
        match mobility(document, &chosen) {
            Some(left) if left < free => free = left,
            _ => {
                chosen.pop();
            }
        }
    }
    for kind in chosen {
        let name = match kind {
            InputKind::Crank { link, pivot, .. } => format!(
                "the link `{}` about `{}`",
                shown(&document.links[link].name),
                shown(&document.joints[pivot].name)
            ),
            InputKind::Position { slot } => {
                let pin = document.slots[slot].pin;
                format!("the slot of `{}`", shown(&document.joints[pin].name))
            }
            InputKind::Length { link } => format!("`{}`", shown(&document.links[link].name)),
        };
        document.warnings.push(format!(
            "the file names no input: {name} is chosen; `--input PIVOT,JOINT` names another one"
        ));
        document.inputs.push(Input {
            kind,
            travel: None,
            speed: None,
            rate: None,
        });
    }
}

/// Returns links on fixed pivots in the order of the pivots, then slots of the frame.
fn candidates(document: &Document) -> Vec<InputKind> {
    let pivots = (0..document.joints.len()).filter(|joint| document.is_fixed(*joint));
    let cranks = pivots.flat_map(|pivot| {
        let links = document.links_of(pivot).into_iter();
        let links = links.filter(|link| *link != FRAME);
        links.map(move |link| InputKind::Crank {
            link,
            pivot,
            base: FRAME,
        })
    });
    let slots = document.slots.iter().enumerate();
    let slots = slots.filter(|(_, slot)| slot.guide == FRAME);
    let slots = slots.map(|(slot, _)| InputKind::Position { slot });
    cranks.chain(slots).collect()
}
