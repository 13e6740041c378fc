//! The picture with names for everything, without what is not needed.

use linkage_symbolic::Vn;

use crate::unit::{Guide, GuideOn, GuideShape, Link, Picture, Point, PointKind};

use super::Found;
use super::chains::Sketch;
use super::guides::Guides;
use super::joints::Turning;
use super::links::Links;
use super::owners::Owners;
use super::seen::Seen;

pub(super) fn named<'m>(
    sketch: &Sketch<'_, 'm>,
    seen: &Seen,
    links: &Links<'m>,
    guides: &Guides<'m>,
    owners: &Owners,
) -> Found<'m> {
    let namer = Namer {
        sketch,
        seen,
        links,
        guides,
        link_names: link_names(links),
    };
    let kept: Vec<(usize, PointKind)> = (0..sketch.points.len())
        .filter(|&point| seen.same[point] == point)
        .filter_map(|point| Some((point, namer.kind(point)?)))
        .collect();
    // Points that are nowhere are left out, and what hangs on them.
    let place = |point: usize| kept.iter().position(|(own, _)| *own == seen.same[point]);
    let mut names = Vec::new();
    let points = kept.iter().map(|&(point, kind)| {
        let name = unique(namer.name(point), &mut names);
        Point { name, kind }
    });
    let mut picture = Picture {
        dimension: sketch.dimension,
        points: points.collect(),
        ..Picture::default()
    };
    picture.links = links
        .all
        .iter()
        .zip(&namer.link_names)
        .map(|(link, name)| Link {
            name: name.clone(),
            points: link
                .points
                .iter()
                .filter_map(|&point| place(point))
                .collect(),
        })
        .collect();
    let mut directions: Vec<Vn> = Vec::new();
    for guide in &guides.all {
        let (Some(origin), Some(slider)) = (place(guide.origin), place(guide.slider)) else {
            continue;
        };
        let name = unique(format!("along {}", guide.name), &mut names);
        picture.directions.push(name);
        directions.push(guide.along);
        picture.guides.push(Guide {
            name: guide.name.clone(),
            origin,
            direction: picture.directions.len() - 1,
            slider,
            on: guide.on,
            shape: match guide.is_cylinder {
                true => GuideShape::Cylinder,
                false => GuideShape::Slot,
            },
        });
    }
    for (point, along) in &sketch.axes {
        let Some(point) = place(*point) else {
            continue;
        };
        let known = directions.iter().position(|own| own == along);
        let direction = known.unwrap_or_else(|| {
            let name = format!("axis at {}", picture.points[point].name);
            let name = unique(name, &mut names);
            picture.directions.push(name);
            directions.push(*along);
            directions.len() - 1
        });
        if !picture.axes.contains(&(point, direction)) {
            picture.axes.push((point, direction));
        }
    }
    let declared = sketch.joints.iter();
    let declared = declared.filter_map(|(point, kind)| Some((place(*point)?, *kind)));
    let turning = Turning {
        seen,
        points: kept.iter().map(|(point, _)| *point).collect(),
        ways: seen.tracks_of(&directions),
        declared: declared.collect(),
    };
    picture.joints = turning.joints(&picture);
    picture.drives = sketch.drives(&picture, &place);
    let own: Vec<usize> = kept.iter().map(|(point, _)| *point).collect();
    picture.parts = owners.parts(&picture, links, &own);
    picture.gears = sketch.gears(&picture, &place, seen);
    let vectors = kept.iter().map(|(point, _)| sketch.points[*point].at);
    Found {
        vectors: vectors.chain(directions).collect(),
        picture,
    }
}

struct Namer<'a, 'b, 'm> {
    sketch: &'a Sketch<'b, 'm>,
    seen: &'a Seen<'a>,
    links: &'a Links<'m>,
    guides: &'a Guides<'m>,
    link_names: Vec<String>,
}

impl Namer<'_, '_, '_> {
    /// What becomes of a point; `None` if nothing needs it.
    fn kind(&self, point: usize) -> Option<PointKind> {
        let links = self.links.at(point).count();
        let slides = self.guides.all.iter().any(|guide| guide.slider == point);
        let turns = |guide: &&super::guides::RawGuide| guide.on == GuideOn::Itself;
        let mut guides = self.guides.all.iter().filter(|guide| guide.origin == point);
        let has_guide = guides.clone().next().is_some();
        let pivots = guides.any(|guide| turns(&guide));
        let has_axis = self
            .sketch
            .axes
            .iter()
            .any(|(at, _)| self.seen.same[*at] == point);
        let wanted = (0..self.seen.same.len())
            .any(|other| self.seen.same[other] == point && self.sketch.points[other].wanted);
        if !self.seen.is_known(point) {
            return None;
        }
        match (self.is_fixed(point), links) {
            (true, _) if links > 0 || pivots || slides => Some(PointKind::Ground),
            (true, _) if has_guide || has_axis => Some(PointKind::Construction),
            (true, _) => None,
            (false, _) if links + usize::from(slides) + usize::from(pivots) > 1 => {
                Some(PointKind::Joint)
            }
            (false, _) if slides => Some(PointKind::Joint),
            // The foot of a guide on its link.
            (false, 1) if has_guide && !self.has_name(point) => Some(PointKind::Construction),
            (false, 1) => Some(PointKind::Tip),
            (false, _) if has_guide || has_axis => Some(PointKind::Construction),
            (false, _) => (wanted && self.has_name(point)).then_some(PointKind::Loose),
        }
    }

    /// Whether it is a point of the frame, or of a guide that is.
    fn is_fixed(&self, point: usize) -> bool {
        let mut guides = self.guides.all.iter();
        let begins = guides.any(|guide| guide.on == GuideOn::Frame && guide.origin == point);
        begins || self.seen.is_fixed(point)
    }

    fn has_name(&self, point: usize) -> bool {
        let mut own = self.sketch.points.iter().zip(&self.seen.same);
        own.any(|(spot, &first)| first == point && spot.name.is_some())
    }

    /// The best name among those of points that coincide; otherwise what meets there.
    fn name(&self, point: usize) -> String {
        let all = (0..self.seen.same.len()).filter(|&other| self.seen.same[other] == point);
        let titles = all.filter_map(|other| self.sketch.points[other].name.as_ref());
        if let Some(title) = titles.min_by_key(|title| title.rank) {
            return title.text.clone();
        }
        let links = self.links.all.iter().zip(&self.link_names);
        let here = links.filter(|(link, _)| link.points.contains(&point));
        let mut parts: Vec<&str> = here.map(|(_, name)| name.as_str()).collect();
        let (fixed, kind) = (self.is_fixed(point), self.kind(point));
        let mut guides = self.guides.all.iter();
        let is_here = |guide: &&super::guides::RawGuide| {
            let begins = guide.on == GuideOn::Itself || kind == Some(PointKind::Construction);
            guide.slider == point || guide.origin == point && begins
        };
        let guide = guides.find(is_here);
        if let Some(guide) = guide {
            match kind {
                Some(PointKind::Construction) => return format!("guide of {}", guide.name),
                _ if parts.len() < 2 => parts.push(&guide.name),
                _ => {}
            }
        }
        if fixed {
            parts.push("frame");
        }
        match parts[..] {
            [] => "point".to_owned(),
            [link] if !fixed => format!("end of {link}"),
            _ => parts.join("/"),
        }
    }
}

/// A link without a name is called by its number.
fn link_names(links: &Links) -> Vec<String> {
    let mut names = Vec::new();
    let each = links.all.iter().enumerate();
    each.map(|(index, link)| {
        let title = link.title.as_ref().map(|title| title.text.clone());
        unique(
            title.unwrap_or_else(|| format!("link {}", index + 1)),
            &mut names,
        )
    })
    .collect()
}

/// The name, with a number behind it if it is taken.
fn unique(name: String, taken: &mut Vec<String>) -> String {
    let numbered = (2..).map(|number| format!("{name} {number}"));
    let mut candidates = std::iter::once(name.clone()).chain(numbered);
    let free = candidates.find(|candidate| !taken.contains(candidate));
    let free = free.unwrap_or(name);
    taken.push(free.clone());
    free
}
