//! Directions in which parameters may move together.

use std::vec;
use std::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::determined::Determined;
use super::named::Named;

/// A direction in which all may move, in terms of ranges, with its name if it has one.
pub(super) struct Candidate {
    pub(super) direction: DVector<f64>,
    pub(super) pattern: Option<&'static str>,
}

/// Returns single parameters, a common scale, rotation or shift, pairs, and the rest of the open
/// directions.
pub(super) fn candidates(named: &Named, found: &Determined, open: &[usize]) -> Vec<Candidate> {
    let n = named.values.len();
    let unit = |j: usize| DVector::from_fn(n, |i, _| if i == j { 1.0 } else { 0.0 });
    let bare = |direction| Candidate {
        direction,
        pattern: None,
    };
    if open.is_empty() {
        return Vec::new();
    }
    let mut all: Vec<Candidate> = (0..n).map(|j| bare(unit(j))).collect();
    all.extend(patterns(named, found));
    for i in 0..n {
        all.extend((i + 1..n).map(|j| bare(pair(found, i, j))));
    }
    all.extend(reduced(found, open).into_iter().map(bare));
    all
}

/// Returns common changes of the whole mechanism, of three parameters at least: two have a simpler
/// name.
fn patterns(named: &Named, found: &Determined) -> Vec<Candidate> {
    let n = named.values.len();
    let is_length = |j: usize| !matches!(named.parameters[j].unit, "" | "rad");
    let ends = |j: usize, end: &str| named.parameters[j].name.ends_with(end);
    let by =
        |change: &dyn Fn(usize) -> f64| DVector::from_fn(n, |j, _| change(j) / named.ranges[j]);
    let partner = |j: usize, end: &str| {
        let stem = &named.parameters[j].name[..named.parameters[j].name.len() - 2];
        let names = named.parameters.iter();
        let index = names
            .clone()
            .position(|p| p.name.strip_suffix(end) == Some(stem));
        index.map_or(0.0, |index| named.values[index])
    };
    let turned = |j: usize| match j {
        _ if ends(j, ".x") => -partner(j, ".y"),
        _ if ends(j, ".y") => partner(j, ".x"),
        _ => 0.0,
    };
    let all = [
        (
            "a common scale",
            by(&|j| if is_length(j) { named.values[j] } else { 0.0 }),
        ),
        (
            "a common rotation about the origin",
            with_angles(named, found, by(&turned)),
        ),
        (
            "a common shift along x",
            by(&|j| f64::from(u8::from(ends(j, ".x")))),
        ),
        (
            "a common shift along y",
            by(&|j| f64::from(u8::from(ends(j, ".y")))),
        ),
        (
            "a common shift along z",
            by(&|j| f64::from(u8::from(ends(j, ".z")))),
        ),
    ];
    let large = |direction: &DVector<f64>| direction.iter().filter(|x| x.abs() > 1e-9).count() > 2;
    let named = all.into_iter().filter(|(_, direction)| large(direction));
    named
        .map(|(name, direction)| Candidate {
            direction,
            pattern: Some(name),
        })
        .collect()
}

/// With the changes of angles that make the least difference: which of them turn with the rest is
/// not known here.
fn with_angles(named: &Named, found: &Determined, direction: DVector<f64>) -> DVector<f64> {
    let angles: Vec<usize> = (0..named.values.len())
        .filter(|&j| named.parameters[j].unit == "rad")
        .collect();
    if angles.is_empty() || direction.norm() == 0.0 {
        return direction;
    }
    let columns = DMatrix::from_fn(found.jacobian.nrows(), angles.len(), |i, k| {
        found.jacobian[(i, angles[k])]
    });
    let change = &found.jacobian * &direction;
    let svd = columns.svd(true, true);
    let rounding = found.needed().min(svd.singular_values.max());
    let Ok(changes) = svd.solve(&change, rounding * 1e-6) else {
        return direction;
    };
    let mut all = direction;
    for (&j, changes) in angles.iter().zip(changes.iter()) {
        all[j] -= changes;
    }
    all
}

/// The direction of two parameters that changes readings least: the smaller singular vector of
/// their columns.
fn pair(found: &Determined, i: usize, j: usize) -> DVector<f64> {
    let (a, b) = (found.jacobian.column(i), found.jacobian.column(j));
    let [aa, bb] = [a.norm(), b.norm()];
    let mut direction = DVector::zeros(found.singular.len());
    if aa == 0.0 || bb == 0.0 {
        return direction;
    }
    // Parallel columns: one cancels the effect of the other. Of columns that are not, this is no
    // candidate.
    let way = a.dot(&b).signum();
    (direction[i], direction[j]) = (1.0 / aa, -way / bb);
    direction
}

/// Returns the undetermined directions with as many zeros as possible: Gauss's elimination by the
/// largest entries.
fn reduced(found: &Determined, open: &[usize]) -> Vec<DVector<f64>> {
    let n = found.singular.len();
    let mut rows: Vec<DVector<f64>> = open
        .iter()
        .map(|&k| found.directions.row(k).transpose())
        .collect();
    let mut free = vec![true; n];
    for k in 0..rows.len() {
        let places = (k..rows.len()).flat_map(|i| (0..n).map(move |j| (i, j)));
        let size = |&(i, j): &(usize, usize)| if free[j] { rows[i][j].abs() } else { 0.0 };
        let Some((i, j)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else {
            break;
        };
        rows.swap(k, i);
        free[j] = false;
        let pivot = &rows[k] / rows[k][j];
        for (i, row) in rows.iter_mut().enumerate() {
            if i != k {
                *row -= &pivot * row[j];
            }
        }
        rows[k] = pivot;
    }
    rows
}
