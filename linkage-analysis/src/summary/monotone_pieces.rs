//! The curve as a chain of pieces, on each of which the quantity rises or falls.

use super::cascade::{Root, Solved};
use super::extremes::Kind;
use super::source::{Node, Source};
use alloc::vec::Vec;
use linkage_core::numeric::bracket::root;

/// An end of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct PieceEnd<const N: usize> {
    pub(super) node: Node<N>,
    /// The kind of limit; `None` for an extreme velocity, and where a cycle was cut open.
    pub(super) limit: Option<Kind>,
    /// True at an end of the curve.
    pub(super) end: bool,
}

impl<const N: usize> PieceEnd<N> {
    pub(super) fn u(&self) -> f64 {
        self.node.u
    }

    pub(super) fn value(&self) -> f64 {
        self.node.jet[0]
    }
}

/// The ends of a stretch, its limits and its extreme velocities, in order of the input: between
/// neighbours the quantity is monotone, and with a second derivative its speed is, too.
pub(super) fn monotone_pieces<const N: usize>(part: &Solved<N>) -> Vec<PieceEnd<N>> {
    let turns = |root: &&Root<N>| root.before != root.after;
    let mut monotone_pieces: Vec<PieceEnd<N>> = Vec::new();
    for (k, roots) in part.roots.iter().enumerate().take(3).skip(1) {
        monotone_pieces.extend(roots.iter().filter(turns).map(|root| PieceEnd {
            node: root.node,
            limit: match root.before {
                1 if k == 1 => Some(Kind::High),
                -1 if k == 1 => Some(Kind::Low),
                _ => None,
            },
            end: false,
        }));
    }
    monotone_pieces.sort_by(|a, b| a.u().total_cmp(&b.u()));
    let nodes = &part.interval.nodes;
    let whole = part.interval.whole;
    let end = |node: Node<N>, beside: Option<&PieceEnd<N>>| PieceEnd {
        node,
        limit: match beside {
            _ if whole => None,
            Some(beside) if beside.value() < node.jet[0] => Some(Kind::High),
            Some(_) => Some(Kind::Low),
            None => None,
        },
        end: !whole,
    };
    let last = end(nodes[nodes.len() - 1], None);
    let first = end(nodes[0], monotone_pieces.first().or(Some(&last)));
    let last = end(last.node, monotone_pieces.last().or(Some(&first)));
    monotone_pieces.insert(0, first);
    monotone_pieces.push(last);
    monotone_pieces
}

/// The input, on the piece from `inside` to `outside` (in either direction), at which the quantity
/// crosses `bound`. A value that is not a number counts as outside.
pub(super) fn crossing_input<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    inside: &Node<N>,
    outside: &Node<N>,
    bound: f64,
) -> f64 {
    crossing(source, inside, outside, bound).u
}

/// Works as [`crossing_input`], with the derivatives there.
pub(super) fn crossing<const N: usize, F: Fn(f64) -> [f64; N]>(
    source: &Source<N, F>,
    inside: &Node<N>,
    outside: &Node<N>,
    bound: f64,
) -> Node<N> {
    let beyond = outside.jet[0] - bound;
    let mut last = *inside;
    let mut value = |u: f64| {
        last = source.node(u);
        if last.is_finite() {
            [last.jet[0] - bound, last.jet[1]]
        } else {
            [beyond, f64::NAN]
        }
    };
    let u = root(
        (inside.u, inside.jet[0] - bound),
        (outside.u, beyond),
        &mut value,
    );
    if u == last.u { last } else { source.node(u) }
}
