//! A closed contour of four links, class IV: two ternary links, joined by two binary ones, each on a pivot.

use crate::legs::{Point, turned};
use crate::polynomial::Trigonometric;

/// Two ternary links and what joins them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contour {
    pub(crate) pivots: [Point; 2],
    /// Where the binary links hang on the first and on the second ternary link.
    pub(crate) ends: [[Point; 2]; 2],
    pub(crate) lengths: [f64; 2],
}

impl Contour {
    /// What each binary link misses for given directions of the ternary links, over its length.
    pub(crate) fn misses(&self, [alpha, beta]: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|k| {
            let [x, y] = self.between(k, alpha);
            let end = turned(self.ends[1][k], beta);
            let square = (x - end[0]).powi(2) + (y - end[1]).powi(2);
            (square / self.lengths[k].powi(2) - 1.0) / 2.0
        })
    }

    /// From the second pivot to where a binary link begins.
    fn between(&self, k: usize, alpha: f64) -> Point {
        let end = turned(self.ends[0][k], alpha);
        let [one, two] = self.pivots;
        [one[0] + end[0] - two[0], one[1] + end[1] - two[1]]
    }

    /// Cosine and sine of the second direction for a given first one, from both lengths, as numerators
    /// over one denominator.
    fn second(&self, alpha: f64) -> [f64; 3] {
        let rows: [[f64; 3]; 2] = std::array::from_fn(|k| {
            let ([x, y], [u, v]) = (self.between(k, alpha), self.ends[1][k]);
            let rest = x * x + y * y + u * u + v * v - self.lengths[k].powi(2);
            [x * u + y * v, y * u - x * v, rest / 2.0]
        });
        let [[a, b, e], [c, d, f]] = rows;
        [e * d - b * f, a * f - e * c, a * d - b * c]
    }

    /// All pairs of directions; `None` where two of them nearly coincide.
    pub(crate) fn poses(&self) -> Option<Vec<[f64; 2]>> {
        let polynomial = Trigonometric::through(|alpha| {
            let [c, s, d] = self.second(alpha);
            c * c + s * s - d * d
        });
        let found = polynomial.zeros()?.into_iter().map(|alpha| {
            let [c, s, d] = self.second(alpha);
            let mut pose = [alpha, (s * d.signum()).atan2(c * d.signum())];
            let mut last = (1.0, 0.0);
            for _ in 0..5 {
                last = crate::newton::step(&|x| self.misses(*x), &mut pose);
            }
            (last.0 < 1e-12 && last.1.abs() > 1e-5).then_some(pose)
        });
        found.collect()
    }
}
