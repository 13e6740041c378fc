//! Curved slots, as drawings need them.

use super::linkage::FRAME;
use super::locations::{angle, point};
use super::sheet::Sheet;
use crate::syntax::{ArcItem, Item};

/// Returns the arcs. A pin that a real link joins to the middle of its arc has none: the link is
/// drawn.
pub(super) fn items(sheet: &Sheet) -> Vec<Item> {
    let (linkage, bodies) = (sheet.linkage, sheet.bodies);
    let is_slot = |link: &usize| linkage.arcs.iter().any(|arc| arc.link == *link);
    let arcs = linkage.arcs.iter().filter(|arc| {
        let body = &bodies.list[bodies.of_link[arc.link]];
        body.links.iter().all(is_slot)
    });
    arcs.map(|arc| {
        let guide = bodies.of_link[arc.guide];
        Item::Arc(ArcItem {
            name: linkage.links[arc.link].name.clone(),
            slider: point(linkage, arc.pin),
            centre: point(linkage, arc.centre),
            turned: (guide != FRAME).then(|| angle(linkage, bodies.list[guide].lead())),
        })
    })
    .collect()
}
