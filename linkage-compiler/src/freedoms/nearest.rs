//! Where loops that do not close come nearest to it: by how much each misses there, and how its unknowns can move.
//!
//! There the misses are a left null vector of the loops: like the forces of stretched links they hold each other, and no motion makes all of them
//! less.

use linkage_core::numeric::cholesky;
use linkage_symbolic::Graph;

use super::loops::Loops;
use super::motion::list;
use super::null::{LITTLE, NEARLY_ZERO, largest};
use super::{Position, Rows};
use crate::model::Type;

/// Steps of Levenberg's and Marquardt's method: near a dead point it converges linearly.
const STEPS: usize = 400;

/// The longest step, in radians or shares of the longest length: a long one may leave the neighbourhood.
const LONGEST: f64 = 0.1;

/// A slope below this part of the misses is none: differences know no more.
const LEVEL: f64 = 1e-8;

/// Misses that are a smaller share of the longest length are none.
const CLOSED: f64 = 1e-9;

/// Damping as a part of the largest diagonal: where it begins, by how much it changes, and where no step is worth more.
const DAMPING: f64 = 1e-3;
const LESS: f64 = 0.3;
const MORE: f64 = 5.0;
const MOST: f64 = 1e9;
const LEAST: f64 = 1e-13;

/// So many loops are told.
const TOLD: usize = 6;

/// Where loops come nearest to closing, in words.
pub(crate) struct Nearest {
    /// `loop 1 by 12.3mm and loop 4 by -2.1mm`, the largest first.
    pub(crate) missing: String,
    /// `body` can turn about ...
    pub(crate) motion: Option<String>,
}

impl Position<'_, '_> {
    /// Where the loops come nearest to closing; nothing if they close, or if that is not found out.
    pub(crate) fn nearest(&self) -> Option<Nearest> {
        let graph = Graph::new();
        let loops = Loops::new(self.mechanism, &graph);
        let (there, rows) = self.settled(&loops)?;
        let most = largest(&rows.missed);
        (most > CLOSED).then(|| Nearest {
            missing: there.missing(&rows, &loops),
            motion: there.motion(&rows, NEARLY_ZERO),
        })
    }

    /// The least sum of squares of what the loops miss by.
    fn settled(&self, loops: &Loops) -> Option<(Self, Rows)> {
        let mut here = self.clone();
        let mut damping = DAMPING;
        for _ in 0..STEPS {
            let rows = here.rows(loops)?;
            let slope: Vec<f64> = (0..rows.columns.len())
                .map(|k| rows.products(|row| rows.matrix[row][k], |row| rows.missed[row]))
                .collect();
            let size = square(&rows.missed).sqrt();
            let steepest = rows.matrix.iter().map(|row| largest(row));
            let steepest = steepest.fold(0.0, f64::max);
            if size <= CLOSED || largest(&slope) <= LEVEL * size * steepest {
                return Some((here, rows));
            }
            loop {
                let next = rows
                    .step(&slope, damping)
                    .map(|step| here.after(&rows, &step));
                let less = next.filter(|next| next.square_of(loops, &rows) < size * size);
                if let Some(next) = less {
                    here = next;
                    damping = (LESS * damping).max(LEAST);
                    break;
                }
                damping *= MORE;
                if damping > MOST {
                    // Nothing but rounding is left to gain.
                    return Some((here, rows));
                }
            }
        }
        None
    }

    fn square_of(&self, loops: &Loops, rows: &Rows) -> f64 {
        let all = loops.missed(self, &self.values);
        let kept: Vec<f64> = rows.kept.iter().map(|&k| all[k]).collect();
        square(&kept)
    }

    fn after(&self, rows: &Rows, step: &[f64]) -> Self {
        let shorter = (LONGEST / largest(step)).min(1.0);
        let mut next = self.clone();
        for (&column, own) in rows.columns.iter().zip(step) {
            self.shift(&mut next.values, column, -shorter * own);
        }
        next
    }

    /// By how much each loop misses, the largest first.
    fn missing(&self, rows: &Rows, loops: &Loops) -> String {
        let mut all: Vec<(usize, f64, Vec<f64>)> = Vec::new();
        for (row, (&index, missed)) in rows.loops.iter().zip(&rows.missed).enumerate() {
            let value = missed * loops.unit(rows.kept[row], self.length);
            match all.last_mut().filter(|(last, ..)| *last == index) {
                Some((_, size, components)) => {
                    *size = size.hypot(*missed);
                    components.push(value);
                }
                None => all.push((index, missed.abs(), vec![value])),
            }
        }
        let most = all
            .iter()
            .fold(0.0, |most: f64, (_, size, _)| most.max(*size));
        all.retain(|(_, size, _)| *size > LITTLE * most);
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        let told = all.iter().take(TOLD).map(|(index, _, value)| {
            let ty = &self.mechanism.loops[*index].left.ty;
            let by = match (ty, &value[..]) {
                (Type::Scalar(dimension), [x]) if dimension.half_lengths <= 2 => {
                    self.words.rounded(*dimension, *x)
                }
                _ => self.words.value(ty, value),
            };
            format!("loop {} by {by}", index + 1)
        });
        let told: Vec<String> = told.collect();
        match all.len() - told.len() {
            0 => list(told),
            more => format!("{}, and {more} more by less", told.join(", ")),
        }
    }
}

impl Rows {
    fn products(&self, a: impl Fn(usize) -> f64, b: impl Fn(usize) -> f64) -> f64 {
        (0..self.missed.len()).map(|row| a(row) * b(row)).sum()
    }

    /// The damped step, by column.
    fn step(&self, slope: &[f64], damping: f64) -> Option<Vec<f64>> {
        let own = |i: usize| move |row: usize| self.matrix[row][i];
        let mut matrix: Vec<Vec<f64>> = (0..slope.len())
            .map(|i| (0..=i).map(|j| self.products(own(i), own(j))).collect())
            .collect();
        let most = (0..slope.len()).fold(0.0, |most: f64, i| most.max(matrix[i][i]));
        (0..slope.len()).for_each(|i| matrix[i][i] += damping * most);
        cholesky::solve(matrix, slope)
    }
}

fn square(all: &[f64]) -> f64 {
    all.iter().map(|x| x * x).sum()
}
