//! A cycle as a chain of marks: where the quantity turns back, and where it passes given levels.

use super::curve::Curve;
use super::extremes::Kind;
use super::monotone_pieces::{crossing, monotone_pieces};
use alloc::vec::Vec;

/// The kind of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CurveEventKind {
    /// A limit.
    Turn(Kind),
    /// The level of this index.
    Level(usize),
}

/// A place of the cycle; between two marks that follow each other the quantity only rises or only
/// falls.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurveEvent<const N: usize> {
    pub(crate) at: f64,
    pub(crate) jet: [f64; N],
    pub(crate) sign: CurveEventKind,
}

/// The marks of [`Curve::events`].
pub(super) fn events<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    levels: &[f64],
) -> Vec<CurveEvent<N>> {
    let chain = monotone_pieces(&curve.solved[0]);
    let mut events = Vec::new();
    let mut order: Vec<usize> = (0..levels.len()).collect();
    order.sort_by(|&a, &b| levels[a].total_cmp(&levels[b]));
    for pair in chain.windows(2) {
        let [a, b] = [&pair[0].node, &pair[1].node];
        let limit = pair[0].limit.map(CurveEventKind::Turn);
        let passed = |&&level: &&usize| (a.jet[0] < levels[level]) != (b.jet[0] < levels[level]);
        let event = |node: super::source::Node<N>, sign| {
            let node = curve.source.in_range(node);
            let (at, jet) = (node.u, node.jet);
            CurveEvent { at, jet, sign }
        };
        events.extend(limit.map(|sign| event(*a, sign)));
        let pass = |&level: &usize| {
            let node = crossing(&curve.source, a, b, levels[level]);
            event(node, CurveEventKind::Level(level))
        };
        if a.jet[0] < b.jet[0] {
            events.extend(order.iter().filter(passed).map(pass));
        } else {
            events.extend(order.iter().rev().filter(passed).map(pass));
        }
    }
    events
}
