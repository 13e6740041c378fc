//! SDF: links and joints of a model as a graph, which may have loops.
//!
//! The format is that of the files `link.sdf`, `joint.sdf`, `pose.sdf` and `mimic.sdf` of the public
//! library `sdformat`.

use super::attribute_numbers::exactly;
use super::model::{Robot, tensor};
use super::urdf::follow;
use crate::error::ImportError;
use crate::names::shown;
use crate::placement::FIXED;
use crate::xml::XmlElement;

mod graph;
mod poses;
mod single_joints;

use graph::tree;
use poses::{Frames, name_of, pose, text_of};

/// Reads the model of a file.
pub(super) fn read(root: &XmlElement) -> Result<Robot, ImportError> {
    if root.name != "sdf" {
        return Err(ImportError::new(format!(
            "the file begins with `{}`, and SDF with `sdf`",
            shown(&root.name)
        )));
    }
    let in_worlds = root.named("world").flat_map(|world| world.named("model"));
    let mut models = root.named("model").chain(in_worlds);
    let Some(model) = models.next() else {
        return Err(ImportError::new("the file has no `model`"));
    };
    let mut robot = Robot::new(model.attribute("name").unwrap_or("model"));
    let others = models.count();
    if others > 0 {
        robot.warnings.push(format!(
            "{others} other models of the file are left out: `{}` is taken",
            shown(&robot.name)
        ));
    }
    let frames = Frames {
        elements: model
            .children
            .iter()
            .filter(|element| ["link", "joint", "frame"].contains(&element.name.as_str()))
            .filter_map(|element| Some((element.attribute("name")?, element)))
            .collect(),
    };
    for element in &model.children {
        match element.name.as_str() {
            "link" | "joint" | "frame" | "pose" => {}
            "model" | "include" => {
                return Err(ImportError::new(format!(
                    "the model has another one within it (`{}`), which is not taken\nhelp: write the links and joints of all models into one, as `gz sdf` prints them",
                    shown(&element.name)
                )));
            }
            other => robot.leave_out(other),
        }
    }
    let is_static = text_of(model, "static").is_some_and(|text| ["1", "true"].contains(&text));
    if is_static {
        return Err(ImportError::new("the model is static: nothing moves"));
    }
    let bodies = tree(&mut robot, model, &frames)?;
    for link in model.named("link") {
        if let Some(body) = link.attribute("name").and_then(|name| bodies.get(name)) {
            add_mass(&mut robot, *body, link, &frames)?;
        }
    }
    couple(&mut robot, model)?;
    Ok(robot)
}

fn add_mass(
    robot: &mut Robot,
    body: usize,
    link: &XmlElement,
    frames: &Frames,
) -> Result<(), ImportError> {
    for element in &link.children {
        match element.name.as_str() {
            "inertial" => {}
            "pose" => continue,
            other => {
                robot.leave_out(&format!("{other} of links"));
                continue;
            }
        }
        let local = element.named("pose").next().map_or(Ok(FIXED), pose)?;
        let located = frames.frame_placement(name_of(link)?, 0)?.then(&local);
        let number = |element: &XmlElement, name: &'static str| match text_of(element, name) {
            Some(text) => Ok::<f64, ImportError>(exactly::<1>(text, name)?[0]),
            None => Ok(0.0),
        };
        let mass = number(element, "mass")?;
        let tensor = match element.named("inertia").next() {
            Some(inertia) => tensor(|name| number(inertia, name))?,
            None => [[0.0; 3]; 3],
        };
        robot.add_mass(body, &located, mass, &tensor);
    }
    Ok(())
}

/// Couples the axes that mimic others.
fn couple(robot: &mut Robot, model: &XmlElement) -> Result<(), ImportError> {
    for element in model.named("joint") {
        let axes = element.named("axis");
        for mimic in axes.flat_map(|axis| axis.named("mimic")) {
            let leader = mimic.attribute("joint").unwrap_or_default();
            if mimic.attribute("axis").is_some_and(|axis| axis != "axis") {
                return Err(ImportError::new(format!(
                    "the joint `{}` mimics a second axis, which is not taken",
                    shown(name_of(element)?)
                )));
            }
            let number = |name: &'static str, default: f64| match text_of(mimic, name) {
                Some(text) => Ok::<f64, ImportError>(exactly::<1>(text, name)?[0]),
                None => Ok(default),
            };
            let multiplier = number("multiplier", 1.0)?;
            let offset = number("offset", 0.0)? - multiplier * number("reference", 0.0)?;
            follow(robot, name_of(element)?, leader, vec![offset, multiplier])?;
        }
    }
    Ok(())
}
