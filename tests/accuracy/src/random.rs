//! Deterministic random numbers.

/// A generator (splitmix64) that gives the same numbers on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator for a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 * 2f64.powi(-53))
    }

    /// A number between two positive bounds, its logarithm uniform.
    pub fn ratio(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// A length, 50 for a spread of 1; its logarithm is uniform over a range of the given ratio.
    /// One of ten is negative.
    pub fn length(&mut self, spread: f64) -> f64 {
        let side = spread.sqrt();
        let length = 50.0 * self.ratio(1.0 / side, side);
        if self.chance(0.1) { -length } else { length }
    }

    /// An angle between -180 and 180 degrees.
    pub fn angle(&mut self) -> f64 {
        self.between(-core::f64::consts::PI, core::f64::consts::PI)
    }

    /// Whether an event of the given probability happens.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }
}
