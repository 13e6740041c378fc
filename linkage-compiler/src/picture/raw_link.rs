//! A link while links are joined.

use linkage_symbolic::Vn;

use crate::picture::marks::Title;

pub(super) struct RawLink<'m> {
    /// Points in the order in which they were found, each the first of those that coincide.
    pub(super) points: Vec<usize>,
    pub(super) title: Option<Title>,
    /// Pairs of points that the link is written by, as they are written.
    pub(super) frames: Vec<Frame<'m>>,
    /// True if the user listed it.
    pub(super) asked: bool,
    /// The link of the text that it is.
    pub(super) named: Option<usize>,
    /// The body that it is.
    pub(super) body: Option<usize>,
    /// The unknown frame that says where it is.
    pub(super) unknown: Option<usize>,
    /// The part of a machine that it belongs to.
    pub(super) part: Option<usize>,
}

impl<'m> RawLink<'m> {
    /// Becomes one with another link.
    pub(super) fn take_in(&mut self, other: Self) {
        let points = self.points.iter().chain(&other.points).copied();
        self.points = distinct(points);
        self.frames.extend(other.frames);
        self.asked |= other.asked;
        self.named = self.named.or(other.named);
        self.body = self.body.or(other.body);
        self.unknown = self.unknown.or(other.unknown);
        self.part = self.part.or(other.part);
        let titles = [self.title.take(), other.title].into_iter().flatten();
        self.title = titles.min_by_key(|title| title.rank);
    }
}

/// Each point once.
pub(super) fn distinct(points: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut distinct = Vec::new();
    for point in points {
        if !distinct.contains(&point) {
            distinct.push(point);
        }
    }
    distinct
}

/// Two points that a link is written by, the way they are written.
#[derive(Clone, Debug)]
pub(super) struct Frame<'m> {
    pub(super) from: usize,
    pub(super) to: usize,
    /// The vector from one to the other.
    pub(super) step: Vn<'m>,
}
