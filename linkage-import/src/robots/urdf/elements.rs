//! Elements of URDF: attributes that must be there, and placements.

use crate::error::ImportError;
use crate::names::shown;
use crate::placement::{FIXED, Placement};
use crate::robots::attribute_numbers::attribute;
use crate::xml::XmlElement;

pub(super) fn twice(kind: &str, name: &str) -> ImportError {
    ImportError::new(format!("there are two {kind}s `{}`", shown(name)))
}

pub(super) fn required<'t>(element: &'t XmlElement, name: &str) -> Result<&'t str, ImportError> {
    element.attribute(name).ok_or_else(|| {
        ImportError::new(format!(
            "a `{}` has no attribute `{name}`",
            shown(&element.name)
        ))
    })
}

/// The link of `parent` or `child`.
pub(super) fn end<'t>(joint: &'t XmlElement, name: &'t str) -> Result<&'t str, ImportError> {
    let element = joint.named(name).next().ok_or_else(|| {
        ImportError::new(format!(
            "the joint `{}` has no `{name}`",
            shown(joint.attribute("name").unwrap_or_default())
        ))
    })?;
    required(element, "link")
}

/// The placement in `xyz` and `rpy`.
pub(super) fn placement(element: &XmlElement) -> Result<Placement, ImportError> {
    let xyz = attribute(element, "xyz")?.unwrap_or_default();
    let rpy = attribute(element, "rpy")?.unwrap_or_default();
    Ok(Placement::roll_pitch_yaw(xyz, rpy))
}

pub(super) fn origin(element: &XmlElement) -> Result<Placement, ImportError> {
    element.named("origin").next().map_or(Ok(FIXED), placement)
}
