//! The largest box of a grid whose nodes all have a property.

use alloc::vec;
use alloc::vec::Vec;

/// Returns the first and the last line along each axis of the box that is largest by volume among
/// those that contain the node `start` and no node that fails. An axis of several lines has at
/// least two of them in the box.
///
/// `lines` are the places of the lines of each axis, ascending; `works` is a value for each node,
/// the last axis changing fastest. `None` if no box works.
///
/// ```
/// use linkage_core::numeric::largest_box::largest_box;
///
/// let lines = [vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 5.0]];
/// let works = [true, true, false, true, true, true, true, true, true];
/// let found = largest_box(&lines, &[1, 1], &works);
/// assert_eq!(found, Some(vec![[1, 2], [0, 2]]));
/// ```
///
/// # Panics
///
/// If there are not as many values as nodes.
#[must_use]
pub fn largest_box(lines: &[Vec<f64>], start: &[usize], works: &[bool]) -> Option<Vec<[usize; 2]>> {
    let nodes: usize = lines.iter().map(Vec::len).product();
    assert!(works.len() == nodes, "a value for each node");
    let failures = Failures::new(lines, works);
    let mut best: Option<(f64, Vec<[usize; 2]>)> = None;
    let mut around = vec![[0, 0]; lines.len()];
    try_all(lines, start, &failures, 0, 1.0, &mut around, &mut best);
    best.map(|(_, found)| found)
}

/// Tries all sides of the box from an axis on; those before are in `around`.
fn try_all(
    lines: &[Vec<f64>],
    start: &[usize],
    failures: &Failures,
    axis: usize,
    volume: f64,
    around: &mut Vec<[usize; 2]>,
    best: &mut Option<(f64, Vec<[usize; 2]>)>,
) {
    let Some(places) = lines.get(axis) else {
        let larger = best.as_ref().is_none_or(|(most, _)| volume > *most);
        if larger && failures.within(around) == 0 {
            *best = Some((volume, around.clone()));
        }
        return;
    };
    for first in 0..=start[axis] {
        for last in start[axis]..places.len() {
            let length = match places.len() {
                1 => 1.0,
                _ => places[last] - places[first],
            };
            if length > 0.0 {
                around[axis] = [first, last];
                try_all(
                    lines,
                    start,
                    failures,
                    axis + 1,
                    volume * length,
                    around,
                    best,
                );
            }
        }
    }
}

/// The numbers of nodes that fail, summed along all axes.
struct Failures {
    /// Nodes along each axis, and one more.
    sides: Vec<usize>,
    sums: Vec<usize>,
}

impl Failures {
    fn new(lines: &[Vec<f64>], works: &[bool]) -> Self {
        let sides: Vec<usize> = lines.iter().map(|places| places.len() + 1).collect();
        let mut sums = vec![0; sides.iter().product()];
        for (number, works) in works.iter().enumerate() {
            let mut rest = number;
            let mut index = 0;
            let mut stride = 1;
            for side in sides.iter().rev() {
                index += (rest % (side - 1) + 1) * stride;
                rest /= side - 1;
                stride *= side;
            }
            sums[index] = usize::from(!works);
        }
        let mut stride = 1;
        for side in sides.iter().rev() {
            for index in 0..sums.len() {
                if !(index / stride).is_multiple_of(*side) {
                    sums[index] += sums[index - stride];
                }
            }
            stride *= side;
        }
        Self { sides, sums }
    }

    /// Returns the number of nodes in a box that fail.
    fn within(&self, around: &[[usize; 2]]) -> usize {
        let (mut plus, mut minus) = (0, 0);
        for corner in 0..1_usize << around.len() {
            let pairs = self.sides.iter().zip(around).enumerate();
            let index = pairs.fold(0, |index, (axis, (side, [first, last]))| {
                let low = corner >> axis & 1 == 1;
                index * side + if low { *first } else { last + 1 }
            });
            match corner.count_ones() % 2 {
                0 => plus += self.sums[index],
                _ => minus += self.sums[index],
            }
        }
        plus - minus
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with a count of the nodes of each box.
    #[test]
    fn it_is_the_largest() {
        let lines = [
            vec![0.0, 0.5, 2.0, 3.0],
            vec![0.0, 1.0, 2.0],
            vec![-1.0, 0.0, 4.0, 5.0],
        ];
        let start = [2, 1, 1];
        for seed in 0..40_usize {
            let mut state = seed as u64 * 2_654_435_761 + 1;
            let works: Vec<bool> = (0..48)
                .map(|node| {
                    state = state
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1);
                    node == (2 * 3 + 1) * 4 + 1 || state >> 60 > 1
                })
                .collect();
            let volume = |found: &[[usize; 2]]| -> f64 {
                let pairs = lines.iter().zip(found);
                pairs.map(|(x, [a, b])| x[*b] - x[*a]).product()
            };
            let sound = |found: &[[usize; 2]]| {
                (0..48).all(|node| {
                    let at = [node / 12, node / 4 % 3, node % 4];
                    let inside = at.iter().zip(found).all(|(k, [a, b])| a <= k && k <= b);
                    !inside || works[node]
                })
            };
            let mut most = 0.0;
            for sides in 0..4_usize.pow(6) {
                let side = |k: usize| sides / 4_usize.pow(k as u32) % 4;
                let found = [0, 1, 2].map(|axis| [side(2 * axis), side(2 * axis + 1)]);
                let valid = found
                    .iter()
                    .zip(&lines)
                    .zip(start)
                    .all(|(([a, b], x), k)| *a <= k && k <= *b && *b < x.len());
                if valid && sound(&found) {
                    most = f64::max(most, volume(&found));
                }
            }
            match largest_box(&lines, &start, &works) {
                Some(found) => {
                    assert!(sound(&found), "{found:?}");
                    assert_eq!(volume(&found), most, "{found:?}");
                }
                None => assert_eq!(most, 0.0),
            }
        }
    }

    #[test]
    fn an_axis_of_one_line_has_no_length() {
        let lines = [vec![3.0], vec![0.0, 1.0]];
        assert_eq!(
            largest_box(&lines, &[0, 0], &[true, true]),
            Some(vec![[0, 0], [0, 1]])
        );
        assert_eq!(largest_box(&lines, &[0, 0], &[true, false]), None);
    }
}
