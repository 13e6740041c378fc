//! Mistakes in gears and belts: wheels that cannot turn, wheels without a pivot on their carrier, sizes
//! that do not fit the distance of the pivots.

use super::drawing::DRAWN_APART;
use super::linkage::{FRAME, Wheels};
use super::measure::{Measure, measure};
use super::printed::in_millimetres;
use super::sheet::Sheet;
use crate::diagnostic::Diagnostics;
use crate::syntax::{Expr, ExprKind};

/// Reports the mistakes in all pairs of wheels.
pub(super) fn report_wheels(sheet: &Sheet, diagnostics: &mut Diagnostics) {
    for pair in &sheet.linkage.wheels {
        if refuse_wheels_that_cannot_turn(sheet, pair, diagnostics) {
            continue;
        }
        let pivots = pair
            .wheels
            .map(|wheel| sheet.bodies.shared_joint(wheel, pair.carrier));
        refuse_missing_pivots(sheet, pair, pivots, diagnostics);
        report_missing_unit(pair.sizes, diagnostics);
        for size in pair.sizes {
            if sheet.drawing.number(size) == Some(0.0) {
                diagnostics.error_with_help(size.span, "a wheel of no size", "write its teeth");
            }
        }
        if let [Some(one), Some(other)] = pivots
            && pair.reverses
        {
            warn_of_other_distance(sheet, pair, [one, other], diagnostics);
        }
    }
}

/// Reports wheels that are one body, and a wheel that is the carrier.
fn refuse_wheels_that_cannot_turn(
    sheet: &Sheet,
    pair: &Wheels,
    diagnostics: &mut Diagnostics,
) -> bool {
    let span = pair.item.span;
    let body = |link: usize| sheet.bodies.of_link[link];
    let [one, other] = pair.wheels;
    if body(one) == body(other) {
        diagnostics.error_with_help(span, "both wheels are one body", "name two links");
        return true;
    }
    let mut fixed = pair.wheels.into_iter();
    let Some(fixed) = fixed.find(|wheel| body(*wheel) == body(pair.carrier)) else {
        return false;
    };
    let turning = if fixed == one { other } else { one };
    let [fixed, turning, carrier] =
        [fixed, turning, pair.carrier].map(|link| &sheet.linkage.links[link].name);
    let fact = match pair.item.carrier {
        Some(_) => format!("`{fixed}` does not turn on `{carrier}`, which carries both pivots"),
        None => format!("`{fixed}` does not turn on the frame, which carries both pivots"),
    };
    let help = format!(
        "name two links that turn; `{turning}` can roll on a fixed wheel if an arm carries both: \
         `gears {turning}, frame on ARM teeth 20, -60;`"
    );
    diagnostics.error_with_help(span, fact, help);
    true
}

fn refuse_missing_pivots(
    sheet: &Sheet,
    pair: &Wheels,
    pivots: [Option<usize>; 2],
    diagnostics: &mut Diagnostics,
) {
    for (wheel, pivot) in pair.wheels.into_iter().zip(pivots) {
        // A wheel that is fixed needs no pivot.
        if sheet.bodies.of_link[wheel] == FRAME || pivot.is_some() {
            continue;
        }
        let wheel = &sheet.linkage.links[wheel].name;
        let carrier = &sheet.linkage.links[pair.carrier].name;
        let fact = format!("the wheel `{wheel}` has no pivot on `{carrier}`");
        let help = "name the link that carries both pivots after `on`, and let each wheel share a \
                    joint with it";
        diagnostics.error_with_help(pair.item.span, fact, help);
    }
}

/// Warns of gears whose radii are not those of wheels that touch. Their ratio counts all the same.
fn warn_of_other_distance(
    sheet: &Sheet,
    pair: &Wheels,
    [one, other]: [usize; 2],
    diagnostics: &mut Diagnostics,
) {
    let is_length = |size: &Expr| measure(sheet.drawing, size) == Measure::Length;
    if !pair.sizes.iter().all(is_length) {
        return;
    }
    let radii = pair.sizes.each_ref().map(|size| {
        let size = sheet.drawing.at_reference(size);
        sheet.drawing.number(&size)
    });
    let distance = sheet.drawing.distance(one, other);
    let ([Some(first), Some(second)], Some(distance)) = (radii, distance) else {
        return;
    };
    // An inner gear has a negative radius.
    let needed = (first + second).abs();
    if (distance - needed).abs() <= DRAWN_APART * distance.max(needed) {
        return;
    }
    let [one, other] = [one, other].map(|joint| &sheet.linkage.joints[joint].name);
    let (sum, difference) = (
        first.abs() + second.abs(),
        (first.abs() - second.abs()).abs(),
    );
    let [distance, sum, difference] = [distance, sum, difference].map(in_millimetres);
    let fact = format!(
        "the pivots `{one}` and `{other}` are {distance} mm apart, but gears with these radii touch at {}",
        match first * second < 0.0 {
            true => format!("their difference, {difference} mm"),
            false => format!("their sum, {sum} mm"),
        }
    );
    let help = match first * second < 0.0 {
        true => format!("change the radii or the drawing; two outer gears touch at {sum} mm"),
        false => format!(
            "change the radii or the drawing; an inner gear has a negative radius, and touches at {difference} mm"
        ),
    };
    diagnostics.warning_with_help(pair.item.span, fact, help);
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
