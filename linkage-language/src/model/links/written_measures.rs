//! Mistakes in units: coordinates without a unit, directions that are lengths, lengths that are
//! angles. They are reported where they are written, before many expressions contain them.

use super::drawing::{Drawing, nominal};
use super::linkage::{Joint, Linkage, Path};
use super::measure::{Measure, measure};
use super::printed::in_millimetres;
use crate::diagnostic::text::list;
use crate::diagnostic::{Diagnostics, SourceSpan};
use crate::syntax::{Expr, ExprKind, Item, MechanismDef};

/// The unit that advice has if the mechanism declares none.
const USUAL_UNIT: &str = "mm";

/// Reports the mistakes in units of joints, links and sliders.
pub(super) fn report(
    definition: &MechanismDef,
    linkage: &Linkage,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) {
    report_coordinates_without_unit(definition, linkage, drawing, diagnostics);
    for joint in &linkage.joints {
        report_angle_as_coordinate(joint, drawing, diagnostics);
    }
    for link in &linkage.links {
        let name = &link.name;
        if let Some(at) = link.at {
            let of = format!("the direction of the link `{name}`");
            let length = format!("a distance of joints is written `length {at}`");
            refuse_direction(at, &of, &length, drawing, diagnostics);
        }
        if let Some(length) = link.length.map(nominal) {
            let of = format!("the {} of `{name}`", link.length_word);
            refuse_angle(&length, &of, drawing, diagnostics);
            refuse_no_length(&length, &of, drawing, diagnostics);
        }
    }
    for slider in &linkage.sliders {
        if let Path::Direction(angle, _) = slider.path {
            let of = format!("the direction of the slider `{}`", slider.name);
            let length = "a line through two joints is written `along joint, joint`";
            refuse_direction(angle, &of, length, drawing, diagnostics);
        }
        if let Some(at) = slider.at {
            let of = format!("the position of the slider `{}`", slider.name);
            refuse_angle(at, &of, drawing, diagnostics);
        }
    }
}

/// Returns the coordinates of a joint as they are drawn, or its position if that is no vector.
fn coordinates(joint: &Joint) -> Vec<Expr> {
    let Some(position) = joint.drawn.map(nominal) else {
        return Vec::new();
    };
    match position.kind {
        ExprKind::Tuple(components) => components,
        _ => vec![position],
    }
}

/// Reports all joints that are drawn by numbers without units, once.
fn report_coordinates_without_unit(
    definition: &MechanismDef,
    linkage: &Linkage,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) {
    let is_bare = |value: &Expr| measure(drawing, value) == Measure::Number;
    let bare = linkage.joints.iter().filter_map(|joint| {
        let bare: Vec<Expr> = coordinates(joint).into_iter().filter(&is_bare).collect();
        (!bare.is_empty()).then_some((joint, bare))
    });
    let bare: Vec<(&Joint, Vec<Expr>)> = bare.collect();
    let Some((first, _)) = bare.first() else {
        return;
    };
    let unit = declared_unit(definition);
    let numbers = bare.iter().flat_map(|(_, values)| values);
    let edits = numbers.filter_map(|value| bare_number(value));
    let edits: Vec<(SourceSpan, String)> = edits
        .map(|(span, text)| (span, format!("{text}{unit}")))
        .collect();
    let Some(position) = first.drawn.map(nominal) else {
        return;
    };
    let name = &first.name;
    let names: Vec<String> = bare
        .iter()
        .map(|(joint, _)| joint.name.to_string())
        .collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let fact = match names[..] {
        [_] => format!("the joint `{name}` = {position} has no unit"),
        _ => format!(
            "the joints {} have no units, as in `{name}` = {position}",
            list(&names)
        ),
    };
    let help = match &edits[..] {
        [] => "coordinates are lengths: give each number its unit".to_owned(),
        [(_, number), ..] => format!("coordinates are lengths: write `{number}`"),
    };
    let message = diagnostics.error_with_help(name.into(), fact, help);
    if !edits.is_empty() {
        let title = match &edits[..] {
            [(_, number)] => format!("write `{number}`"),
            _ => format!("write `{unit}` after each number"),
        };
        message.suggest_all(title, edits);
    }
}

/// Returns the number that a coordinate is, and its place.
fn bare_number(value: &Expr) -> Option<(SourceSpan, &str)> {
    match &value.kind {
        ExprKind::Number { text, .. } => Some((value.span, text)),
        ExprKind::Negate(value) => bare_number(value),
        _ => None,
    }
}

fn declared_unit(definition: &MechanismDef) -> String {
    let mut items = definition.items.iter();
    let unit = items.find_map(|item| match item {
        Item::Unit(item) => Some(item.unit.to_string()),
        _ => None,
    });
    unit.unwrap_or_else(|| USUAL_UNIT.to_owned())
}

/// Reports a joint that is drawn at an angle.
fn report_angle_as_coordinate(joint: &Joint, drawing: &Drawing, diagnostics: &mut Diagnostics) {
    let coordinates = coordinates(joint);
    let mut angles = coordinates.iter();
    let angle = angles.find(|value| measure(drawing, value) == Measure::Angle);
    if let Some(angle) = angle {
        let fact = format!(
            "a coordinate of the joint `{}` is an angle: `{angle}`",
            joint.name
        );
        let help = "coordinates are lengths; a point in a direction is `polar(50mm, 30deg)`";
        diagnostics.error_with_help(angle.span, fact, help);
    }
}

/// Reports a direction that is a length, or a number without its unit.
fn refuse_direction(
    at: &Expr,
    of: &str,
    length: &str,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) {
    match (measure(drawing, at), &at.kind) {
        (Measure::Length, _) => {
            let fact = format!("{of} cannot be a length: `{at}`");
            let help = format!("write an angle, or an input that is one; {length}");
            diagnostics.error_with_help(at.span, fact, help);
        }
        (Measure::Number, ExprKind::Number { text, .. }) => {
            let fact = format!("{of} has no unit: `{text}` would be {text} rad");
            let help = format!("write `{text}deg`, or `{text}rad`");
            let message = diagnostics.error_with_help(at.span, fact, help);
            let angle = format!("{text}deg");
            message.suggest(format!("write `{angle}`"), at.span, angle);
        }
        (Measure::Zero | Measure::Number | Measure::Angle | Measure::Other, _) => {}
    }
}

/// Reports a length that is an angle.
fn refuse_angle(value: &Expr, of: &str, drawing: &Drawing, diagnostics: &mut Diagnostics) {
    if measure(drawing, value) == Measure::Angle {
        let fact = format!("{of} cannot be an angle: `{value}`");
        let help = "write a length, like `50mm`; the direction of a link is written `at ANGLE`";
        diagnostics.error_with_help(value.span, fact, help);
    }
}

/// Reports a constant length that is zero or negative.
fn refuse_no_length(value: &Expr, of: &str, drawing: &Drawing, diagnostics: &mut Diagnostics) {
    if !matches!(measure(drawing, value), Measure::Length | Measure::Zero) {
        return;
    }
    let length = drawing.is_constant(value).then(|| drawing.number(value));
    let fact = match length.flatten() {
        Some(length) if length < 0.0 => {
            format!("{of} is negative: {} mm", in_millimetres(length))
        }
        Some(0.0) => format!("{of} is zero"),
        _ => return,
    };
    let help = "write the distance of its joints, which is positive, or leave it out: it is drawn";
    diagnostics.error_with_help(value.span, fact, help);
}
