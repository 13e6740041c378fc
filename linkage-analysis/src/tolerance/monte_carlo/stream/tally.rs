//! What is kept of the mechanisms of some blocks: memory does not grow with their number.

use alloc::vec::Vec;

use super::bins::{Bins, Scale};
use super::sums::{Sums, Tree};
use crate::tolerance::monte_carlo::block::BLOCK;
use crate::tolerance::monte_carlo::wide::{self, Loop};

/// What is kept of `K` numbers of some blocks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tally<const K: usize> {
    pub(super) sums: Tree<K>,
    /// Mechanisms in the blocks.
    pub(super) done: u64,
    /// Those without a value in any of the numbers.
    pub(super) missing: u64,
    /// The least and the largest value of each number.
    pub(super) ends: [[Option<End>; 2]; K],
    pub(super) bins: Vec<Bins>,
}

/// The least or the largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    pub(super) value: f64,
    /// The first mechanism that has it.
    pub(super) number: u64,
}

impl<const K: usize> Tally<K> {
    /// Nothing yet.
    pub(super) fn new(scales: &[Scale; K]) -> Self {
        Self {
            sums: Tree::default(),
            done: 0,
            missing: 0,
            ends: [[None; 2]; K],
            bins: scales.iter().copied().map(Bins::new).collect(),
        }
    }

    /// Adds a block behind all others.
    pub(super) fn push(&mut self, block: u64, columns: [&[f64]; K]) {
        let length = columns.first().map_or(0, |column| column.len());
        let mut sums = [Sums::default(); K];
        for (k, &values) in columns.iter().enumerate() {
            let summed = wide::run(Summing {
                values,
                centre: self.bins[k].scale.centre,
            });
            sums[k] = summed.sums;
            self.bins[k].count(values);
            for (end, sign) in self.ends[k].iter_mut().zip([1.0, -1.0]) {
                let found = if sign > 0.0 {
                    summed.least
                } else {
                    summed.largest
                };
                *end = further(*end, end_of_block(values, found, block, *end, sign), sign);
            }
        }
        self.sums.push(block, sums);
        self.done += length as u64;
        if sums.iter().any(|sums| sums.count < length as u64) {
            let lacks = |&row: &usize| columns.iter().any(|column| column[row].is_nan());
            self.missing += (0..length).filter(lacks).count() as u64;
        }
    }

    /// Adds other blocks; `None` and no change if both have a block.
    pub(super) fn merge(&mut self, other: &Self) -> Option<()> {
        self.sums = self.sums.merged(&other.sums)?;
        self.done += other.done;
        self.missing += other.missing;
        for (ends, others) in self.ends.iter_mut().zip(other.ends) {
            for ((end, other), sign) in ends.iter_mut().zip(others).zip([1.0, -1.0]) {
                *end = further(*end, other, sign);
            }
        }
        for (bins, other) in self.bins.iter_mut().zip(&other.bins) {
            bins.merge(other);
        }
        Some(())
    }
}

/// The end of a block's values, if it is beyond the one that is known.
fn end_of_block(
    values: &[f64],
    found: f64,
    block: u64,
    known: Option<End>,
    sign: f64,
) -> Option<End> {
    if known.is_some_and(|known| sign * found > sign * known.value) {
        return None;
    }
    // A block without values has an infinity on the wrong side.
    let row = values.iter().position(|&x| x == found)?;
    Some(End {
        value: found,
        number: block * BLOCK as u64 + row as u64,
    })
}

/// The lower end for the sign 1, the upper one for -1; the first mechanism of those that are equal.
fn further(a: Option<End>, b: Option<End>, sign: f64) -> Option<End> {
    let (Some(one), Some(other)) = (a, b) else {
        return a.or(b);
    };
    let key = |end: End| (sign * end.value, end.number);
    if key(other) < key(one) { b } else { a }
}

/// Sums over a block, and its ends.
struct Summing<'a> {
    values: &'a [f64],
    centre: f64,
}

struct Summed {
    sums: Sums,
    least: f64,
    largest: f64,
}

impl Loop for Summing<'_> {
    type Result = Summed;

    #[inline(always)]
    fn run(self) -> Summed {
        // Sums side by side, in an order that is the same for all instruction sets.
        const LANES: usize = 8;
        let mut count = [0.0; LANES];
        let mut powers = [[0.0; LANES]; 4];
        let mut least = [f64::INFINITY; LANES];
        let mut largest = [f64::NEG_INFINITY; LANES];
        let mut add = |lane: usize, x: f64| {
            let is_number = !x.is_nan();
            let distance = if is_number { x - self.centre } else { 0.0 };
            let square = distance * distance;
            count[lane] += if is_number { 1.0 } else { 0.0 };
            powers[0][lane] += distance;
            powers[1][lane] += square;
            powers[2][lane] += square * distance;
            powers[3][lane] += square * square;
            least[lane] = if x < least[lane] { x } else { least[lane] };
            largest[lane] = if x > largest[lane] { x } else { largest[lane] };
        };
        let (chunks, rest) = self.values.as_chunks::<LANES>();
        for chunk in chunks {
            for (lane, &x) in chunk.iter().enumerate() {
                add(lane, x);
            }
        }
        for (lane, &x) in rest.iter().enumerate() {
            add(lane, x);
        }
        Summed {
            sums: Sums {
                count: count.iter().sum::<f64>() as u64,
                powers: powers.map(|lanes| lanes.iter().sum()),
            },
            least: least.into_iter().fold(f64::INFINITY, f64::min),
            largest: largest.into_iter().fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALE: Scale = Scale {
        centre: 1.0,
        width: 0.125,
    };

    fn value(number: u64) -> f64 {
        match number % 11 {
            3 => f64::NAN,
            rest => 0.25 * (rest as f64) - (number % 5) as f64,
        }
    }

    fn tally(blocks: core::ops::Range<u64>) -> Tally<1> {
        let mut tally = Tally::new(&[SCALE]);
        for block in blocks {
            let numbers = block * BLOCK as u64..(block + 1) * BLOCK as u64;
            let values: Vec<f64> = numbers.map(value).collect();
            tally.push(block, [&values]);
        }
        tally
    }

    /// All sums are exact here.
    #[test]
    fn sums_counts_and_ends() {
        let tally = tally(0..3);
        let count = 3 * BLOCK as u64;
        let values: Vec<f64> = (0..count).map(value).filter(|x| !x.is_nan()).collect();
        assert_eq!(tally.done, count);
        assert_eq!(tally.missing, count - values.len() as u64);
        let sums = tally.sums.total(0);
        assert_eq!(sums.count, values.len() as u64);
        for (power, exponent) in sums.powers.iter().zip(1..) {
            let known: f64 = values.iter().map(|x| (x - 1.0).powi(exponent)).sum();
            assert_eq!(*power, known, "{exponent}");
        }
        let [least, largest] = tally.ends[0].map(|end| end.expect("there are values"));
        let end = |value| {
            (
                value,
                (0..count).find(|&n| self::value(n) == value).unwrap(),
            )
        };
        assert_eq!((least.value, least.number), end(-4.0));
        assert_eq!((largest.value, largest.number), end(2.5));
    }

    #[test]
    fn parts_in_any_order() {
        let whole = tally(0..9);
        for cut in 1..9 {
            let mut merged = tally(cut..9);
            merged.merge(&tally(0..cut)).expect("they are apart");
            assert_eq!(merged, whole);
        }
        assert!(tally(0..3).merge(&tally(2..4)).is_none());
    }
}
