//! A link that is driven by a name without a declaration: its input was forgotten.

use super::drawing::Drawing;
use super::linkage::{Link, Linkage};
use crate::diagnostic::{Diagnostics, EditLocation};
use crate::syntax::{ExprKind, Item, MechanismDef};

/// Reports links whose direction is an unknown name, if the mechanism declares no input.
pub(super) fn report(
    definition: &MechanismDef,
    linkage: &Linkage,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) {
    let mut items = definition.items.iter();
    // Some names have no value in the drawing.
    let may_declare = |item: &Item| {
        matches!(
            item,
            Item::Input(_) | Item::Unknown(_) | Item::Part(_) | Item::Argument(_)
        )
    };
    if items.any(may_declare) {
        return;
    }
    for link in &linkage.links {
        let Some(at) = link.at else { continue };
        let ExprKind::Name(name) = &at.kind else {
            continue;
        };
        let text = name.to_string();
        let mut links = linkage.links.iter();
        let is_link = links.any(|link| link.name == *name);
        if text == "PI" || is_link || drawing.value(&text).is_some() {
            continue;
        }
        let reference = drawn_degrees(link, drawing).unwrap_or(0.0);
        let fact = format!("unknown name `{text}`: the mechanism has no input");
        let item = format!("input {text} = {reference}deg in 0deg..360deg;");
        let help = format!("declare it: `{item}`");
        let message = diagnostics.error_with_help(at.span, fact, help);
        let title = format!("declare `input {text} = {reference}deg in 0deg..360deg`");
        message.suggest_text(title, at.span, EditLocation::BeforeItem, item);
    }
}

/// Returns the direction of a link as drawn, in whole degrees from 0 to 359.
fn drawn_degrees(link: &Link, drawing: &Drawing) -> Option<f64> {
    let [first, second, ..] = link.joints[..] else {
        return None;
    };
    let [x, y] = drawing.coordinates(&drawing.vector(first, second)?)?;
    Some(y.atan2(x).to_degrees().rem_euclid(360.0).round() % 360.0)
}
