//! Mistakes in a drawing: joints at one place, pins beside their slots, cylinders of another length.

use super::drawing::{DRAWN_APART, nominal};
use super::driven_angles::report_driven_twice;
use super::linkage::FRAME;
use super::printed::in_millimetres;
use super::sheet::Sheet;
use super::slides::drawn_in_slot;
use super::wheel_faults::report_wheels;
use crate::diagnostic::Diagnostics;

/// Lengths in metres below this part of the largest coordinate are none.
const NONE: f64 = 1e-9;

/// Reports the mistakes of a drawing in the plane.
pub(super) fn report(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    report_driven_twice(sheet.linkage, sheet.bodies, diagnostics);
    report_joints_at_one_place(sheet, diagnostics);
    report_cylinders(sheet, diagnostics);
    report_pins_beside_slots(sheet, diagnostics);
    report_wheels(sheet, diagnostics);
}

/// Returns the largest coordinate of all joints.
fn size(sheet: &Sheet) -> f64 {
    let positions = sheet.drawing.positions.iter().flatten();
    let coordinates = positions.filter_map(|position| sheet.drawing.coordinates(position));
    coordinates
        .flatten()
        .fold(0.0, |size, coordinate| size.max(coordinate.abs()))
}

fn report_joints_at_one_place(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    let linkage = sheet.linkage;
    for link in &linkage.links[FRAME + 1..] {
        let [first, second, ..] = link.joints[..] else {
            continue;
        };
        if link.length.is_none()
            && sheet
                .drawing
                .distance(first, second)
                .is_some_and(|length| length <= NONE * size(sheet))
        {
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

fn report_pins_beside_slots(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    for slider in &sheet.linkage.sliders {
        let Some([_, beside]) = drawn_in_slot(slider, sheet.drawing) else {
            continue;
        };
        if beside > DRAWN_APART * size(sheet) {
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
