//! The real solutions: those that are their own reflections.

use super::endgame::{Root, polish};
use super::homotopy::Homotopy;
use super::projective::ProjectivePoint;
use super::system::Variable;
use crate::numeric::choose_assembly::MEETING;
use crate::numeric::complex::Complex;
use crate::numeric::complex_matrix::Vector;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// The values of the real solutions in ascending order; `None` if the reflection of a solution is
/// missing or not certain. Of solutions that are not real up to `blurred` may be missing.
pub(super) fn list<const N: usize>(
    homotopy: &mut Homotopy<N>,
    variables: &[Variable],
    roots: &[Root<N>],
    blurred: usize,
) -> Option<Vec<Vec<[f64; 2]>>> {
    let partners: Vec<Option<usize>> = roots
        .iter()
        .map(|root| partner(variables, root, roots))
        .collect();
    let mut found = Vec::new();
    let mut alone = 0;
    for (index, &partner) in partners.iter().enumerate() {
        let Some(partner) = partner else {
            alone += 1;
            continue;
        };
        if partners[partner] != Some(index) {
            return None;
        }
        if partner == index {
            found.push(polished(homotopy, variables, &roots[index])?);
        }
    }
    if alone > blurred {
        return None;
    }
    found.sort_by(|a, b| order(variables, a, b));
    let list = |values: &Vector<N>| values.iter().copied().map(parts).collect();
    Some(found.iter().map(list).collect())
}

/// Index of the solution that is the reflection of another one, or the same.
fn partner<const N: usize>(
    variables: &[Variable],
    root: &Root<N>,
    roots: &[Root<N>],
) -> Option<usize> {
    let image = root.point.reflection(variables);
    let distances = roots.iter().map(|other| image.distance(&other.point));
    let (index, distance) = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let reach = root.reach.min(roots[index].reach);
    (distance < reach * reach).then_some(index)
}

/// Returns the exactly real values next to a solution that is real to rounding.
fn polished<const N: usize>(
    homotopy: &mut Homotopy<N>,
    variables: &[Variable],
    root: &Root<N>,
) -> Option<Vector<N>> {
    let mut point = alike(variables, &root.point);
    homotopy.turn(point.flipped);
    point.x = made_real(variables, &point.x);
    let (x, _) = polish(homotopy, &point.x)?;
    point.x = made_real(variables, &x);
    (point.distance(&root.point) < root.reach * root.reach).then(|| point.values())
}

/// About where real solutions meet: multiple ones that are no farther from their reflections than
/// both may be off.
pub(super) fn meeting<const N: usize>(
    variables: &[Variable],
    multiple: &[ProjectivePoint<N>],
) -> Vec<Vec<[f64; 2]>> {
    let may_be_real = |point: &&ProjectivePoint<N>| {
        let image = point.reflection(variables);
        image.distance(point) <= (2.0 * MEETING) * (2.0 * MEETING)
    };
    let real = |point: &ProjectivePoint<N>| {
        let mut point = alike(variables, point);
        point.x = made_real(variables, &point.x);
        point.values().into_iter().map(parts).collect()
    };
    multiple.iter().filter(may_be_real).map(real).collect()
}

/// The same place, a point and its conjugate both by their values or both by the inverses.
fn alike<const N: usize>(variables: &[Variable], point: &ProjectivePoint<N>) -> ProjectivePoint<N> {
    let mut point = *point;
    for (j, variable) in variables.iter().enumerate() {
        if *variable == Variable::Conjugate && point.flipped[j] != point.flipped[j - 1] {
            point.flipped[j] = point.flipped[j - 1];
            point.x[j] = point.x[j].inverse();
        }
    }
    point
}

/// The nearest real coordinates, which are either variables or their inverses: a point and its
/// conjugate both the one or both the other.
fn made_real<const N: usize>(variables: &[Variable], x: &Vector<N>) -> Vector<N> {
    let mut real = *x;
    for (j, variable) in variables.iter().enumerate() {
        match variable {
            // One Newton step for the inverse square root, twice.
            Variable::Unit => {
                for _ in 0..2 {
                    real[j] = real[j].scaled(1.5 - 0.5 * real[j].square());
                }
            }
            Variable::Length | Variable::Number => real[j].im = 0.0,
            Variable::Point => real[j] = (x[j] + x[j + 1].conjugate()).scaled(0.5),
            Variable::Conjugate => real[j] = real[j - 1].conjugate(),
        }
    }
    real
}

fn order<const N: usize>(variables: &[Variable], a: &Vector<N>, b: &Vector<N>) -> Ordering {
    let keys = |values: &Vector<N>, j: usize| match variables[j] {
        Variable::Unit => [turn(values[j]), 0.0],
        _ => parts(values[j]),
    };
    (0..N)
        .flat_map(|j| keys(a, j).into_iter().zip(keys(b, j)))
        .map(|(a, b)| a.total_cmp(&b))
        .fold(Ordering::Equal, Ordering::then)
}

/// A number that grows with the angle of a unit number, from -pi to pi.
fn turn(unit: Complex) -> f64 {
    if unit.im < 0.0 {
        unit.re - 1.0
    } else {
        1.0 - unit.re
    }
}

fn parts(value: Complex) -> [f64; 2] {
    // No negative zero.
    [value.re + 0.0, value.im + 0.0]
}
