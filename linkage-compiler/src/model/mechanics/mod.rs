//! Bodies, joints, loads, and what functions ask about them.

mod bodies;
mod clauses;
mod dump;
mod inertia;
mod joints;
mod loads;
mod members;
mod parts;
mod quantities;

use super::names::Resolver;
use super::passes::Mechanical;
use super::place::{Context, Place};
use super::types::{Dimension, Expr, Mechanism};
use crate::syntax::{BodyItem, GravityItem, PartItem};

pub(super) use dump::write_mechanics;
pub(super) use members::Scope;

/// Clauses may use all names.
const CONTEXT: Context = Context {
    place: Place::Mechanics,
    item: usize::MAX,
};

impl Resolver<'_> {
    /// Everything about masses and forces. Bodies come first: they tell whether the mechanism is one of the plane or of space.
    pub(super) fn mechanics(
        &mut self,
        bodies: &[&BodyItem],
        others: &[Mechanical],
        parts: &[&PartItem],
        mechanism: &mut Mechanism,
    ) {
        let mut members = self.declare_members(bodies, others);
        for (index, item) in bodies.iter().enumerate() {
            let (body, joint) = self.body_item(item, index);
            mechanism.bodies.push(body);
            mechanism.joints.push(joint);
        }
        self.bodies_of_parts(parts, &mut members, mechanism);
        self.refuse_circles(mechanism);
        let mut gravity = None;
        for item in others {
            match *item {
                Mechanical::Gravity(item) => {
                    let value = self.gravity_item(item, gravity);
                    gravity = gravity.or(Some(item));
                    mechanism.gravity.get_or_insert(value);
                }
                Mechanical::Joint(item) => {
                    let joint = self.joint_item(item);
                    mechanism.joints.push(joint);
                }
                Mechanical::Force(item) => mechanism.loads.push(self.force_item(item)),
                Mechanical::Torque(item) => mechanism.loads.push(self.torque_item(item)),
                Mechanical::Spring(item) => {
                    let spring = self.spring_item(item, &mechanism.bodies);
                    mechanism.elements.push(spring);
                }
                Mechanical::Damper(item) => mechanism.elements.push(self.damper_item(item)),
            }
        }
        self.mechanics_of_parts(parts, &members, mechanism);
    }

    fn gravity_item(&mut self, item: &GravityItem, first: Option<&GravityItem>) -> Expr {
        if let Some(first) = first {
            let help = "leave one of them out";
            self.diagnostics
                .error_with_help(item.span, "a second `gravity`", help);
            self.diagnostics
                .error(first.span, "`gravity` is first given here");
        }
        let wanted = Some(Dimension::ACCELERATION);
        self.vector_clause(&item.value, wanted, "gravity", "(0, -9.80665m/s^2)")
    }
}
