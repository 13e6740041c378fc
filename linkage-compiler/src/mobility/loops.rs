//! All loops on numbers, as they are written.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, SymbolId, evaluate_given, lookup::Map};

use crate::algebra::{Bound, Names, Translate, Value, scalar, translate};
use crate::mobility::position::{Position, halves};
use crate::model::{Loop, Mechanism, unknown_frames};

/// The differences of the sides of all loops, one for each component.
pub(crate) struct Loops<'g> {
    names: Names<'g>,
    sides: Vec<Ex<'g>>,
    /// The loop of each row, and the dimension of its sides in halves of lengths.
    rows: Vec<(usize, i32)>,
}

impl<'g> Loops<'g> {
    /// In a graph of their own: nodes made in another order would change how sums of the mechanism
    /// are written.
    pub(crate) fn new(mechanism: &'g Mechanism, graph: &'g Graph) -> Self {
        let mut names = Names::new(mechanism, graph);
        translate::translate_lets(&mut names);
        let (mut sides, mut rows) = (Vec::new(), Vec::new());
        for (index, equation) in mechanism.loops.iter().enumerate() {
            if unknown_frames::is_loop_of_frame(mechanism, index) {
                continue;
            }
            let halves = halves(&equation.left.ty).max(halves(&equation.right.ty));
            for row in difference(&mut names, equation) {
                rows.push((index, halves));
                sides.push(row);
            }
        }
        Self { names, sides, rows }
    }

    /// The loop that a row is of.
    pub(crate) fn of_row(&self, row: usize) -> usize {
        self.rows[row].0
    }

    /// Returns the size of a row in its unit, where this length counts like a radian.
    pub(crate) fn unit(&self, row: usize, length: f64) -> f64 {
        length.powf(0.5 * f64::from(self.rows[row].1))
    }

    /// The sides' differences where unknowns have these values, as shares of the length that counts
    /// like a radian.
    pub(crate) fn missed(&self, position: &Position, values: &[Vec<f64>]) -> Vec<f64> {
        let nominal = position.nominal;
        let mut known: Map<SymbolId, f64> = Map::new();
        for (bound, value) in self.names.bound.iter().zip(values) {
            match bound {
                Bound::Angle(angle) => {
                    let symbols = &self.names.angles[*angle];
                    let (sin, cos) = value[0].sin_cos();
                    known.extend([
                        (symbols.cos, cos),
                        (symbols.sin, sin),
                        (symbols.value, value[0]),
                    ]);
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
pub(crate) fn difference<'m>(names: &mut Names<'m>, equation: &Loop) -> Vec<Ex<'m>> {
    let [left, right] = [&equation.left, &equation.right].map(|side| names.translate(side));
    match (&left, &right) {
        (Value::Scalar(_), Value::Scalar(_)) => {
            vec![scalar::number(names, &left) - scalar::number(names, &right)]
        }
        _ => {
            let difference = scalar::vector(names, &left) - scalar::vector(names, &right);
            difference.iter().collect()
        }
    }
}
