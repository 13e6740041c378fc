//! Random draws of mechanisms.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::array;

use super::block::BLOCK;
use super::deviates::{Deviates, fill};
use super::origin::Source;
use super::random::Numbers;
use crate::tolerance::correlation::Square;
use linkage_runtime::Dimensions;

/// Everything that a sample depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Draw<const N: usize> {
    pub(super) seed: u64,
    pub(super) nominal: [f64; N],
    pub(super) middles: [f64; N],
    pub(super) tolerances: [f64; N],
    pub(super) sources: [Source; N],
    /// The root of the matrix of correlations: all that are correlated are normal. `None` if
    /// nothing is.
    pub(super) root: Option<Square<N>>,
}

/// The dimensions of a block of mechanisms, a column for each.
pub(super) struct Columns<const N: usize> {
    columns: Box<[[f64; BLOCK]]>,
}

impl<const N: usize> Columns<N> {
    pub(super) fn new() -> Self {
        Self {
            columns: vec![[0.0; BLOCK]; N].into_boxed_slice(),
        }
    }

    /// The dimensions of one mechanism.
    pub(super) fn row(&self, row: usize) -> [f64; N] {
        array::from_fn(|i| self.columns[i][row])
    }

    /// The first mechanisms of the block.
    pub(super) fn mechanisms<M: Dimensions<N>>(&self, length: usize, mechanisms: &mut Vec<M>) {
        mechanisms.clear();
        mechanisms.extend((0..length).map(|row| M::from_values(&self.row(row))));
    }

    /// The dimensions of the first mechanisms of the block.
    pub(super) fn slices(&self, length: usize) -> [&[f64]; N] {
        array::from_fn(|i| &self.columns[i][..length])
    }
}

impl<const N: usize> Draw<N> {
    /// Draws the mechanisms of a block.
    pub(super) fn block(&self, block: u64, into: &mut Columns<N>) {
        for (i, column) in into.columns.iter_mut().enumerate() {
            if self.is_exact(i) {
                column.fill(self.nominal[i] + self.middles[i]);
                continue;
            }
            let [nominal, middle, factor] = match (&self.root, &self.sources[i]) {
                // Deviations for a tolerance of 1 alone: they are mixed first.
                (Some(_), _) => [0.0, 0.0, 1.0],
                (None, Source::Distribution(_)) => {
                    [self.nominal[i], self.middles[i], self.tolerances[i]]
                }
                (None, Source::Measured(_)) => [self.nominal[i], 0.0, 1.0],
            };
            fill(Deviates {
                source: &self.sources[i],
                numbers: Numbers::new(self.seed, i),
                block,
                nominal,
                middle,
                factor,
                column,
            });
        }
        if let Some(root) = &self.root {
            for row in 0..BLOCK {
                self.mix(root, &mut into.columns, row);
            }
        }
    }

    /// True for a dimension that no random number changes.
    fn is_exact(&self, i: usize) -> bool {
        let is_drawn = self.root.is_some() || matches!(self.sources[i], Source::Measured(_));
        !is_drawn && self.tolerances[i] == 0.0
    }

    /// One mechanism of a block: normal distributions have one standard deviation for a tolerance
    /// of 1, and so has what the root mixes.
    fn mix(&self, root: &Square<N>, columns: &mut [[f64; BLOCK]], row: usize) {
        let independent: [f64; N] = array::from_fn(|i| columns[i][row]);
        for (i, column) in columns.iter_mut().enumerate() {
            let deviation: f64 = (0..N).map(|j| root[i][j] * independent[j]).sum();
            column[row] = self.nominal[i] + (self.middles[i] + self.tolerances[i] * deviation);
        }
    }

    /// The dimensions of the mechanism with this number.
    pub(super) fn mechanism(&self, number: u64) -> [f64; N] {
        let mut columns = Columns::new();
        self.block(number / BLOCK as u64, &mut columns);
        columns.row((number % BLOCK as u64) as usize)
    }

    /// The standard deviation that each parameter has for a tolerance of 1.
    pub(super) fn deviations(&self) -> [f64; N] {
        array::from_fn(|i| match &self.sources[i] {
            Source::Distribution(distribution) => distribution.deviation(),
            Source::Measured(measured) => measured.deviation() / self.tolerances[i],
        })
    }
}
