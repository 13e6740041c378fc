//! URDF: links and joints in a tree, `mimic`, and `loop_joint`.
//!
//! The format is that of the parser of ROS (`urdfdom`). `loop_joint` is the extension of Isaac Sim
//! for closed loops: two links, each with the located of the joint in it.

use std::collections::BTreeMap;

use super::attribute_numbers::attribute;
use super::model::{ClosingJoint, Closure, Mass, Motion, Robot, joint, tensor};
use super::placement::{FIXED, Placement, Vector, unit};
use crate::error::ImportError;
use crate::names::shown;
use crate::xml::XmlElement;

/// Reads a robot.
pub(super) fn read(root: &XmlElement) -> Result<Robot, ImportError> {
    if root.name != "robot" {
        return Err(ImportError::new(format!(
            "the file begins with `{}`, and URDF with `robot`",
            shown(&root.name)
        )));
    }
    let mut robot = Robot::new(root.attribute("name").unwrap_or("robot"));
    let mut links: BTreeMap<&str, &XmlElement> = BTreeMap::new();
    for link in root.named("link") {
        if links.insert(required(link, "name")?, link).is_some() {
            return Err(twice("link", required(link, "name")?));
        }
    }
    let joints: Vec<&XmlElement> = root.named("joint").collect();
    let mut children: BTreeMap<&str, Vec<&XmlElement>> = BTreeMap::new();
    let mut has_parent: BTreeMap<&str, &str> = BTreeMap::new();
    for joint in &joints {
        let [parent, child] = [end(joint, "parent")?, end(joint, "child")?];
        for name in [parent, child] {
            if !links.contains_key(name) {
                return Err(ImportError::new(format!(
                    "there is no link `{}`, which the joint `{}` names",
                    shown(name),
                    shown(required(joint, "name")?)
                )));
            }
        }
        children.entry(parent).or_default().push(joint);
        let name = required(joint, "name")?;
        if let Some(other) = has_parent.insert(child, name) {
            return Err(ImportError::new(format!(
                "the link `{}` is the child of two joints, `{}` and `{}`: URDF is a tree\nhelp: write one of them as `<loop_joint name=\"...\" type=\"revolute\"><link1 link=\"...\" xyz=\"...\"/><link2 link=\"...\" xyz=\"...\"/></loop_joint>`, or save the model as SDF",
                shown(child),
                shown(other),
                shown(name)
            )));
        }
    }
    let mut roots = links.keys().filter(|link| !has_parent.contains_key(**link));
    let Some(first) = roots.next() else {
        return Err(ImportError::new("every link is the child of a joint"));
    };
    if let Some(second) = roots.next() {
        return Err(ImportError::new(format!(
            "the links `{}` and `{}` both have no parent: URDF has one root",
            shown(first),
            shown(second)
        )));
    }
    let mut placed: BTreeMap<&str, (usize, Placement)> = BTreeMap::new();
    let mut open = vec![(*first, 0, FIXED)];
    while let Some((link, body, at)) = open.pop() {
        placed.insert(link, (body, at));
        add_mass(&mut robot, body, links[link], &at)?;
        let below = children.get(link).map_or(&[][..], |joints| &joints[..]);
        for joint in below {
            let (child, index, located) = add_joint(&mut robot, joint, body, &at)?;
            open.push((child, index, located));
        }
    }
    mimic(&mut robot, &joints)?;
    for element in &root.children {
        match element.name.as_str() {
            "link" | "joint" => {}
            "loop_joint" => add_loop(&mut robot, element, &placed)?,
            "transmission" | "ros2_control" => drives(&mut robot, element),
            other => robot.leave_out(other),
        }
    }
    Ok(robot)
}

fn twice(kind: &str, name: &str) -> ImportError {
    ImportError::new(format!("there are two {kind}s `{}`", shown(name)))
}

fn required<'t>(element: &'t XmlElement, name: &str) -> Result<&'t str, ImportError> {
    element.attribute(name).ok_or_else(|| {
        ImportError::new(format!(
            "a `{}` has no attribute `{name}`",
            shown(&element.name)
        ))
    })
}

/// The link of `parent` or `child`.
fn end<'t>(joint: &'t XmlElement, name: &'t str) -> Result<&'t str, ImportError> {
    let element = joint.named(name).next().ok_or_else(|| {
        ImportError::new(format!(
            "the joint `{}` has no `{name}`",
            shown(joint.attribute("name").unwrap_or_default())
        ))
    })?;
    required(element, "link")
}

/// The placement in `xyz` and `rpy`.
fn placement(element: &XmlElement) -> Result<Placement, ImportError> {
    let xyz = attribute(element, "xyz")?.unwrap_or_default();
    let rpy = attribute(element, "rpy")?.unwrap_or_default();
    Ok(Placement::roll_pitch_yaw(xyz, rpy))
}

fn origin(element: &XmlElement) -> Result<Placement, ImportError> {
    element.named("origin").next().map_or(Ok(FIXED), placement)
}

fn add_joint<'t>(
    robot: &mut Robot,
    element: &'t XmlElement,
    parent: usize,
    on: &Placement,
) -> Result<(&'t str, usize, Placement), ImportError> {
    let name = required(element, "name")?;
    let child = end(element, "child")?;
    let located = on.then(&origin(element)?);
    let axis = match element.named("axis").next() {
        Some(axis) => attribute(axis, "xyz")?.unwrap_or([1.0, 0.0, 0.0]),
        None => [1.0, 0.0, 0.0],
    };
    let kind = required(element, "type")?;
    let axis = || axis_of(located.direction(axis), name);
    let motion = match kind {
        "revolute" | "continuous" => Motion::Hinge(axis()?),
        "prismatic" => Motion::Slide(axis()?),
        "floating" => Motion::Free,
        "fixed" => {
            note_rest(robot, element);
            return Ok((child, parent, located));
        }
        other => {
            return Err(ImportError::new(format!(
                "the joint `{}` is `{}`, which is not taken; `revolute`, `continuous`, `prismatic`, `floating` and `fixed` are",
                shown(name),
                shown(other)
            )));
        }
    };
    if robot.joint_named(name).is_some() {
        return Err(twice("joint", name));
    }
    let mut added = joint(name, motion, parent, located.origin);
    let limit = element.named("limit").next();
    if let Some(limit) = limit.filter(|_| kind != "continuous" && motion != Motion::Free) {
        let end = |name: &str| Ok(attribute::<1>(limit, name)?.map_or(0.0, |[value]| value));
        added.range = Some([end("lower")?, end("upper")?]);
    }
    note_rest(robot, element);
    let index = robot.add(child, added)?;
    Ok((child, index, located))
}

/// Counts what a joint has besides its located.
fn note_rest(robot: &mut Robot, joint: &XmlElement) {
    for element in &joint.children {
        match element.name.as_str() {
            "origin" | "parent" | "child" | "axis" | "mimic" => {}
            "limit" => {
                let limits = element.attributes.iter();
                let other = limits.filter(|limit| limit.0 != "lower" && limit.0 != "upper");
                for (name, _) in other {
                    robot.leave_out(&format!("{name} of joints"));
                }
            }
            other => robot.leave_out(&format!("{other} of joints")),
        }
    }
}

pub(super) fn axis_of(axis: Vector, name: &str) -> Result<Vector, ImportError> {
    unit(axis)
        .ok_or_else(|| ImportError::new(format!("the axis of the joint `{}` is zero", shown(name))))
}

fn add_mass(
    robot: &mut Robot,
    body: usize,
    link: &XmlElement,
    at: &Placement,
) -> Result<(), ImportError> {
    for element in &link.children {
        if element.name != "inertial" {
            robot.leave_out(&format!("{} of links", element.name));
            continue;
        }
        let located = at.then(&origin(element)?);
        let value = |name: &'static str, of: &XmlElement| {
            Ok(attribute::<1>(of, name)?.map_or(0.0, |[value]| value))
        };
        let mass = match element.named("mass").next() {
            Some(mass) => value("value", mass)?,
            None => 0.0,
        };
        let tensor = match element.named("inertia").next() {
            Some(inertia) => tensor(|name| value(name, inertia))?,
            None => [[0.0; 3]; 3],
        };
        robot.bodies[body].masses.push(Mass {
            mass,
            centre: located.origin,
            inertia: located.tensor(&tensor),
        });
    }
    Ok(())
}

/// Couples the joints that mimic others.
fn mimic(robot: &mut Robot, joints: &[&XmlElement]) -> Result<(), ImportError> {
    for element in joints {
        let name = required(element, "name")?;
        for mimic in element.named("mimic") {
            let leader = required(mimic, "joint")?;
            let number = |name: &str, default: f64| {
                Ok(attribute::<1>(mimic, name)?.map_or(default, |[value]| value))
            };
            let powers = vec![number("offset", 0.0)?, number("multiplier", 1.0)?];
            follow(robot, name, leader, powers)?;
        }
    }
    Ok(())
}

/// Makes a joint follow another one.
pub(super) fn follow(
    robot: &mut Robot,
    name: &str,
    leader: &str,
    powers: Vec<f64>,
) -> Result<(), ImportError> {
    let [follower, led_by] = [name, leader].map(|name| robot.joint_named(name));
    let (Some(follower), Some(led_by)) = (follower, led_by) else {
        return Err(ImportError::new(format!(
            "the joint `{}` follows `{}`, and one of them does not move",
            shown(name),
            shown(leader)
        )));
    };
    // A circle of joints that follow each other has no leader.
    let mut current = led_by;
    loop {
        if current == follower {
            return Err(ImportError::new(format!(
                "the joint `{}` follows itself",
                shown(name)
            )));
        }
        let joint = robot.bodies[current].joint.as_ref();
        match joint.and_then(|joint| joint.follows.as_ref()) {
            Some((next, _)) => current = *next,
            None => break,
        }
    }
    if let Some(joint) = &mut robot.bodies[follower].joint {
        joint.follows = Some((led_by, powers));
    }
    Ok(())
}

fn add_loop(
    robot: &mut Robot,
    element: &XmlElement,
    placed: &BTreeMap<&str, (usize, Placement)>,
) -> Result<(), ImportError> {
    let name = required(element, "name")?;
    let end = |which: &str| {
        let link = element.named(which).next().ok_or_else(|| {
            ImportError::new(format!("the loop `{}` has no `{which}`", shown(name)))
        })?;
        let named = required(link, "link")?;
        let (body, at) = placed.get(named).ok_or_else(|| {
            ImportError::new(format!(
                "the loop `{}` names the link `{}`, which the file does not have",
                shown(name),
                shown(named)
            ))
        })?;
        Ok::<_, ImportError>((*body, at.then(&placement(link)?)))
    };
    let [(first, at), (second, other)] = [end("link1")?, end("link2")?];
    let closing = match required(element, "type")? {
        "spherical" | "ball" => ClosingJoint::Point,
        "revolute" | "continuous" => {
            robot.warnings.push(format!(
                "the loop `{}` is a hinge whose axis is not in the file: a ball is written, which is the same if all axes are parallel",
                shown(name)
            ));
            ClosingJoint::Point
        }
        "fixed" => ClosingJoint::Weld,
        other => {
            return Err(ImportError::new(format!(
                "the loop `{}` is `{}`, which is not taken; `spherical`, `revolute` and `fixed` are",
                shown(name),
                shown(other)
            )));
        }
    };
    robot.closures.push(Closure {
        name: name.to_owned(),
        closing,
        bodies: [first, second],
        at: [at.origin, other.origin],
    });
    Ok(())
}

/// Joints that a transmission or a controller commands are driven.
fn drives(robot: &mut Robot, element: &XmlElement) {
    let mut open = vec![element];
    while let Some(element) = open.pop() {
        let name = element.attribute("name");
        if element.name == "joint"
            && let Some(body) = name.and_then(|name| robot.joint_named(name))
            && let Some(joint) = &mut robot.bodies[body].joint
        {
            joint.is_driven = true;
        }
        open.extend(&element.children);
    }
}
