//! Lines and arcs along which points slide.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::ir::{GuideOn, GuideShape};
use crate::picture::candidates::{self, Candidate};
use crate::picture::layout::Layout;
use crate::picture::links::Links;
use crate::picture::marks::Spot;
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;
use crate::picture::track::Track;

/// Unit vectors whose product misses 1 by less point along one line: 4e-5 radians, far above
/// rounding, far below any angle that is meant.
const PARALLEL: f64 = 1e-9;

pub(super) struct Guides<'m> {
    pub(super) all: Vec<RawGuide<'m>>,
}

pub(super) struct RawGuide<'m> {
    pub(super) name: String,
    /// Points, each the first of those that coincide.
    pub(super) origin: usize,
    pub(super) slider: usize,
    pub(super) along: Vn<'m>,
    pub(super) on: GuideOn,
    /// A distance between two pins is a cylinder, and a length that an input drives and that turns
    /// about its end.
    pub(super) shape: GuideShape,
    /// True for a straight slot that the text has.
    is_slot: bool,
}

impl<'m> Guides<'m> {
    pub(super) fn find(
        algebra: &mut Algebra<'m>,
        layout: &Layout<'m>,
        sketch: &mut Sketch<'m>,
        samples: &mut Samples,
        links: &Links,
    ) -> Self {
        let candidates = candidates::collect(algebra, layout, sketch, samples);
        let known = samples.same.len();
        samples.add(&sketch.points[known..]);
        let mut guides = Self { all: Vec::new() };
        let ways: Vec<Vn> = candidates.iter().map(|candidate| candidate.along).collect();
        for (candidate, along) in candidates.into_iter().zip(samples.tracks_of(&ways)) {
            guides.add(candidate, &sketch.points, &along, samples, links);
        }
        guides
    }

    /// The points that slide, and those at which guides begin.
    pub(super) fn ends(&self) -> impl Iterator<Item = usize> {
        let guides = self.all.iter();
        guides.flat_map(|guide| [guide.slider, guide.origin])
    }

    /// Adds a guide unless it is known.
    fn add(
        &mut self,
        candidate: Candidate<'m>,
        points: &[Spot<'m>],
        along: &Track,
        samples: &Samples,
        links: &Links,
    ) {
        let (origin, slider) = (
            samples.same[candidate.origin],
            samples.same[candidate.slider],
        );
        if along.iter().flatten().any(|x| !x.is_finite()) {
            return;
        }
        let carrier = links.all.iter().position(|link| {
            let mut points = link.points.iter();
            points.all(|&point| {
                samples.keep_distance(point, origin) && samples.carries(point, origin, along)
            })
        });
        let fixed = candidate.on_frame || samples.is_fixed(origin);
        let on = match carrier {
            _ if candidate.is_distance => GuideOn::Itself,
            _ if fixed && samples.is_steady(along) => GuideOn::Frame,
            Some(link) => GuideOn::Link(link),
            None => GuideOn::Itself,
        };
        let turns = || {
            let turns_against = turns_against_carrier(&candidate, points, on, samples, links);
            turns_against || on == GuideOn::Itself && !samples.is_steady(along)
        };
        let is_cylinder = candidate.is_distance || candidate.is_driven && turns();
        let (on, shape) = match candidate {
            Candidate { is_arc: true, .. } => (on, GuideShape::Arc),
            _ if is_cylinder => (GuideOn::Itself, GuideShape::Cylinder),
            _ => (on, GuideShape::Slot),
        };
        // A cylinder may be in line with a slot, but not with one that belongs to nothing else: that is
        // the joint of its rod. Arcs have no line.
        let known = self.all.iter().any(|guide| {
            let has_line = shape != GuideShape::Arc && guide.shape != GuideShape::Arc;
            let is_rod =
                guide.on == GuideOn::Itself && on == GuideOn::Itself && guide.origin == origin;
            let is_like = has_line && (guide.shape == shape || is_rod);
            // A joint of forces may have the slot in its first body, whose origin slides there.
            let is_other_way = guide.is_slot && !candidate.is_slot && guide.origin == slider;
            is_like && (guide.slider == slider || is_other_way) && {
                let other = samples.tracks_of(&[guide.along]);
                parallel(along, &other[0])
            }
        });
        if known {
            return;
        }
        // What belongs to the link does not slide on it.
        if let GuideOn::Link(link) = on
            && links.all[link].points.contains(&slider)
        {
            return;
        }
        self.all.push(RawGuide {
            name: candidate.name,
            origin,
            slider,
            along: candidate.along,
            on,
            shape,
            is_slot: candidate.is_slot,
        });
    }
}

/// Returns true if the direction of a guide turns against its carrier where nothing closes the
/// loops: these may keep a cylinder in line with a slot.
fn turns_against_carrier<'m>(
    candidate: &Candidate<'m>,
    points: &[Spot<'m>],
    on: GuideOn,
    samples: &Samples,
    links: &Links,
) -> bool {
    let free = samples.free();
    let end = points[candidate.origin].at + candidate.along;
    let courses = free.courses(&[candidate.along, end]);
    match on {
        GuideOn::Frame | GuideOn::Itself => !free.stays(&courses[0]),
        GuideOn::Link(link) => links.all[link].points.iter().any(|&point| {
            let stretching = free.stretching([&courses[1], samples.course(point)]);
            !free.follows(&stretching, &[])
        }),
    }
}

/// True if two unit vectors always point along one line.
fn parallel(a: &[Vec<f64>], b: &[Vec<f64>]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let along: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
        (1.0 - along.abs()).abs() < PARALLEL
    })
}
