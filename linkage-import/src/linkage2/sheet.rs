//! A file of Linkage while it is read, and attributes of its elements.

use std::collections::BTreeMap;

use crate::document::Document;
use crate::error::ImportError;
use crate::names::shown;
use crate::xml::XmlElement;

/// The layer of the mechanism. Other layers have drawings and measures.
const MECHANISM_LAYER: u32 = 16;

/// A file while it is read.
pub(super) struct Sheet<'t> {
    pub(super) root: &'t XmlElement,
    pub(super) document: Document,
    /// The length of a unit of the file, in the unit of the document.
    pub(super) scale: f64,
    /// Joints by the ids of connectors.
    pub(super) joints: BTreeMap<i64, usize>,
    /// The elements of links that are taken, each with its index in the document. An id occurs
    /// several times in some files; the program takes the first one then.
    pub(super) bodies: Vec<(&'t XmlElement, usize)>,
}

/// Returns true for elements of the layer of the mechanism, which is that of elements without one.
pub(super) fn is_mechanism(element: &XmlElement) -> bool {
    let layers = element.attribute("layer").map(str::trim);
    let layers: u32 = layers.and_then(|text| text.parse().ok()).unwrap_or(0);
    (layers == 0 || layers & MECHANISM_LAYER != 0) && !is_true(element, "measurementelement")
}

pub(super) fn is_true(element: &XmlElement, name: &str) -> bool {
    element.attribute(name) == Some("true")
}

/// Returns the name of an element unless it is blank.
pub(super) fn named(element: &XmlElement) -> Option<String> {
    let name = element.attribute("name")?.trim();
    (!name.is_empty()).then(|| name.to_owned())
}

pub(super) fn identifier(element: &XmlElement) -> Result<i64, ImportError> {
    let text = element.attribute("id").unwrap_or_default();
    text.trim().parse().map_err(|_| {
        ImportError::new(format!(
            "an element `{}` has the id `{}`, which is no whole number",
            shown(&element.name),
            shown(text)
        ))
    })
}

impl Sheet<'_> {
    /// Returns the joint of an element that refers to a connector; `None` with a warning if there
    /// is none, as the program does.
    pub(super) fn referred(&mut self, element: &XmlElement) -> Result<Option<usize>, ImportError> {
        let id = identifier(element)?;
        let joint = self.joints.get(&id).copied();
        if joint.is_none() {
            self.document.warnings.push(format!(
                "`{}` refers to the connector {id}, which is no part of the mechanism",
                shown(&element.name)
            ));
        }
        Ok(joint)
    }

    /// Returns the first link with an id.
    pub(super) fn body(&self, id: &str) -> Option<usize> {
        let id = id.trim();
        let mut bodies = self.bodies.iter();
        let found = bodies.find(|body| body.0.attribute("id").map(str::trim) == Some(id))?;
        Some(found.1)
    }
}
