//! Single joints: those of the tree, with their limits, and those that close loops.

use super::poses::{Frames, axis, name_of, text_of};
use crate::error::ImportError;
use crate::names::shown;
use crate::placement::Vector;
use crate::robots::attribute_numbers::exactly;
use crate::robots::model::{ClosingJoint, Closure, Motion, Robot, joint};
use crate::xml::XmlElement;

/// Adds the link at the end of a joint. Against its direction the axis points the other way.
pub(super) fn add_joint(
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

/// Adds a joint that closes a loop.
pub(super) fn close(
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
