//! The part of a machine to which points, links and guides belong. The names of a part's items
//! begin with its name.

use crate::ir::{Picture, PicturePart};
use crate::model::Mechanism;
use crate::picture::marks::Spot;
use crate::picture::raw_link::RawLink;
use crate::picture::samples::Samples;

pub(super) struct Ownership {
    parts: Vec<String>,
    /// For each point, the parts that have a name for it or for one that coincides; the machine
    /// itself is `None`.
    of_points: Vec<Vec<Option<usize>>>,
    fixed: Vec<bool>,
}

impl Ownership {
    pub(super) fn new(mechanism: &Mechanism, points: &[Spot], samples: &Samples) -> Self {
        let parts = mechanism.parts.iter();
        let parts: Vec<String> = parts.map(|part| part.name.clone()).collect();
        let of_points = (0..samples.same.len()).map(|point| {
            let here = samples.aliases(point);
            let titles = here.filter_map(|alias| points[alias].name.as_ref());
            titles.map(|title| owner(&parts, &title.text)).collect()
        });
        // Where there are no parts, nobody asks.
        let points = if parts.is_empty() {
            0
        } else {
            samples.same.len()
        };
        Self {
            of_points: of_points.take(points).collect(),
            fixed: (0..points).map(|point| samples.is_fixed(point)).collect(),
            parts,
        }
    }

    /// The part after which a link or guide is named. If the name comes from an argument of the
    /// part, as a crank's from `radius`, it belongs to the first part that has names for all its
    /// moving points that have any.
    pub(super) fn part_of(&self, name: Option<&str>, points: &[usize]) -> Option<usize> {
        if self.parts.is_empty() {
            return None;
        }
        let by_name = name.and_then(|name| self.named(name));
        by_name.or_else(|| {
            let moving = points.iter().filter(|&&point| !self.fixed[point]);
            let named = moving.map(|&point| &self.of_points[point]);
            let named: Vec<_> = named.filter(|owners| !owners.is_empty()).collect();
            let has_all = |part: &usize| named.iter().all(|owners| owners.contains(&Some(*part)));
            (0..self.parts.len())
                .find(has_all)
                .filter(|_| !named.is_empty())
        })
    }

    /// The part that a name begins with.
    pub(super) fn named(&self, name: &str) -> Option<usize> {
        owner(&self.parts, name)
    }

    /// True if a point has names of other parts only.
    pub(super) fn is_foreign(&self, point: usize, part: Option<usize>) -> bool {
        let (Some(part), Some(owners)) = (part, self.of_points.get(point)) else {
            return false;
        };
        !owners.is_empty()
            && owners
                .iter()
                .all(|owner| owner.is_some_and(|owner| owner != part))
    }

    /// The items of each part; `kept` are the points of the picture.
    pub(super) fn parts(
        &self,
        picture: &Picture,
        links: &[RawLink],
        kept: &[usize],
    ) -> Vec<PicturePart> {
        let guides = picture.guides.iter().map(|guide| {
            let points = [guide.origin, guide.slider].map(|point| kept[point]);
            self.part_of(Some(&guide.name), &points)
        });
        let of_guides: Vec<_> = guides.collect();
        let of_links: Vec<_> = links.iter().map(|link| link.part).collect();
        let parts = self.parts.iter().enumerate().map(|(index, name)| {
            let members = |parts: &[Option<usize>]| -> Vec<usize> {
                let mine = (0..parts.len()).filter(|&member| parts[member] == Some(index));
                mine.collect()
            };
            let (links, guides) = (members(&of_links), members(&of_guides));
            let has = |point: &usize| {
                let ends = |guide: &usize| {
                    let guide = &picture.guides[*guide];
                    [guide.origin, guide.slider]
                };
                self.of_points[kept[*point]].contains(&Some(index))
                    || links
                        .iter()
                        .any(|&link| picture.links[link].points.contains(point))
                    || guides.iter().any(|guide| ends(guide).contains(point))
            };
            PicturePart {
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
