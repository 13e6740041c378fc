//! Quasi-random starts: Sobol's sequence with Owen's scrambling (crate `sobol_burley`).

use std::vec::Vec;

/// Points of one sequence; beyond them comes another one.
const SEQUENCE: u64 = 1 << 16;
/// Dimensions of one sequence; further ones are those of another one.
const DIMENSIONS: u32 = sobol_burley::NUM_DIMENSIONS;

/// The numbers of a start, each from 0 to below 1: those of an index and a seed are always the
/// same.
pub fn unit(seed: u64, index: usize, count: usize) -> Vec<f64> {
    let sequence = index as u64 / SEQUENCE;
    let term = (index as u64 % SEQUENCE) as u32;
    let number = |dimension: u32| {
        let seed = mixed(mixed(seed ^ mixed(sequence)) ^ u64::from(dimension / DIMENSIONS)) as u32;
        f64::from(sobol_burley::sample(term, dimension % DIMENSIONS, seed))
    };
    (0..count as u32).map(number).collect()
}

/// A step of SplitMix64, which spreads neighbouring numbers over all bits.
fn mixed(state: u64) -> u64 {
    let mut z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
