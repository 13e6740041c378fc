//! URDF: links and joints in a tree, `mimic`, `loop_joint`, and a table of closures.
//!
//! The format is that of the parser of ROS (`urdfdom`). `loop_joint` is the extension of Isaac Sim
//! for closed loops.

mod closure_table;
mod closures;
mod elements;
mod masses;
mod placed_links;

use std::collections::BTreeMap;

use self::closures::add_loop;
use self::elements::{end, origin, required, twice};
use self::masses::add_mass;
use self::placed_links::PlacedLinks;
use super::attribute_numbers::{attribute, axis_of};
use super::model::{Motion, Robot, joint};
use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{FIXED, Placement};
use crate::xml::XmlElement;

/// Reads a robot, with the closures of a table in CSV.
pub(super) fn read(root: &XmlElement, table: Option<&str>) -> Result<Robot, ImportError> {
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
                "the link `{}` is the child of two joints, `{}` and `{}`: URDF is a tree\nhelp: write one of them as `<loop_joint name=\"...\" type=\"revolute\"><link1 link=\"...\" xyz=\"...\"/><link2 link=\"...\" xyz=\"...\"/></loop_joint>`, or as a line of the table of `--closures`",
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
    let mut placed = PlacedLinks::new();
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
    if let Some(table) = table {
        closure_table::add(&mut robot, table, &placed)?;
    }
    Ok(robot)
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

/// Counts what a joint has besides its placement.
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
