//! The picture with names for everything, without what is not needed.

use crate::picture::drives;
use linkage_symbolic::Vn;
use linkage_symbolic::lookup::Map;

use crate::ir::{Guide, GuideOn, GuideShape, Link, Picture, Point, PointKind};

use super::Found;
use super::by_point::{Meeting, Names};
use super::chains::Sketch;
use super::guides::Guides;
use super::joints::Turning;
use super::links::Links;
use super::ownership::Owners;
use super::samples::Seen;

pub(super) fn named<'m>(
    sketch: &Sketch<'_, 'm>,
    seen: &Seen,
    links: &Links<'m>,
    guides: &Guides<'m>,
    owners: &Owners,
) -> Found<'m> {
    let axes = sketch.axes.iter().map(|(at, _)| seen.same[*at]);
    let namer = Namer {
        sketch,
        seen,
        guides,
        link_names: link_names(links),
        meeting: Meeting::new(links, guides, axes.collect()),
    };
    let kept: Vec<(usize, PointKind)> = (0..sketch.points.len())
        .filter(|&point| seen.same[point] == point)
        .filter_map(|point| Some((point, namer.kind(point)?)))
        .collect();
    // Points that are nowhere are left out, and what hangs on them.
    let places = kept
        .iter()
        .enumerate()
        .map(|(place, (own, _))| (*own, place));
    let places: Map<usize, usize> = places.collect();
    let place = |point: usize| places.get(&seen.same[point]).copied();
    let mut names = Names::default();
    let points = kept.iter().map(|&(point, kind)| {
        let name = names.unique(namer.name(point));
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
        let name = names.unique(format!("along {}", guide.name));
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
            let name = names.unique(name);
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
    picture.drives = drives::drives(sketch, &picture, &place);
    let own: Vec<usize> = kept.iter().map(|(point, _)| *point).collect();
    picture.parts = owners.parts(&picture, links, &own);
    picture.gears = drives::gears(sketch, &picture, &place, seen);
    let vectors = kept.iter().map(|(point, _)| sketch.points[*point].at);
    Found {
        vectors: vectors.chain(directions).collect(),
        picture,
    }
}

struct Namer<'a, 'b, 'm> {
    sketch: &'a Sketch<'b, 'm>,
    seen: &'a Seen<'a>,
    guides: &'a Guides<'m>,
    link_names: Vec<String>,
    meeting: Meeting,
}

impl Namer<'_, '_, '_> {
    /// What becomes of a point; `None` if nothing needs it.
    fn kind(&self, point: usize) -> Option<PointKind> {
        let links = self.meeting.links.of(point).len();
        let slides = !self.meeting.sliders.of(point).is_empty();
        let guides = self.meeting.origins.of(point);
        let has_guide = !guides.is_empty();
        let mut guides = guides.iter().map(|&own| &self.guides.all[own]);
        let pivots = guides.any(|guide| guide.on == GuideOn::Itself);
        let has_axis = self.meeting.axes.contains(&point);
        let mut all = self.seen.aliases(point);
        let wanted = all.any(|other| self.sketch.points[other].wanted);
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
        let guides = self.meeting.origins.of(point).iter();
        let mut guides = guides.map(|&own| &self.guides.all[own]);
        guides.any(|guide| guide.on == GuideOn::Frame) || self.seen.is_fixed(point)
    }

    fn has_name(&self, point: usize) -> bool {
        let mut own = self.seen.aliases(point);
        own.any(|own| self.sketch.points[own].name.is_some())
    }

    /// The best name among those of points that coincide; otherwise what meets there.
    fn name(&self, point: usize) -> String {
        let all = self.seen.aliases(point);
        let titles = all.filter_map(|other| self.sketch.points[other].name.as_ref());
        if let Some(title) = titles.min_by_key(|title| title.rank) {
            return title.text.clone();
        }
        let here = self.meeting.links.of(point).iter();
        let mut parts: Vec<&str> = here.map(|&own| self.link_names[own].as_str()).collect();
        let (fixed, kind) = (self.is_fixed(point), self.kind(point));
        let begins = |index: &&usize| {
            let guide = &self.guides.all[**index];
            guide.on == GuideOn::Itself || kind == Some(PointKind::Construction)
        };
        let slider = self.meeting.sliders.of(point).first();
        let begun = self.meeting.origins.of(point).iter().find(begins);
        if let Some(&guide) = slider.into_iter().chain(begun).min() {
            let guide = &self.guides.all[guide];
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
    let mut names = Names::default();
    let each = links.all.iter().enumerate();
    each.map(|(index, link)| {
        let title = link.title.as_ref().map(|title| title.text.clone());
        names.unique(title.unwrap_or_else(|| format!("link {}", index + 1)))
    })
    .collect()
}
