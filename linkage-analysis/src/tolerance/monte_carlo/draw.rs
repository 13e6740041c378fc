//! Random draws of mechanisms.

use alloc::vec::Vec;
use core::array;

use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

use crate::tolerance::Distribution;
use crate::tolerance::correlation::Square;
use linkage_runtime::Dimensions;

/// Everything that a sample depends on.
pub(super) struct Draw<const N: usize> {
    pub(super) seed: u64,
    pub(super) nominal: [f64; N],
    pub(super) middles: [f64; N],
    pub(super) tolerances: [f64; N],
    pub(super) distributions: [Distribution; N],
    /// The root of the matrix of correlations: all that are correlated are normal. `None` if
    /// nothing is.
    pub(super) root: Option<Square<N>>,
}

impl<const N: usize> Draw<N> {
    /// The mechanisms of a block.
    pub(super) fn block<M: Dimensions<N>>(&self, index: usize, length: usize) -> Vec<M> {
        let mut random = stream(self.seed, index as u64);
        let mut mechanism = || {
            let independent: [f64; N] =
                array::from_fn(|i| drawn(self.distributions[i], &mut random));
            let deviations: [f64; N] = match &self.root {
                None => independent,
                // Normal distributions have one standard deviation for a tolerance of 1, and so has
                // what the root mixes.
                Some(root) => array::from_fn(|i| (0..N).map(|j| root[i][j] * independent[j]).sum()),
            };
            let value =
                |i: usize| self.nominal[i] + (self.middles[i] + self.tolerances[i] * deviations[i]);
            M::from_values(&array::from_fn(value))
        };
        (0..length).map(|_| mechanism()).collect()
    }
}

/// A deviation for a tolerance of 1.
fn drawn(distribution: Distribution, random: &mut impl Rng) -> f64 {
    // 52 bits, in the middle of their intervals: exact, and never 0 or 1.
    const STEP: f64 = 1.0 / (1_u64 << 52) as f64;
    distribution.quantile(((random.next_u64() >> 12) as f64 + 0.5) * STEP)
}

/// The random numbers of one block.
fn stream(seed: u64, block: u64) -> Xoshiro256PlusPlus {
    let mut state = mixed(mixed(seed) ^ block);
    let mut bytes = [0; 32];
    for word in bytes.chunks_exact_mut(8) {
        state = mixed(state);
        word.copy_from_slice(&state.to_le_bytes());
    }
    Xoshiro256PlusPlus::from_seed(bytes)
}

/// A step of SplitMix64, which spreads neighbouring numbers over all bits.
fn mixed(state: u64) -> u64 {
    let mut z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
