//! Where the loops of a group come nearest to closing, and by how much each misses there.

use super::group::CoupledGroup;
use super::solve::CoupledPrograms;
use crate::numeric::cholesky;
use crate::numeric::continuation::turned;
use crate::numeric::least_squares::{CLOSED, Equations, Rows, STEP, minimise};
use crate::{Missed, Reach};
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::math;

/// Loops that miss by a smaller part of what the farthest misses by hold.
const LITTLE: f64 = 1e-3;

/// Bodies are rigid but for this.
const RIGID: f64 = 1e-13;

/// Corrections of bodies that are not: each leaves a tenth after the longest step.
const CORRECTIONS: usize = 20;

/// Axes may be estimated roughly, so what their loops say there is a rough guide for the first time.
const TIMES: usize = 3;

impl CoupledGroup {
    /// How near to closing its loops come from where its unknowns are estimated: where a way ends, bodies may be far from rigid.
    pub(super) fn reach(
        &self,
        programs: &mut dyn CoupledPrograms,
        x: &[f64],
        estimate: Vec<f64>,
    ) -> Reach {
        if self.missed.is_empty() {
            return Reach::Unknown;
        }
        let mut loops = Loops {
            group: self,
            programs,
            x,
        };
        let found = loops
            .rigid(estimate)
            .and_then(|from| minimise(&mut loops, from));
        found.map_or(Reach::Unknown, |(_, rows)| self.told(&rows.missed))
    }

    /// The loops that miss, the farthest first; `shares` are those of their scales.
    fn told(&self, shares: &[f64]) -> Reach {
        let mut shares = shares.iter().copied();
        let mut all: Vec<(f64, Missed)> = Vec::new();
        for own in self.missed {
            let sides: Vec<f64> = shares.by_ref().take(own.rows).collect();
            let share = match sides[..] {
                [one] => one,
                ref several => math::double::sqrt(several.iter().map(|x| x * x).sum()),
            };
            let missed = Missed {
                number: own.number,
                by: share * own.scale,
                unit: own.unit,
            };
            all.push((share.abs(), missed));
        }
        let most = all.iter().fold(0.0, |most: f64, (size, _)| most.max(*size));
        if most <= CLOSED {
            return Reach::Closes;
        }
        all.retain(|(size, _)| *size > LITTLE * most);
        all.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        Reach::Misses(all.into_iter().map(|(_, missed)| missed).collect())
    }
}

/// The loops of a group by its state.
struct Loops<'a> {
    group: &'a CoupledGroup,
    programs: &'a mut dyn CoupledPrograms,
    x: &'a [f64],
}

/// What is to be least, and what holds all the while.
struct Sides {
    /// As shares of the loops' scales.
    of_loops: Vec<f64>,
    /// Of the loops that make bodies rigid.
    of_bodies: Vec<f64>,
}

/// The loops about a state.
struct Near {
    missed: Vec<f64>,
    /// By row and unknown, for changes that leave bodies rigid.
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
        let mut all = matrix.iter().flatten().chain(&missed);
        all.all(|x| x.is_finite()).then_some(Near {
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
        let mut all = self.programs.missed(self.x, state).into_iter();
        let loops = self.group.missed.iter();
        let scales = loops.flat_map(|own| core::iter::repeat_n(own.scale, own.rows));
        Sides {
            of_loops: scales.zip(&mut all).map(|(scale, x)| x / scale).collect(),
            of_bodies: all.collect(),
        }
    }

    /// Of the loops, and of those of bodies: by row and unknown.
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
        let rows = |of: fn(&Sides) -> &Vec<f64>| {
            let count = columns.first().map_or(0, |own| of(own).len());
            let row = |row: usize| columns.iter().map(|own| of(own)[row]).collect();
            (0..count).map(row).collect()
        };
        [rows(|own| &own.of_loops), rows(|own| &own.of_bodies)]
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

    /// Bodies made rigid again, as near to the state as possible; `bodies` are the derivatives of their loops thereabouts.
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
