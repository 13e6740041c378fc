//! The closest approach of a group's loops, with the gap of each.

use super::group::CoupledGroup;
use super::programs::CoupledPrograms;
use crate::error::{ClosestApproach, Missed};
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::math;
use linkage_core::numeric::cholesky;
use linkage_core::numeric::continuation::turned;
use linkage_core::numeric::least_squares::{CLOSED, Equations, Rows, STEP, minimise};

/// Share of the largest gap below which a loop counts as closed.
const LITTLE: f64 = 1e-3;

/// Greatest change of a body that counts as rigid.
const RIGID: f64 = 1e-13;

/// Corrections of bodies that are not: each leaves a tenth after the longest step.
const CORRECTIONS: usize = 20;

/// Repetitions: axes may be estimated roughly, so that the first derivatives of their loops are
/// rough.
const TIMES: usize = 3;

/// The closest approach of the loops from the estimates of the unknowns. At the end of a path,
/// bodies may be far from rigid.
pub(super) fn closest_approach(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
    estimate: Vec<f64>,
) -> ClosestApproach {
    if group.missed.is_empty() {
        return ClosestApproach::Unknown;
    }
    let mut loops = Loops { group, programs, x };
    let found = loops
        .rigid(estimate)
        .and_then(|from| minimise(&mut loops, from));
    found.map_or(ClosestApproach::Unknown, |(_, rows)| {
        farthest_first(group, &rows.missed)
    })
}

/// The loops that miss, the farthest first; `shares` are those of their scales.
fn farthest_first(group: &CoupledGroup, shares: &[f64]) -> ClosestApproach {
    let mut shares = shares.iter().copied();
    let mut loops: Vec<(f64, Missed)> = Vec::new();
    for group_loop in group.missed {
        let sides: Vec<f64> = shares.by_ref().take(group_loop.rows).collect();
        let share = match sides[..] {
            [one] => one,
            ref several => math::double::sqrt(several.iter().map(|x| x * x).sum()),
        };
        let missed = Missed {
            number: group_loop.number,
            joint: group_loop.joint,
            by: share * group_loop.scale,
            unit: group_loop.unit,
        };
        loops.push((share.abs(), missed));
    }
    let most = loops
        .iter()
        .fold(0.0, |most: f64, (size, _)| most.max(*size));
    if most <= CLOSED {
        return ClosestApproach::Closes;
    }
    loops.retain(|(size, _)| *size > LITTLE * most);
    loops.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    ClosestApproach::Misses(loops.into_iter().map(|(_, missed)| missed).collect())
}

/// The loops of a group by its state.
struct Loops<'a> {
    group: &'a CoupledGroup,
    programs: &'a mut dyn CoupledPrograms,
    x: &'a [f64],
}

/// The sides to be minimised, and the constraints.
struct Sides {
    /// Gaps of the loops, as shares of their scales.
    of_loops: Vec<f64>,
    /// Gaps of the loops that make bodies rigid.
    of_bodies: Vec<f64>,
}

/// The loops about a state.
struct Near {
    missed: Vec<f64>,
    /// Derivatives by row and unknown, for changes that leave bodies rigid.
    matrix: Vec<Vec<f64>>,
    bodies: Vec<Vec<f64>>,
}

impl Rows for Near {
    fn missed(&self) -> &[f64] {
        &self.missed
    }

    fn matrix(&self) -> &[Vec<f64>] {
        &self.matrix
    }
}

impl Equations<Vec<f64>> for Loops<'_> {
    type Rows = Near;

    fn rows(&mut self, at: &Vec<f64>) -> Option<Near> {
        let missed = self.sides(at).of_loops;
        let [mut matrix, bodies] = self.derivatives(at);
        for row in &mut matrix {
            let along = products(&bodies, row);
            let across = across(&bodies, &along)?;
            row.iter_mut().zip(across).for_each(|(x, y)| *x -= y);
        }
        let mut numbers = matrix.iter().flatten().chain(&missed);
        numbers.all(|x| x.is_finite()).then_some(Near {
            missed,
            matrix,
            bodies,
        })
    }

    fn misses(&mut self, at: &Vec<f64>, _: &Near) -> Vec<f64> {
        self.sides(at).of_loops
    }

    fn after(&mut self, at: &Vec<f64>, rows: &Near, changes: &[f64]) -> Vec<f64> {
        let next = turned(self.group.variables, at, changes);
        self.corrected(next, &rows.bodies)
    }
}

impl Loops<'_> {
    fn sides(&mut self, state: &[f64]) -> Sides {
        let mut sides = self.programs.missed(self.x, state).into_iter();
        let loops = self.group.missed.iter();
        let scales =
            loops.flat_map(|group_loop| core::iter::repeat_n(group_loop.scale, group_loop.rows));
        Sides {
            of_loops: scales.zip(&mut sides).map(|(scale, x)| x / scale).collect(),
            of_bodies: sides.collect(),
        }
    }

    /// Derivatives of the loops, and of those of bodies: by row and unknown.
    fn derivatives(&mut self, state: &[f64]) -> [Vec<Vec<f64>>; 2] {
        let variables = self.group.variables;
        let columns: Vec<Sides> = (0..variables.len())
            .map(|column| {
                let [before, after] = [-STEP, STEP].map(|step| {
                    let mut way = vec![0.0; variables.len()];
                    way[column] = step;
                    self.sides(&turned(variables, state, &way))
                });
                Sides {
                    of_loops: slopes(&before.of_loops, &after.of_loops),
                    of_bodies: slopes(&before.of_bodies, &after.of_bodies),
                }
            })
            .collect();
        let rows = |side: fn(&Sides) -> &Vec<f64>| {
            let count = columns.first().map_or(0, |column| side(column).len());
            let row = |row: usize| columns.iter().map(|column| side(column)[row]).collect();
            (0..count).map(row).collect()
        };
        [
            rows(|sides| &sides.of_loops),
            rows(|sides| &sides.of_bodies),
        ]
    }

    /// A state of rigid bodies.
    fn rigid(&mut self, mut state: Vec<f64>) -> Option<Vec<f64>> {
        for _ in 0..TIMES {
            let [_, bodies] = self.derivatives(&state);
            state = self.corrected(state, &bodies);
        }
        let left = self.sides(&state).of_bodies;
        left.iter().all(|x| x.abs() <= CLOSED).then_some(state)
    }

    /// Bodies made rigid again, as near to the state as possible; `bodies` are the derivatives of
    /// their loops nearby.
    fn corrected(&mut self, mut state: Vec<f64>, bodies: &[Vec<f64>]) -> Vec<f64> {
        for _ in 0..CORRECTIONS {
            let off = self.sides(&state).of_bodies;
            if off.iter().all(|x| x.abs() <= RIGID) {
                break;
            }
            let Some(across) = across(bodies, &off) else {
                break;
            };
            let back: Vec<f64> = across.iter().map(|x| -x).collect();
            state = turned(self.group.variables, &state, &back);
        }
        state
    }
}

fn slopes(before: &[f64], after: &[f64]) -> Vec<f64> {
    let pairs = before.iter().zip(after);
    pairs.map(|(a, b)| (b - a) / (2.0 * STEP)).collect()
}

/// The products of each row with a vector.
fn products(rows: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    let product = |row: &Vec<f64>| row.iter().zip(vector).map(|(a, b)| a * b).sum();
    rows.iter().map(product).collect()
}

/// The shortest vector with these products with the rows; nothing if these are not independent.
fn across(rows: &[Vec<f64>], along: &[f64]) -> Option<Vec<f64>> {
    let matrix: Vec<Vec<f64>> = rows.iter().map(|row| products(rows, row)).collect();
    let weights = cholesky::solve(&matrix, along)?;
    let width = rows.first().map_or(0, Vec::len);
    let mut sum = vec![0.0; width];
    for (row, weight) in rows.iter().zip(weights) {
        let pairs = sum.iter_mut().zip(row);
        pairs.for_each(|(sum, x)| *sum += weight * x);
    }
    Some(sum)
}
