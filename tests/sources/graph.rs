//! Circles in a graph of uses.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt::Debug;

#[derive(Debug)]
pub(crate) struct Graph<N> {
    next: BTreeMap<N, BTreeSet<N>>,
}

impl<N: Copy + Ord + Debug> Graph<N> {
    pub(crate) fn new(arrows: impl Iterator<Item = (N, N)>) -> Self {
        let mut next: BTreeMap<N, BTreeSet<N>> = BTreeMap::new();
        for (from, to) in arrows {
            next.entry(to).or_default();
            next.entry(from).or_default().insert(to);
        }
        Self { next }
    }

    /// Sets of nodes that reach each other, larger than one, the largest first.
    pub(crate) fn circles(&self) -> Vec<BTreeSet<N>> {
        let mut left = BTreeSet::new();
        let mut order = Vec::new();
        for node in self.next.keys() {
            self.visit(*node, &mut left, &mut order);
        }
        let mut back: BTreeMap<N, Vec<N>> = BTreeMap::new();
        for (from, nexts) in &self.next {
            for to in nexts {
                back.entry(*to).or_default().push(*from);
            }
        }
        let mut circles = Vec::new();
        for node in order.into_iter().rev() {
            let mut circle = BTreeSet::new();
            let mut open = vec![node];
            while let Some(node) = open.pop() {
                if left.remove(&node) {
                    circle.insert(node);
                    open.extend(back.get(&node).into_iter().flatten());
                }
            }
            if circle.len() > 1 {
                circles.push(circle);
            }
        }
        circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
        circles
    }

    /// Adds all nodes that can be reached, the last ones first.
    fn visit(&self, node: N, seen: &mut BTreeSet<N>, order: &mut Vec<N>) {
        if seen.insert(node) {
            for next in &self.next[&node] {
                self.visit(*next, seen, order);
            }
            order.push(node);
        }
    }

    /// The shortest way round within a set that `circles` gave.
    pub(crate) fn shortest(&self, circle: &BTreeSet<N>) -> Vec<N> {
        let rounds = circle.iter().filter_map(|node| self.way(*node, *node));
        rounds.min_by_key(Vec::len).unwrap_or_default()
    }

    /// The shortest way from a node to another along at least one arrow, without its end.
    pub(crate) fn way(&self, from: N, to: N) -> Option<Vec<N>> {
        let mut before: BTreeMap<N, N> = BTreeMap::new();
        let mut open = VecDeque::from([from]);
        while let Some(node) = open.pop_front() {
            for next in self.next.get(&node).into_iter().flatten() {
                if *next == to {
                    let mut way = vec![node];
                    while way[way.len() - 1] != from {
                        way.push(before[&way[way.len() - 1]]);
                    }
                    way.reverse();
                    return Some(way);
                }
                if *next != from && !before.contains_key(next) {
                    before.insert(*next, node);
                    open.push_back(*next);
                }
            }
        }
        None
    }
}
