//! Positions in which loops that do not close come nearest to it: the error of each there, and the
//! motion of its unknowns.
//!
//! There the misses are a left null vector of the loops: like the forces of stretched links they
//! hold each other, and no motion makes all of them less.

use linkage_core::numeric::least_squares::{self, CLOSED, Equations, minimise};
use linkage_symbolic::Graph;

use crate::message_format::loop_names;
use crate::mobility::loops::Loops;
use crate::mobility::motion::list;
use crate::mobility::null_space::{LITTLE, NEARLY_ZERO, largest};
use crate::mobility::position::{LoopRows, Position};
use crate::mobility::{motion, rows};
use crate::model::Type;

/// The greatest number of loops in a message.
const TOLD: usize = 6;

/// The text about the position in which loops come nearest to closing.
pub(crate) struct Nearest {
    /// `loop 1 by 12.3mm and loop 4 by -2.1mm`, the largest first.
    pub(crate) missing: String,
    /// `body` can turn about ...
    pub(crate) motion: Option<String>,
}

/// Returns the position in which the loops come nearest to closing; nothing if they close, or if
/// that is not found.
pub(crate) fn nearest(position: &Position<'_, '_>) -> Option<Nearest> {
    let graph = Graph::new();
    let mut loops = Loops::new(position.mechanism, &graph);
    let (there, rows) = minimise(&mut loops, position.clone())?;
    let most = largest(&rows.missed);
    (most > CLOSED).then(|| Nearest {
        missing: missing(&there, &rows, &loops),
        motion: motion::motion(&there, &rows, NEARLY_ZERO),
    })
}

/// Returns the error of each loop, the largest first.
fn missing(position: &Position<'_, '_>, rows: &LoopRows, loops: &Loops) -> String {
    let mut all: Vec<(usize, f64, Vec<f64>)> = Vec::new();
    for (row, (&index, missed)) in rows.loops.iter().zip(&rows.missed).enumerate() {
        let value = missed * loops.unit(rows.kept[row], position.length);
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
        let ty = &position.mechanism.loops[*index].left.ty;
        let by = match (ty, &value[..]) {
            (Type::Scalar(dimension), [x]) if dimension.half_lengths <= 2 => {
                position.words.rounded(*dimension, *x)
            }
            _ => position.words.value(ty, value),
        };
        format!("{} by {by}", loop_names(position.mechanism, [index]))
    });
    let told: Vec<String> = told.collect();
    match all.len() - told.len() {
        0 => list(told),
        more => format!("{}, and {more} more by less", told.join(", ")),
    }
}

impl<'w, 'm> Equations<Position<'w, 'm>> for Loops<'_> {
    type Rows = LoopRows;

    fn rows(&mut self, at: &Position<'w, 'm>) -> Option<LoopRows> {
        rows::rows(at, self)
    }

    fn misses(&mut self, at: &Position<'w, 'm>, rows: &LoopRows) -> Vec<f64> {
        let all = self.missed(at, &at.values);
        rows.kept.iter().map(|&k| all[k]).collect()
    }

    fn after(
        &mut self,
        at: &Position<'w, 'm>,
        rows: &LoopRows,
        changes: &[f64],
    ) -> Position<'w, 'm> {
        let mut next = at.clone();
        for (&column, change) in rows.columns.iter().zip(changes) {
            at.shift(&mut next.values, column, *change);
        }
        next
    }
}

impl least_squares::Rows for LoopRows {
    fn missed(&self) -> &[f64] {
        &self.missed
    }

    fn matrix(&self) -> &[Vec<f64>] {
        &self.matrix
    }
}
