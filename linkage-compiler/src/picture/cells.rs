//! Points by where they are: those that may coincide with a point are looked for near it, not among all.

use linkage_symbolic::lookup::Map;

use super::open_loop::Track;

/// The direction along which points are sorted: shares of the coordinates without pattern, so that rows of points parallel to
/// an axis, or on a common diagonal, are not in one cell.
const DIRECTION: [f64; 3] = [1.0, 0.618, 0.379];

pub(super) struct Cells {
    /// Two cells next to each other have all that is as near as points that coincide.
    width: f64,
    cells: Map<i64, Vec<usize>>,
    /// Points without a place to be sorted by.
    anywhere: Vec<usize>,
}

impl Cells {
    /// For points that coincide if they are as near as this.
    pub(super) fn new(reach: f64) -> Self {
        let length = DIRECTION.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self {
            // Twice as wide as need be, for what is rounded.
            width: 2.0 * length * reach,
            cells: Map::new(),
            anywhere: Vec::new(),
        }
    }

    /// Adds a point, by where it is at the first place.
    pub(super) fn add(&mut self, point: usize, track: &Track) {
        let list = match self.cell(track) {
            Some(cell) => self.cells.entry(cell).or_default(),
            None => &mut self.anywhere,
        };
        list.push(point);
    }

    /// The points that may be where this one is, in order.
    pub(super) fn near(&self, track: &Track) -> Vec<usize> {
        let Some(cell) = self.cell(track) else {
            return self.anywhere.clone();
        };
        let cells = [cell.saturating_sub(1), cell, cell.saturating_add(1)];
        let cells = cells.iter().filter_map(|cell| self.cells.get(cell));
        let mut near: Vec<usize> = cells.flatten().copied().collect();
        near.sort_unstable();
        near.dedup();
        near
    }

    /// `None` where a point has no place at all, or no numbers.
    fn cell(&self, track: &Track) -> Option<i64> {
        let at = track.first()?;
        let along: f64 = at.iter().zip(DIRECTION).map(|(x, d)| x * d).sum();
        let cell = match self.width > 0.0 {
            true => (along / self.width).floor(),
            false => 0.0,
        };
        cell.is_finite().then_some(cell as i64)
    }
}
