//! Deterministic random numbers, and what else the tests share.

/// A generator (splitmix64) that gives the same numbers on every machine.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number between two others.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        low + (high - low) * ((z >> 11) as f64 * 2f64.powi(-53))
    }

    /// Dimensions changed by up to a part of themselves; one of four is left as it is.
    pub(crate) fn near<const N: usize>(&mut self, dimensions: [f64; N], part: f64) -> [f64; N] {
        dimensions.map(|x| {
            let factor = 1.0 + self.between(-part, part);
            if self.between(0.0, 1.0) < 0.25 {
                x
            } else {
                x * factor
            }
        })
    }
}

/// How many times the usual number of cases: 10 for `LINKAGE_LONG=1`, 20 for `LINKAGE_LONG=2`.
pub(crate) fn effort() -> usize {
    let long = std::env::var("LINKAGE_LONG").ok();
    let times = long.and_then(|value| value.parse::<usize>().ok());
    times.map_or(1, |times| 10 * times.max(1))
}

/// Whether two lists of directions, or of numbers of size 1, are the same.
pub(crate) fn alike(one: &[f64], two: &[f64], tolerance: f64) -> bool {
    one.iter()
        .zip(two)
        .all(|(a, b)| ((a - b) / 2.0).sin().abs() < tolerance)
}
