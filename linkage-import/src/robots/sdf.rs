//! SDF: links and joints of a model as a graph, which may have loops.
//!
//! The format is that of the files `link.sdf`, `joint.sdf`, `pose.sdf` and `mimic.sdf` of the public
//! library `sdformat`.

use std::collections::BTreeMap;

use super::attribute_numbers::exactly;
use super::model::{ClosingJoint, Closure, Motion, Robot, joint, tensor};
use super::urdf::follow;
use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{FIXED, Vector};
use crate::xml::XmlElement;

mod poses;

use poses::{Frames, axis, name_of, pose, text_of};

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

/// A joint with the links that it joins.
struct Ends<'t> {
    element: &'t XmlElement,
    parent: Option<String>,
    child: Option<String>,
}

/// Makes a tree of the joints, beginning at the world, or at the first link without one. The others
/// close loops. Returns the bodies of links.
fn tree(
    robot: &mut Robot,
    model: &XmlElement,
    frames: &Frames,
) -> Result<BTreeMap<String, usize>, ImportError> {
    let mut joints: Vec<Ends> = Vec::new();
    for element in model.named("joint") {
        let end = |name: &str| frames.link(text_of(element, name).unwrap_or_default(), 0);
        joints.push(Ends {
            element,
            parent: end("parent")?,
            child: end("child")?,
        });
    }
    let links: Vec<&str> = model
        .named("link")
        .map(name_of)
        .collect::<Result<_, ImportError>>()?;
    let mut bodies: BTreeMap<String, usize> = BTreeMap::new();
    let is_held = joints
        .iter()
        .any(|joint| joint.parent.is_none() || joint.child.is_none());
    if !is_held && let Some(first) = links.first() {
        bodies.insert((*first).to_owned(), 0);
        robot.warnings.push(format!(
            "no joint holds the model in the world: the link `{}` is the frame",
            shown(first)
        ));
    }
    let mut used = vec![false; joints.len()];
    // In the order of the file, as far as a joint has one end on a body that is known.
    while let Some((index, ends)) = joints.iter().enumerate().find(|(index, ends)| {
        let known =
            |link: &Option<String>| link.as_ref().is_none_or(|link| bodies.contains_key(link));
        !used[*index] && known(&ends.parent) != known(&ends.child)
    }) {
        used[index] = true;
        let body = |link: &Option<String>| match link {
            None => Some(0),
            Some(link) => bodies.get(link).copied(),
        };
        let (on, link, is_forward) = match (body(&ends.parent), &ends.child, &ends.parent) {
            (Some(on), Some(child), _) => (on, child, true),
            (_, _, Some(parent)) => (body(&ends.child).unwrap_or_default(), parent, false),
            (_, _, None) => continue,
        };
        let added = add_joint(robot, ends.element, frames, on, link, is_forward)?;
        bodies.insert(link.clone(), added);
    }
    for (ends, is_used) in joints.iter().zip(&used) {
        if !is_used {
            let body = |link: &Option<String>| match link {
                None => Some(0),
                Some(link) => bodies.get(link).copied(),
            };
            match [body(&ends.parent), body(&ends.child)] {
                [Some(parent), Some(child)] => {
                    close(robot, ends.element, frames, [child, parent])?;
                }
                _ => robot.warnings.push(format!(
                    "the joint `{}` joins links that nothing joins to the frame: it is left out",
                    shown(name_of(ends.element)?)
                )),
            }
        }
    }
    for link in links {
        if !bodies.contains_key(link) {
            robot.warnings.push(format!(
                "the link `{}` is joined to nothing: it is left out",
                shown(link)
            ));
        }
    }
    Ok(bodies)
}

/// Adds the link at the end of a joint. Against its direction the axis points the other way.
fn add_joint(
    robot: &mut Robot,
    element: &XmlElement,
    frames: &Frames,
    on: usize,
    link: &str,
    is_forward: bool,
) -> Result<usize, ImportError> {
    let name = name_of(element)?;
    let at = frames.frame_placement(name, 0)?.origin;
    let directed = |which: &str| {
        let axis = axis(element, which, frames)?;
        Ok::<Vector, ImportError>(match is_forward {
            true => axis,
            false => axis.map(|component| -component),
        })
    };
    note_rest(robot, element);
    let kind = element.attribute("type").unwrap_or_default();
    let motion = match kind {
        "revolute" | "continuous" => Motion::Hinge(directed("axis")?),
        "prismatic" => Motion::Slide(directed("axis")?),
        "ball" => Motion::Ball,
        "fixed" => return Ok(on),
        "universal" | "revolute2" => {
            let [first, second] = match is_forward {
                true => ["axis", "axis2"],
                false => ["axis2", "axis"],
            };
            let cross = joint(
                &format!("{name}_1"),
                Motion::Hinge(directed(first)?),
                on,
                at,
            );
            let middle = robot.add(&format!("{name}_cross"), cross)?;
            let second = joint(
                &format!("{name}_2"),
                Motion::Hinge(directed(second)?),
                middle,
                at,
            );
            return robot.add(link, second);
        }
        other => {
            return Err(ImportError::new(format!(
                "the joint `{}` is `{}`, which is not taken; `revolute`, `continuous`, `prismatic`, `ball`, `universal`, `revolute2` and `fixed` are",
                shown(name),
                shown(other)
            )));
        }
    };
    if robot.joint_named(name).is_some() {
        return Err(ImportError::new(format!(
            "there are two joints `{}`",
            shown(name)
        )));
    }
    let mut added = joint(name, motion, on, at);
    added.range = range(element)?;
    robot.add(link, added)
}

/// The limits of the first axis, if both are finite.
fn range(element: &XmlElement) -> Result<Option<[f64; 2]>, ImportError> {
    let axis = element.named("axis").next();
    let Some(limit) = axis.and_then(|axis| axis.named("limit").next()) else {
        return Ok(None);
    };
    let end = |name: &str| match text_of(limit, name) {
        // 1e16 stands for no limit in older files.
        Some(text) if !text.contains("inf") && !text.contains("e+16") && !text.contains("e16") => {
            Ok::<_, ImportError>(Some(exactly::<1>(text, "a limit")?[0]))
        }
        _ => Ok(None),
    };
    Ok(end("lower")?
        .zip(end("upper")?)
        .map(|(low, high)| [low, high]))
}

fn note_rest(robot: &mut Robot, joint: &XmlElement) {
    for element in &joint.children {
        match element.name.as_str() {
            "pose" | "parent" | "child" => {}
            "axis" | "axis2" => {
                for part in &element.children {
                    let known = ["xyz", "limit", "mimic", "use_parent_model_frame"];
                    if !known.contains(&part.name.as_str()) {
                        robot.leave_out(&format!("{} of joints", part.name));
                    }
                }
            }
            other => robot.leave_out(&format!("{other} of joints")),
        }
    }
}

fn close(
    robot: &mut Robot,
    element: &XmlElement,
    frames: &Frames,
    bodies: [usize; 2],
) -> Result<(), ImportError> {
    let name = name_of(element)?;
    let at = frames.frame_placement(name, 0)?.origin;
    note_rest(robot, element);
    let closing = match element.attribute("type").unwrap_or_default() {
        "revolute" | "continuous" => ClosingJoint::Hinge(axis(element, "axis", frames)?),
        "prismatic" => ClosingJoint::Slide(axis(element, "axis", frames)?),
        "ball" => ClosingJoint::Point,
        "fixed" => ClosingJoint::Weld,
        other => {
            return Err(ImportError::new(format!(
                "the joint `{}`, which closes a loop, is `{}`, which is not taken there",
                shown(name),
                shown(other)
            )));
        }
    };
    robot.close(Closure {
        name: name.to_owned(),
        closing,
        bodies,
        at: [at; 2],
    })
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
