//! Dwells between limits: the quantity passes through the whole band, slowly.

use super::curve::Curve;
use super::monotone_pieces::{PieceEnd, crossing_input};
use super::source::Node;
use alloc::vec::Vec;
use linkage_core::numeric::bracket::root;

/// Two neighbouring stations.
type Piece<const N: usize> = [Node<N>; 2];

/// Into how many steps the first piece is divided where the speeds at both ends change in the same
/// sense.
const STEPS: u32 = 16;

/// The intervals over which the quantity changes by the whole band, with the same speed at both
/// ends: those that become shorter if they are moved either way.
pub(super) fn between<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    chain: &[PieceEnd<N>],
    band: f64,
) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    if N < 3 {
        // Pieces would have speeds that rise and fall.
        return found;
    }
    let pieces = chain.windows(2).map(|pair| [pair[0].node, pair[1].node]);
    let pieces: Vec<Piece<N>> = pieces.collect();
    for (i, first) in pieces.iter().enumerate() {
        let (mut low, mut high) = (first[1].jet[0], first[1].jet[0]);
        for last in &pieces[i + 1..] {
            if high - low > band {
                break;
            }
            if rises(last) == rises(first) {
                equal_speeds(curve, [first, last], [low, high], band, &mut found);
            }
            low = low.min(last[1].jet[0]);
            high = high.max(last[1].jet[0]);
        }
    }
    found
}

/// Those from the first to the last piece; `between` are the lowest and highest value between the
/// pieces.
fn equal_speeds<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    [first, last]: [&Piece<N>; 2],
    between: [f64; 2],
    band: f64,
    found: &mut Vec<[f64; 2]>,
) {
    let steps = match [first, last].map(quickens) {
        // Moving it makes one end faster and the other one slower: one place at most.
        [false, true] => 1,
        // It becomes longer either way.
        [true, false] => return,
        _ => STEPS,
    };
    let Some([a, b]) = beginnings(curve, [first, last], between, band) else {
        return;
    };
    let excess = |u: f64| {
        let start = curve.source.node(u);
        let end = curve.source.node(end_of(curve, &start, first, last, band));
        end.jet[1].abs() - start.jet[1].abs()
    };
    let mut before = (a, excess(a));
    for step in 1..=steps {
        let u = a + (b - a) * (f64::from(step) / f64::from(steps));
        let after = (u, excess(u));
        if before.1 <= 0.0 && after.1 >= 0.0 && before.1 < after.1 {
            let start = root(before, after, &mut |u| [excess(u), f64::NAN]);
            found.push([
                start,
                end_of(curve, &curve.source.node(start), first, last, band),
            ]);
        }
        before = after;
    }
}

/// The first and the last beginning on the first piece of an interval that ends on the last piece
/// and is within the band between.
fn beginnings<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    [first, last]: [&Piece<N>; 2],
    between: [f64; 2],
    band: f64,
) -> Option<[f64; 2]> {
    // Turned over if it falls: the interval goes from the band's lower bound to the upper one.
    let sign = if rises(first) { 1.0 } else { -1.0 };
    let [from, to] = first.map(|node| sign * node.jet[0]);
    let ends = last.map(|node| sign * node.jet[0] - band);
    let [a, b] = between.map(|value| sign * value);
    let lower = from.max(ends[0]).max(a.max(b) - band);
    let upper = to.min(ends[1]).min(a.min(b));
    let beginning = |bound: f64| {
        if bound <= from {
            first[0].u
        } else if bound >= to {
            first[1].u
        } else {
            crossing_input(&curve.source, &first[1], &first[0], sign * bound)
        }
    };
    (lower < upper).then(|| [beginning(lower), beginning(upper)])
}

/// The end, on the last piece, of an interval that begins at `start`.
fn end_of<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    start: &Node<N>,
    first: &Piece<N>,
    last: &Piece<N>,
    band: f64,
) -> f64 {
    let sign = if rises(first) { 1.0 } else { -1.0 };
    let bound = sign * start.jet[0] + band;
    if bound <= sign * last[0].jet[0] {
        last[0].u
    } else if bound >= sign * last[1].jet[0] {
        last[1].u
    } else {
        crossing_input(&curve.source, &last[0], &last[1], sign * bound)
    }
}

fn rises<const N: usize>(piece: &Piece<N>) -> bool {
    piece[1].jet[0] > piece[0].jet[0]
}

fn quickens<const N: usize>(piece: &Piece<N>) -> bool {
    piece[1].jet[1].abs() > piece[0].jet[1].abs()
}
