//! Lists by points, so that entries of a point are found without a search.

use linkage_symbolic::lookup::Map;

/// Places in a list by the points that they are about, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct ByPoint(Map<usize, Vec<usize>>);

impl ByPoint {
    /// Builds the lists from pairs of a point and an index; indices in order.
    pub(super) fn new(pairs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut lists: Map<usize, Vec<usize>> = Map::new();
        for (point, index) in pairs {
            lists.entry(point).or_default().push(index);
        }
        Self(lists)
    }

    /// Builds the lists from lists of points.
    pub(super) fn of_lists<'a>(lists: impl IntoIterator<Item = &'a Vec<usize>>) -> Self {
        let lists = lists.into_iter().enumerate();
        Self::new(lists.flat_map(|(index, points)| points.iter().map(move |&point| (point, index))))
    }

    pub(super) fn at_point(&self, point: usize) -> &[usize] {
        self.0.get(&point).map_or(&[], Vec::as_slice)
    }
}
