//! The size of an error, from the derivatives of a quantity with respect to the parameters.

use std::vec;
use std::vec::Vec;

use linkage_analysis::internals::{corners as corners_of, in_space, norm};
use linkage_analysis::tolerance::Tolerances;
use linkage_core::numeric::vector::dot;

/// The derivatives of each component with respect to the parameters.
pub(super) type Slopes<const N: usize> = Vec<[f64; N]>;

/// The measure of an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure<const N: usize> {
    /// The largest one within tolerances.
    WorstCase(Tolerances<N>),
    /// The root of a sum of squares, with its name, for dimensions with these covariances.
    Deviation(&'static str, [[f64; N]; N]),
}

/// An error, and its growth with each slope of each component.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Measured<const N: usize> {
    pub(super) value: f64,
    pub(super) weights: Vec<[f64; N]>,
    /// The number of the way to the largest one, among several.
    pub(super) way: usize,
}

/// The size of an effect is smoothed below this part of the root of the sum of squares, upwards: at
/// zero it has no derivative.
const SMOOTH: f64 = 1e-3;

/// Corners whose error is at least this part of the largest one count: a step may make one of them
/// the largest.
const NEAR: f64 = 0.8;

impl<const N: usize> Measure<N> {
    /// The ways to the largest one that are looked at over the range: where zones do not lie about
    /// the nominal dimensions, the effect of their middles may have either sign.
    pub(super) fn ways(&self) -> &'static [f64] {
        match self {
            Self::WorstCase(tolerances) if tolerances.middles().iter().any(|m| *m != 0.0) => {
                &[1.0, -1.0]
            }
            _ => &[0.0],
        }
    }

    /// All that may be the largest one at a place.
    pub(super) fn candidates(&self, slopes: &Slopes<N>) -> Vec<Measured<N>> {
        if let (Self::WorstCase(tolerances), 2..) = (self, slopes.len()) {
            return corners(tolerances, slopes);
        }
        let ways = self.ways().iter().enumerate();
        let of = |(way, sign): (usize, &f64)| Measured {
            way,
            ..self.largest_of_way(sign, slopes)
        };
        ways.map(of).collect()
    }

    /// The largest one of a way.
    pub(super) fn largest_of_way(&self, sign: &f64, slopes: &Slopes<N>) -> Measured<N> {
        match (self, &slopes[..]) {
            (Self::WorstCase(tolerances), [slopes]) => sum_of_sizes(tolerances, *sign, slopes),
            (Self::WorstCase(tolerances), _) => worst_corner(tolerances, slopes),
            (Self::Deviation(_, covariance), _) => deviation(covariance, slopes),
        }
    }

    /// The largest one of a way with its first and second derivative by the input.
    pub(super) fn jet(&self, sign: &f64, slopes: [&Slopes<N>; 3]) -> [f64; 3] {
        match (self, &slopes[0][..]) {
            (Self::WorstCase(tolerances), [_]) => {
                jet_of_sizes(tolerances, *sign, slopes.map(|slopes| &slopes[0]))
            }
            (Self::WorstCase(tolerances), _) => {
                let changes = worst_changes(tolerances, slopes[0]);
                let vector = |slopes: &Slopes<N>| -> Vec<f64> {
                    slopes.iter().map(|slopes| dot(slopes, &changes)).collect()
                };
                length(slopes.map(vector))
            }
            (Self::Deviation(_, covariance), _) => {
                let [s, v, a] = slopes;
                let of = |a: &Slopes<N>, b: &Slopes<N>| -> f64 {
                    let pairs = a.iter().zip(b);
                    pairs.map(|(a, b)| dot(a, &times(covariance, b))).sum()
                };
                root([of(s, s), 2.0 * of(s, v), 2.0 * (of(v, v) + of(s, a))])
            }
        }
    }
}

/// The root of a number with first and second derivative.
fn root([square, rate, second]: [f64; 3]) -> [f64; 3] {
    let root = square.sqrt();
    if root == 0.0 {
        return [0.0; 3];
    }
    let slope = 0.5 * rate / root;
    [root, slope, (0.5 * second - slope * slope) / root]
}

/// The length of a vector with first and second derivative.
fn length([f, v, a]: [Vec<f64>; 3]) -> [f64; 3] {
    let of = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    root([
        of(&f, &f),
        2.0 * of(&f, &v),
        2.0 * (of(&v, &v) + of(&f, &a)),
    ])
}

fn deviation<const N: usize>(covariance: &[[f64; N]; N], slopes: &Slopes<N>) -> Measured<N> {
    let weights: Vec<[f64; N]> = slopes.iter().map(|s| times(covariance, s)).collect();
    let square: f64 = slopes.iter().zip(&weights).map(|(s, w)| dot(s, w)).sum();
    let value = square.sqrt();
    let over = if value > 0.0 { 1.0 / value } else { 0.0 };
    Measured {
        value,
        weights: weights.iter().map(|row| row.map(|w| w * over)).collect(),
        way: 0,
    }
}

/// The sum of the sizes of all effects, smoothed, and the effect of the middles of the zones, with
/// a sign.
fn sum_of_sizes<const N: usize>(
    tolerances: &Tolerances<N>,
    sign: f64,
    slopes: &[f64; N],
) -> Measured<N> {
    let (halves, middles) = (tolerances.values(), tolerances.middles());
    let effects: [f64; N] = core::array::from_fn(|k| slopes[k] * halves[k]);
    let all = norm(&effects);
    let sizes = effects.map(|effect| effect.hypot(SMOOTH * all));
    // All effects smooth each, and have a part in its size.
    let part: f64 = sizes.iter().map(|size| SMOOTH * SMOOTH / size).sum();
    let weight = |k: usize| {
        let weight_of_size = if all > 0.0 {
            effects[k] * (1.0 / sizes[k] + part)
        } else {
            0.0
        };
        weight_of_size * halves[k] + sign * middles[k]
    };
    Measured {
        value: sizes.iter().sum::<f64>() + sign * dot(slopes, middles),
        weights: vec![core::array::from_fn(weight)],
        way: 0,
    }
}

/// The same with first and second derivative by the input.
fn jet_of_sizes<const N: usize>(
    tolerances: &Tolerances<N>,
    sign: f64,
    slopes: [&[f64; N]; 3],
) -> [f64; 3] {
    let (halves, middles) = (tolerances.values(), tolerances.middles());
    let [e, v, a] =
        slopes.map(|slopes| -> [f64; N] { core::array::from_fn(|k| slopes[k] * halves[k]) });
    let square = |k: usize| {
        [
            e[k] * e[k],
            2.0 * e[k] * v[k],
            2.0 * (v[k] * v[k] + e[k] * a[k]),
        ]
    };
    let sum = |sums: [f64; 3], more: [f64; 3]| core::array::from_fn(|i| sums[i] + more[i]);
    let all: [f64; 3] = (0..N).map(square).fold([0.0; 3], sum);
    let size = |k: usize| {
        let effect = square(k);
        root(core::array::from_fn(|i| {
            effect[i] + SMOOTH * SMOOTH * all[i]
        }))
    };
    let shift = slopes.map(|slopes| sign * dot(slopes, middles));
    (0..N).map(size).fold(shift, sum)
}

/// The differences of all dimensions in a corner of the tolerances, and the signs by which it is
/// known.
fn changes<const N: usize>(tolerances: &Tolerances<N>, signs: &[f64]) -> ([f64; N], usize) {
    let (halves, middles) = (tolerances.values(), tolerances.middles());
    // All sums lie symmetrically about 0, the shift among them: it may be the opposite corner that
    // is meant.
    let first = signs.iter().rev().find(|sign| **sign != 0.0);
    let way = first.copied().unwrap_or(1.0);
    let bit =
        |(k, sign): (usize, &f64)| usize::from(way * sign > 0.0) << (k % (usize::BITS as usize));
    let number = signs.iter().enumerate().map(bit).sum();
    (
        core::array::from_fn(|k| middles[k] + way * signs[k] * halves[k]),
        number,
    )
}

/// The effects of all tolerances as vectors, and after them the effects of the middles of the
/// zones.
fn vectors<const N: usize>(tolerances: &Tolerances<N>, slopes: &Slopes<N>) -> Vec<[f64; 3]> {
    let halves = tolerances.values();
    let space = |of: &dyn Fn(&[f64; N]) -> f64| {
        let mut vector = [0.0; 3];
        vector
            .iter_mut()
            .zip(slopes)
            .for_each(|(to, slopes)| *to = of(slopes));
        in_space(&vector)
    };
    let effect = |k: usize| space(&|slopes| slopes[k] * halves[k]);
    let shift = space(&|slopes| dot(slopes, tolerances.middles()));
    (0..N).map(effect).chain([shift]).collect()
}

/// The errors of a vector at the corners that are worst.
fn corners<const N: usize>(tolerances: &Tolerances<N>, slopes: &Slopes<N>) -> Vec<Measured<N>> {
    let mut found: Vec<Measured<N>> = Vec::new();
    corners_of(&vectors(tolerances, slopes), &mut |signs, _| {
        let corner = at_corner(tolerances, slopes, signs);
        if !found.iter().any(|other| other.way == corner.way) {
            found.push(corner);
        }
    });
    let largest = found
        .iter()
        .fold(0.0, |most: f64, corner| most.max(corner.value));
    // Those without a value stay: the mechanism does not assemble.
    found.retain(|corner| corner.value.is_nan() || corner.value >= NEAR * largest);
    found
}

fn at_corner<const N: usize>(
    tolerances: &Tolerances<N>,
    slopes: &Slopes<N>,
    signs: &[f64],
) -> Measured<N> {
    let (changes, way) = changes(tolerances, signs);
    let vector: Vec<f64> = slopes.iter().map(|slopes| dot(slopes, &changes)).collect();
    let value = norm(&vector);
    let over = if value > 0.0 { 1.0 / value } else { 0.0 };
    let weights = vector
        .iter()
        .map(|x| changes.map(|change| x * over * change));
    Measured {
        value,
        weights: weights.collect(),
        way,
    }
}

/// The error of a vector at its worst corner.
fn worst_corner<const N: usize>(tolerances: &Tolerances<N>, slopes: &Slopes<N>) -> Measured<N> {
    let corners = corners(tolerances, slopes).into_iter();
    let worst = corners.max_by(|a, b| a.value.total_cmp(&b.value));
    worst.unwrap_or(Measured {
        value: f64::NAN,
        weights: Vec::new(),
        way: 0,
    })
}

/// The differences of all dimensions at the worst corner of a vector.
fn worst_changes<const N: usize>(tolerances: &Tolerances<N>, slopes: &Slopes<N>) -> [f64; N] {
    let mut worst = (f64::NEG_INFINITY, [f64::NAN; N]);
    corners_of(&vectors(tolerances, slopes), &mut |signs, sum| {
        let value = norm(&sum);
        if value > worst.0 {
            worst = (value, changes(tolerances, signs).0);
        }
    });
    worst.1
}

fn times<const N: usize>(matrix: &[[f64; N]; N], vector: &[f64; N]) -> [f64; N] {
    matrix.map(|row| dot(&row, vector))
}
