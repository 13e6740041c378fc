//! The picture with names for everything, without unnecessary parts.

use linkage_symbolic::Vn;
use linkage_symbolic::lookup::Map;

use crate::algebra::Algebra;
use crate::ir::{Gear, Guide, GuideOn, GuideShape, Link, Picture, Point, PointKind};
use crate::picture::declared_gears;
use crate::picture::drives;
use crate::picture::found_picture::FoundPicture;
use crate::picture::guides::Guides;
use crate::picture::joints::JointFinder;
use crate::picture::links::Links;
use crate::picture::marks::Spot;
use crate::picture::meeting::Meeting;
use crate::picture::ownership::Ownership;
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;
use crate::picture::unique_names::UniqueNames;

pub(super) fn named<'m>(
    algebra: &Algebra<'m>,
    dimension: usize,
    sketch: &Sketch<'m>,
    samples: &Samples,
    links: &Links<'m>,
    guides: &Guides<'m>,
    ownership: &Ownership,
) -> FoundPicture<'m> {
    let axes = sketch.axes.iter().map(|(at, _)| samples.same[*at]);
    let wheels = sketch.wheels.iter().flat_map(|pair| pair.centres);
    let wheels = wheels.map(|centre| samples.same[centre]);
    let namer = Namer {
        points: &sketch.points,
        samples,
        guides,
        link_names: link_names(links),
        meeting: Meeting::new(links, guides, axes.collect(), wheels.collect()),
    };
    let kept: Vec<(usize, PointKind)> = (0..sketch.points.len())
        .filter(|&point| samples.same[point] == point)
        .filter_map(|point| Some((point, namer.kind(point)?)))
        .collect();
    // Points that are nowhere are left out, and what hangs on them.
    let places = kept
        .iter()
        .enumerate()
        .map(|(index, (point, _))| (*point, index));
    let places: Map<usize, usize> = places.collect();
    let index_of = |point: usize| places.get(&samples.same[point]).copied();
    let mut names = UniqueNames::default();
    let points = kept.iter().map(|&(point, kind)| {
        let name = names.unique(namer.name(point));
        Point { name, kind }
    });
    let mut picture = Picture {
        dimension,
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
                .filter_map(|&point| index_of(point))
                .collect(),
        })
        .collect();
    let mut directions: Vec<Vn> = Vec::new();
    for guide in &guides.all {
        let (Some(origin), Some(slider)) = (index_of(guide.origin), index_of(guide.slider)) else {
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
            shape: guide.shape,
        });
    }
    for (point, along) in &sketch.axes {
        let Some(point) = index_of(*point) else {
            continue;
        };
        let known = directions.iter().position(|known| known == along);
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
    let declared = declared_gears::gears(
        &sketch.wheels,
        &mut picture,
        &mut directions,
        &mut names,
        &index_of,
    );
    let joints = sketch.joints.iter();
    let joints = joints.filter_map(|(point, kind)| Some((index_of(*point)?, *kind)));
    let turning = JointFinder {
        samples,
        points: kept.iter().map(|(point, _)| *point).collect(),
        ways: samples.tracks_of(&directions),
        declared: joints.collect(),
    };
    picture.joints = turning.joints(&picture);
    let named = sketch.joint_names.iter();
    let named = named.filter_map(|(name, point)| Some((name.clone(), index_of(*point)?)));
    picture.declared_joints = named.collect();
    picture.drives = drives::drives(algebra, &sketch.segments, &picture, &index_of);
    let kept_points: Vec<usize> = kept.iter().map(|(point, _)| *point).collect();
    picture.parts = ownership.parts(&picture, &links.all, &kept_points);
    let found = drives::gears(algebra, &sketch.segments, &picture, &index_of, samples);
    // Those that the text has are known better.
    let is_new = |gear: &Gear| {
        let [a, b] = gear.centres;
        let mut declared = declared.iter().map(|gear| gear.centres);
        declared.all(|centres| centres != [a, b] && centres != [b, a])
    };
    picture.gears = declared
        .iter()
        .copied()
        .chain(found.into_iter().filter(is_new))
        .collect();
    let vectors = kept.iter().map(|(point, _)| sketch.points[*point].at);
    FoundPicture {
        vectors: vectors.chain(directions).collect(),
        picture,
    }
}

struct Namer<'a, 'm> {
    points: &'a [Spot<'m>],
    samples: &'a Samples<'a>,
    guides: &'a Guides<'m>,
    link_names: Vec<String>,
    meeting: Meeting,
}

impl Namer<'_, '_> {
    /// The kind of a point; `None` if nothing needs it.
    fn kind(&self, point: usize) -> Option<PointKind> {
        let links = self.meeting.links.at_point(point).len();
        let slides = !self.meeting.sliders.at_point(point).is_empty();
        let guides = self.meeting.origins.at_point(point);
        let has_guide = !guides.is_empty();
        let guides = guides.iter().map(|&guide| &self.guides.all[guide]);
        let pivots = guides.clone().any(|guide| guide.on == GuideOn::Itself);
        let is_centre = guides.clone().any(|guide| guide.shape == GuideShape::Arc);
        let has_axis = self.meeting.axes.contains(&point);
        let has_wheel = self.meeting.wheels.contains(&point);
        let mut aliases = self.samples.aliases(point);
        let wanted = aliases.any(|other| self.points[other].wanted);
        if !self.samples.is_known(point) {
            return None;
        }
        match (self.is_fixed(point), links) {
            (true, _) if links > 0 || pivots || slides || has_wheel => Some(PointKind::Ground),
            (true, _) if has_guide || has_axis => Some(PointKind::Construction),
            (true, _) => None,
            (false, _) if links + usize::from(slides) + usize::from(pivots) > 1 => {
                Some(PointKind::Joint)
            }
            (false, _) if slides || has_wheel => Some(PointKind::Joint),
            // The foot of a guide on its link, and the centre of an arc in which nothing turns.
            (false, 1) if has_guide && (is_centre || !self.has_name(point)) => {
                Some(PointKind::Construction)
            }
            (false, 1) => Some(PointKind::Tip),
            (false, _) if has_guide || has_axis => Some(PointKind::Construction),
            (false, _) => (wanted && self.has_name(point)).then_some(PointKind::Loose),
        }
    }

    /// True if it is a point of the frame, or of a guide that is.
    fn is_fixed(&self, point: usize) -> bool {
        let guides = self.meeting.origins.at_point(point).iter();
        let mut guides = guides.map(|&guide| &self.guides.all[guide]);
        guides.any(|guide| guide.on == GuideOn::Frame) || self.samples.is_fixed(point)
    }

    fn has_name(&self, point: usize) -> bool {
        let mut aliases = self.samples.aliases(point);
        aliases.any(|alias| self.points[alias].name.is_some())
    }

    /// The best name among those of points that coincide; otherwise the names of the members that
    /// meet there.
    fn name(&self, point: usize) -> String {
        let aliases = self.samples.aliases(point);
        let titles = aliases.filter_map(|other| self.points[other].name.as_ref());
        if let Some(title) = titles.min_by_key(|title| title.rank) {
            return title.text.clone();
        }
        let here = self.meeting.links.at_point(point).iter();
        let mut parts: Vec<&str> = here.map(|&link| self.link_names[link].as_str()).collect();
        let (fixed, kind) = (self.is_fixed(point), self.kind(point));
        let begins = |index: &&usize| {
            let guide = &self.guides.all[**index];
            guide.on == GuideOn::Itself || kind == Some(PointKind::Construction)
        };
        let slider = self.meeting.sliders.at_point(point).first();
        let begun = self.meeting.origins.at_point(point).iter().find(begins);
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
    let mut names = UniqueNames::default();
    let each = links.all.iter().enumerate();
    each.map(|(index, link)| {
        let title = link.title.as_ref().map(|title| title.text.clone());
        names.unique(title.unwrap_or_else(|| format!("link {}", index + 1)))
    })
    .collect()
}
