//! A drawing of a page while it is converted.

use std::collections::BTreeMap;

use crate::document::Document;
use crate::error::ImportError;
use crate::names::shown;
use crate::number::plain;

use super::page_drawing::{Drawing, PageJoint};

/// A drawing with the indices of its parts in the document.
pub(super) struct Assembly {
    pub(super) drawing: Drawing,
    pub(super) document: Document,
    /// Joints of the document by ids. A slide has that of its pin.
    pub(super) joints: BTreeMap<String, usize>,
    /// Links of the document by ids of roots and of their parts.
    pub(super) links: BTreeMap<String, usize>,
}

impl Assembly {
    /// Returns the pin on the block of a slide: the older pages have a pin of its own there.
    pub(super) fn pin(&self, slide: &PageJoint) -> Option<&PageJoint> {
        let links = self.drawing.links.iter();
        let mut blocks = links.filter(|link| link.is_block && link.joints.contains(&slide.id));
        let block = blocks.next()?;
        let id = block.joints.iter().find(|id| **id != slide.id)?;
        self.drawing.joints.iter().find(|joint| joint.id == *id)
    }

    pub(super) fn joint(&self, id: &str) -> Result<usize, ImportError> {
        let joint = self.joints.get(id).copied();
        joint.ok_or_else(|| {
            ImportError::new(format!(
                "the address names the joint `{}`, which it lacks",
                shown(id)
            ))
        })
    }

    /// Returns the speed of a motor as text, and in degrees per second, counterclockwise.
    pub(super) fn speed(&self, joint: &PageJoint) -> (String, f64) {
        /// A revolution per minute.
        const DEGREES_PER_SECOND: f64 = 6.0;
        let (speed, is_clockwise) = if joint.speed == 0.0 {
            (self.drawing.speed, self.drawing.is_clockwise)
        } else {
            (joint.speed.abs(), joint.speed < 0.0)
        };
        let (sense, sign) = if is_clockwise {
            ("clockwise", -1.0)
        } else {
            ("counterclockwise", 1.0)
        };
        (
            format!("{sense} at {} revolutions per minute", plain(speed)),
            sign * DEGREES_PER_SECOND * speed,
        )
    }
}
