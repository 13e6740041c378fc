//! Random numbers from counters: each is a function of the seed, the dimension and its index, so
//! that any part of a study can be drawn by itself.
//!
//! The numbers of a dimension are a sequence of SplitMix64 (G. L. Steele, D. Lea and C. H. Flood,
//! "Fast splittable pseudorandom number generators", 2014) from a start of its own.

/// Odd step between neighbours, 2^64 over the golden ratio.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The random numbers of one dimension.
#[derive(Clone, Copy, Debug)]
pub(super) struct Numbers {
    start: u64,
}

impl Numbers {
    /// Those of the dimension with this index.
    pub(super) fn new(seed: u64, dimension: usize) -> Self {
        Self {
            start: mixed(mixed(seed.wrapping_add(STEP)).wrapping_add(dimension as u64)),
        }
    }

    /// The number with this index, between 0 and 1: 52 bits, in the middle of their intervals, so
    /// that it is exact and never 0 or 1.
    #[inline(always)]
    pub(super) fn uniform(self, index: u64) -> f64 {
        // Between 1 and 2, exactly, less what leaves the middle of an interval.
        const OFFSET: f64 = 1.0 - 0.5 * f64::EPSILON;
        let bits = mixed(self.start.wrapping_add(index.wrapping_mul(STEP)));
        f64::from_bits(bits >> 12 | 1.0_f64.to_bits()) - OFFSET
    }
}

/// Spreads neighbouring numbers over all bits.
#[inline(always)]
fn mixed(state: u64) -> u64 {
    let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first outputs of SplitMix64 from state 1234567, as published with the generator.
    #[test]
    fn known_numbers() {
        let known: [u64; 3] = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
        ];
        for (k, known) in (1..).zip(known) {
            let state = 1_234_567_u64.wrapping_add(STEP.wrapping_mul(k));
            assert_eq!(mixed(state), known);
        }
    }

    #[test]
    fn numbers_are_within_and_evenly_spread() {
        let numbers = Numbers::new(3, 2);
        let mut counts = [0; 16];
        for index in 0..1 << 16 {
            let x = numbers.uniform(index);
            assert!(x > 0.0 && x < 1.0);
            counts[(16.0 * x) as usize] += 1;
        }
        // The deviation of each is 62.
        assert!(
            counts.iter().all(|&count: &i32| (count - 4096).abs() < 300),
            "{counts:?}"
        );
    }

    /// Products of neighbouring dimensions and of neighbouring seeds.
    #[test]
    fn sequences_are_independent() {
        let pairs = [
            (Numbers::new(0, 0), Numbers::new(0, 1)),
            (Numbers::new(0, 0), Numbers::new(1, 0)),
            (Numbers::new(1, 0), Numbers::new(0, 1)),
        ];
        for (a, b) in pairs {
            let products = (0..100_000).map(|i| (a.uniform(i) - 0.5) * (b.uniform(i) - 0.5));
            let mean = products.sum::<f64>() / 1e5;
            assert!(mean.abs() < 4.0 / 12.0 / 316.0, "{mean}");
        }
    }
}
