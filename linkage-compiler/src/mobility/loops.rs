//! All loops on numbers, as they are written.

use crate::algebra::translate;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, SymbolId, evaluate_given, lookup::Map};

use crate::algebra::{Algebra, Bound, Translate, Value};
use crate::model::{Loop, Mechanism};

use super::{Position, halves};

/// The differences of the sides of all loops, one for each component.
pub(super) struct Loops<'g> {
    algebra: Algebra<'g>,
    sides: Vec<Ex<'g>>,
    /// By row: its loop, and the dimension of its sides in halves of lengths.
    rows: Vec<(usize, i32)>,
}

impl<'g> Loops<'g> {
    /// In a graph of their own: nodes made in another order would change how sums of the mechanism are written.
    pub(super) fn new(mechanism: &'g Mechanism, graph: &'g Graph) -> Self {
        let mut algebra = Algebra::new(mechanism, graph);
        translate::translate_lets(&mut algebra);
        let (mut sides, mut rows) = (Vec::new(), Vec::new());
        for (index, own) in mechanism.loops.iter().enumerate() {
            if mechanism.is_loop_of_frame(index) {
                continue;
            }
            let halves = halves(&own.left.ty).max(halves(&own.right.ty));
            for row in difference(&mut algebra, own) {
                rows.push((index, halves));
                sides.push(row);
            }
        }
        Self {
            algebra,
            sides,
            rows,
        }
    }

    /// The loop that a row is of.
    pub(super) fn of_row(&self, row: usize) -> usize {
        self.rows[row].0
    }

    /// How much of its unit a row counts, where so much length counts like a radian.
    pub(super) fn unit(&self, row: usize, length: f64) -> f64 {
        length.powf(0.5 * f64::from(self.rows[row].1))
    }

    /// The sides' differences where unknowns have these values, as shares of the length that counts like a radian.
    pub(super) fn missed(&self, position: &Position, values: &[Vec<f64>]) -> Vec<f64> {
        let nominal = position.nominal;
        let mut known: Map<SymbolId, f64> = Map::new();
        for (bound, value) in self.algebra.names.bound.iter().zip(values) {
            match bound {
                Bound::Angle(angle) => {
                    let own = &self.algebra.names.angles[*angle];
                    let (sin, cos) = value[0].sin_cos();
                    known.extend([(own.cos, cos), (own.sin, sin), (own.value, value[0])]);
                }
                Bound::Lengths(symbols) => {
                    let symbols = symbols.iter().map(|(symbol, _)| *symbol);
                    known.extend(symbols.zip(value.iter().copied()));
                }
            }
        }
        let load = |source| match source {
            Source::Parameter(index) => nominal.parameters[index],
            Source::Input(index) => nominal.inputs.get(index).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        };
        let all = evaluate_given(&self.sides, load, |symbol| known.get(&symbol).copied());
        let all = all.into_iter().enumerate();
        all.map(|(row, x)| x / self.unit(row, position.length))
            .collect()
    }
}

/// The left side of a loop without the right one, by component.
pub(crate) fn difference<'m>(algebra: &mut Algebra<'m>, own: &Loop) -> Vec<Ex<'m>> {
    let [left, right] = [&own.left, &own.right].map(|side| algebra.translate(side));
    match (&left, &right) {
        (Value::Scalar(_), Value::Scalar(_)) => {
            vec![translate::number(algebra, &left) - translate::number(algebra, &right)]
        }
        _ => {
            let difference = translate::vector(algebra, &left) - translate::vector(algebra, &right);
            difference.iter().collect()
        }
    }
}
