//! Dwells: the longest intervals of the input in which a quantity stays in a band.

use super::curve::Curve;
use super::dwell_between_limits::between;
use super::extremes::Kind;
use super::interval::Interval;
use super::monotone_pieces::{PieceEnd, crossing_input, monotone_pieces};
use super::source::Node;
use alloc::vec::Vec;

/// An interval of the input in which the quantity stays in a band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dwell {
    /// The interval; in a cycle perhaps across the seam.
    pub interval: Interval,
    /// The lowest value in it. If the quantity advances over a cycle, and the interval goes across
    /// the seam, values beyond it are those of the next cycle; so also for the highest one.
    pub lowest: f64,
    /// The highest value in it.
    pub highest: f64,
    /// The highest less the lowest of the limits in it: how much the quantity moves to and fro. 0
    /// with one limit or none.
    pub ripple: f64,
}

/// The dwells of [`Curve::dwells`].
pub(super) fn dwells<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    band: f64,
) -> Vec<Dwell> {
    if band.is_nan() || band <= 0.0 {
        return Vec::new();
    }
    if curve.is_cycle() && curve.solved[0].interval.whole && curve.position().stroke() <= band {
        let interval = Interval::whole(&curve.source);
        return alloc::vec![dwell(
            curve,
            &chain_of(curve, 0),
            interval,
            [interval.from, interval.to]
        )];
    }
    let mut found: Vec<(usize, [f64; 2])> = Vec::new();
    let chains: Vec<_> = (0..curve.solved.len())
        .map(|i| chain_of(curve, i))
        .collect();
    for (i, chain) in chains.iter().enumerate() {
        let whole = curve.solved[i].interval.whole;
        let limits = (0..chain.len()).filter_map(|at| around(curve, chain, at, band));
        found.extend(
            limits
                .chain(between(curve, chain, band))
                .filter(|ends| ends[1] > ends[0] && (!whole || begins_in_range(curve, ends[0])))
                .map(|ends| (i, ends)),
        );
    }
    let length = |ends: [f64; 2]| ends[1] - ends[0];
    found.sort_by(|(_, a), (_, b)| length(*b).total_cmp(&length(*a)));
    let mut kept: Vec<(usize, [f64; 2])> = Vec::new();
    for dwell in found {
        if !kept.iter().any(|other| overlap(curve, other.1, dwell.1)) {
            kept.push(dwell);
        }
    }
    let located = |(i, ends): (usize, [f64; 2])| {
        let interval = Interval::between(&curve.source, ends[0], ends[1]);
        dwell(curve, &chains[i], interval, ends)
    };
    let mut dwells: Vec<Dwell> = kept.into_iter().map(located).collect();
    dwells.sort_by(|a, b| a.interval.from.total_cmp(&b.interval.from));
    dwells
}

/// The longest of the dwells.
pub(super) fn longest_dwell<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    band: f64,
) -> Option<Dwell> {
    let longer = |a: Dwell, b: Dwell| {
        if b.interval.range > a.interval.range {
            b
        } else {
            a
        }
    };
    dwells(curve, band).into_iter().reduce(longer)
}

/// The stations of a stretch; those of a cycle thrice, one after the other.
fn chain_of<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    index: usize,
) -> Vec<PieceEnd<N>> {
    let part = &curve.solved[index];
    let chain = monotone_pieces(part);
    if !part.interval.whole {
        return chain;
    }
    let once = &chain[..chain.len() - 1];
    let again = |cycle: f64| {
        once.iter().map(move |piece_end| PieceEnd {
            node: curve.source.shifted(piece_end.node, cycle),
            ..*piece_end
        })
    };
    [-1.0, 0.0, 1.0].into_iter().flat_map(again).collect()
}

/// Around the limit `at` of a chain: as far as the quantity stays in the band that it closes.
fn around<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    chain: &[PieceEnd<N>],
    at: usize,
    band: f64,
) -> Option<[f64; 2]> {
    let value = chain[at].value();
    let bounds = match chain[at].limit? {
        Kind::High => [value - band, value],
        _ => [value, value + band],
    };
    Some([
        leaves(curve, chain[..=at].iter().rev(), bounds)?,
        leaves(curve, chain[at..].iter(), bounds)?,
    ])
}

/// The input where the quantity leaves the bounds on the path through these ends of pieces.
fn leaves<'a, const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    mut way: impl Iterator<Item = &'a PieceEnd<N>>,
    [low, high]: [f64; 2],
) -> Option<f64> {
    let mut inside = way.next()?;
    for next in way {
        let bound = if next.value() > high { high } else { low };
        if next.value() > high || next.value() < low {
            return Some(crossing_input(
                &curve.source,
                &inside.node,
                &next.node,
                bound,
            ));
        }
        inside = next;
    }
    Some(inside.u())
}

/// Returns true if a dwell of a chain of three cycles belongs to the range.
fn begins_in_range<const N: usize, F: Fn(f64) -> [f64; N]>(curve: &Curve<N, F>, from: f64) -> bool {
    let (low, high) = curve.range();
    (low..high).contains(&from)
}

fn overlap<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    a: [f64; 2],
    b: [f64; 2],
) -> bool {
    let width = curve.source.width();
    let shifts = match curve.source.advance {
        Some(_) => &[-width, 0.0, width][..],
        None => &[0.0],
    };
    let meet = |shift: &f64| a[0] < b[1] + shift && b[0] + shift < a[1];
    shifts.iter().any(meet)
}

fn dwell<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    chain: &[PieceEnd<N>],
    interval: Interval,
    ends: [f64; 2],
) -> Dwell {
    let within = |piece_end: &&PieceEnd<N>| piece_end.u() >= ends[0] && piece_end.u() <= ends[1];
    let inside: Vec<&PieceEnd<N>> = chain.iter().filter(within).collect();
    let turns = inside
        .iter()
        .filter(|piece_end| piece_end.limit.is_some() && !piece_end.end);
    let limits: Vec<f64> = turns.map(|piece_end| piece_end.value()).collect();
    // An end at the border of a gap may be no number, but it is a station.
    let at_ends = ends.map(|u| curve.source.node(u).jet[0]);
    let values = inside.iter().map(|piece_end| piece_end.value());
    let values: Vec<f64> = values.chain(at_ends).collect();
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // The value is that at the begin of the interval, in a cycle over which the quantity advances.
    let jet = [0.0; N];
    let shift = curve.source.in_range(Node { u: ends[0], jet }).jet[0];
    Dwell {
        interval,
        lowest: least(&values) + shift,
        highest: most(&values) + shift,
        ripple: (most(&limits) - least(&limits)).max(0.0),
    }
}
