//! Bodies that hang on nothing but their slot, as bodies of the mechanics: a block hangs on the pin, and
//! the body with the slot slides on the block.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use super::link_bodies::{body_item, body_name, end_of};
use super::linkage::{FRAME, Slider};
use super::locations::point;
use super::nodes::{call, ident};
use super::sheet::Sheet;
use super::slides::slot_angle;
use crate::model::types::Function;
use crate::syntax::{BodyItem, Item, JointKind, JointPart, Member};

/// Returns a body whose slot gives it its position, and the block on which it slides. The joint of the
/// slider's name is the pin of a block without mass, or the slide on the link that is the block.
pub(super) fn items(
    sheet: &Sheet,
    body: usize,
    from: usize,
    slider: &Slider,
    taken: &mut BTreeSet<String>,
) -> Vec<Item> {
    let name = &slider.name;
    taken.insert(name.to_string());
    match slider.block {
        Some(link) => {
            let block = body_name(sheet, sheet.bodies.of_link[link]);
            let slide = slide(sheet, from, slider, Some(name.clone()), block);
            vec![body_item(sheet, body, slide)]
        }
        None => {
            let block = block(sheet, slider);
            let slide = slide(sheet, from, slider, None, &block.name);
            vec![Item::Body(block), body_item(sheet, body, slide)]
        }
    }
}

/// Returns the block of a pin. It turns with the slot.
fn block(sheet: &Sheet, slider: &Slider) -> BodyItem {
    let name = slider.name.clone();
    let seat = sheet.plan.seats[slider.pin].unwrap_or(FRAME);
    BodyItem {
        name: ident(&format!("{name}_block"), name.span()),
        joint: JointPart {
            kind: JointKind::Pin,
            span: (&name).into(),
            name: Some(name),
            on: Member::from(&end_of(sheet, seat, slider.pin)),
            at: point(sheet.linkage, slider.pin),
            direction: None,
        },
        turns: Some(slot_angle(
            sheet.linkage,
            sheet.bodies,
            slider,
            sheet.drawing,
        )),
        masses: Vec::new(),
        inertias: Vec::new(),
    }
}

/// Returns the joint in which a body slides on a block.
fn slide(
    sheet: &Sheet,
    from: usize,
    slider: &Slider,
    name: Option<Ident>,
    block: &Ident,
) -> JointPart {
    let angle = slot_angle(sheet.linkage, sheet.bodies, slider, sheet.drawing);
    JointPart {
        kind: JointKind::Slide,
        span: (&slider.name).into(),
        name,
        on: Member::from(block),
        at: point(sheet.linkage, from),
        direction: Some(call(Function::Dir, vec![angle])),
    }
}
