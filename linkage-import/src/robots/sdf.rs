//! SDF: links and joints of a model as a graph, which may have loops.
//!
//! The format is that of the files `link.sdf`, `joint.sdf`, `pose.sdf` and `mimic.sdf` of the public
//! library `sdformat`.

use std::collections::BTreeMap;

use super::attribute_numbers::{exactly, numbers};
use super::model::{ClosingJoint, Closure, Mass, Motion, Robot, joint};
use super::placement::{FIXED, Placement, Vector};
use super::urdf::{axis_of, follow};
use crate::error::ImportError;
use crate::names::shown;
use crate::xml::XmlElement;

/// Poses that refer to each other more often than this are a circle.
const DEEPEST: usize = 64;

/// The names of frames with the elements that say where they are.
struct Frames<'t> {
    elements: BTreeMap<&'t str, &'t XmlElement>,
}

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

fn text_of<'t>(element: &'t XmlElement, name: &'t str) -> Option<&'t str> {
    let child = element.named(name).next()?;
    Some(child.text.trim()).filter(|text| !text.is_empty())
}

fn name_of(element: &XmlElement) -> Result<&str, ImportError> {
    element
        .attribute("name")
        .ok_or_else(|| ImportError::new(format!("a `{}` has no name", shown(&element.name))))
}

/// The numbers of a pose.
fn pose(element: &XmlElement) -> Result<Placement, ImportError> {
    let is_quaternion = element.attribute("rotation_format") == Some("quat_xyzw");
    if is_quaternion {
        let [x, y, z, a, b, c, w] = exactly(&element.text, "a pose")?;
        return Placement::quaternion([x, y, z], [w, a, b, c])
            .ok_or_else(|| ImportError::new("the quaternion of a pose is zero"));
    }
    let found = numbers(&element.text, "a pose")?;
    let [x, y, z, roll, pitch, yaw] = match found[..] {
        [] => [0.0; 6],
        [x, y, z, a, b, c] => [x, y, z, a, b, c],
        _ => {
            return Err(ImportError::new(format!(
                "a pose has {} numbers where 6 are expected",
                found.len()
            )));
        }
    };
    let is_degrees = ["true", "1"].contains(&element.attribute("degrees").unwrap_or_default());
    let angle = |value: f64| {
        if is_degrees {
            value.to_radians()
        } else {
            value
        }
    };
    Ok(Placement::roll_pitch_yaw(
        [x, y, z],
        [roll, pitch, yaw].map(angle),
    ))
}

impl Frames<'_> {
    /// The placement of a link, a joint or a frame in the model.
    fn frame_placement(&self, name: &str, depth: usize) -> Result<Placement, ImportError> {
        if name == "__model__" || name == "world" || name.is_empty() {
            return Ok(FIXED);
        }
        if depth > DEEPEST {
            return Err(ImportError::new(format!(
                "the pose of `{}` refers to itself",
                shown(name)
            )));
        }
        let Some(element) = self.elements.get(name) else {
            return Err(ImportError::new(format!(
                "there is no link, joint or frame `{}`",
                shown(name)
            )));
        };
        let pose_element = element.named("pose").next();
        let local = pose_element.map_or(Ok(FIXED), pose)?;
        // Without a name, a joint is in its child and a frame in what it is attached to.
        let default = match element.name.as_str() {
            "joint" => text_of(element, "child").unwrap_or_default(),
            "frame" => element.attribute("attached_to").unwrap_or_default(),
            _ => "",
        };
        let relative = pose_element.and_then(|pose| pose.attribute("relative_to"));
        let relative = relative.filter(|name| !name.is_empty()).unwrap_or(default);
        Ok(self.frame_placement(relative, depth + 1)?.then(&local))
    }

    /// The link that a link or a frame moves with; `None` for the world.
    fn link(&self, name: &str, depth: usize) -> Result<Option<String>, ImportError> {
        if name == "world" {
            return Ok(None);
        }
        let element = self.elements.get(name).filter(|_| depth < DEEPEST);
        let Some(element) = element else {
            return Err(ImportError::new(format!(
                "a joint names `{}`, which is no link of the model",
                shown(name)
            )));
        };
        match element.name.as_str() {
            "link" => Ok(Some(name.to_owned())),
            "joint" => self.link(text_of(element, "child").unwrap_or_default(), depth + 1),
            _ => self.link(
                element.attribute("attached_to").unwrap_or_default(),
                depth + 1,
            ),
        }
    }
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

/// The axis of a joint in the model.
fn axis(element: &XmlElement, which: &str, frames: &Frames) -> Result<Vector, ImportError> {
    let name = name_of(element)?;
    let located = frames.frame_placement(name, 0)?;
    let Some(axis) = element.named(which).next() else {
        return axis_of(located.direction([0.0, 0.0, 1.0]), name);
    };
    let Some(xyz) = axis.named("xyz").next() else {
        return axis_of(located.direction([0.0, 0.0, 1.0]), name);
    };
    let local: Vector = exactly(&xyz.text, "an axis")?;
    // Files of version 1.6 and before may give the axis in the axes of the model.
    let old = text_of(axis, "use_parent_model_frame");
    let located = match xyz
        .attribute("expressed_in")
        .filter(|name| !name.is_empty())
    {
        Some(frame) => frames.frame_placement(frame, 0)?,
        None if old.is_some_and(|text| ["1", "true"].contains(&text)) => FIXED,
        None => located,
    };
    axis_of(located.direction(local), name)
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
    robot.closures.push(Closure {
        name: name.to_owned(),
        closing,
        bodies,
        at: [at; 2],
    });
    Ok(())
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
        let mut tensor = [[0.0; 3]; 3];
        if let Some(inertia) = element.named("inertia").next() {
            let names = [
                ["ixx", "ixy", "ixz"],
                ["ixy", "iyy", "iyz"],
                ["ixz", "iyz", "izz"],
            ];
            for (row, names) in tensor.iter_mut().zip(names) {
                for (value, name) in row.iter_mut().zip(names) {
                    *value = number(inertia, name)?;
                }
            }
        }
        robot.bodies[body].masses.push(Mass {
            mass,
            centre: located.origin,
            inertia: located.tensor(&tensor),
        });
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
