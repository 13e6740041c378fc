//! The highest and lowest values of a quantity or of one of its derivatives.

use super::cascade::Solved;
use super::source::{Node, Source};
use super::zero_threshold::ZeroThreshold;
use alloc::vec::Vec;

/// Extremes of a quantity and of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A local maximum.
    High,
    /// A local minimum.
    Low,
    /// It moves on in the same sense.
    Pass,
}

/// A place where a quantity is stationary, or an end of its curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// The input.
    pub at: f64,
    /// The value there. Its tolerance is that of the quantity at this place, `sensitivity(q)`:
    /// where the quantity is stationary, its derivative by the input is zero, and it does not
    /// matter that the place shifts (the envelope theorem).
    pub value: f64,
    /// The kind of limit.
    pub kind: Kind,
    /// True at an end of the curve: an end of a range that is no cycle, or of the assembled part.
    /// The quantity need not be stationary there.
    pub end: bool,
}

impl Extreme {
    /// Returns true if the quantity turns back there.
    #[must_use]
    pub fn is_limit(&self) -> bool {
        self.kind != Kind::Pass
    }
}

/// The extreme values of a quantity, or of one of its derivatives, over its curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Extremes {
    /// The stationary places, and the ends of the curve, in order of the input. A rest with the
    /// derivative 0 exactly is represented by its first position. Empty for a constant.
    pub points: Vec<Extreme>,
    /// The first of the lowest values.
    pub lowest: Extreme,
    /// The first of the highest values.
    pub highest: Extreme,
}

impl Extremes {
    /// The highest value less the lowest one: the stroke.
    #[must_use]
    pub fn stroke(&self) -> f64 {
        self.highest.value - self.lowest.value
    }

    /// The one of `lowest` and `highest` that is farther from zero.
    #[must_use]
    pub fn largest(&self) -> Extreme {
        if self.lowest.value.abs() > self.highest.value.abs() {
            self.lowest
        } else {
            self.highest
        }
    }

    /// The places where it turns back, the ends of its curve left out.
    pub fn limits(&self) -> impl Iterator<Item = &Extreme> {
        self.points
            .iter()
            .filter(|point| point.is_limit() && !point.end)
    }

    /// The extremes of the `k`th derivative.
    pub(super) fn new<const N: usize, F: Fn(f64) -> [f64; N]>(
        source: &Source<N, F>,
        threshold: &ZeroThreshold<N>,
        solved: &[Solved<N>],
        k: usize,
    ) -> Self {
        let mut points = Vec::new();
        let mut extremes = Vec::new();
        for part in solved {
            let turns = part.roots[k + 1].iter();
            points.extend(turns.map(|root| {
                let node = source.in_range(root.node);
                extreme(node, k, [root.before, root.after])
            }));
            points.extend(ends(source, threshold, part, k));
            extremes.push(extreme(source.in_range(part.interval.nodes[0]), k, [0; 2]));
        }
        points.sort_by(|a, b| a.at.total_cmp(&b.at));
        if !points.is_empty() {
            extremes.clone_from(&points);
        }
        // A constant has no point; its value is the one of any node.
        let lower = |a: Extreme, b: Extreme| if b.value < a.value { b } else { a };
        let higher = |a: Extreme, b: Extreme| if b.value > a.value { b } else { a };
        let first = extremes[0];
        Self {
            lowest: extremes.iter().copied().fold(first, lower),
            highest: extremes.iter().copied().fold(first, higher),
            points,
        }
    }
}

/// The ends of a stretch. Over the seam of a cycle over which the quantity advances, also the ends
/// of the range.
fn ends<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    threshold: &ZeroThreshold<N>,
    part: &Solved<N>,
    k: usize,
) -> Vec<Extreme> {
    let mut ends = Vec::new();
    let nodes = &part.interval.nodes;
    let [start, end] = [nodes[0], nodes[nodes.len() - 1]];
    if !part.interval.whole {
        let sign = |node: &Node<N>| threshold.sign(node, k + 1);
        let first = nodes.iter().map(sign).find(|&sign| sign != 0);
        let last = nodes.iter().rev().map(sign).find(|&sign| sign != 0);
        ends.extend(first.map(|sign| ending(source.in_range(start), k, [0, sign])));
        ends.extend(last.map(|sign| ending(source.in_range(end), k, [sign, 0])));
    }
    let advance = source.advance.filter(|&advance| k == 0 && advance != 0.0);
    if let Some(advance) = advance.filter(|_| start.u < source.high && end.u >= source.high) {
        let [low, high] = [source.low, source.high].map(|x| source.node(x));
        let sense = match threshold.sign(&low, 1) {
            0 if advance > 0.0 => 1,
            0 => -1,
            sign => sign,
        };
        ends.extend([ending(low, k, [0, sense]), ending(high, k, [sense, 0])]);
    }
    ends
}

fn ending<const N: usize>(node: Node<N>, k: usize, signs: [i8; 2]) -> Extreme {
    Extreme {
        end: true,
        ..extreme(node, k, signs)
    }
}

/// With the signs of the slope before and after it; 0 where there is nothing.
fn extreme<const N: usize>(node: Node<N>, k: usize, signs: [i8; 2]) -> Extreme {
    Extreme {
        at: node.u,
        value: node.jet[k],
        kind: match signs {
            [0 | 1, -1] | [1, 0] => Kind::High,
            [0 | -1, 1] | [-1, 0] => Kind::Low,
            _ => Kind::Pass,
        },
        end: false,
    }
}
