//! MJCF, the format of MuJoCo: bodies within bodies, with `connect`, `weld` and `joint` equalities.
//!
//! The format is that of MuJoCo's XML reference: the meaning of attributes and their defaults.

use std::collections::BTreeMap;

use super::attribute_numbers::{attribute, axis_of, numbers};
use super::model::{Joint, Motion, Robot, joint};
use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{AXES, FIXED, Placement, Vector};
use crate::xml::XmlElement;

mod constraints;
mod model_settings;
mod unused;

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
            "option" => reader.robot.gravity = attribute(element, "gravity")?,
            "include" => return Err(included(element)),
            other => reader.robot.leave_out(other),
        }
    }
    unused::name_settings(root, &mut reader.robot);
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
        unused::name_attributes(element, &unused::OF_JOINTS, "joints", &mut self.robot);
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
        self.robot.add_mass(body, &located, mass, &tensor);
        Ok(())
    }
}
