//! A step: the minimum of linearised groups within a box.

use std::vec;
use std::vec::Vec;

use super::super::limits::Limits;
use super::super::quadratic::{Face, Quadratic};
use super::curvature::Curvature;
use super::rows::{FunctionRow, Groups, cost};

/// The region of a step, and the price of violations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim<'a> {
    pub(super) limits: &'a Limits,
    pub(super) reach: &'a [f64],
    /// The bound of a variable, in reaches.
    pub(super) radius: f64,
    pub(super) price: f64,
}

/// A step and its promised gain.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub(super) d: Vec<f64>,
    /// The sum of objective, violations and curvature.
    pub(super) merit: f64,
    /// The worst violation that remains.
    pub(super) excess: f64,
    /// The cost of all remaining violations at a price of 1.
    pub(super) missed: f64,
    /// The most that a variable goes, in reaches.
    pub(super) length: f64,
    /// The weights of all rows, the objective's first.
    pub(super) multipliers: Vec<Vec<f64>>,
}

/// The box counts as this part of the change of the objective in it: variables without effect stay
/// where they are.
const BOX: f64 = 1e-6;
/// The objective counts with this part of its change as curvature, or the program would not be
/// strictly convex. It is still greater where it is greater, so that its least place is the same.
const BENT: f64 = 0.1;

/// The best step, or without a curvature the shortest one that leads back to the conditions. `None`
/// if rounding leaves no solution.
///
/// The quadratic program has the variables of the step in reaches, then for each group how much its
/// largest row may be: the objective's less its value now, and violations.
pub(super) fn step(
    x: &[f64],
    here: &Groups,
    curvature: Option<&Curvature>,
    aim: &Aim<'_>,
) -> Option<Plan> {
    let n = x.len();
    let (gram, gradient) = costs(n, here, curvature, aim);
    let (faces, first) = faces(x, here, aim);
    let mut program = Quadratic::default();
    if !program.solve(&gram, &gradient, &faces) {
        return None;
    }
    let d = &program.d[..n];
    let linearised = |rows: &[FunctionRow]| {
        let along = |row: &FunctionRow| aim.scaled(row).zip(d).map(|(s, d)| s * d).sum::<f64>();
        let values = rows.iter().map(|row| row.value + along(row));
        values.fold(f64::NEG_INFINITY, f64::max)
    };
    let left = here.conditions.iter().map(|rows| linearised(rows).max(0.0));
    let missed: f64 = left.clone().map(cost).sum();
    let bend = curvature.map_or(0.0, |curvature| curvature.along(d));
    Some(Plan {
        merit: linearised(&here.objective) + aim.price * missed + bend,
        missed,
        excess: left.fold(0.0, f64::max),
        length: d.iter().fold(0.0, |most: f64, d| most.max(d.abs())),
        multipliers: multipliers(here, &program, faces.len(), first),
        d: d.iter().zip(aim.reach).map(|(d, r)| d * r).collect(),
    })
}

/// Returns the largest decrease of objective and violations together within the first box, to first
/// order: zero where the first-order conditions hold, those of Karush, Kuhn and Tucker. `None` if
/// rounding leaves no answer.
///
/// Source of the measure: Y. Yuan, "Conditions for convergence of trust region algorithms for
/// nonsmooth optimization", Mathematical Programming 31 (1985).
pub(super) fn fall(x: &[f64], here: &Groups, aim: &Aim<'_>) -> Option<f64> {
    let flat = Curvature::new(aim.reach);
    let first = Aim {
        radius: 1.0,
        ..*aim
    };
    let plan = step(x, here, Some(&flat), &first)?;
    Some(here.merit(aim.price) - plan.merit)
}

impl Aim<'_> {
    /// The slopes of a row by the variables in reaches.
    fn scaled<'r>(&'r self, row: &'r FunctionRow) -> impl Iterator<Item = f64> + 'r {
        row.slopes.iter().zip(self.reach).map(|(s, r)| s * r)
    }
}

/// The minimised function: matrix, of which the lower triangle counts, and gradient.
fn costs(
    n: usize,
    here: &Groups,
    curvature: Option<&Curvature>,
    aim: &Aim<'_>,
) -> (Vec<f64>, Vec<f64>) {
    let all = n + 1 + here.conditions.len();
    let change = |row: &FunctionRow| aim.radius * aim.scaled(row).map(f64::abs).sum::<f64>();
    let changes = here.objective.iter().map(change);
    let change = changes.fold(f64::MIN_POSITIVE.sqrt(), f64::max);
    let mut gram = vec![0.0; all * all];
    let mut gradient = vec![0.0; all];
    for i in 0..n {
        for j in 0..=i {
            gram[i * all + j] = match curvature {
                Some(curvature) => curvature.entry(i, j),
                None => f64::from(i == j),
            };
        }
        gram[i * all + i] += BOX * change / (aim.radius * aim.radius);
    }
    if curvature.is_some() {
        gradient[n] = 1.0;
    }
    gram[n * all + n] = BENT / change;
    for k in n + 1..all {
        gradient[k] = aim.price;
        gram[k * all + k] = aim.price;
    }
    (gram, gradient)
}

/// The faces of the region: the box and the limits, then from the returned index on all rows.
fn faces(x: &[f64], here: &Groups, aim: &Aim<'_>) -> (Vec<Face>, usize) {
    let n = x.len();
    let one = |j: usize, a: f64, slack: f64, equality: bool| Face {
        normal: vec![(j, a)],
        slack,
        equality,
    };
    let mut faces = Vec::new();
    for (j, x) in x.iter().enumerate() {
        let [below, above] = [x - aim.limits.lower[j], aim.limits.upper[j] - x]
            .map(|room| (room / aim.reach[j]).min(aim.radius));
        if below + above > 0.0 {
            faces.push(one(j, 1.0, below, false));
            faces.push(one(j, -1.0, above, false));
        } else {
            // Two faces in one plane would contradict each other by rounding.
            faces.push(one(j, 1.0, 0.0, true));
        }
    }
    faces.extend((0..here.conditions.len()).map(|k| one(n + 1 + k, 1.0, 0.0, false)));
    for relation in &aim.limits.relations {
        let terms = relation.terms.iter();
        faces.push(Face {
            normal: terms.map(|&(j, a)| (j, -a * aim.reach[j])).collect(),
            slack: relation.slack(x),
            equality: relation.equality,
        });
    }
    let first = faces.len();
    let conditions = here.conditions.iter().map(|rows| (rows, 0.0));
    let groups = core::iter::once((&here.objective, here.value())).chain(conditions);
    for (k, (rows, base)) in groups.enumerate() {
        faces.extend(rows.iter().map(|row| {
            let slopes = aim.scaled(row).enumerate().filter(|(_, s)| *s != 0.0);
            let normal = slopes.map(|(j, s)| (j, -s)).chain([(n + k, 1.0)]);
            Face {
                normal: normal.collect(),
                slack: base - row.value,
                equality: false,
            }
        }));
    }
    (faces, first)
}

/// The multipliers of the rows, of which the first is this face.
fn multipliers(here: &Groups, program: &Quadratic, faces: usize, first: usize) -> Vec<Vec<f64>> {
    let mut weights = vec![0.0; faces];
    for (&face, &weight) in program.active.iter().zip(&program.multipliers) {
        weights[face] = weight;
    }
    let mut weights = weights.into_iter().skip(first);
    let groups = core::iter::once(&here.objective).chain(&here.conditions);
    let of = |rows: &Vec<FunctionRow>| weights.by_ref().take(rows.len()).collect();
    groups.map(of).collect()
}
