//! Joints with two coordinates next to joints with three.

use super::linkage::{Joint, Linkage};
use crate::diagnostic::text::list;
use crate::diagnostic::{Diagnostics, SourceSpan};
use crate::syntax::{Expr, ExprKind, Toleranced};

/// Reports joints of the plane among those of space. The fewer ones are taken for the mistake.
pub(super) fn report(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    let with = |count: usize| {
        let joints = linkage.joints.iter();
        let joints = joints.filter(move |joint| components(joint).len() == count);
        joints.collect::<Vec<&Joint>>()
    };
    let (flat, spatial, more) = (with(2), with(3), with(4));
    if more.is_empty() && (flat.is_empty() || spatial.is_empty()) {
        return;
    }
    let mut long = spatial.iter().chain(&more);
    if let Some((joint, meant, span)) = long.find_map(decimal_comma) {
        let fact = format!(
            "the joint `{}` has {} coordinates, one of them a number without a unit",
            joint.name,
            components(joint).len()
        );
        let help = format!("the decimal sign is a point: write `{meant}`");
        let message = diagnostics.error_with_help((&joint.name).into(), fact, &help);
        message.suggest(format!("write `{meant}`"), span, meant);
        return;
    }
    if flat.is_empty() || spatial.is_empty() {
        return;
    }
    let (odd, found, others) = match flat.len() <= spatial.len() {
        true => (flat, "two", "three"),
        false => (spatial, "three", "two"),
    };
    let names: Vec<String> = odd.iter().map(|joint| joint.name.to_string()).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let have = if names.len() == 1 { "has" } else { "have" };
    let fact = format!(
        "{} {have} {found} coordinates, but other joints have {others}",
        list(&names)
    );
    let help = "draw all joints in the plane or all in space; decimals are written with a point";
    diagnostics.error_with_help((&odd[0].name).into(), fact, help);
}

/// Returns the coordinates of a joint that is drawn at a vector.
fn components<'a>(joint: &Joint<'a>) -> Vec<&'a Expr> {
    match joint.drawn {
        Some(Toleranced::Single { nominal, .. }) => match &nominal.kind {
            ExprKind::Tuple(components) => components.iter().collect(),
            _ => Vec::new(),
        },
        Some(Toleranced::Components { components, .. }) => {
            components.iter().map(|(nominal, _)| nominal).collect()
        }
        None => Vec::new(),
    }
}

/// Returns the number that is meant by two coordinates like `43,3mm`, and the place of both.
fn decimal_comma<'j, 'a>(joint: &&'j Joint<'a>) -> Option<(&'j Joint<'a>, String, SourceSpan)> {
    let components = components(joint);
    components.windows(2).find_map(|pair| {
        let (before, after) = (number(pair[0])?, number(pair[1])?);
        let is_whole = before.0.bytes().all(|digit| digit.is_ascii_digit());
        let is_one = is_whole && before.1.is_empty() && before.0 != "0" && !after.1.is_empty();
        let meant = format!("{}.{}{}", before.0, after.0, after.1);
        is_one.then(|| (*joint, meant, pair[0].span.to(pair[1].span)))
    })
}

fn number(value: &Expr) -> Option<(&str, &str)> {
    match &value.kind {
        ExprKind::Number { text, suffix } => Some((text, suffix)),
        ExprKind::Negate(value) => number(value),
        _ => None,
    }
}
