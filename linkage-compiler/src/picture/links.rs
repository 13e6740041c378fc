//! Segments that turn together are one link.

use super::chains::{Sketch, Title};
use super::seen::Seen;

pub(super) struct Links {
    pub(super) all: Vec<RawLink>,
}

pub(super) struct RawLink {
    /// Points in the order in which they were found, each the first of those that coincide.
    pub(super) points: Vec<usize>,
    pub(super) title: Option<Title>,
    /// Whether the user listed it.
    asked: bool,
}

impl Links {
    pub(super) fn find(sketch: &Sketch, seen: &Seen) -> Self {
        let mut links = Self { all: Vec::new() };
        let first = |point: usize| seen.same[point];
        for asked in &sketch.asked {
            let points = distinct(asked.points.iter().map(|&point| first(point)));
            links.all.push(RawLink {
                points,
                title: None,
                asked: true,
            });
        }
        for segment in &sketch.segments {
            let (from, to) = (first(segment.from), first(segment.to));
            let moves = !(seen.is_fixed(from) && seen.is_fixed(to));
            if from != to && moves && seen.keep_distance(from, to) {
                links.all.push(RawLink {
                    points: vec![from, to],
                    title: segment.title.clone(),
                    asked: false,
                });
            }
        }
        let structure = sketch.algebra.mechanism.inputs.is_empty();
        links.join(seen, structure);
        if !structure {
            links.attach(sketch, seen);
        }
        links
    }

    /// Joins links that have a point in common and turn together, until none is left.
    fn join(&mut self, seen: &Seen, structure: bool) {
        let mut next = 0;
        while next < self.all.len() {
            let joined = (0..next).find(|&known| match structure {
                // Where nothing moves, only what is said twice is known to be one link.
                true => same_points(&self.all[known], &self.all[next]),
                false => turn_together(&self.all[known], &self.all[next], seen),
            });
            let Some(known) = joined else {
                next += 1;
                continue;
            };
            let other = self.all.remove(next);
            let link = &mut self.all[known];
            let points = link.points.iter().chain(&other.points).copied();
            link.points = distinct(points);
            link.asked |= other.asked;
            let titles = [link.title.take(), other.title].into_iter().flatten();
            link.title = titles.min_by_key(|title| title.rank);
            // It has grown: what did not fit before may fit now.
            next = known;
        }
    }

    /// Named points that move with a link belong to it.
    fn attach(&mut self, sketch: &Sketch, seen: &Seen) {
        for (index, spot) in sketch.points.iter().enumerate() {
            let point = seen.same[index];
            let free = !self.all.iter().any(|link| link.points.contains(&point));
            if !spot.wanted || spot.name.is_none() || !free || seen.is_fixed(point) {
                continue;
            }
            let rigid = |link: &&mut RawLink| {
                let mut points = link.points.iter();
                points.all(|&other| seen.keep_distance(point, other))
            };
            if let Some(link) = self.all.iter_mut().find(rigid) {
                link.points.push(point);
            }
        }
    }

    /// Leaves out corners on the way along a link.
    pub(super) fn drop_corners(&mut self, is_needed: impl Fn(usize) -> bool) {
        for index in 0..self.all.len() {
            let points = self.all[index].points.clone();
            let alone = |point: usize| self.at(point).count() == 1;
            let kept = points
                .iter()
                .copied()
                .filter(|&point| !alone(point) || is_needed(point));
            let kept: Vec<usize> = kept.collect();
            if kept.len() > 1 {
                self.all[index].points = kept;
            }
        }
    }

    /// The links that have a point.
    pub(super) fn at(&self, point: usize) -> impl Iterator<Item = &RawLink> {
        self.all
            .iter()
            .filter(move |link| link.points.contains(&point))
    }
}

fn same_points(a: &RawLink, b: &RawLink) -> bool {
    a.points.len() == b.points.len() && a.points.iter().all(|point| b.points.contains(point))
}

fn turn_together(a: &RawLink, b: &RawLink, seen: &Seen) -> bool {
    let meet = a.points.iter().any(|point| b.points.contains(point));
    let rigid = |p: &usize| b.points.iter().all(|&q| seen.keep_distance(*p, q));
    // Lists are different links: in space, turning about a common line does not show in distances.
    meet && !(a.asked && b.asked) && a.points.iter().all(rigid)
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
