//! One connected piece of a curve, from end to end of its slab or round.

use super::curve::{Node, SolutionCurve};
use alloc::collections::VecDeque;
use alloc::vec::Vec;
use linkage_core::math;
use linkage_core::numeric::golden_section::RATIO;
use linkage_core::numeric::vector::dot;

/// Lengths of steps: the first, the largest, and one that is no step any more.
const FIRST: f64 = 0.01;
const LARGEST: f64 = 0.06;
const LEAST: f64 = 1e-11;

/// A curve that comes back misses its beginning by less, as a part of the step, and anyway.
const CLOSURE: (f64, f64) = (0.02, 1e-6);

/// The parameter grows slower than this where the curve may turn back and forth between two nodes.
const STEEP: f64 = 0.3;

/// Refinements of a turning point, at most, and how upright the curve is there at last.
const REFINEMENTS: usize = 80;
const VERTICAL: f64 = 2e-6;

/// An end of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum CurveEnd {
    /// With the slab.
    Slab,
    /// At a turning point; the number counts those of the slab.
    Turning(usize),
    /// It cannot be followed: it runs off to infinity, or crosses another one.
    Lost,
}

/// A part of a curve along which the input only grows.
#[derive(Clone, Debug)]
pub(super) struct Strand {
    pub(super) nodes: Vec<Node>,
    pub(super) ends: [CurveEnd; 2],
}

/// The nodes of a curve through a known one, and its ends, both turning points of number 0 if it is
/// closed.
struct Trace {
    nodes: Vec<Node>,
    ends: [CurveEnd; 2],
    closed: bool,
}

impl SolutionCurve<'_> {
    /// The strands of the curve through a node; `count` numbers the turning points.
    pub(super) fn strands(&mut self, start: Node, count: &mut usize) -> Vec<Strand> {
        let mut trace = self.trace(start);
        self.look_closer(&mut trace);
        if trace.closed {
            // Begins and ends at a turning point, which every closed curve has.
            trace.nodes.pop();
            let turns = |nodes: &[Node]| nodes[0].direction[0] * nodes[1].direction[0] < 0.0;
            let Some(first) = trace.nodes.windows(2).position(turns) else {
                return Vec::new();
            };
            trace.nodes.rotate_left(first + 1);
            let last = trace.nodes[trace.nodes.len() - 1].clone();
            trace.nodes.insert(0, last);
        }
        self.cut(trace, count)
    }

    fn trace(&mut self, start: Node) -> Trace {
        let (above, end, closed) = self.run(&start);
        let mut nodes = VecDeque::from([start.clone()]);
        nodes.extend(above);
        let mut ends = [CurveEnd::Turning(0), end];
        if !closed {
            let (below, end, _) = self.run(&start.turned());
            for node in below {
                nodes.push_front(node.turned());
            }
            ends[0] = end;
        }
        Trace {
            nodes: nodes.into(),
            ends,
            closed,
        }
    }

    /// Nodes from the start on, its end, and whether it has come back.
    fn run(&mut self, start: &Node) -> (Vec<Node>, CurveEnd, bool) {
        let mut nodes: Vec<Node> = Vec::new();
        let mut length = FIRST;
        loop {
            let last = nodes.last().unwrap_or(start).clone();
            if last.u.abs() >= 1.0 && last.u * last.direction[0] > 0.0 {
                return (nodes, CurveEnd::Slab, false);
            }
            if length < LEAST {
                return (nodes, CurveEnd::Lost, false);
            }
            if nodes.len() > 2
                && let Some(next) = self.back(&last, start, length)
            {
                nodes.push(next);
                return (nodes, CurveEnd::Turning(0), true);
            }
            let border = last.direction[0].signum();
            let lands = (border - last.u) / last.direction[0] <= length;
            let next = if lands {
                self.land(&last, border)
            } else {
                self.step_along(&last, length)
            };
            match next {
                Some(next) => {
                    length = (Self::growth(&last, &next) * length).min(LARGEST);
                    nodes.push(next);
                }
                None if lands => {
                    let far = ((border - last.u) / last.direction[0]).min(length);
                    length = 0.5 * far;
                }
                None => length *= 0.5,
            }
        }
    }

    /// The start, if it is the next node.
    fn back(&mut self, last: &Node, start: &Node, length: f64) -> Option<Node> {
        let mut way = self.difference(&last.state, &start.state);
        way.insert(0, start.u - last.u);
        let along = dot(&way, &last.direction);
        let near = along > 0.0 && along <= length && dot(&way, &way) <= 4.0 * length * length;
        if !near || dot(&last.direction, &start.direction) < 0.5 {
            return None;
        }
        let next = self.step_along(last, along)?;
        let miss = self.difference(&next.state, &start.state);
        let miss = math::double::sqrt(dot(&miss, &miss)) + (next.u - start.u).abs();
        (miss <= CLOSURE.0 * along + CLOSURE.1).then(|| start.clone())
    }

    /// Adds nodes where the curve turns back and forth between neighbours.
    fn look_closer(&mut self, trace: &mut Trace) {
        let mut more: Vec<(usize, Node)> = Vec::new();
        for (index, three) in trace.nodes.windows(3).enumerate() {
            let [before, middle, after] = [0, 1, 2].map(|k| three[k].direction[0]);
            let sign = middle.signum();
            let low = middle.abs() < STEEP
                && before * sign >= middle.abs()
                && after * sign >= middle.abs();
            if !low {
                continue;
            }
            let reach = [&three[0], &three[2]].map(|other| self.along(&three[1], other));
            if let Some((length, node)) = self.lowest(&three[1], sign, reach) {
                more.push((index + 1 + usize::from(length > 0.0), node));
            }
        }
        for (index, node) in more.into_iter().rev() {
            trace.nodes.insert(index, node);
        }
    }

    /// A node between two lengths from another one where the input falls instead of rising, or the
    /// other way round.
    fn lowest(
        &mut self,
        node: &Node,
        sign: f64,
        [mut low, mut high]: [f64; 2],
    ) -> Option<(f64, Node)> {
        const STEPS: usize = 30;
        for _ in 0..STEPS {
            let lengths = [high - RATIO * (high - low), low + RATIO * (high - low)];
            let [left, right] = [
                self.step_along(node, lengths[0])?,
                self.step_along(node, lengths[1])?,
            ];
            let slopes = [&left, &right].map(|node| sign * node.direction[0]);
            for (length, slope, node) in [
                (lengths[0], slopes[0], left),
                (lengths[1], slopes[1], right),
            ] {
                if slope < 0.0 {
                    return Some((length, node));
                }
            }
            if slopes[0] < slopes[1] {
                high = lengths[1];
            } else {
                low = lengths[0];
            }
        }
        None
    }

    /// The distance of another node along its direction.
    fn along(&self, node: &Node, other: &Node) -> f64 {
        let way = self.difference(&node.state, &other.state);
        (other.u - node.u) * node.direction[0] + dot(&way, &node.direction[1..])
    }

    /// The strands between turning points.
    fn cut(&mut self, trace: Trace, count: &mut usize) -> Vec<Strand> {
        let mut strands: Vec<Strand> = Vec::new();
        let mut nodes: Vec<Node> = Vec::new();
        let mut begin = trace.ends[0];
        let first = *count;
        for node in trace.nodes {
            if let Some(last) = nodes.last()
                && last.direction[0] * node.direction[0] < 0.0
            {
                let turning = self.turning(last, &node);
                let end = CurveEnd::Turning(*count);
                *count += 1;
                nodes.push(turning.clone());
                let done = core::mem::replace(&mut nodes, Vec::from([turning]));
                strands.push(Strand {
                    nodes: done,
                    ends: [begin, end],
                });
                begin = end;
            }
            nodes.push(node);
        }
        if trace.closed {
            // The part before the first turning point is the end of the last strand.
            strands.remove(0);
            let end = CurveEnd::Turning(first);
            if let Some(beginning) = strands.first().map(|strand| strand.nodes[0].clone()) {
                nodes.push(beginning);
            }
            strands.push(Strand {
                nodes,
                ends: [begin, end],
            });
        } else {
            strands.push(Strand {
                nodes,
                ends: [begin, trace.ends[1]],
            });
        }
        for strand in &mut strands {
            self.put_right(strand);
        }
        strands
    }

    /// The node between two at which the curve turns back: by the secant, and by halves where that
    /// does not come nearer.
    fn turning(&mut self, one: &Node, other: &Node) -> Node {
        let (mut low, mut high) = (one.clone(), other.clone());
        for refinement in 0..REFINEMENTS {
            let [at_low, at_high] = [&low, &high].map(|node| node.direction[0]);
            if at_low.abs().min(at_high.abs()) < VERTICAL {
                break;
            }
            let secant = match refinement % 3 {
                2 => 0.5,
                _ => at_low / (at_low - at_high),
            };
            let length = self.along(&low, &high);
            let mut next = None;
            for share in [secant, 0.5, 0.3, 0.7] {
                next = self.step_along(&low, share * length);
                next = next.or_else(|| self.step_along(&high, (share - 1.0) * length));
                if next.is_some() {
                    break;
                }
            }
            let Some(next) = next else {
                break;
            };
            if next.direction[0] * at_low > 0.0 {
                low = next;
            } else {
                high = next;
            }
        }
        if low.direction[0].abs() < high.direction[0].abs() {
            low
        } else {
            high
        }
    }

    /// Nodes in the order of their inputs, at least one between the ends.
    fn put_right(&mut self, strand: &mut Strand) {
        let [first, last] = [0, strand.nodes.len() - 1].map(|k| strand.nodes[k].u);
        if first > last {
            strand.nodes.reverse();
            strand.ends.reverse();
        }
        if let [one, other] = &strand.nodes[..] {
            let length = 0.5 * self.along(one, other);
            let between = self.step_along(&one.clone(), length);
            strand.nodes.splice(1..1, between);
        }
    }
}
