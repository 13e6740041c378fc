//! Bodies, joints and loads of parts.

use super::super::embed::{Embedding, Members};
use super::super::names::Resolver;
use super::super::types::Mechanism;
use crate::diagnostic::SourceSpan;
use crate::syntax::PartItem;

impl Resolver<'_> {
    /// Bodies of parts, with the joints that they hang on.
    pub(super) fn bodies_of_parts(
        &mut self,
        items: &[&PartItem],
        members: &mut [Members],
        mechanism: &mut Mechanism,
    ) {
        for ((part, item), members) in items.iter().enumerate().zip(members) {
            if let Some(on) = &item.on {
                members.on = self.body_named(on).flatten();
            }
            let own = Embedding::new(&self.parts[part], &mechanism.lets, &self.placed);
            let Some(embedding) = own else { continue };
            let bodies: Vec<_> = embedding.bodies(*members).collect();
            let joints: Vec<_> = embedding.joints(*members, true).collect();
            if let Some(joint) = joints.first() {
                let count = joint.at.ty.components().unwrap_or(2);
                let all = *self.mechanics.components.get_or_insert(count);
                if all != count {
                    self.refuse_other_space(item, count);
                }
            }
            mechanism.bodies.extend(bodies);
            mechanism.joints.extend(joints);
        }
    }

    fn refuse_other_space(&mut self, item: &PartItem, count: usize) {
        let (own, others) = match count {
            3 => ("in space", "in the plane"),
            _ => ("in the plane", "in space"),
        };
        let fact = format!(
            "the bodies of the part `{}` are {own}, those before it {others}",
            item.name
        );
        let help = "forces are those of the plane or of space: write all points alike";
        let span = SourceSpan::from(&item.name);
        self.diagnostics.error_with_help(span, fact, help);
    }

    /// Joints of parts that close loops, what acts on their bodies, and gravity if the mechanism itself says nothing of it.
    pub(super) fn mechanics_of_parts(
        &mut self,
        items: &[&PartItem],
        members: &[Members],
        mechanism: &mut Mechanism,
    ) {
        let said = mechanism.gravity.is_some();
        for ((part, item), members) in items.iter().enumerate().zip(members) {
            let own = Embedding::new(&self.parts[part], &mechanism.lets, &self.placed);
            let Some(embedding) = own else { continue };
            let gravity = embedding.gravity();
            let joints: Vec<_> = embedding.joints(*members, false).collect();
            let loads: Vec<_> = embedding.loads(*members).collect();
            let elements: Vec<_> = embedding.elements(*members).collect();
            mechanism.joints.extend(joints);
            mechanism.loads.extend(loads);
            mechanism.elements.extend(elements);
            match (&mechanism.gravity, gravity) {
                (_, None) => {}
                (None, gravity) => mechanism.gravity = gravity,
                (Some(first), Some(own)) if !said && *first != own => {
                    let fact = format!(
                        "the gravity of the part `{}` is not that of the parts before it",
                        item.name
                    );
                    let help =
                        "write the `gravity` of the whole mechanism, which counts for all parts";
                    self.diagnostics
                        .error_with_help((&item.name).into(), fact, help);
                }
                (Some(_), Some(_)) => {}
            }
        }
    }
}
