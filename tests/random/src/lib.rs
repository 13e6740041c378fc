//! Random numbers of all tests: the same on every machine, and for ever; and how much tests try.
//!
//! The corpus of mechanisms, figures of accuracy and many limits hang on the very numbers. Libraries promise the bits of a
//! generator at most, not the numbers made of them, so the few lines stand here.

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

pub mod four_bar {
    //! Four-bars about their change points: random lengths, and what the lengths say of a turn of the crank.

    use std::f64::consts::{PI, TAU};

    use crate::Random;

    /// What ends an assembly.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Limit {
        /// Two assemblies meet, and both go on.
        ChangePoint,
        /// The assembly ends.
        DeadPoint,
        /// The assembly ends, and closes again.
        Gap,
    }

    /// Crank, coupler, rocker and frame of a parallelogram, a kite of either kind, or with the longest and the shortest as long as the others.
    pub fn at_change_point(random: &mut Random) -> [f64; 4] {
        let [a, b, c] = [0; 3].map(|_| random.between(20.0, 200.0));
        match random.below(6) {
            0 => [a, b, a, b],
            1 => [a, a, b, b],
            2 => [a, b, b, a],
            3 => [a, b, c, b + c - a],
            4 => [a, b, c, a + b - c],
            _ => [a, b, c, a + c - b],
        }
    }

    /// Of three rounds one has lengths at a change point, one as near to it as a millionth, and one others.
    pub fn lengths(random: &mut Random, round: usize) -> [f64; 4] {
        let mut all = at_change_point(random);
        match round % 3 {
            1 => all[random.below(4)] *= 1.0 + random.pick(&[1e-6, -1e-6]),
            2 => all = all.map(|own| own * random.between(0.5, 2.0)),
            _ => {}
        }
        all
    }

    /// The limits in a turn with where each begins and ends, from where the diagonal between crank and rocker is too long or too short for both. `None`
    /// where it is at a limit all the way, or beyond one.
    #[must_use]
    pub fn limits([crank, coupler, rocker, frame]: [f64; 4]) -> Option<Vec<(Limit, f64, f64)>> {
        let (inner, outer) = ((frame - crank).abs(), frame + crank);
        let (near, far) = ((coupler - rocker).abs(), coupler + rocker);
        let same = |a: f64, b: f64| (a - b).abs() < 1e-13 * outer;
        let angle = |distance: f64| {
            let cosine =
                (crank * crank + frame * frame - distance * distance) / (2.0 * crank * frame);
            cosine.clamp(-1.0, 1.0).acos()
        };
        // Where both links nearly fold onto a diagonal that nearly vanishes, the slack is near what counts as a dead point over a stretch, and the
        // ends of a gap are as uncertain.
        if !same(inner, near) && inner.max(near) < 3e-3 * outer {
            return None;
        }
        if inner > far || same(inner, far) || outer < near || same(outer, near) {
            return None;
        }
        let mut found = Vec::new();
        if same(inner, near) {
            found.extend([
                (Limit::ChangePoint, 0.0, 0.0),
                (Limit::ChangePoint, TAU, TAU),
            ]);
        } else if inner < near {
            // It is open at both ends of the turn.
            found.push((Limit::DeadPoint, 0.0, angle(near)));
            found.push((Limit::DeadPoint, TAU - angle(near), TAU));
        }
        if same(outer, far) {
            found.push((Limit::ChangePoint, PI, PI));
        } else if outer > far {
            found.push((Limit::Gap, angle(far), TAU - angle(far)));
        }
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        Some(found)
    }
}

// How much tests try: what everybody waits for, or all that there is.

/// Whether `LINKAGE_LONG` asks for long runs.
#[must_use]
pub fn is_long() -> bool {
    std::env::var_os("LINKAGE_LONG").is_some()
}

/// One of so many, the first among them; all of them in long runs.
pub fn one_in<T>(count: usize, all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(if is_long() { 1 } else { count })
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
