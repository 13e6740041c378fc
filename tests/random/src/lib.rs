//! Random numbers of all tests: the same on every machine, and for ever; and how much tests try.
//!
//! The corpus of mechanisms, figures of accuracy and many limits hang on the very numbers. Libraries promise the bits of a
//! generator at most, not the numbers made of them, so the few lines stand here.

mod effort;
pub mod four_bar;

pub use effort::{is_long, one_in};

/// A generator (splitmix64): any seed is a good one, neighbours too.
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

    /// A number between two others.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 * 2f64.powi(-53))
    }

    /// A whole number below `limit`.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.bits() % limit as u64) as usize
    }

    /// Whether an event of the given probability happens.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    /// One of several.
    pub fn pick<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }

    /// A number between two positive bounds, its logarithm uniform.
    pub fn ratio(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// An angle between -180 and 180 degrees.
    pub fn angle(&mut self) -> f64 {
        self.between(-core::f64::consts::PI, core::f64::consts::PI)
    }

    /// An angle between 0 and 360 degrees.
    pub fn turn(&mut self) -> f64 {
        self.between(0.0, core::f64::consts::TAU)
    }

    /// A length, 50 for a spread of 1; its logarithm is uniform over a range of the given ratio.
    /// One of ten is negative.
    pub fn length(&mut self, spread: f64) -> f64 {
        let side = spread.sqrt();
        let length = 50.0 * self.ratio(1.0 / side, side);
        if self.chance(0.1) { -length } else { length }
    }

    /// A tenth of a positive number to ten times as much, the logarithm uniform.
    pub fn size(&mut self, typical: f64) -> f64 {
        typical * self.ratio(0.1, 10.0)
    }

    /// A [`size`](Self::size) of either sign.
    pub fn load(&mut self, typical: f64) -> f64 {
        let size = self.size(typical);
        if self.chance(0.5) { size } else { -size }
    }

    /// Dimensions changed by up to a part of themselves; one of four is left as it is.
    pub fn near<const N: usize>(&mut self, dimensions: [f64; N], part: f64) -> [f64; N] {
        dimensions.map(|x| {
            let factor = 1.0 + self.between(-part, part);
            if self.chance(0.25) { x } else { x * factor }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// The sequence that Vigna's reference program prints for this seed.
    #[test]
    fn the_sequence_is_that_of_splitmix64() {
        let mut random = Random::new(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(expected.map(|_| random.bits()), expected);
    }

    #[test]
    fn numbers_are_where_they_should_be() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            assert!((-2.0..3.0).contains(&random.between(-2.0, 3.0)));
            assert!(random.below(7) < 7);
            assert!((0.5..=8.0).contains(&random.ratio(0.5, 8.0)));
            assert!(random.angle().abs() <= core::f64::consts::PI);
            assert!((0.0..core::f64::consts::TAU).contains(&random.turn()));
            assert!((25.0 - 1e-12..=100.0 + 1e-12).contains(&random.length(4.0).abs()));
            assert!((3.0 - 1e-12..=300.0 + 1e-12).contains(&random.load(30.0).abs()));
        }
        let kept = random.near([5.0; 1000], 0.1);
        assert!(kept.iter().all(|x| (4.5..=5.5).contains(x)));
        let kept = kept.iter().filter(|&&x| x == 5.0).count();
        assert!((200..300).contains(&kept), "{kept} of 1000 stay");
        let heads = (0..1000).filter(|_| random.chance(0.3)).count();
        assert!((250..350).contains(&heads), "{heads} of 1000");
    }
}
