//! Bodies, joints, loads, and what functions ask about them.

mod bodies;
mod clauses;
mod dump;
mod inertia;
mod joints;
mod loads;
mod members;
mod quantities;

use super::names::{Context, Place, Resolver};
use super::types::{Dimension, Expr, Mechanism};
use crate::syntax::{GravityItem, Item, MechanismDef};

pub(super) use dump::write_mechanics;
pub(super) use members::Scope;
pub(super) use quantities::MECHANICS;

/// Clauses may use all names.
const CONTEXT: Context = Context {
    place: Place::Mechanics,
    item: usize::MAX,
};

impl Resolver<'_> {
    /// Everything about masses and forces. Bodies come first: they tell whether the mechanism is one of the plane or of space.
    pub(super) fn mechanics(&mut self, definition: &MechanismDef, mechanism: &mut Mechanism) {
        self.declare_members(definition);
        for item in &definition.items {
            if let Item::Body(item) = item {
                let index = mechanism.bodies.len();
                let (body, joint) = self.body(item, index);
                mechanism.bodies.push(body);
                mechanism.joints.push(joint);
            }
        }
        self.refuse_circles(mechanism);
        let mut gravity = None;
        for item in &definition.items {
            match item {
                Item::Gravity(item) => {
                    let value = self.gravity(item, gravity);
                    gravity = gravity.or(Some(item));
                    mechanism.gravity.get_or_insert(value);
                }
                Item::Joint(item) => {
                    let joint = self.closing_joint(item);
                    mechanism.joints.push(joint);
                }
                Item::Force(item) => mechanism.loads.push(self.force(item)),
                Item::Torque(item) => mechanism.loads.push(self.torque(item)),
                Item::Spring(item) => {
                    let spring = self.spring(item, &mechanism.bodies);
                    mechanism.elements.push(spring);
                }
                Item::Damper(item) => mechanism.elements.push(self.damper(item)),
                _ => {}
            }
        }
    }

    fn gravity(&mut self, item: &GravityItem, first: Option<&GravityItem>) -> Expr {
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
