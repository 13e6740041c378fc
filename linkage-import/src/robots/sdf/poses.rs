//! Poses of SDF: numbers, frames that refer to each other, axes of joints.

use std::collections::BTreeMap;

use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{FIXED, Placement, Vector};
use crate::robots::attribute_numbers::{axis_of, exactly, numbers};
use crate::xml::XmlElement;

/// Poses that refer to each other more often than this are a circle.
const DEEPEST: usize = 64;

/// The names of frames with the elements that say where they are.
pub(super) struct Frames<'t> {
    pub(super) elements: BTreeMap<&'t str, &'t XmlElement>,
}

pub(super) fn text_of<'t>(element: &'t XmlElement, name: &'t str) -> Option<&'t str> {
    let child = element.named(name).next()?;
    Some(child.text.trim()).filter(|text| !text.is_empty())
}

pub(super) fn name_of(element: &XmlElement) -> Result<&str, ImportError> {
    element
        .attribute("name")
        .ok_or_else(|| ImportError::new(format!("a `{}` has no name", shown(&element.name))))
}

/// The numbers of a pose.
pub(super) fn pose(element: &XmlElement) -> Result<Placement, ImportError> {
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
    pub(super) fn frame_placement(
        &self,
        name: &str,
        depth: usize,
    ) -> Result<Placement, ImportError> {
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
    pub(super) fn link(&self, name: &str, depth: usize) -> Result<Option<String>, ImportError> {
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

/// The axis of a joint in the model.
pub(super) fn axis(
    element: &XmlElement,
    which: &str,
    frames: &Frames,
) -> Result<Vector, ImportError> {
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
