//! Messages about links that `at` gives a direction: more than one direction, no freedom to turn, and
//! a drawing that differs from it.

use super::drawing::{DRAWN_APART, names};
use super::linkage::{FRAME, Link, Linkage};
use super::printed::rounded;
use super::rigid_bodies::Bodies;
use super::sheet::Sheet;
use crate::diagnostic::Diagnostics;
use crate::syntax::{Expr, ExprKind};

/// Reports bodies whose angle is given by more than one link, and links of the frame that are to
/// turn.
pub(super) fn report_driven_twice(
    linkage: &Linkage,
    bodies: &Bodies,
    diagnostics: &mut Diagnostics,
) {
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
        for link in driven {
            refuse_frozen(linkage, link, diagnostics);
            refuse_driven_by_itself(link, diagnostics);
        }
    }
}

/// Reports a link that is to turn, although two of its joints are fixed.
fn refuse_frozen(linkage: &Linkage, link: &Link, diagnostics: &mut Diagnostics) {
    let frame = &linkage.links[FRAME].joints;
    let fixed: Vec<usize> = link
        .joints
        .iter()
        .copied()
        .filter(|joint| frame.contains(joint))
        .collect();
    if let [first, second, ..] = fixed[..] {
        let [first, second] = [first, second].map(|joint| &linkage.joints[joint].name);
        let name = &link.name;
        let fact = format!(
            "`{name}` is to turn, but its joints `{first}` and `{second}` are both joints of the frame"
        );
        let help = format!("leave one of them out of `link frame`, or `at` out of `{name}`");
        diagnostics.error_with_help(name.into(), fact, help);
    }
}

/// Reports a link whose direction is given by this direction.
fn refuse_driven_by_itself(link: &Link, diagnostics: &mut Diagnostics) {
    let Some(at) = link.at else { return };
    let mut open = vec![at];
    while let Some(value) = open.pop() {
        if let ExprKind::Field(link_name, quantity) = &value.kind
            && matches!(&link_name.kind, ExprKind::Name(name) if *name == link.name)
            && quantity == "angle"
        {
            let name = &link.name;
            let fact =
                format!("`{name}` gets its direction from `{name}.angle`, which is this direction");
            let help = "write an input after `at`, or the angle of another link";
            diagnostics.error_with_help(value.span, fact, help);
            return;
        }
        open.extend(value.operands());
    }
}

/// Compares the given angle of a link with its drawing.
pub(super) fn check_angle(sheet: &Sheet, link: usize, at: &Expr, diagnostics: &mut Diagnostics) {
    let drawing = sheet.drawing;
    let item = &sheet.linkage.links[link];
    if sheet.are_at_one_place(item.joints[0], item.joints[1]) {
        // It is drawn in no direction.
        return;
    }
    let written = drawing.at_reference(at);
    let reference = drawing.angle(&written);
    let vector = drawing.vector(item.joints[0], item.joints[1]);
    let drawn = vector.and_then(|vector| drawing.coordinates(&vector));
    let (Some(reference), Some([x, y])) = (reference, drawn) else {
        return;
    };
    let drawn = y.atan2(x);
    let turn = std::f64::consts::TAU;
    let apart = (reference - drawn).rem_euclid(turn);
    if apart.min(turn - apart) <= DRAWN_APART {
        return;
    }
    let is_reversed = (apart - turn / 2.0).abs() <= DRAWN_APART;
    let [reference, drawn] = [reference, drawn].map(|angle| rounded(angle.to_degrees()));
    if drawing.is_constant(at) {
        let fact = format!(
            "`{}` is drawn at {drawn} deg, but `at` holds it at {reference} deg",
            item.name
        );
        let help = "draw it there; a link that moves has an input after `at`, or no `at`";
        diagnostics.error_with_help((&item.name).into(), fact, help);
        return;
    }
    let fact = format!(
        "`{}` is drawn at {drawn} deg, but its input is {reference} deg at the reference",
        item.name
    );
    let help = help_for_reference(sheet, item, at, drawn, is_reversed);
    let message = diagnostics.error_with_help((&item.name).into(), fact, help);
    let is_number = matches!(written.kind, ExprKind::Number { .. });
    if matches!(at.kind, ExprKind::Name(_)) && is_number {
        let angle = format!("{drawn}deg");
        message.suggest(
            format!("write `{angle}` as the reference"),
            written.span,
            angle,
        );
    }
}

/// Returns the advice for a link that is drawn in another direction than its input has at the
/// reference.
fn help_for_reference(
    sheet: &Sheet,
    item: &Link,
    at: &Expr,
    drawn: f64,
    is_reversed: bool,
) -> String {
    let [first, second] = [0, 1].map(|end| &sheet.linkage.joints[item.joints[end]].name);
    if is_reversed {
        return format!(
            "directions lead from the first joint to the second: write `link {}: {second}, {first}`, or \
             `{drawn}deg` as the reference",
            item.name
        );
    }
    let ExprKind::Name(input) = &at.kind else {
        return "change the reference of the input, or draw the link there".to_owned();
    };
    let mut others = sheet.linkage.links.iter().filter(|other| {
        let drives = |at: &Expr| names(at).into_iter().any(|name| name == input);
        other.name != item.name && other.at.is_some_and(drives)
    });
    match others.next() {
        Some(other) => format!(
            "`{input}` is the direction of `{}` already: leave `at` out of `{}`, or declare another input",
            other.name, item.name
        ),
        None => {
            format!("write `{drawn}deg` as the reference of the input, or draw the link there")
        }
    }
}
