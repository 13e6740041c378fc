//! A cycle as a chain of marks: where the quantity turns back, and where it passes given levels.

use super::course::Course;
use super::extremes::Kind;
use super::stations::{passage, stations};
use alloc::vec::Vec;

/// What is at a mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    /// A limit.
    Turn(Kind),
    /// The level of this index.
    Level(usize),
}

/// A place of the cycle; between two marks that follow each other the quantity only rises or only falls.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark<const N: usize> {
    pub(crate) at: f64,
    pub(crate) jet: [f64; N],
    pub(crate) sign: Sign,
}

/// The marks of [`Course::marks`].
pub(super) fn marks<const N: usize, F: Fn(f64) -> [f64; N]>(
    course: &Course<N, F>,
    levels: &[f64],
) -> Vec<Mark<N>> {
    let chain = stations(&course.solved[0]);
    let mut marks = Vec::new();
    let mut order: Vec<usize> = (0..levels.len()).collect();
    order.sort_by(|&a, &b| levels[a].total_cmp(&levels[b]));
    for pair in chain.windows(2) {
        let [a, b] = [&pair[0].node, &pair[1].node];
        let limit = pair[0].limit.map(Sign::Turn);
        let passed = |&&level: &&usize| (a.jet[0] < levels[level]) != (b.jet[0] < levels[level]);
        let mark = |node: super::source::Node<N>, sign| {
            let node = course.source.in_range(node);
            let (at, jet) = (node.u, node.jet);
            Mark { at, jet, sign }
        };
        marks.extend(limit.map(|sign| mark(*a, sign)));
        let pass = |&level: &usize| {
            let node = passage(&course.source, a, b, levels[level]);
            mark(node, Sign::Level(level))
        };
        if a.jet[0] < b.jet[0] {
            marks.extend(order.iter().filter(passed).map(pass));
        } else {
            marks.extend(order.iter().rev().filter(passed).map(pass));
        }
    }
    marks
}
