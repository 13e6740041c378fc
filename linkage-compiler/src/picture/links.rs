//! Segments that are written as one link are one.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::{Map, Set};

use super::chains::Sketch;
use super::joining::Joining;
use super::marks::{Segment, Shape, Title};
use super::ownership::Owners;
use super::rigid_bodies::{Frame, Welds};
use super::samples::Seen;

pub(super) struct Links<'m> {
    pub(super) all: Vec<RawLink<'m>>,
}

pub(super) struct RawLink<'m> {
    /// Points in the order in which they were found, each the first of those that coincide.
    pub(super) points: Vec<usize>,
    pub(super) title: Option<Title>,
    /// Pairs of points that the link is written by, as they are written.
    pub(super) frames: Vec<Frame<'m>>,
    /// Whether the user listed it.
    asked: bool,
    /// The body that it is.
    pub(super) body: Option<usize>,
    /// The unknown frame that says where it is.
    unknown: Option<usize>,
    /// The part of a machine that it belongs to.
    pub(super) part: Option<usize>,
}

impl<'m> Links<'m> {
    pub(super) fn find(sketch: &Sketch<'_, 'm>, seen: &Seen, owners: &Owners) -> Self {
        let mut links = Self { all: Vec::new() };
        let welds = Welds::new(sketch, seen);
        let first = |point: usize| seen.same[point];
        for asked in &sketch.asked {
            let points = distinct(asked.points.iter().map(|&point| first(point)));
            let frames = asked.points.windows(2).map(|ends| Frame {
                from: ends[0],
                to: ends[1],
                step: sketch.points[ends[0]].step_to(&sketch.points[ends[1]]),
            });
            links.all.push(RawLink {
                part: owners.of(None, &points),
                points,
                title: None,
                frames: frames.collect(),
                asked: true,
                body: None,
                unknown: None,
            });
        }
        for segment in &sketch.segments {
            let (from, to) = (first(segment.from), first(segment.to));
            let moves = !(seen.is_fixed(from) && seen.is_fixed(to));
            if from != to && moves && is_rigid(segment, seen) {
                let name = segment.title.as_ref().map(|title| title.text.as_str());
                links.all.push(RawLink {
                    points: vec![from, to],
                    part: match segment.shape {
                        Shape::Base(carrier) => carrier,
                        Shape::Body(Some(_)) => name.and_then(|name| owners.named(name)),
                        _ => owners.of(name, &[from, to]),
                    },
                    title: segment.title.clone(),
                    frames: vec![Frame {
                        from: segment.from,
                        to: segment.to,
                        step: segment.step,
                    }],
                    asked: false,
                    body: match segment.shape {
                        Shape::Body(body) => body,
                        _ => None,
                    },
                    unknown: match segment.shape {
                        Shape::Frame(frame) => Some(frame),
                        _ => None,
                    },
                });
            }
        }
        links.join(seen, &welds);
        links.take_means(sketch, seen);
        links.join(seen, &welds);
        if !sketch.algebra.mechanism.inputs.is_empty() {
            links.attach(sketch, seen, owners);
        }
        links
    }

    /// Joins links that have a point in common and are written to turn together, until none is left.
    fn join(&mut self, seen: &Seen, welds: &Welds) {
        let joining = Joining::new(std::mem::take(&mut self.all));
        self.all = joining.joined(|a, b| are_one(a, b, seen, welds));
    }

    /// What is computed from points of a link belongs to it.
    fn take_means(&mut self, sketch: &Sketch, seen: &Seen) {
        let mut at: Map<usize, BTreeSet<usize>> = Map::new();
        for (index, link) in self.all.iter().enumerate() {
            for &point in &link.points {
                at.entry(point).or_default().insert(index);
            }
        }
        for mean in &sketch.means {
            let point = seen.same[mean.point];
            let of: Vec<usize> = mean.of.iter().map(|&own| seen.same[own]).collect();
            let has_all = |index: &&usize| {
                let points = &self.all[**index].points;
                of.iter().all(|own| points.contains(own))
                    && of.iter().all(|&own| seen.keep_distance(point, own))
            };
            let candidates = of.first().and_then(|first| at.get(first));
            let found = candidates.and_then(|all| all.iter().find(has_all)).copied();
            if let Some(index) = found
                && !self.all[index].points.contains(&point)
            {
                self.all[index].points.push(point);
                at.entry(point).or_default().insert(index);
            }
        }
    }

    /// Named points that move with a link belong to it.
    fn attach(&mut self, sketch: &Sketch, seen: &Seen, owners: &Owners) {
        let points = self.all.iter().flat_map(|link| &link.points);
        let mut taken: Set<usize> = points.copied().collect();
        for (index, spot) in sketch.points.iter().enumerate() {
            let point = seen.same[index];
            if !spot.wanted || spot.name.is_none() || taken.contains(&point) || seen.is_fixed(point)
            {
                continue;
            }
            let rigid = |link: &&mut RawLink<'m>| {
                let mut points = link.points.iter();
                points.all(|&other| seen.keep_distance(point, other))
                    && !owners.is_foreign(point, link.part)
            };
            if let Some(link) = self.all.iter_mut().find(rigid) {
                link.points.push(point);
                taken.insert(point);
            }
        }
    }

    /// Leaves out corners on the way along a link.
    pub(super) fn drop_corners(&mut self, is_needed: impl Fn(usize) -> bool) {
        let mut counts: Map<usize, usize> = Map::new();
        for &point in self.all.iter().flat_map(|link| &link.points) {
            *counts.entry(point).or_insert(0) += 1;
        }
        for link in &mut self.all {
            let points = link.points.iter().copied();
            let kept = points.filter(|point| counts[point] > 1 || is_needed(*point));
            let kept: Vec<usize> = kept.collect();
            if kept.len() > 1 {
                link.points = kept;
            }
        }
    }
}

impl<'m> RawLink<'m> {
    /// Becomes one with another link.
    pub(super) fn take_in(&mut self, other: Self) {
        let points = self.points.iter().chain(&other.points).copied();
        self.points = distinct(points);
        self.frames.extend(other.frames);
        self.asked |= other.asked;
        self.body = self.body.or(other.body);
        self.unknown = self.unknown.or(other.unknown);
        self.part = self.part.or(other.part);
        let titles = [self.title.take(), other.title].into_iter().flatten();
        self.title = titles.min_by_key(|title| title.rank);
    }
}

/// Whether the ends of a segment are held by what it says of itself: a term has its length, whatever the unknowns are; distances and bodies are
/// what loops say.
pub(super) fn is_rigid(segment: &Segment, seen: &Seen) -> bool {
    let (from, to) = (segment.from, segment.to);
    let written = match segment.shape {
        Shape::Term(..) | Shape::Part(..) => seen.free().follows(&seen.stretching(from, to), &[]),
        Shape::Distance | Shape::Body(_) | Shape::Frame(_) | Shape::Base(_) => true,
    };
    written && seen.keep_distance(from, to)
}

fn are_one(a: &RawLink, b: &RawLink, seen: &Seen, welds: &Welds) -> bool {
    let shared: Vec<usize> = a
        .points
        .iter()
        .filter(|p| b.points.contains(p))
        .copied()
        .collect();
    let rigid = |p: &usize| b.points.iter().all(|&q| seen.keep_distance(*p, q));
    // Lists are different links: in space, turning about a common line does not show in distances. So are bodies.
    let other_lists = a.asked && b.asked;
    let other_bodies = a.body.is_some() && b.body.is_some() && a.body != b.body;
    // Cranks of two parts on one shaft are drawn as two.
    let other_parts = a.part.is_some() && b.part.is_some() && a.part != b.part;
    let others = other_lists || other_bodies || other_parts;
    if shared.is_empty() || others || !a.points.iter().all(rigid) {
        return false;
    }
    // What has two points of a link is part of it, such as a rod between two joints of a body.
    let within = shared.len() == b.points.len() || shared.len() == a.points.len();
    within
        || a.body.is_some() && a.body == b.body
        || a.unknown.is_some() && a.unknown == b.unknown
        || welds.join(&a.frames, &b.frames, &a.points)
        || welds.join(&b.frames, &a.frames, &b.points)
}

/// Each point once.
fn distinct(points: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut all = Vec::new();
    for point in points {
        if !all.contains(&point) {
            all.push(point);
        }
    }
    all
}
