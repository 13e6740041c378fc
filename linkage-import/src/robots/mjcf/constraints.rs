//! Equalities and actuators of a model, and bodies that float.

use super::Reader;
use crate::error::ImportError;
use crate::names::shown;
use crate::robots::attribute_numbers::{attribute, numbers};
use crate::robots::model::{ClosingJoint, Closure, Motion};
use crate::robots::urdf::follow;
use crate::xml::XmlElement;

impl Reader<'_> {
    pub(super) fn equality(&mut self, element: &XmlElement) -> Result<(), ImportError> {
        let number = self.robot.closures.len() + 1;
        let name = element
            .attribute("name")
            .map_or_else(|| format!("{}_{number}", element.name), ToOwned::to_owned);
        if element.attribute("active") == Some("false") {
            self.robot.warnings.push(format!(
                "the equality `{}` is not active: it is left out",
                shown(&name)
            ));
            return Ok(());
        }
        match element.name.as_str() {
            "connect" | "weld" => self.closure(element, &name),
            "joint" => self.coupling(element, &name),
            other => {
                self.robot.leave_out(&format!("equality {other}"));
                Ok(())
            }
        }
    }

    fn closure(&mut self, element: &XmlElement, name: &str) -> Result<(), ImportError> {
        let is_weld = element.name == "weld";
        let missing = |what: &str, named: &str| {
            ImportError::new(format!(
                "the equality `{}` names the {what} `{}`, which the file does not have",
                shown(name),
                shown(named)
            ))
        };
        let absent = |attribute: &str| {
            ImportError::new(format!(
                "the equality `{}` has no `{attribute}`",
                shown(name)
            ))
        };
        let (bodies, at) = match (element.attribute("site1"), element.attribute("site2")) {
            (Some(first), Some(second)) => {
                let site = |name: &str| self.sites.get(name).ok_or_else(|| missing("site", name));
                let [(a, at), (b, other)] = [site(first)?, site(second)?];
                ([*a, *b], [at.origin, other.origin])
            }
            _ => {
                let body = |name: &str| self.bodies.get(name).ok_or_else(|| missing("body", name));
                let first = element.attribute("body1").ok_or_else(|| absent("body1"))?;
                let (a, frame_a) = body(first)?;
                let (b, frame_b) = body(element.attribute("body2").unwrap_or("world"))?;
                // That of a weld is in the second body.
                let frame = if is_weld { frame_b } else { frame_a };
                let anchor = attribute(element, "anchor")?;
                if anchor.is_none() && !is_weld {
                    return Err(absent("anchor"));
                }
                if let Some(pose) = attribute::<7>(element, "relpose")?
                    && pose[3..].iter().any(|number| *number != 0.0)
                {
                    self.robot.warnings.push(format!(
                        "the weld `{}` has a `relpose`: the drawn position is taken instead",
                        shown(name)
                    ));
                }
                ([*a, *b], [frame.point(anchor.unwrap_or_default()); 2])
            }
        };
        let closing = if is_weld {
            ClosingJoint::Weld
        } else {
            ClosingJoint::Point
        };
        self.robot.close(Closure {
            name: name.to_owned(),
            closing,
            bodies,
            at,
        })
    }

    fn coupling(&mut self, element: &XmlElement, name: &str) -> Result<(), ImportError> {
        let follower = element.attribute("joint1").unwrap_or_default();
        let Some(leader) = element.attribute("joint2") else {
            self.robot.warnings.push(format!(
                "the equality `{}` holds the joint `{}`: hold it as an input",
                shown(name),
                shown(follower)
            ));
            return Ok(());
        };
        let mut powers = match element.attribute("polycoef") {
            Some(text) => numbers(text, "`polycoef`")?,
            None => vec![0.0, 1.0],
        };
        // Missing numbers keep their defaults.
        for (power, default) in [0.0, 1.0, 0.0, 0.0, 0.0].iter().enumerate() {
            if powers.len() <= power {
                powers.push(*default);
            }
        }
        powers.truncate(5);
        while powers.len() > 2 && powers.last() == Some(&0.0) {
            powers.pop();
        }
        follow(&mut self.robot, follower, leader, powers)
    }

    /// Marks the joints that an actuator drives: one, or those of a tendon.
    pub(super) fn actuator(&mut self, element: &XmlElement, tendons: &[&XmlElement]) {
        let of_tendon = element.attribute("tendon");
        let tendon = tendons
            .iter()
            .filter(|tendon| of_tendon.is_some() && tendon.attribute("name") == of_tendon);
        let joints = tendon.flat_map(|tendon| tendon.named("joint"));
        let joints = joints.filter_map(|joint| joint.attribute("joint"));
        let names: Vec<&str> = element
            .attribute("joint")
            .into_iter()
            .chain(joints)
            .collect();
        let mut has_joint = false;
        for name in names {
            let body = self.robot.joint_named(name);
            if let Some(joint) = body.and_then(|body| self.robot.bodies[body].joint.as_mut()) {
                joint.is_driven = true;
                has_joint = true;
            }
        }
        if !has_joint {
            let name = format!("actuator {} without a joint", element.name);
            self.robot.leave_out(&name);
        }
    }

    /// A single body that floats is the frame. More of them need closures.
    pub(super) fn settle_floating(&mut self) -> Result<(), ImportError> {
        let is_closed = |body: usize| {
            let closures = self.robot.closures.iter();
            let mut bodies = closures.flat_map(|closure| closure.bodies);
            bodies.any(|other| self.robot.hangs_on(other, body))
        };
        let to_world = self
            .robot
            .closures
            .iter()
            .any(|closure| closure.bodies.contains(&0));
        match self.floating[..] {
            [] => Ok(()),
            [only] if !to_world || !is_closed(only) => {
                let name = self.robot.bodies[only].name.clone();
                self.robot.warnings.push(format!(
                    "the body `{}` floats in the file: here it is fixed",
                    shown(&name)
                ));
                if let Some(joint) = &mut self.robot.bodies[only].joint {
                    joint.motion = Motion::Fixed;
                }
                Ok(())
            }
            _ if self.floating.iter().all(|body| is_closed(*body)) => Ok(()),
            _ => Err(ImportError::new(format!(
                "{} bodies float, and no equality holds them",
                self.floating.len()
            ))),
        }
    }
}
