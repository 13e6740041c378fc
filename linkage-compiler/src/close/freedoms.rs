//! In which ways the unknowns of a singular group can still move, in words: the null vectors of its loops.
//!
//! A body counts as a whole: its loops are differentiated by shifts and turns, not by the unknowns that it consists of.

mod line;
mod motion;
mod null;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, SymbolId, evaluate_given, unordered::Map};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::formulate::Prepared;
use crate::model::{Mechanism, Type};
use crate::structure::Core;
use crate::structure::report::loop_list;
use crate::vector::{Vector, cross};

use super::redundant::difference;
use super::reference::Assembly;
use super::words::Words;

/// Differences over twice this step have an error of its square, and as much rounding.
const STEP: f64 = 1e-5;

/// What can change on its own.
#[derive(Clone, Debug)]
enum Mover {
    /// A body in space, by its name, its origin and two of its axes: three shifts and three turns.
    Body {
        name: String,
        origin: usize,
        axes: [usize; 2],
    },
    /// One component of an unknown.
    Component { unknown: usize, component: usize },
}

/// A column of the matrix: what changes, and in which of its ways.
type Column = (usize, usize);

/// The loops about a position.
struct Position<'w, 'm> {
    mechanism: &'m Mechanism,
    words: &'w Words<'m>,
    /// The length that counts like a radian.
    length: f64,
    /// By unknown, with all components; NaN for what later groups find.
    values: Vec<Vec<f64>>,
    movers: Vec<Mover>,
}

/// The rows of the loops, each with the loop that it is of.
struct Rows {
    loops: Vec<usize>,
    columns: Vec<Column>,
    matrix: Vec<Vec<f64>>,
}

impl<'m> Assembly<'_, 'm> {
    /// How the mechanism moves where a group has this state, and which loops leave it free; nothing where it is not singular.
    pub(super) fn freedom_at(&self, prepared: &Prepared<'m>, state: &[f64]) -> Option<String> {
        let mechanism = self.algebra.mechanism;
        let position = Position {
            mechanism,
            words: &self.words,
            length: self.longest,
            values: self.standing(prepared, state),
            movers: movers(mechanism),
        };
        let rows = position.rows(self.nominal)?;
        let motion = position.motion(&rows)?;
        Some(match position.dependence(&rows) {
            Some(dependence) => format!("{motion}, since {dependence}"),
            None => motion,
        })
    }

    /// All unknowns where a group has this state.
    fn standing(&self, prepared: &Prepared<'m>, state: &[f64]) -> Vec<Vec<f64>> {
        let names = &self.algebra.names;
        let mut known: Map<SymbolId, f64> = Map::new();
        let mut numbers = prepared.unscaled(self.nominal, state).into_iter();
        for core in prepared.core() {
            let symbols = match *core {
                Core::Angle(angle) => vec![names.angles[angle].cos, names.angles[angle].sin],
                Core::Length { symbol, .. } => vec![symbol],
            };
            known.extend(symbols.into_iter().zip(&mut numbers));
        }
        let all = (0..names.bound.len()).map(|unknown| {
            let numbers = names.numbers_of(unknown);
            let found = self
                .machine
                .evaluate_open(&numbers, &self.nominal.inputs, &known);
            match names.bound[unknown] {
                Bound::Angle(_) => vec![found[1].atan2(found[0])],
                Bound::Lengths(_) => found,
            }
        });
        all.collect()
    }
}

/// Bodies, and what is no part of one.
fn movers(mechanism: &Mechanism) -> Vec<Mover> {
    let bodies = mechanism.bodies_of_space();
    let is_part = |unknown: &usize| bodies.iter().any(|(_, parts)| parts.contains(unknown));
    let alone = (0..mechanism.unknowns.len()).filter(|unknown| !is_part(unknown));
    let alone = alone.flat_map(|unknown| {
        let count = mechanism.unknowns[unknown].ty.components().unwrap_or(1);
        (0..count).map(move |component| Mover::Component { unknown, component })
    });
    let bodies = bodies.iter().map(|(name, parts)| Mover::Body {
        name: name.clone(),
        origin: parts[0],
        axes: [parts[1], parts[2]],
    });
    bodies.chain(alone).collect()
}

impl<'m> Position<'_, 'm> {
    /// The derivatives of all loops that can be evaluated, by all that is known to be somewhere.
    fn rows(&self, nominal: &Nominal) -> Option<Rows> {
        // A graph of its own: nodes made in another order would change how sums of the mechanism are written.
        let graph = Graph::new();
        let mut algebra = Algebra::new(self.mechanism, &graph);
        algebra.translate_lets();
        let mut loops = Vec::new();
        let mut sides = Vec::new();
        for (index, own) in self.mechanism.loops.iter().enumerate() {
            if self.mechanism.is_loop_of_frame(index) {
                continue;
            }
            let unit = self
                .length
                .powf(0.5 * f64::from(halves(&own.left.ty).max(halves(&own.right.ty))));
            for row in difference(&mut algebra, own) {
                loops.push((index, unit));
                sides.push(row);
            }
        }
        let at = |values: &[Vec<f64>]| open(&algebra, nominal, &sides, values);
        let here = at(&self.values);
        let kept: Vec<usize> = (0..sides.len()).filter(|&k| here[k].is_finite()).collect();
        let columns = self.columns();
        let mut matrix = vec![vec![0.0; columns.len()]; kept.len()];
        for (place, &column) in columns.iter().enumerate() {
            let [before, after] = [-STEP, STEP].map(|step| at(&self.moved(column, step)));
            for (row, &k) in matrix.iter_mut().zip(&kept) {
                row[place] = (after[k] - before[k]) / (2.0 * STEP * loops[k].1);
            }
        }
        let finite = matrix.iter().flatten().all(|x| x.is_finite());
        let loops = kept.iter().map(|&k| loops[k].0).collect();
        finite.then_some(Rows {
            loops,
            columns,
            matrix,
        })
    }

    fn columns(&self) -> Vec<Column> {
        let movers = self.movers.iter().enumerate();
        let ways = movers.filter_map(|(index, mover)| match mover {
            Mover::Body { origin, axes, .. } => {
                let mut parts = [*origin, axes[0], axes[1]].into_iter();
                let known = parts.all(|part| self.values[part].iter().all(|x| x.is_finite()));
                known.then_some((index, 6))
            }
            Mover::Component { unknown, component } => {
                let known = self.values[*unknown][*component].is_finite();
                known.then_some((index, 1))
            }
        });
        let columns = ways.flat_map(|(index, count)| (0..count).map(move |way| (index, way)));
        columns.collect()
    }

    /// All unknowns after a small change.
    fn moved(&self, (mover, way): Column, step: f64) -> Vec<Vec<f64>> {
        let mut values = self.values.clone();
        match &self.movers[mover] {
            Mover::Body { origin, .. } if way < 3 => values[*origin][way] += step * self.length,
            Mover::Body { axes, .. } => {
                let about: Vector = [0, 1, 2].map(|k| if k == way - 3 { step } else { 0.0 });
                for &axis in axes {
                    let own = [0, 1, 2].map(|k| values[axis][k]);
                    let turned = cross(about, own);
                    (0..3).for_each(|k| values[axis][k] += turned[k]);
                }
            }
            Mover::Component { unknown, component } => {
                values[*unknown][*component] += step * self.unit(*unknown);
            }
        }
        values
    }

    /// What of an unknown counts like a radian.
    fn unit(&self, unknown: usize) -> f64 {
        match halves(&self.mechanism.unknowns[unknown].ty) {
            0 => 1.0,
            _ => self.length,
        }
    }

    /// Which loops say the same.
    fn dependence(&self, rows: &Rows) -> Option<String> {
        let transposed = null::transposed(&rows.matrix);
        let weights = null::vectors(&transposed, rows.matrix.len())
            .into_iter()
            .next()?;
        let largest = null::largest(&weights);
        let bound = (0..weights.len()).filter(|&k| weights[k].abs() > null::LITTLE * largest);
        let bound: Vec<usize> = bound.collect();
        let loops: Vec<usize> = bound.iter().map(|&k| rows.loops[k]).collect();
        if let Some(shape) = self.shape_of_links(rows, &bound) {
            return Some(format!("the links of {} {shape}", loop_list(&loops)));
        }
        (loops.len() > 1).then(|| {
            format!(
                "{} do not hold independently of each other",
                loop_list(&loops)
            )
        })
    }
}

fn halves(ty: &Type) -> i32 {
    ty.dimension().map_or(0, |own| own.half_lengths)
}

/// The sides' differences where unknowns have these values.
fn open(algebra: &Algebra, nominal: &Nominal, sides: &[Ex], values: &[Vec<f64>]) -> Vec<f64> {
    let mut known: Map<SymbolId, f64> = Map::new();
    for (bound, value) in algebra.names.bound.iter().zip(values) {
        match bound {
            Bound::Angle(angle) => {
                let own = &algebra.names.angles[*angle];
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
    evaluate_given(sides, load, |symbol| known.get(&symbol).copied())
}
