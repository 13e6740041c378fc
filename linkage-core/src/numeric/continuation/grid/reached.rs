//! The nodes of a grid that a solution reaches.

use super::super::Correction;
use super::super::follow::Follower;
use super::path::{PathEnd, follow};
use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;

/// Corrections, at most: some ten for each of a few thousand nodes.
const CORRECTIONS: usize = 200_000;

/// Follows the solution `state` at the node `start` to all nodes of a grid, from neighbour to
/// neighbour. Returns the size of the determinant at each node as a share of that at the start, the
/// last input changing fastest; 0 where the solution is not reached.
///
/// `lines` are the places of the grid's lines along each input.
///
/// # Panics
///
/// If `start` is no node.
#[must_use]
pub fn reached(
    correction: &mut dyn Correction,
    lines: &[Vec<f64>],
    start: &[usize],
    state: &[f64],
) -> Vec<f64> {
    let nodes: usize = lines.iter().map(Vec::len).product();
    let mut shares = vec![0.0; nodes];
    let position = |node: &[usize]| -> Vec<f64> {
        let pairs = lines.iter().zip(node);
        pairs.map(|(places, &k)| places[k]).collect()
    };
    let number = |node: &[usize]| {
        let pairs = lines.iter().zip(node);
        pairs.fold(0, |number, (places, &k)| number * places.len() + k)
    };
    let at = position(start);
    let mut state = state.to_vec();
    let Some(mut follower) = Follower::new(correction, &at, &mut state, CORRECTIONS) else {
        return shares;
    };
    let Some(first) = follower.settle(&at, &mut state) else {
        return shares;
    };
    shares[number(start)] = 1.0;
    let mut queue: VecDeque<(Vec<usize>, Vec<f64>, f64)> = VecDeque::new();
    queue.push_back((start.to_vec(), state, first));
    while let Some((node, state, determinant)) = queue.pop_front() {
        let from = position(&node);
        for axis in 0..node.len() {
            let below = node[axis].checked_sub(1);
            let above = Some(node[axis] + 1).filter(|&k| k < lines[axis].len());
            for k in [below, above].into_iter().flatten() {
                let mut next = node.clone();
                next[axis] = k;
                let index = number(&next);
                if shares[index] > 0.0 {
                    continue;
                }
                let mut moved = state.clone();
                let to = position(&next);
                let determinants = [determinant, first];
                let end = follow(&mut follower, &from, &to, &mut moved, determinants);
                if let PathEnd::Reached(there) = end {
                    shares[index] = (there / first).abs();
                    queue.push_back((next, moved, there));
                }
            }
        }
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::super::super::Step;
    use super::*;

    /// `s^2 = 1 - x - y`, on the branch of positive numbers: a dead point where the sum is 1.
    #[test]
    fn nodes_before_the_dead_point_are_reached() {
        let mut correction = |x: &[f64], state: &mut [f64]| {
            let (s, rest) = (state[0], 1.0 - x[0] - x[1]);
            let change = (s * s - rest) / (2.0 * s);
            state[0] -= change;
            Step {
                size: change.abs(),
                determinant: 2.0 * s,
            }
        };
        let line: Vec<f64> = (0..9).map(|k| 0.2 * f64::from(k) - 0.7).collect();
        let lines = [line.clone(), line.clone()];
        let start = [3, 3];
        let at = line[3];
        let shares = reached(&mut correction, &lines, &start, &[(1.0 - 2.0 * at).sqrt()]);
        for (index, share) in shares.iter().enumerate() {
            let rest = 1.0 - line[index / 9] - line[index % 9];
            let expected = (rest.max(0.0) / (1.0 - 2.0 * at)).sqrt();
            assert!(
                (share - expected).abs() < 1e-6,
                "{index}: {share} {expected}"
            );
        }
    }
}
