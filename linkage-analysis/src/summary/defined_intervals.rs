//! Intervals of the range in which the quantity is defined.

use super::source::{Node, Source};
use super::zero_threshold::ZeroThreshold;
use alloc::vec::Vec;

/// Nodes in order of the input, all of them finite, without a known gap between them.
#[derive(Clone, Debug)]
pub(super) struct DefinedInterval<const N: usize> {
    pub(super) nodes: Vec<Node<N>>,
    /// The whole of a cycle: the last node is the first one, a cycle later.
    pub(super) whole: bool,
}

/// The evenly spaced positions over a range, both ends among them, from which a
/// [`Curve`](super::Curve) is followed: a sweep computes the rows of
/// [`Curve::swept`](super::Curve::swept) there.
///
/// ```
/// use linkage_analysis::summary::positions;
///
/// assert_eq!(positions((0.0, 6.0), 4).collect::<Vec<_>>(), [0.0, 2.0, 4.0, 6.0]);
/// ```
pub fn positions((low, high): (f64, f64), count: usize) -> impl ExactSizeIterator<Item = f64> {
    let last = count.saturating_sub(1);
    (0..count).map(move |i| {
        if i == last {
            high
        } else {
            low + (high - low) * (i as f64 / last as f64)
        }
    })
}

/// The advance of the quantity in a range of whole turns after which all derivatives return to
/// their values; `None` for other ranges.
pub(super) fn advance<const N: usize>(nodes: &[Node<N>]) -> Option<f64> {
    const AGREE: f64 = 1e-9;
    let (first, last) = (nodes.first()?, nodes.last()?);
    let turns = (last.u - first.u) / core::f64::consts::TAU;
    let whole = (1..=64).any(|n| (turns - f64::from(n)).abs() < AGREE);
    if !(whole && first.is_finite() && last.is_finite()) {
        return None;
    }
    // The size of a value: its mean, so that one position next to a dead point does not make all
    // values equal.
    let size = |k: usize| {
        let finite = || nodes.iter().filter(|node| node.is_finite());
        let count = finite().count() as f64;
        finite().map(|node| node.jet[k].abs() / count).sum::<f64>()
    };
    let difference = |k: usize| last.jet[k] - first.jet[k];
    let returns = |k: usize| difference(k).abs() <= AGREE * size(k);
    let constant = |k: usize| k > 0 && size(k) <= AGREE * size(k - 1);
    if !(1..N).all(|k| returns(k) || constant(k)) {
        return None;
    }
    Some(if returns(0) { 0.0 } else { difference(0) })
}

/// The stretches between positions that are not finite, with their borders; over the seam if the
/// range is a cycle.
pub(super) fn defined_intervals<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    nodes: &[Node<N>],
    threshold: &ZeroThreshold<N>,
) -> Vec<DefinedInterval<N>> {
    let mut runs: Vec<Vec<Node<N>>> = Vec::new();
    let mut before: Option<Node<N>> = None;
    for &node in nodes {
        match (before.filter(Node::is_finite), node.is_finite()) {
            (None, true) => {
                let border = before.map(|bad| border(source, node, bad.u));
                runs.push(joined(border.as_slice(), &[node]));
            }
            (Some(_), true) => push(&mut runs, node),
            (Some(good), false) => push(&mut runs, border(source, good, node.u)),
            (None, false) => {}
        }
        before = Some(node);
    }
    if source.advance.is_some() {
        if runs.len() == 1 {
            let nodes = rotated(source, &runs[0], threshold);
            return alloc::vec![DefinedInterval { nodes, whole: true }];
        }
        if let Some(last) = runs.pop() {
            let first = runs.remove(0);
            runs.push(over_seam(source, &last, &first));
        }
    }
    let open = |nodes| DefinedInterval {
        nodes,
        whole: false,
    };
    runs.into_iter().map(open).collect()
}

impl<const N: usize> DefinedInterval<N> {
    /// The parts on both sides of a gap at `u`, which is not finite. Without `search` for its
    /// borders, the whole space between the nodes next to it is taken for the gap.
    pub(super) fn split<F: Fn(f64) -> [f64; N]>(
        &self,
        source: &Source<N, F>,
        u: f64,
        search: bool,
    ) -> Vec<Self> {
        let (left, right) = self
            .nodes
            .split_at(self.nodes.partition_point(|node| node.u < u));
        let ends = |good: Option<&Node<N>>| {
            let good = good.filter(|_| search);
            good.map(|&good| border(source, good, u))
        };
        let left = joined(left, ends(left.last()).as_slice());
        let right = joined(ends(right.first()).as_slice(), right);
        let parts = if self.whole {
            alloc::vec![over_seam(source, &right, &left)]
        } else {
            alloc::vec![left, right]
        };
        let open = |nodes| Self {
            nodes,
            whole: false,
        };
        parts.into_iter().map(open).collect()
    }
}

/// The last place, seen from a good one, before the quantity is no longer finite.
fn border<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    mut good: Node<N>,
    mut bad: f64,
) -> Node<N> {
    let precision = 0.5 * f64::EPSILON * good.u.abs().max(bad.abs());
    while (bad - good.u).abs() > precision {
        let middle = source.node(good.u + 0.5 * (bad - good.u));
        if middle.u == good.u || middle.u == bad {
            break;
        }
        if middle.is_finite() {
            good = middle;
        } else {
            bad = middle.u;
        }
    }
    good
}

fn push<const N: usize>(runs: &mut [Vec<Node<N>>], node: Node<N>) {
    if let Some(run) = runs.last_mut() {
        run.push(node);
        run.dedup_by(|a, b| a.u == b.u);
    }
}

fn joined<const N: usize>(left: &[Node<N>], right: &[Node<N>]) -> Vec<Node<N>> {
    let mut nodes = [left, right].concat();
    nodes.dedup_by(|a, b| a.u == b.u);
    nodes
}

/// The last run of a cycle and the first one, which goes on where the last one ends.
fn over_seam<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    before: &[Node<N>],
    after: &[Node<N>],
) -> Vec<Node<N>> {
    let later = after.iter().skip(1).map(|&node| source.shifted(node, 1.0));
    before.iter().copied().chain(later).collect()
}

/// A cycle that begins where no derivative is near zero, so that nothing has to be looked for at
/// its ends.
fn rotated<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    nodes: &[Node<N>],
    threshold: &ZeroThreshold<N>,
) -> Vec<Node<N>> {
    let clearness: Vec<f64> = nodes.iter().map(|node| threshold.clearness(node)).collect();
    let clearest = (0..nodes.len() - 1).max_by(|&a, &b| clearness[a].total_cmp(&clearness[b]));
    let start = clearest.unwrap_or(0);
    let later = nodes[1..=start]
        .iter()
        .map(|&node| source.shifted(node, 1.0));
    nodes[start..].iter().copied().chain(later).collect()
}
