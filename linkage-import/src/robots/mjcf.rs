//! MJCF, the format of MuJoCo: bodies within bodies, with `connect`, `weld` and `joint` equalities.
//!
//! The format is that of MuJoCo's XML reference: the meaning of attributes and their defaults.

use std::collections::BTreeMap;

use super::attribute_numbers::{attribute, numbers};
use super::model::{ClosingJoint, Closure, Joint, Mass, Motion, Robot, joint};
use super::placement::{AXES, FIXED, Placement, Vector};
use super::urdf::{axis_of, follow};
use crate::error::ImportError;
use crate::names::shown;
use crate::xml::XmlElement;

mod model_settings;

use model_settings::Settings;

/// A site: the body and the located.
type Sites = BTreeMap<String, (usize, Placement)>;

/// What is known while bodies are read.
struct Reader<'t> {
    settings: Settings<'t>,
    robot: Robot,
    sites: Sites,
    /// Bodies by name, with their frames.
    bodies: BTreeMap<String, (usize, Placement)>,
    /// Bodies that float.
    floating: Vec<usize>,
    unnamed: usize,
}

/// The surroundings of an element.
#[derive(Clone, Copy)]
struct Within<'t> {
    body: usize,
    at: Placement,
    class: Option<&'t str>,
}

/// Reads a model.
pub(super) fn read(root: &XmlElement) -> Result<Robot, ImportError> {
    if root.name != "mujoco" {
        return Err(ImportError::new(format!(
            "the file begins with `{}`, and MJCF with `mujoco`",
            shown(&root.name)
        )));
    }
    let mut reader = Reader {
        settings: Settings::read(root)?,
        robot: Robot::new(root.attribute("model").unwrap_or("model")),
        sites: Sites::new(),
        bodies: BTreeMap::new(),
        floating: Vec::new(),
        unnamed: 0,
    };
    let world = Within {
        body: 0,
        at: FIXED,
        class: None,
    };
    reader.bodies.insert("world".to_owned(), (0, FIXED));
    for element in &root.children {
        match element.name.as_str() {
            "worldbody" => reader.content(element, world)?,
            "compiler" | "default" | "equality" | "actuator" => {}
            "option" => {
                reader.robot.gravity = attribute(element, "gravity")?;
                let others = element.attributes.iter();
                for (name, _) in others.filter(|(name, _)| name != "gravity") {
                    reader.robot.leave_out(&format!("{name} of option"));
                }
            }
            "include" => return Err(included(element)),
            other => reader.robot.leave_out(other),
        }
    }
    for element in root.named("equality").flat_map(|all| &all.children) {
        reader.equality(element)?;
    }
    let tendons = root.named("tendon").flat_map(|all| all.named("fixed"));
    let tendons: Vec<&XmlElement> = tendons.collect();
    for element in root.named("actuator").flat_map(|all| &all.children) {
        reader.actuator(element, &tendons);
    }
    reader.settle_floating()?;
    Ok(reader.robot)
}

fn included(element: &XmlElement) -> ImportError {
    ImportError::new(format!(
        "the file includes `{}`, which is not read\nhelp: save the model as one file, as MuJoCo's `mj_saveLastXML` does",
        shown(element.attribute("file").unwrap_or_default())
    ))
}

impl<'t> Reader<'t> {
    /// The elements within a body or a frame.
    fn content(&mut self, element: &'t XmlElement, within: Within<'t>) -> Result<(), ImportError> {
        for inner in &element.children {
            match inner.name.as_str() {
                "body" => self.body(inner, within)?,
                "frame" => {
                    let at = within.at.then(&self.settings.placement(inner)?);
                    let class = inner.attribute("childclass").or(within.class);
                    self.content(
                        inner,
                        Within {
                            at,
                            class,
                            ..within
                        },
                    )?;
                }
                "site" => {
                    let at = within.at.then(&self.settings.placement(inner)?);
                    if let Some(name) = inner.attribute("name") {
                        self.sites.insert(name.to_owned(), (within.body, at));
                    }
                }
                // Those of a body have been read with it.
                "joint" | "freejoint" | "inertial"
                    if within.body > 0 || !self.is_world(element) => {}
                "include" => return Err(included(inner)),
                "replicate" | "composite" | "flexcomp" | "attach" => {
                    return Err(ImportError::new(format!(
                        "`{}` makes bodies that are not in the file\nhelp: save the model after MuJoCo has compiled it",
                        inner.name
                    )));
                }
                other => self.robot.leave_out(&format!("{other} of bodies")),
            }
        }
        Ok(())
    }

    fn is_world(&self, element: &XmlElement) -> bool {
        element.name == "worldbody"
    }

    fn body(&mut self, element: &'t XmlElement, within: Within<'t>) -> Result<(), ImportError> {
        let class = element.attribute("childclass").or(within.class);
        let at = within.at.then(&self.settings.placement(element)?);
        self.unnamed += 1;
        let name = match element.attribute("name") {
            Some(name) => name.to_owned(),
            None => format!("body_{}", self.unnamed),
        };
        let mut body = within.body;
        let joints = element.children.iter();
        let joints: Vec<&XmlElement> = joints
            .filter(|inner| ["joint", "freejoint"].contains(&inner.name.as_str()))
            .collect();
        for (number, inner) in joints.iter().enumerate() {
            let is_last = number + 1 == joints.len();
            let part = match is_last {
                true => name.clone(),
                false => format!("{name}_{}", number + 1),
            };
            let added = self.joint(inner, &name, number, Within { body, at, class })?;
            let is_free = added.motion == Motion::Free;
            body = self.robot.add(&part, added)?;
            if is_free {
                self.floating.push(body);
            }
        }
        if self.bodies.insert(name.clone(), (body, at)).is_some() {
            return Err(ImportError::new(format!(
                "there are two bodies `{}`",
                shown(&name)
            )));
        }
        match element.named("inertial").next() {
            Some(inertial) => self.mass(inertial, body, &at)?,
            None if element.named("geom").next().is_some() => {
                self.robot.leave_out("mass of geoms");
            }
            None => {}
        }
        self.content(element, Within { body, at, class })
    }

    fn joint(
        &mut self,
        element: &XmlElement,
        body: &str,
        number: usize,
        within: Within,
    ) -> Result<Joint, ImportError> {
        let value = |name: &str| self.settings.value(element, within.class, name);
        let name = match element.attribute("name") {
            Some(name) => name.to_owned(),
            None if number == 0 => format!("{body}_joint"),
            None => format!("{body}_joint_{}", number + 1),
        };
        if self.robot.joint_named(&name).is_some() {
            return Err(ImportError::new(format!(
                "there are two joints `{}`",
                shown(&name)
            )));
        }
        let kind = match element.name.as_str() {
            "freejoint" => "free",
            _ => value("type").unwrap_or("hinge"),
        };
        let vector = |attribute: &str, default: Vector| match value(attribute) {
            Some(text) => {
                super::attribute_numbers::exactly(text, &format!("`{attribute}` of a joint"))
            }
            None => Ok(default),
        };
        let axis = || axis_of(within.at.direction(vector("axis", AXES[2])?), &name);
        let motion = match kind {
            "hinge" => Motion::Hinge(axis()?),
            "slide" => Motion::Slide(axis()?),
            "ball" => Motion::Ball,
            "free" => Motion::Free,
            other => {
                return Err(ImportError::new(format!(
                    "the joint `{}` is `{}`; there are `hinge`, `slide`, `ball` and `free`",
                    shown(&name),
                    shown(other)
                )));
            }
        };
        let at = match motion {
            Motion::Free => within.at.origin,
            _ => within.at.point(vector("pos", [0.0; 3])?),
        };
        let mut added = joint(&name, motion, within.body, at);
        let angle = |value: f64| match motion {
            Motion::Hinge(_) => self.settings.radians(value),
            Motion::Slide(_) | Motion::Ball | Motion::Free | Motion::Fixed => value,
        };
        if let Some(text) = value("ref") {
            let found = numbers(text, "`ref` of a joint")?;
            added.zero = angle(found.first().copied().unwrap_or_default());
        }
        let is_scalar = matches!(motion, Motion::Hinge(_) | Motion::Slide(_));
        let is_limited = match value("limited") {
            Some("true") => true,
            Some("false") => false,
            _ => self.settings.has_auto_limits,
        };
        if let Some(text) = value("range").filter(|_| is_scalar && is_limited) {
            let ends: [f64; 2] = super::attribute_numbers::exactly(text, "`range` of a joint")?;
            added.range = Some(ends.map(|end| angle(end) - added.zero));
        }
        let known = [
            "name", "class", "type", "pos", "axis", "ref", "range", "limited",
        ];
        let others = element.attributes.iter();
        let others = others.filter(|(name, _)| !known.contains(&name.as_str()));
        let others: Vec<String> = others
            .map(|(name, _)| format!("{name} of joints"))
            .collect();
        for other in others {
            self.robot.leave_out(&other);
        }
        Ok(added)
    }

    fn mass(
        &mut self,
        element: &XmlElement,
        body: usize,
        at: &Placement,
    ) -> Result<(), ImportError> {
        let located = at.then(&self.settings.placement(element)?);
        let [mass] = attribute(element, "mass")?.unwrap_or_default();
        let tensor = match (
            attribute::<3>(element, "diaginertia")?,
            attribute::<6>(element, "fullinertia")?,
        ) {
            (_, Some([xx, yy, zz, xy, xz, yz])) => [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
            (Some([x, y, z]), None) => [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]],
            (None, None) => [[0.0; 3]; 3],
        };
        self.robot.bodies[body].masses.push(Mass {
            mass,
            centre: located.origin,
            inertia: located.tensor(&tensor),
        });
        Ok(())
    }

    fn equality(&mut self, element: &XmlElement) -> Result<(), ImportError> {
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
        let missing = |what: &str| {
            ImportError::new(format!(
                "the equality `{}` names no {what} of the file",
                shown(name)
            ))
        };
        let (bodies, at) = match (element.attribute("site1"), element.attribute("site2")) {
            (Some(first), Some(second)) => {
                let site = |name: &str| self.sites.get(name).ok_or_else(|| missing("site"));
                let [(a, at), (b, other)] = [site(first)?, site(second)?];
                ([*a, *b], [at.origin, other.origin])
            }
            _ => {
                let body = |name: &str| self.bodies.get(name).ok_or_else(|| missing("body"));
                let (a, frame_a) = body(element.attribute("body1").unwrap_or_default())?;
                let (b, frame_b) = body(element.attribute("body2").unwrap_or("world"))?;
                // That of a weld is in the second body.
                let frame = if is_weld { frame_b } else { frame_a };
                let anchor = attribute(element, "anchor")?;
                if anchor.is_none() && !is_weld {
                    return Err(missing("anchor"));
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
        self.robot.closures.push(Closure {
            name: name.to_owned(),
            closing,
            bodies,
            at,
        });
        Ok(())
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
    fn actuator(&mut self, element: &XmlElement, tendons: &[&XmlElement]) {
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
    fn settle_floating(&mut self) -> Result<(), ImportError> {
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
