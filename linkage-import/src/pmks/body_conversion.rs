//! A document of bodies while it is converted.

use std::collections::BTreeMap;

use crate::document::Document;
use crate::error::ImportError;
use crate::names::shown;

use super::body_document::{BodyDocument, Point, Pose, WORLD};

/// A document of bodies, with the indices of its parts in the mechanism.
pub(super) struct Conversion<'d> {
    pub(super) source: &'d BodyDocument,
    pub(super) document: Document,
    /// The link of each body.
    pub(super) links: Vec<usize>,
    /// The joint of each attachment.
    pub(super) joints: Vec<usize>,
    pub(super) bodies: BTreeMap<&'d str, usize>,
    pub(super) attachments: BTreeMap<&'d str, usize>,
}

impl Conversion<'_> {
    /// Returns the index of a body.
    pub(super) fn body(&self, id: &str) -> Result<usize, ImportError> {
        let body = self.bodies.get(id).copied();
        body.ok_or_else(|| ImportError::new(format!("the address lacks the body `{}`", shown(id))))
    }

    /// Returns the index of an attachment.
    pub(super) fn attachment(&self, id: &str) -> Result<usize, ImportError> {
        let attachment = self.attachments.get(id).copied();
        attachment
            .ok_or_else(|| ImportError::new(format!("the address lacks the point `{}`", shown(id))))
    }

    /// Returns the pose of a body. The fixed body is at the origin.
    pub(super) fn pose(&self, body: usize) -> Pose {
        let body = &self.source.bodies[body];
        if body.id == WORLD {
            Pose::default()
        } else {
            body.pose
        }
    }

    /// Returns the link of a body.
    pub(super) fn link(&self, id: &str) -> Result<usize, ImportError> {
        Ok(self.links[self.body(id)?])
    }

    /// Returns a point of a body in the drawing.
    pub(super) fn drawn_point(&self, id: &str, point: Point) -> Result<[f64; 2], ImportError> {
        Ok(self.pose(self.body(id)?).point(point))
    }
}
