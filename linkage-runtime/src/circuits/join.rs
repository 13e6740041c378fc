//! Assemblies that continue each other: through a turning point, or from one turn to the next.

use super::leaf::{End, GroupAssembly, Leaf};
use super::unknowns::{near, size};
use alloc::vec::Vec;

/// Greatest distance between positions of one assembly in two turns, relative to their size.
const SAME: f64 = 1e-6;

/// The end of a leaf: its number, and 0 or 1.
type LeafEnd = (usize, usize);

/// The circuits that the assemblies belong to, numbered from 0 in the order of their first ones,
/// and which of them are closed.
pub(super) fn join(
    leaves: &[Leaf],
    seams: &[[Vec<f64>; 2]],
    turn: bool,
) -> (Vec<usize>, Vec<bool>) {
    let mut numbers: Vec<usize> = (0..leaves.len()).collect();
    let mut unite = |one: usize, other: usize| {
        let [low, high] = [
            numbers[one].min(numbers[other]),
            numbers[one].max(numbers[other]),
        ];
        for number in &mut numbers {
            if *number == high {
                *number = low;
            }
        }
    };
    for (one, other) in partners(leaves) {
        unite(one, other);
    }
    let mut closed = alloc::vec![false; leaves.len()];
    for (one, closed) in closed.iter_mut().enumerate() {
        for other in continuing(leaves, seams, one, turn) {
            unite(one, other);
            *closed |= one == other;
        }
    }
    let mut order: Vec<usize> = Vec::new();
    for number in &mut numbers {
        let known = order.iter().position(|known| known == number);
        *number = known.unwrap_or_else(|| {
            order.push(*number);
            order.len() - 1
        });
    }
    (numbers, closed)
}

/// The leaves that continue one in the next turn: their unknowns are where its own end.
///
/// At a change point several begin in one place. There the leaf continues that is assembled in the
/// same way, wherever the turn begins.
fn continuing(leaves: &[Leaf], seams: &[[Vec<f64>; 2]], one: usize, turn: bool) -> Vec<usize> {
    let here = &seams[one][1];
    let is_near = |&other: &usize| {
        let ends = [leaves[one].ends[1], leaves[other].ends[0]];
        let there = &seams[other][0];
        turn && ends == [End::Range; 2] && near(here, there, size(here).max(size(there)), SAME)
    };
    let near_leaves: Vec<usize> = (0..leaves.len()).filter(is_near).collect();
    let alike = |other: &usize| {
        let mut pairs = leaves[one].ways.iter().zip(&leaves[*other].ways);
        pairs.all(|((_, here), (_, there))| match (here, there) {
            (GroupAssembly::Mode(a), GroupAssembly::Mode(b)) => a == b,
            _ => true,
        })
    };
    let same: Vec<usize> = near_leaves.iter().copied().filter(alike).collect();
    if same.is_empty() { near_leaves } else { same }
}

/// Pairs of leaves that meet at a turning point: of those that end there, two in which the group
/// that turns back is assembled differently and the later ones alike.
fn partners(leaves: &[Leaf]) -> Vec<(usize, usize)> {
    let ends: Vec<LeafEnd> = (0..leaves.len())
        .flat_map(|leaf| [(leaf, 0), (leaf, 1)])
        .collect();
    let mut free: Vec<bool> = alloc::vec![true; ends.len()];
    let mut pairs = Vec::new();
    for (index, &one) in ends.iter().enumerate() {
        if !free[index] {
            continue;
        }
        let distance = |&other: &usize| apart(leaves, one, ends[other]);
        let others =
            (index + 1..ends.len()).filter(|&other| free[other] && distance(&other).is_finite());
        if let Some(other) = others.min_by(|a, b| distance(a).total_cmp(&distance(b))) {
            free[other] = false;
            pairs.push((one.0, ends[other].0));
        }
    }
    pairs
}

/// Distance of the states of later groups at two ends; infinite unless these are two sides of one
/// turning point.
fn apart(leaves: &[Leaf], one: LeafEnd, other: LeafEnd) -> f64 {
    let [here, there] = [one, other].map(|(leaf, end)| (&leaves[leaf], end));
    let ends = [here, there].map(|(leaf, end)| leaf.ends[end]);
    let [End::Turning { group, .. }, _] = ends else {
        return f64::INFINITY;
    };
    if ends[0] != ends[1] {
        return f64::INFINITY;
    }
    let pairs = here.0.ways.iter().zip(&there.0.ways);
    let pairs = pairs.filter(|((later, _), _)| *later >= group);
    pairs
        .map(
            |((later, here_way), (_, there_way))| match (here_way, there_way) {
                (GroupAssembly::Mode(a), GroupAssembly::Mode(b))
                    if (a == b) == (*later > group) =>
                {
                    0.0
                }
                (GroupAssembly::States(a), GroupAssembly::States(b)) => {
                    let pairs = a[here.1].iter().zip(&b[there.1]);
                    pairs.map(|(a, b)| (a - b) * (a - b)).sum()
                }
                _ => f64::INFINITY,
            },
        )
        .sum()
}
