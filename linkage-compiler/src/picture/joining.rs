//! Links that are one link are joined.
//!
//! Every link is compared with those before it, in order, as long as two of them are one. Only links that have a point in common
//! can be, and only those that share a point with a link that has grown have to be compared again: in a long chain each link
//! meets a few others.

use std::collections::{BTreeMap, BTreeSet};

use linkage_symbolic::lookup::Set;

use super::links::RawLink;

pub(super) struct Joining<'m> {
    /// `None` for what has become a part of a link before.
    links: Vec<Option<RawLink<'m>>>,
    /// How often each has grown.
    grown: Vec<usize>,
    /// The links that have a point.
    at: BTreeMap<usize, BTreeSet<usize>>,
    /// Links to be compared with those before them.
    open: BTreeSet<usize>,
    /// Two links that are not one, and how often they had grown.
    apart: Set<[(usize, usize); 2]>,
}

impl<'m> Joining<'m> {
    pub(super) fn new(links: Vec<RawLink<'m>>) -> Self {
        let mut at: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for (index, link) in links.iter().enumerate() {
            for &point in &link.points {
                at.entry(point).or_default().insert(index);
            }
        }
        Self {
            open: (0..links.len()).collect(),
            grown: vec![0; links.len()],
            links: links.into_iter().map(Some).collect(),
            at,
            apart: Set::new(),
        }
    }

    /// Joins links until no two of them are one, and returns them.
    pub(super) fn joined(
        mut self,
        are_one: impl Fn(&RawLink<'m>, &RawLink<'m>) -> bool,
    ) -> Vec<RawLink<'m>> {
        while let Some(next) = self.open.pop_first() {
            if let Some(known) = self.partner(next, &are_one) {
                self.join(known, next);
            }
        }
        self.links.into_iter().flatten().collect()
    }

    /// The first link before this one that is one with it.
    fn partner(
        &mut self,
        next: usize,
        are_one: &impl Fn(&RawLink<'m>, &RawLink<'m>) -> bool,
    ) -> Option<usize> {
        let link = self.links[next].as_ref()?;
        let before = link.points.iter().filter_map(|point| self.at.get(point));
        let before: BTreeSet<usize> = before.flat_map(|own| own.range(..next)).copied().collect();
        before.into_iter().find(|&known| {
            let pair = [(known, self.grown[known]), (next, self.grown[next])];
            let other = self.links[known].as_ref();
            // Of one link with many at a point, most pairs are as before.
            let is_apart = self.apart.contains(&pair);
            let is_one = !is_apart && other.is_some_and(|other| are_one(other, link));
            if !is_one {
                self.apart.insert(pair);
            }
            is_one
        })
    }

    fn join(&mut self, known: usize, next: usize) {
        let (Some(other), Some(link)) = (self.links[next].take(), &mut self.links[known]) else {
            return;
        };
        for point in &other.points {
            let here = self.at.entry(*point).or_default();
            here.remove(&next);
            here.insert(known);
        }
        link.take_in(other);
        self.grown[known] += 1;
        // What did not fit before may fit now.
        self.open.insert(known);
        for point in &link.points {
            let here = self.at.get(point).into_iter().flatten();
            self.open.extend(here.filter(|&&own| own > known));
        }
    }
}
