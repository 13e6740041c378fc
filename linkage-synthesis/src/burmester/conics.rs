//! The points of two conics.

use super::super::polynomial::roots;
use linkage_core::numeric::complex::{Complex, ONE, ZERO};
use std::vec::Vec;

/// A symmetric matrix: `w C w = 0`.
pub(super) type Conic = [[f64; 3]; 3];
/// Homogeneous coordinates.
pub(super) type Point = [Complex; 3];

/// No conics of a task are special in these coordinates: an orthogonal matrix without pattern, from
/// a quaternion.
const GENERIC: [[f64; 3]; 3] = generic([0.55, -0.31, 0.67, 0.39]);
const STEPS: usize = 4;

const fn generic([a, b, c, d]: [f64; 4]) -> [[f64; 3]; 3] {
    let n = a * a + b * b + c * c + d * d;
    [
        [
            1.0 - 2.0 * (c * c + d * d) / n,
            2.0 * (b * c - a * d) / n,
            2.0 * (b * d + a * c) / n,
        ],
        [
            2.0 * (b * c + a * d) / n,
            1.0 - 2.0 * (b * b + d * d) / n,
            2.0 * (c * d - a * b) / n,
        ],
        [
            2.0 * (b * d - a * c) / n,
            2.0 * (c * d + a * b) / n,
            1.0 - 2.0 * (b * b + c * c) / n,
        ],
    ]
}

/// The four points that are on both, complex ones among them; fewer if the conics have a part in
/// common.
pub(super) fn common(conics: &[Conic; 2]) -> Vec<Point> {
    let turned = conics.map(|conic| turned(&conic));
    // The equations as polynomials in the second coordinate, whose coefficients are polynomials in
    // the first one.
    let [first, second] = turned.map(|c| {
        let real = |value: f64| ONE.scaled(value);
        let line = [real(2.0 * c[1][2]), real(2.0 * c[0][1])];
        let rest = [real(c[2][2]), real(2.0 * c[0][2]), real(c[0][0])];
        (real(c[1][1]), line, rest)
    });
    let ((a1, b1, c1), (a2, b2, c2)) = (first, second);
    let ac: [Complex; 3] = core::array::from_fn(|i| a1 * c2[i] - a2 * c1[i]);
    let ab: [Complex; 2] = core::array::from_fn(|i| a1 * b2[i] - a2 * b1[i]);
    let mut bc = [ZERO; 4];
    for i in 0..2 {
        for j in 0..3 {
            bc[i + j] = bc[i + j] + b1[i] * c2[j] - b2[i] * c1[j];
        }
    }
    // The resultant ac^2 - ab bc.
    let mut resultant = [ZERO; 5];
    for (i, &left) in ac.iter().enumerate() {
        for (j, &right) in ac.iter().enumerate() {
            resultant[i + j] += left * right;
        }
    }
    for (i, &left) in ab.iter().enumerate() {
        for (j, &right) in bc.iter().enumerate() {
            resultant[i + j] = resultant[i + j] - left * right;
        }
    }
    let points = roots(&resultant).into_iter().map(|u| {
        let at = |coefficients: &[Complex]| {
            let terms = coefficients.iter().rev();
            terms.fold(ZERO, |sum, &coefficient| sum * u + coefficient)
        };
        let v = -at(&ac) * at(&ab).inverse();
        back(&polished(&turned, [u, v, ONE]))
    });
    points.collect()
}

fn turned(conic: &Conic) -> Conic {
    let entry = |i: usize, j: usize| {
        let pairs = (0..3).flat_map(|k| (0..3).map(move |l| (k, l)));
        pairs
            .map(|(k, l)| GENERIC[k][i] * conic[k][l] * GENERIC[l][j])
            .sum()
    };
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}

fn back(point: &Point) -> Point {
    core::array::from_fn(|k| {
        let terms = (0..3).map(|i| point[i].scaled(GENERIC[k][i]));
        terms.fold(ZERO, |sum, term| sum + term)
    })
}

/// Newton's steps with the largest coordinate kept at 1.
fn polished(conics: &[Conic; 2], start: Point) -> Point {
    let largest = (0..3).max_by(|&a, &b| start[a].square().total_cmp(&start[b].square()));
    let largest = largest.unwrap_or(2);
    let scale = start[largest].inverse();
    let mut point = start.map(|coordinate| coordinate * scale);
    let [i, j] = [(largest + 1) % 3, (largest + 2) % 3];
    for _ in 0..STEPS {
        let slopes = conics.map(|conic| {
            conic.map(|row| {
                let terms = row.iter().zip(&point).map(|(&c, w)| w.scaled(c));
                terms.fold(ZERO, |sum, term| sum + term)
            })
        });
        let [f, g] = slopes.map(|slope| {
            let terms = slope.iter().zip(&point);
            terms.fold(ZERO, |sum, (&s, &w)| sum + s * w)
        });
        let [[a, b], [c, d]] = slopes.map(|slope| [slope[i].scaled(2.0), slope[j].scaled(2.0)]);
        let determinant = a * d - b * c;
        if determinant.square() == 0.0 {
            break;
        }
        let inverse = determinant.inverse();
        point[i] = point[i] - (d * f - b * g) * inverse;
        point[j] = point[j] - (a * g - c * f) * inverse;
    }
    point
}
