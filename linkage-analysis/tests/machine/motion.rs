//! Random closed motions of points.

use linkage_random::Random;

/// A point each coordinate of which is a sum of three harmonics about a middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving<const K: usize> {
    middle: [f64; K],
    /// Factors of cosine and sine.
    harmonics: [[[f64; 2]; 3]; K],
}

impl<const K: usize> Moving<K> {
    pub(crate) fn random(random: &mut Random, spread: f64) -> Self {
        let mut number = |size: f64| random.between(-size, size);
        Self {
            middle: std::array::from_fn(|_| number(spread)),
            harmonics: std::array::from_fn(|_| {
                [10.0, 3.0, 1.0].map(|size| [number(size), number(size)])
            }),
        }
    }

    /// Position, velocity, acceleration.
    pub(crate) fn at(&self, x: f64) -> [[f64; K]; 3] {
        let jet = |k: usize| {
            let mut jet = [self.middle[k], 0.0, 0.0];
            for (i, [a, b]) in self.harmonics[k].iter().enumerate() {
                let n = (i + 1) as f64;
                let (sin, cos) = (n * x).sin_cos();
                jet[0] += a * cos + b * sin;
                jet[1] += n * (b * cos - a * sin);
                jet[2] -= n * n * (a * cos + b * sin);
            }
            jet
        };
        let jets: [[f64; 3]; K] = std::array::from_fn(jet);
        std::array::from_fn(|order| jets.map(|jet| jet[order]))
    }

    /// Another middle of a coordinate.
    pub(crate) fn moved(mut self, k: usize, by: f64) -> Self {
        self.middle[k] += by;
        self
    }

    /// Another factor of the cosine of a coordinate.
    pub(crate) fn swung(mut self, k: usize, by: f64) -> Self {
        self.harmonics[k][0][0] += by;
        self
    }
}
