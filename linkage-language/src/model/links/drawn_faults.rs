//! Mistakes in a drawing: joints at one place, pins beside their slots, lengths that the drawing
//! contradicts.

use super::drawing::{DRAWN_APART, nominal};
use super::driven_angles::report_driven_twice;
use super::linkage::FRAME;
use super::printed::in_millimetres;
use super::sheet::Sheet;
use super::slides::{drawn_in_slot, start_joint};
use super::wheel_faults::report_wheels;
use crate::diagnostic::Diagnostics;

/// Reports the mistakes of a drawing in the plane.
pub(super) fn report(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    report_driven_twice(sheet.linkage, sheet.bodies, diagnostics);
    report_joints_at_one_place(sheet, diagnostics);
    report_cylinders(sheet, diagnostics);
    report_lengths_of_welds(sheet, diagnostics);
    report_pins_beside_slots(sheet, diagnostics);
    report_starts_of_slots(sheet, diagnostics);
    report_wheels(sheet, diagnostics);
}

fn report_joints_at_one_place(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    let linkage = sheet.linkage;
    for link in &linkage.links[FRAME + 1..] {
        let [first, second, ..] = link.joints[..] else {
            continue;
        };
        if link.length.is_none() && sheet.are_at_one_place(first, second) {
            let [one, other] = [first, second].map(|joint| &linkage.joints[joint].name);
            let fact = format!(
                "`{one}` and `{other}` of `{}` are drawn at one place",
                link.name
            );
            let help =
                "draw one of them elsewhere; bodies that meet in a joint name the same joint";
            diagnostics.error_with_help((&link.name).into(), fact, help);
        }
    }
}

fn report_cylinders(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    for link in &sheet.linkage.links[FRAME + 1..] {
        let ([first, second, ..], Some(given)) = (&link.joints[..], link.length) else {
            continue;
        };
        let length = nominal(given);
        if sheet.drawing.is_constant(&length) {
            continue;
        }
        let reference = sheet.drawing.number(&sheet.drawing.at_reference(&length));
        let drawn = sheet.drawing.distance(*first, *second);
        if let (Some(reference), Some(drawn)) = (reference, drawn)
            && (reference - drawn).abs() > DRAWN_APART * reference.abs().max(drawn)
        {
            let [reference, drawn] = [reference, drawn].map(in_millimetres);
            let fact = format!(
                "`{}` is drawn with a length of {drawn} mm, but has {reference} mm at the reference of its input",
                link.name
            );
            let help = "change the reference of the input, or draw the link with this length";
            diagnostics.error_with_help((&link.name).into(), fact, help);
        }
    }
}

/// Reports lengths of links that are welded to an earlier one: the drawing places their joints.
fn report_lengths_of_welds(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    let links = &sheet.linkage.links;
    for body in &sheet.bodies.list {
        let lead = &links[body.lead()].name;
        for link in body.links[1..].iter().map(|link| &links[*link]) {
            let ([first, second, ..], Some(_)) = (&link.joints[..], link.length) else {
                continue;
            };
            let [first, second] = [first, second].map(|joint| &sheet.linkage.joints[*joint].name);
            let fact = format!(
                "the length of `{}` has no effect: the link is one body with `{lead}`",
                link.name
            );
            let help =
                format!("leave `length` out, and draw `{first}` and `{second}` at this distance");
            diagnostics.error_with_help((&link.name).into(), fact, help);
        }
    }
}

fn report_pins_beside_slots(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    for slider in &sheet.linkage.sliders {
        let Some([_, beside]) = drawn_in_slot(slider, sheet.drawing) else {
            continue;
        };
        if beside > DRAWN_APART * sheet.size() {
            let pin = &sheet.linkage.joints[slider.pin].name;
            let fact = format!(
                "`{pin}` is drawn {} mm beside the line that it slides on",
                in_millimetres(beside)
            );
            let help = "draw it on the line, or the line through it";
            diagnostics.error_with_help((&slider.name).into(), fact, help);
        }
    }
}

/// Reports sliders that count from the drawn position, with inputs of another reference than 0.
fn report_starts_of_slots(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    for slider in &sheet.linkage.sliders {
        let (Some(at), None) = (slider.at, start_joint(slider)) else {
            continue;
        };
        let reference = sheet.drawing.number(&sheet.drawing.at_reference(at));
        if let Some(reference) = reference
            && reference.abs() > DRAWN_APART * sheet.size()
        {
            let pin = &sheet.linkage.joints[slider.pin].name;
            let fact = format!(
                "`{at}` counts from the drawn position of `{pin}`, but is {} mm at the reference",
                in_millimetres(reference)
            );
            let help = "write `0mm` as the reference, or the start of the slot: `through JOINT`";
            diagnostics.error_with_help((&slider.name).into(), fact, help);
        }
    }
}
