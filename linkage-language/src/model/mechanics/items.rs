//! Everything about masses and forces, in the order in which it is resolved.

use super::bodies::{refuse_circles, resolve_body};
use super::clauses::resolve_vector;
use super::declare::declare_members;
use super::friction::resolve_friction;
use super::joints::resolve_joint_item;
use super::loads::{resolve_damper, resolve_force, resolve_spring, resolve_torque};
use super::part_bodies::{embed_bodies, embed_mechanics};
use crate::model::declare::passes::Mechanical;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Dimension, Expr, Mechanism};
use crate::syntax::{BodyItem, GravityItem, PartItem};

/// Resolves all items about masses and forces. Bodies come first: they decide between plane and
/// space.
pub(in crate::model) fn resolve_mechanics(
    scope: &mut Scope,
    sink: &mut Sink,
    bodies: &[&BodyItem],
    others: &[Mechanical],
    parts: &[&PartItem],
    mechanism: &mut Mechanism,
) {
    let mut members = declare_members(&scope.parts, &mut scope.members, sink, bodies, others);
    for (index, item) in bodies.iter().enumerate() {
        let (body, joint) = resolve_body(scope, sink, item, index);
        mechanism.bodies.push(body);
        mechanism.joints.push(joint);
    }
    embed_bodies(
        &scope.parts,
        &scope.members,
        sink,
        parts,
        &mut members,
        mechanism,
    );
    refuse_circles(sink, mechanism);
    let mut gravity = None;
    for item in others {
        match *item {
            Mechanical::Gravity(item) => {
                let value = resolve_gravity(scope, sink, item, gravity);
                gravity = gravity.or(Some(item));
                mechanism.gravity.get_or_insert(value);
            }
            Mechanical::Joint(item) => {
                let joint = resolve_joint_item(scope, sink, item);
                mechanism.joints.push(joint);
            }
            Mechanical::Force(item) => mechanism.loads.push(resolve_force(scope, sink, item)),
            Mechanical::Torque(item) => mechanism.loads.push(resolve_torque(scope, sink, item)),
            Mechanical::Spring(item) => {
                let spring = resolve_spring(scope, sink, item, &mechanism.bodies);
                mechanism.elements.push(spring);
            }
            Mechanical::Damper(item) => mechanism.elements.push(resolve_damper(scope, sink, item)),
            Mechanical::Friction(item) => {
                let friction = resolve_friction(scope, sink, item, &mechanism.frictions);
                mechanism.frictions.extend(friction);
            }
        }
    }
    embed_mechanics(&scope.parts, sink, parts, &members, mechanism);
}

fn resolve_gravity(
    scope: &Scope,
    sink: &mut Sink,
    item: &GravityItem,
    first: Option<&GravityItem>,
) -> Expr {
    if let Some(first) = first {
        let help = "leave one of them out";
        sink.error_with_help(item.span, "a second `gravity`", help);
        sink.error(first.span, "`gravity` is first given here");
    }
    let wanted = Some(Dimension::ACCELERATION);
    resolve_vector(
        scope,
        sink,
        &item.value,
        wanted,
        "gravity",
        "(0, -9.80665m/s^2)",
    )
}
