//! The roots of all derivatives, from the highest one down.
//!
//! Between neighbouring roots of one derivative the one below is monotone and has one root at most.
//! So only the highest derivative depends on the positions to begin with. There, values and mean
//! (the difference of the derivative below) tell of pairs of roots between two positions.

use super::defined_intervals::DefinedInterval;
use super::source::{Node, Source};
use super::zero_threshold::ZeroThreshold;
use alloc::vec::Vec;
use linkage_core::numeric::bracket::root;

/// The number of divisions of an interval in search of a pair of roots.
const DIVISIONS: u32 = 12;

/// A place where a derivative is zero, and its signs around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root<const N: usize> {
    pub(super) node: Node<N>,
    pub(super) before: i8,
    pub(super) after: i8,
}

/// A stretch, and the roots of its derivatives.
#[derive(Clone, Debug)]
pub(super) struct Solved<const N: usize> {
    pub(super) interval: DefinedInterval<N>,
    /// Roots of the quantity's derivatives by order; no roots of the quantity itself.
    pub(super) roots: [Vec<Root<N>>; N],
}

/// Solves a stretch, in parts if gaps come to light.
pub(super) fn solve<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    threshold: &ZeroThreshold<N>,
    defined_intervals: Vec<DefinedInterval<N>>,
) -> Vec<Solved<N>> {
    // Each gap takes some bisections; a function that is full of gaps should not take for ever.
    let mut searches = 64;
    let mut open = defined_intervals;
    let mut solved = Vec::new();
    while let Some(interval) = open.pop() {
        match cascade(source, threshold, &interval) {
            Ok(roots) => solved.push(Solved { interval, roots }),
            Err(Gap(u)) => {
                open.extend(interval.split(source, u, searches > 0));
                searches -= i32::from(searches > 0);
            }
        }
    }
    solved.sort_by(|a, b| a.interval.nodes[0].u.total_cmp(&b.interval.nodes[0].u));
    solved
}

/// A place between nodes that is not finite.
struct Gap(f64);

fn cascade<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    threshold: &ZeroThreshold<N>,
    interval: &DefinedInterval<N>,
) -> Result<[Vec<Root<N>>; N], Gap> {
    let mut nodes = interval.nodes[..1].to_vec();
    for pair in interval.nodes.windows(2) {
        divide(source, threshold, [pair[0], pair[1]], DIVISIONS, &mut nodes)?;
    }
    let mut roots = [const { Vec::new() }; N];
    for k in (1..N).rev() {
        roots[k] = roots_of(source, threshold, &nodes, k)?;
        nodes.extend(roots[k].iter().map(|root| root.node));
        nodes.sort_by(|a, b| a.u.total_cmp(&b.u));
        nodes.dedup_by(|a, b| a.u == b.u);
    }
    Ok(roots)
}

/// Adds the second node, and before it those between which the highest derivative changes its sign
/// twice.
fn divide<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    threshold: &ZeroThreshold<N>,
    [a, b]: [Node<N>; 2],
    divisions: u32,
    nodes: &mut Vec<Node<N>>,
) -> Result<(), Gap> {
    let same = threshold.sign(&a, N - 1) * threshold.sign(&b, N - 1) > 0;
    let dip = dip(&a, &b).filter(|_| same && divisions > 0);
    let probe = dip.map(|u| source.node(u));
    if let Some(probe) = probe.filter(|probe| probe.u > a.u && probe.u < b.u) {
        let probe = finite(probe)?;
        divide(source, threshold, [a, probe], divisions - 1, nodes)?;
        return divide(source, threshold, [probe, b], divisions - 1, nodes);
    }
    nodes.push(b);
    Ok(())
}

/// The place where the parabola with the highest derivative's values and mean comes nearest to
/// zero, if it comes much nearer than both ends.
fn dip<const N: usize>(a: &Node<N>, b: &Node<N>) -> Option<f64> {
    const NEAR: f64 = 0.25;
    let width = b.u - a.u;
    let (first, last) = (a.jet[N - 1], b.jet[N - 1]);
    let mean = (b.jet[N - 2] - a.jet[N - 2]) / width;
    let bend = 6.0 * (mean - 0.5 * (first + last));
    let share = 0.5 + 0.5 * (last - first) / bend;
    if !(share > 0.0 && share < 1.0) {
        return None;
    }
    let value = first + (last - first) * share + bend * share * (1.0 - share);
    let nearer = value * first.signum() < NEAR * first.abs().min(last.abs());
    nearer.then_some(a.u + width * share)
}

/// The roots of the `k`th derivative: sign changes, and places where it comes down to zero and
/// rises again.
fn roots_of<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    threshold: &ZeroThreshold<N>,
    nodes: &[Node<N>],
    k: usize,
) -> Result<Vec<Root<N>>, Gap> {
    let mut roots = Vec::new();
    let mut last: Option<(usize, i8)> = None;
    for (i, node) in nodes.iter().enumerate() {
        let after = threshold.sign(node, k);
        if after == 0 {
            continue;
        }
        if let Some((left, before)) = last {
            let zeros = &nodes[left + 1..i];
            let near = if before == after {
                nearest(zeros, k)
            } else {
                zeros.iter().copied().find(|zero| zero.jet[k] == 0.0)
            };
            let node = match near {
                Some(zero) => Some(zero),
                None if before == after => None,
                None => Some(crossing(source, &nodes[left], node, k)?),
            };
            roots.extend(node.map(|node| Root {
                node,
                before,
                after,
            }));
        }
        last = Some((i, after));
    }
    Ok(roots)
}

/// The node where the `k`th derivative is nearest to zero.
fn nearest<const N: usize>(nodes: &[Node<N>], k: usize) -> Option<Node<N>> {
    let size = |node: &Node<N>| node.jet[k].abs();
    nodes
        .iter()
        .copied()
        .min_by(|a, b| size(a).total_cmp(&size(b)))
}

fn crossing<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    a: &Node<N>,
    b: &Node<N>,
    k: usize,
) -> Result<Node<N>, Gap> {
    let mut gap = None;
    let mut last = *a;
    let mut value = |u: f64| {
        let node = source.node(u);
        last = node;
        if !node.is_finite() {
            gap = Some(u);
            // An end to the search.
            return [0.0; 2];
        }
        [
            node.jet[k],
            node.jet.get(k + 1).copied().unwrap_or(f64::NAN),
        ]
    };
    let u = root((a.u, a.jet[k]), (b.u, b.jet[k]), &mut value);
    match gap {
        Some(u) => Err(Gap(u)),
        None if u == a.u => Ok(*a),
        None if u == b.u => Ok(*b),
        None if u == last.u => finite(last),
        None => finite(source.node(u)),
    }
}

fn finite<const N: usize>(node: Node<N>) -> Result<Node<N>, Gap> {
    if node.is_finite() {
        Ok(node)
    } else {
        Err(Gap(node.u))
    }
}
