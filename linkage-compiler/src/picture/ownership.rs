//! Which part of a machine points, links and guides belong to: what a part brings along has its name in front.

use crate::ir::{Part, Picture};

use super::chains::Sketch;
use super::links::Links;
use super::samples::Seen;

pub(super) struct Owners {
    parts: Vec<String>,
    /// Of each point, the parts that have a name for it or for one that coincides; the machine itself is `None`.
    of_points: Vec<Vec<Option<usize>>>,
    fixed: Vec<bool>,
}

impl Owners {
    pub(super) fn new(sketch: &Sketch, seen: &Seen) -> Self {
        let parts = sketch.algebra.mechanism.parts.iter();
        let parts: Vec<String> = parts.map(|part| part.name.clone()).collect();
        let of_points = (0..seen.same.len()).map(|point| {
            let here = seen.aliases(point);
            let titles = here.filter_map(|own| sketch.points[own].name.as_ref());
            titles.map(|title| owner(&parts, &title.text)).collect()
        });
        // Where there are no parts, nobody asks.
        let points = if parts.is_empty() { 0 } else { seen.same.len() };
        Self {
            of_points: of_points.take(points).collect(),
            fixed: (0..points).map(|point| seen.is_fixed(point)).collect(),
            parts,
        }
    }

    /// The part that a link or guide is called after. One that is called after what the part is given, as a crank after `radius`, belongs to the
    /// first part that has names for all its moving points that have any.
    pub(super) fn of(&self, name: Option<&str>, points: &[usize]) -> Option<usize> {
        if self.parts.is_empty() {
            return None;
        }
        let by_name = name.and_then(|name| self.named(name));
        by_name.or_else(|| {
            let moving = points.iter().filter(|&&point| !self.fixed[point]);
            let named = moving.map(|&point| &self.of_points[point]);
            let named: Vec<_> = named.filter(|owners| !owners.is_empty()).collect();
            let has_all = |part: &usize| named.iter().all(|own| own.contains(&Some(*part)));
            (0..self.parts.len())
                .find(has_all)
                .filter(|_| !named.is_empty())
        })
    }

    /// The part that a name begins with.
    pub(super) fn named(&self, name: &str) -> Option<usize> {
        owner(&self.parts, name)
    }

    /// Whether a point has names of other parts only.
    pub(super) fn is_foreign(&self, point: usize, part: Option<usize>) -> bool {
        let (Some(part), Some(owners)) = (part, self.of_points.get(point)) else {
            return false;
        };
        !owners.is_empty() && owners.iter().all(|own| own.is_some_and(|own| own != part))
    }

    /// What each part has; `kept` are the points of the picture.
    pub(super) fn parts(&self, picture: &Picture, links: &Links, kept: &[usize]) -> Vec<Part> {
        let guides = picture.guides.iter().map(|guide| {
            let points = [guide.origin, guide.slider].map(|point| kept[point]);
            self.of(Some(&guide.name), &points)
        });
        let of_guides: Vec<_> = guides.collect();
        let of_links: Vec<_> = links.all.iter().map(|link| link.part).collect();
        let parts = self.parts.iter().enumerate().map(|(index, name)| {
            let own = |all: &[Option<usize>]| -> Vec<usize> {
                let mine = (0..all.len()).filter(|&member| all[member] == Some(index));
                mine.collect()
            };
            let (links, guides) = (own(&of_links), own(&of_guides));
            let has = |point: &usize| {
                let ends = |guide: &usize| {
                    let guide = &picture.guides[*guide];
                    [guide.origin, guide.slider]
                };
                self.of_points[kept[*point]].contains(&Some(index))
                    || links
                        .iter()
                        .any(|&own| picture.links[own].points.contains(point))
                    || guides.iter().any(|guide| ends(guide).contains(point))
            };
            Part {
                name: name.clone(),
                points: (0..picture.points.len()).filter(has).collect(),
                links,
                guides,
            }
        });
        parts.collect()
    }
}

/// The part that a name begins with.
fn owner(parts: &[String], name: &str) -> Option<usize> {
    let (first, _) = name.split_once('.')?;
    parts.iter().position(|part| part == first)
}
