//! Gears and belts: relations between angles.

use super::linkage::{FRAME, Wheels};
use super::locations::{angle, drawn_angle};
use super::nodes::{difference, equation, negative, number, product, quotient};
use super::sheet::Sheet;
use crate::diagnostic::SourceSpan;
use crate::syntax::{Expr, Item, LinkLoop};

/// Returns a loop for each pair of wheels: seen from the carrier, the turns since the reference are
/// as the sizes.
pub(super) fn items(sheet: &Sheet) -> Vec<Item> {
    let wheels = sheet.linkage.wheels.iter();
    wheels.map(|pair| relation(sheet, pair)).collect()
}

fn relation(sheet: &Sheet, pair: &Wheels) -> Item {
    let [first, second] = pair.wheels.map(|wheel| turned(sheet, pair, wheel));
    let of = LinkLoop::Wheels(
        pair.wheels
            .map(|link| sheet.linkage.links[link].name.to_string()),
    );
    equation(second, product(ratio(pair), first), of, pair.item.span)
}

/// Returns the turns of the second wheel for one turn of the first, as seen from the carrier.
pub(super) fn ratio(pair: &Wheels) -> Expr {
    let [one, other] = pair.sizes.clone();
    let ratio = quotient(one, other);
    if pair.reverses {
        negative(ratio)
    } else {
        ratio
    }
}

/// Returns the turn of a wheel since the reference, seen from the carrier.
fn turned(sheet: &Sheet, pair: &Wheels, wheel: usize) -> Expr {
    let since = |link: usize| {
        let span = pair.item.span;
        if sheet.bodies.of_link[link] == FRAME {
            return number("0", "deg", span);
        }
        difference(angle(sheet.linkage, link), reference(sheet, link, span))
    };
    let carrier = sheet.bodies.of_link[pair.carrier];
    if carrier == FRAME {
        since(wheel)
    } else {
        difference(since(wheel), since(pair.carrier))
    }
}

/// Returns the angle of a link at the reference: that of its input, or that of the drawing.
fn reference(sheet: &Sheet, link: usize, span: SourceSpan) -> Expr {
    let given = sheet.linkage.links[link].at;
    let given = given.map(|at| sheet.drawing.at_reference(at));
    let drawn = || drawn_angle(sheet.linkage, link, sheet.drawing);
    given
        .or_else(drawn)
        .unwrap_or_else(|| number("0", "deg", span))
}
