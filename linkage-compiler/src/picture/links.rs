//! Segments that are written as one link are one.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::{Map, Set};

use crate::model::Mechanism;
use crate::picture::joining::Joining;
use crate::picture::marks::{Arc, Mean, Segment, Shape, Spot, Title};
use crate::picture::ownership::Ownership;
use crate::picture::raw_link::{self, Frame, RawLink};
use crate::picture::rigid_bodies::Welds;
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;

pub(super) struct Links<'m> {
    pub(super) all: Vec<RawLink<'m>>,
}

impl<'m> Links<'m> {
    pub(super) fn find(
        mechanism: &Mechanism,
        dimension: usize,
        sketch: &Sketch<'m>,
        samples: &Samples,
        ownership: &Ownership,
    ) -> Self {
        let mut links = Self { all: Vec::new() };
        let welds = Welds::new(dimension, &sketch.points, samples);
        let first = |point: usize| samples.same[point];
        for asked in &sketch.asked {
            let link = of_list(sketch, samples, &asked.points);
            links.all.push(RawLink {
                part: ownership.part_of(None, &link.points),
                asked: true,
                ..link
            });
        }
        for (index, named) in sketch.named_links.iter().enumerate() {
            let link = of_list(sketch, samples, &named.points);
            let moves = link.points.iter().any(|&point| !samples.is_fixed(point));
            if moves && link.points.len() > 1 {
                let text = named.name.clone();
                links.all.push(RawLink {
                    part: ownership.named(&text),
                    title: Some(Title { rank: 0, text }),
                    named: Some(index),
                    ..link
                });
            }
        }
        for segment in &sketch.segments {
            let (from, to) = (first(segment.from), first(segment.to));
            let moves = !(samples.is_fixed(from) && samples.is_fixed(to));
            if from != to && moves && is_rigid(segment, samples) {
                let name = segment.title.as_ref().map(|title| title.text.as_str());
                links.all.push(RawLink {
                    points: vec![from, to],
                    part: match segment.shape {
                        Shape::Base(carrier) => carrier,
                        Shape::Body(Some(_)) => name.and_then(|name| ownership.named(name)),
                        _ => ownership.part_of(name, &[from, to]),
                    },
                    title: segment.title.clone(),
                    frames: vec![Frame {
                        from: segment.from,
                        to: segment.to,
                        step: segment.step,
                    }],
                    asked: false,
                    named: None,
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
        links.join(samples, &welds);
        links.take_means(&sketch.means, samples);
        links.join(samples, &welds);
        if !mechanism.inputs.is_empty() {
            links.attach(&sketch.points, samples, ownership);
        }
        links
    }

    /// Joins links that have a point in common and are written to turn together, until none is
    /// left.
    fn join(&mut self, samples: &Samples, welds: &Welds) {
        let joining = Joining::new(std::mem::take(&mut self.all));
        self.all = joining.joined(|a, b| are_one(a, b, samples, welds));
    }

    /// Adds points that are computed from points of a link to the link.
    fn take_means(&mut self, means: &[Mean], samples: &Samples) {
        let mut at: Map<usize, BTreeSet<usize>> = Map::new();
        for (index, link) in self.all.iter().enumerate() {
            for &point in &link.points {
                at.entry(point).or_default().insert(index);
            }
        }
        for mean in means {
            let point = samples.same[mean.point];
            let sources: Vec<usize> = mean
                .sources
                .iter()
                .map(|&point| samples.same[point])
                .collect();
            let has_all = |index: &&usize| {
                let points = &self.all[**index].points;
                sources.iter().all(|other| points.contains(other))
                    && sources
                        .iter()
                        .all(|&other| samples.keep_distance(point, other))
            };
            let candidates = sources.first().and_then(|first| at.get(first));
            let found = candidates
                .and_then(|candidates| candidates.iter().find(has_all))
                .copied();
            if let Some(index) = found
                && !self.all[index].points.contains(&point)
            {
                self.all[index].points.push(point);
                at.entry(point).or_default().insert(index);
            }
        }
    }

    /// Named points that move with a link belong to it.
    fn attach(&mut self, points: &[Spot<'m>], samples: &Samples, ownership: &Ownership) {
        let linked = self.all.iter().flat_map(|link| &link.points);
        let mut taken: Set<usize> = linked.copied().collect();
        for (index, spot) in points.iter().enumerate() {
            let point = samples.same[index];
            if !spot.wanted
                || spot.name.is_none()
                || taken.contains(&point)
                || samples.is_fixed(point)
            {
                continue;
            }
            let rigid = |link: &&mut RawLink<'m>| {
                let mut points = link.points.iter();
                points.all(|&other| samples.keep_distance(point, other))
                    && !ownership.is_foreign(point, link.part)
            };
            if let Some(link) = self.all.iter_mut().find(rigid) {
                link.points.push(point);
                taken.insert(point);
            }
        }
    }

    /// Leaves out the bars that loops have from the centres of arcs to the points in them, except
    /// those that the user listed.
    pub(super) fn drop_bars_of_arcs(&mut self, arcs: &[Arc], samples: &Samples) {
        let ends = arcs.iter();
        let ends: Vec<[usize; 2]> = ends
            .map(|arc| [arc.centre, arc.slider].map(|point| samples.same[point]))
            .collect();
        let is_slot = |link: &RawLink| match link.points[..] {
            [a, b] => ends.contains(&[a, b]) || ends.contains(&[b, a]),
            _ => false,
        };
        self.all.retain(|link| link.asked || !is_slot(link));
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

/// Returns a link of listed points.
fn of_list<'m>(sketch: &Sketch<'m>, samples: &Samples, points: &[usize]) -> RawLink<'m> {
    let frames = points.windows(2).map(|ends| Frame {
        from: ends[0],
        to: ends[1],
        step: sketch.points[ends[0]].step_to(&sketch.points[ends[1]]),
    });
    RawLink {
        points: raw_link::distinct(points.iter().map(|&point| samples.same[point])),
        title: None,
        frames: frames.collect(),
        asked: false,
        named: None,
        body: None,
        unknown: None,
        part: None,
    }
}

/// True if the form of a segment fixes the distance of its ends. A term has its length for all
/// values of the unknowns; distances and bodies get theirs from loops.
pub(super) fn is_rigid(segment: &Segment, samples: &Samples) -> bool {
    let (from, to) = (segment.from, segment.to);
    let written = match segment.shape {
        Shape::Term(..) | Shape::Part(..) => {
            samples.free().follows(&samples.stretching(from, to), &[])
        }
        Shape::Distance | Shape::Body(_) | Shape::Frame(_) | Shape::Base(_) => true,
    };
    written && samples.keep_distance(from, to)
}

fn are_one(a: &RawLink, b: &RawLink, samples: &Samples, welds: &Welds) -> bool {
    let shared: Vec<usize> = a
        .points
        .iter()
        .filter(|p| b.points.contains(p))
        .copied()
        .collect();
    let rigid = |p: &usize| b.points.iter().all(|&q| samples.keep_distance(*p, q));
    // Lists are different links: in space, turning about a common line does not show in distances.
    // So are bodies.
    let other_lists = a.asked && b.asked || are_two(a.named, b.named);
    let other_bodies = are_two(a.body, b.body);
    // Cranks of two parts on one shaft are drawn as two.
    let other_parts = are_two(a.part, b.part);
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

/// True for two different numbers.
fn are_two(a: Option<usize>, b: Option<usize>) -> bool {
    a.is_some() && b.is_some() && a != b
}
