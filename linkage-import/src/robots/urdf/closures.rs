//! Loops that the file closes by `loop_joint`.

use super::elements::{placement, required};
use super::placed_links::PlacedLinks;
use crate::error::ImportError;
use crate::names::shown;
use crate::robots::model::{ClosingJoint, Closure, Robot};
use crate::xml::XmlElement;

/// Adds the closure of an element: two links, each with the placement of the joint in it.
pub(super) fn add_loop(
    robot: &mut Robot,
    element: &XmlElement,
    placed: &PlacedLinks,
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
    robot.close(Closure {
        name: name.to_owned(),
        closing,
        bodies: [first, second],
        at: [at.origin, other.origin],
    })
}
