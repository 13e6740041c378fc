//! Dry friction in pins and slides.

use super::clauses::resolve_scalar;
use crate::model::expression::members::find_joint;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Contact, Dimension, Friction, Rotation};
use crate::syntax::{FrictionItem, JointKind, LoadWord, Word};

/// The two kinds of joints with friction.
#[derive(Clone, Copy)]
enum Surface {
    Pin,
    Guide,
}

/// `friction coefficient on JOINT [, radius length] [, length length];`. Returns `None` after a
/// mistake that leaves the surface unknown.
pub(in crate::model) fn resolve_friction(
    scope: &Scope,
    sink: &mut Sink,
    item: &FrictionItem,
    others: &[Friction],
) -> Option<Friction> {
    let word = LoadWord::Friction.word();
    let number = Dimension::NUMBER;
    let coefficient = resolve_scalar(scope, sink, &item.coefficient, number, word, "0.1");
    let length = |sink: &mut Sink, value, word| {
        resolve_scalar(scope, sink, value, Dimension::LENGTH, word, "8mm")
    };
    let radius = item.radius.as_ref();
    let radius = radius.map(|value| length(sink, value, "radius"));
    let block = item.length.as_ref();
    let block = block.map(|value| length(sink, value, "length"));
    let joint = find_joint(&scope.parts, &scope.members, sink, &item.joint)?;
    let surface = find_surface(sink, item, scope.members.joints[joint])?;
    if others.iter().any(|other| other.joint == joint) {
        let fact = format!("a second `friction` on `{}`", item.joint);
        sink.error_with_help(item.span, fact, "write the sum of both in one item");
    }
    refuse_at_rest(scope, sink, item);
    let contact = match (surface, radius, block) {
        (Surface::Pin, Some(radius), None) => Contact::Pin(radius),
        (Surface::Guide, None, block) => Contact::Guide(block),
        (surface, radius, _) => {
            report_clause(sink, item, surface, radius.is_some());
            return None;
        }
    };
    Some(Friction {
        coefficient,
        joint,
        contact,
        origin: sink.add_origin(item.span),
    })
}

/// Reports joints in space, and kinds of joints without friction.
fn find_surface(sink: &mut Sink, item: &FrictionItem, kind: JointKind) -> Option<Surface> {
    let name = &item.joint;
    if sink.components == Some(3) {
        let fact = "friction of joints in space is not computed";
        let help = format!(
            "write what resists as `damper VALUE on {name}`, or as a load that is an `argument`"
        );
        sink.error_with_help(item.span, fact, help);
        return None;
    }
    match (kind.rotation(), kind.slides()) {
        (Rotation::AboutAxis, false) => Some(Surface::Pin),
        (Rotation::Not, true) => Some(Surface::Guide),
        (Rotation::AboutAxis, true) | (Rotation::Not, false) | (Rotation::Freely, _) => {
            let fact = format!("`{name}` is a `{}`", kind.word());
            let help = "friction acts in a `pin` or in a `slide`";
            sink.error_with_help(name.span, fact, help);
            None
        }
    }
}

/// Reports a pin without a radius, and a clause that belongs to the other kind of joint.
fn report_clause(sink: &mut Sink, item: &FrictionItem, surface: Surface, has_radius: bool) {
    let name = &item.joint;
    let (fact, help) = match (surface, has_radius) {
        (Surface::Pin, false) => (
            format!("the friction of the pin `{name}` lacks its radius"),
            format!(
                "the force of friction acts on the surface: `friction 0.1 on {name}, radius 8mm`"
            ),
        ),
        (Surface::Pin, true) => (
            format!(
                "the friction of the pin `{name}` has a `length`, which is that of a slide's block"
            ),
            "leave out `length`".to_owned(),
        ),
        (Surface::Guide, _) => (
            format!("the friction of the slide `{name}` has a `radius`, which is that of a pin"),
            "leave out `radius`; a block that carries a moment has a `length`".to_owned(),
        ),
    };
    sink.error_with_help(item.span, fact, help);
}

/// Reports friction in a mechanism none of whose inputs has a speed.
fn refuse_at_rest(scope: &Scope, sink: &mut Sink, item: &FrictionItem) {
    let mut speeds = scope.values.rates.iter().map(|[speed, _]| speed);
    if speeds.all(Option::is_none) {
        let fact = "friction acts against a speed, and no input has one";
        let help =
            "name the speed of an input and list it in functions: `input phi = ... at omega`";
        sink.error_with_help(item.span, fact, help);
    }
}
