//! Mistakes in a drawing: joints at one place, pins beside their slots, cylinders of another length,
//! wheels without a pivot on their carrier.

use super::drawing::{DRAWN_APART, nominal};
use super::linkage::{FRAME, Link, Linkage};
use super::rigid_bodies::Bodies;
use super::sheet::Sheet;
use super::slides::drawn_in_slot;
use crate::diagnostic::Diagnostics;
use crate::syntax::{Expr, ExprKind, Toleranced};

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

/// A number of millimetres with four digits after the point at most.
fn in_millimetres(metres: f64) -> f64 {
    (metres * 1e7).round() / 1e4
}

fn report_wheels(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    let body = |link: usize| sheet.bodies.of_link[link];
    for pair in &sheet.linkage.wheels {
        let span = pair.item.span;
        let [one, other] = pair.wheels;
        if body(one) == body(other) {
            diagnostics.error_with_help(span, "both wheels are one body", "name two links");
            continue;
        }
        for wheel in pair.wheels {
            // A wheel that is fixed needs no pivot.
            let pivot = sheet.bodies.shared_joint(wheel, pair.carrier);
            if body(wheel) != FRAME && pivot.is_none() {
                let wheel = &sheet.linkage.links[wheel].name;
                let carrier = &sheet.linkage.links[pair.carrier].name;
                let fact = format!("the wheel `{wheel}` has no pivot on `{carrier}`");
                let help = "name the link that carries both pivots after `on`, and let each wheel share a \
                            joint with it";
                diagnostics.error_with_help(span, fact, help);
            }
        }
        report_missing_unit(pair.sizes, diagnostics);
        for size in pair.sizes {
            if sheet.drawing.number(size) == Some(0.0) {
                diagnostics.error_with_help(size.span, "a wheel of no size", "write its teeth");
            }
        }
    }
}

/// Reports a radius without a unit next to one with a unit.
fn report_missing_unit(sizes: &[Expr; 2], diagnostics: &mut Diagnostics) {
    let written = |size: &Expr| match &size.kind {
        ExprKind::Number { text, suffix } => Some((text.clone(), suffix.clone())),
        _ => None,
    };
    let [Some(one), Some(other)] = [&sizes[0], &sizes[1]].map(written) else {
        return;
    };
    let (bare, text, unit) = match (one.1.is_empty(), other.1.is_empty()) {
        (true, false) => (&sizes[0], &one.0, &other.1),
        (false, true) => (&sizes[1], &other.0, &one.1),
        _ => return,
    };
    let fact = format!("`{text}` has no unit, but the other wheel is in `{unit}`");
    let help = format!("write `{text}{unit}`; `teeth` are two numbers without units");
    diagnostics.error_with_help(bare.span, fact, help);
}

/// Reports bodies whose angle is given by more than one link, and links of the frame that are to
/// turn.
fn report_driven_twice(linkage: &Linkage, bodies: &Bodies, diagnostics: &mut Diagnostics) {
    for (index, body) in bodies.list.iter().enumerate() {
        let links = body.links.iter().map(|link| &linkage.links[*link]);
        let driven: Vec<&Link> = links.filter(|link| link.at.is_some()).collect();
        if index == FRAME {
            for link in driven {
                let fact = format!(
                    "`{}` is fixed to the frame, and cannot be driven",
                    link.name
                );
                let help =
                    "leave `at` out, or the weld or the second joint that it shares with the frame";
                diagnostics.error_with_help((&link.name).into(), fact, help);
            }
            continue;
        }
        if let [first, second, ..] = driven[..] {
            let fact = format!(
                "`{}` and `{}` are one body, which is driven twice",
                first.name, second.name
            );
            let help =
                "leave `at` out of one of them; links that share two joints or a weld are one body";
            diagnostics.error_with_help((&second.name).into(), fact, help);
        }
    }
}

/// Reports joints with two coordinates among those with three.
pub(super) fn refuse_mixed_coordinates(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    let drawn = linkage
        .joints
        .iter()
        .filter_map(|joint| Some((joint, joint.drawn?)));
    let flat = drawn.filter(|(_, position)| match position {
        Toleranced::Single { nominal, .. } => match &nominal.kind {
            ExprKind::Tuple(components) => components.len() == 2,
            _ => false,
        },
        Toleranced::Components { components, .. } => components.len() == 2,
    });
    for (joint, _) in flat {
        let fact = format!(
            "`{}` has two coordinates, but other joints have three",
            joint.name
        );
        let help =
            "draw all joints in the plane or all in space; decimals are written with a point";
        diagnostics.error_with_help((&joint.name).into(), fact, help);
    }
}
