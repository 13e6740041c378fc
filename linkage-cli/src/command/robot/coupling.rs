//! Polynomials that couple the joints to the one that drives.

use super::driven_joints::{Motion, stands_still};
use super::minimax::{polynomial, value};

/// The bound between two places is the larger error there and an eighth of the second difference
/// about them, which is the bound by the second derivative times this. The factor covers its change
/// from place to place.
const CURVATURE: f64 = 2.0 / 8.0;

/// Halvings of the search for the largest range.
const HALVINGS: usize = 20;

/// A joint as a polynomial of the one that drives.
#[derive(Clone, Debug)]
pub(super) struct Coupling {
    pub(super) coordinate: usize,
    /// The joint that it follows.
    pub(super) leader: usize,
    /// That of the lowest power first. One that stands still has none.
    pub(super) coefficients: Vec<f64>,
    /// A bound of the error over the whole range.
    pub(super) error: f64,
    /// The values of the coordinate over the range.
    pub(super) ends: [f64; 2],
}

/// A joint that no polynomial of the format reaches.
#[derive(Clone, Debug)]
pub(super) struct Missed {
    pub(super) coordinate: usize,
    /// The error of the best polynomial.
    pub(super) error: f64,
    /// The range of the input, about the reference, in which the error would be kept.
    pub(super) range: [f64; 2],
}

/// The greatest errors that are allowed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Allowed {
    /// In radians.
    pub(super) angle: f64,
    /// In metres.
    pub(super) length: f64,
}

impl Allowed {
    fn error_of(&self, motion: &Motion, coordinate: usize) -> f64 {
        match motion.coordinates[coordinate].is_length() {
            true => self.length,
            false => self.angle,
        }
    }
}

/// Couples all joints by polynomials of the lowest degrees that keep the errors, or returns those
/// for which the highest degree does not.
pub(super) fn couplings(
    motion: &Motion,
    highest: usize,
    allowed: Allowed,
    size: f64,
) -> Result<Vec<Coupling>, Vec<Missed>> {
    let mut found = Vec::new();
    let mut missed = Vec::new();
    let all = 0..motion.inputs.len();
    for coordinate in motion.passive() {
        let values = &motion.values[coordinate];
        let scale = match motion.coordinates[coordinate].is_length() {
            true => size,
            false => 1.0,
        };
        let ends = ends(values);
        if stands_still(values, scale) {
            found.push(Coupling {
                coordinate,
                leader: motion.driver,
                coefficients: Vec::new(),
                error: ends[0].abs().max(ends[1].abs()),
                ends,
            });
            continue;
        }
        let limit = allowed.error_of(motion, coordinate);
        let mut fits = (1..=highest).map(|degree| fit(motion, coordinate, all.clone(), degree));
        let first = fits.clone().find(|(_, error)| *error <= limit);
        match first.or_else(|| fits.next_back()) {
            Some((coefficients, error)) if error <= limit => found.push(Coupling {
                coordinate,
                leader: motion.driver,
                coefficients,
                error,
                ends,
            }),
            last => missed.push(Missed {
                coordinate,
                error: last.map_or(f64::INFINITY, |(_, error)| error),
                range: largest_range(motion, coordinate, highest, limit),
            }),
        }
    }
    match missed.is_empty() {
        true => Ok(found),
        false => Err(missed),
    }
}

/// The best polynomial of a degree over a part of the places, and a bound of its error there.
fn fit(
    motion: &Motion,
    coordinate: usize,
    places: std::ops::Range<usize>,
    degree: usize,
) -> (Vec<f64>, f64) {
    let mut x = motion.values[motion.driver][places.clone()].to_vec();
    let mut y = motion.values[coordinate][places].to_vec();
    if x.first() > x.last() {
        x.reverse();
        y.reverse();
    }
    let (coefficients, _) = polynomial(&x, &y, degree);
    let errors: Vec<f64> = x
        .iter()
        .zip(&y)
        .map(|(x, y)| y - value(&coefficients, *x))
        .collect();
    (coefficients, bound(&errors))
}

/// A bound of the error at the places and between them.
fn bound(errors: &[f64]) -> f64 {
    let second = |index: usize| {
        let inner = index.clamp(1, errors.len() - 2);
        (errors[inner - 1] - 2.0 * errors[inner] + errors[inner + 1]).abs()
    };
    let cell = |index: usize| {
        let at_ends = errors[index].abs().max(errors[index + 1].abs());
        at_ends + CURVATURE * second(index).max(second(index + 1))
    };
    (0..errors.len() - 1).map(cell).fold(0.0, f64::max)
}

/// The largest range about the reference, cut in the same ratio on both sides, in which the error is
/// kept.
fn largest_range(motion: &Motion, coordinate: usize, degree: usize, limit: f64) -> [f64; 2] {
    let driver = &motion.values[motion.driver];
    let reference = (0..driver.len()).min_by(|i, j| {
        let [a, b] = [*i, *j].map(|index| driver[index].abs());
        a.total_cmp(&b)
    });
    let reference = reference.unwrap_or_default();
    let last = driver.len() - 1;
    let part = |share: f64| {
        let below = (share * reference as f64).floor() as usize;
        let above = (share * (last - reference) as f64).floor() as usize;
        reference - below..reference + above + 1
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let share = 0.5 * (low + high);
        let places = part(share);
        let is_kept =
            places.len() < degree + 3 || fit(motion, coordinate, places.clone(), degree).1 <= limit;
        match is_kept {
            true => low = share,
            false => high = share,
        }
    }
    let places = part(low);
    [motion.inputs[places.start], motion.inputs[places.end - 1]]
}

fn ends(values: &[f64]) -> [f64; 2] {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    [
        low,
        values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    ]
}

#[cfg(test)]
mod tests {
    use super::bound;

    /// Between places, the error of a curve is larger than at them.
    #[test]
    fn the_bound_holds_between_places() {
        let error = |x: f64| (7.0 * x).sin();
        for count in [40, 97, 200] {
            let x = |k: usize| k as f64 / count as f64;
            let at_places: Vec<f64> = (0..=count).map(|k| error(x(k))).collect();
            let found = bound(&at_places);
            let fine = (0..100_000).map(|k| error(f64::from(k) / 1e5).abs());
            let most = fine.fold(0.0, f64::max);
            assert!(found >= most && found < most * (1.0 + 30.0 / (count * count) as f64));
        }
    }
}
