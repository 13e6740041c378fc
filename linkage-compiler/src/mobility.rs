//! In which ways unknowns can still move, in words, and what holds them too often: the null vectors of the loops, whether these close or not.
//!
//! A body counts as a whole: its loops are differentiated by shifts and turns, not by the unknowns that it consists of.

pub(crate) mod line;
pub(crate) mod loops;
pub(crate) mod motion;
pub(crate) mod nearest;
pub(crate) mod null_space;
pub(crate) mod overconstrained;

use linkage_core::numeric::least_squares::STEP;
use linkage_symbolic::Graph;

use crate::algebra::Nominal;
use crate::message_format::MessageFormat;
use crate::message_format::loop_list;
use crate::model::{Mechanism, Type};
use crate::vector::{Vector, cross, dot, norm};

use loops::Loops;
pub(crate) use loops::difference;
pub(crate) use nearest::Nearest;

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

/// Unknowns somewhere.
#[derive(Clone)]
pub(crate) struct Position<'w, 'm> {
    mechanism: &'m Mechanism,
    nominal: &'w Nominal,
    words: &'w MessageFormat<'m>,
    /// The length that counts like a radian.
    length: f64,
    /// By unknown, with all components; NaN for what is not known.
    values: Vec<Vec<f64>>,
    movers: Vec<Mover>,
}

/// The rows of the loops, each with the loop that it is of.
struct Rows {
    /// Their numbers among all rows: some cannot be evaluated.
    kept: Vec<usize>,
    loops: Vec<usize>,
    missed: Vec<f64>,
    columns: Vec<Column>,
    matrix: Vec<Vec<f64>>,
}

impl<'w, 'm> Position<'w, 'm> {
    /// The unknowns of a mechanism at these values, with all components; NaN for what is not known. `length` counts like a radian.
    pub(crate) fn new(
        words: &'w MessageFormat<'m>,
        nominal: &'w Nominal,
        length: f64,
        mut values: Vec<Vec<f64>>,
    ) -> Self {
        let mechanism = words.mechanism();
        let movers = movers(mechanism);
        for mover in &movers {
            if let Mover::Body { axes, .. } = mover {
                make_rigid(&mut values, *axes);
            }
        }
        Self {
            mechanism,
            nominal,
            words,
            length,
            values,
            movers,
        }
    }

    /// How the mechanism moves at a dead point, or shortly before one, and which loops leave it free; nothing where it is not singular.
    pub(crate) fn freedom(&self) -> Option<String> {
        let graph = Graph::new();
        let rows = self.rows(&Loops::new(self.mechanism, &graph))?;
        self.told(&rows, null_space::NEARLY_ZERO)
    }

    /// How the mechanism moves where too few loops hold it.
    pub(crate) fn motion_left(&self) -> Option<String> {
        let graph = Graph::new();
        let rows = self.rows(&Loops::new(self.mechanism, &graph))?;
        self.told(&rows, null_space::ZERO)
    }

    fn told(&self, rows: &Rows, last: f64) -> Option<String> {
        let motion = motion::motion(self, rows, last)?;
        let dependent = self.dependent(rows, last).into_iter().next();
        Some(
            match dependent.and_then(|own| self.dependence(rows, &own)) {
                Some(why) => format!("{motion}, since {why}"),
                None => motion,
            },
        )
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

impl Position<'_, '_> {
    /// The derivatives of all loops that can be evaluated, by all that is known to be somewhere.
    fn rows(&self, loops: &Loops) -> Option<Rows> {
        let at = |values: &[Vec<f64>]| loops.missed(self, values);
        let here = at(&self.values);
        let kept: Vec<usize> = (0..here.len()).filter(|&k| here[k].is_finite()).collect();
        let columns = self.columns();
        let mut matrix = vec![vec![0.0; columns.len()]; kept.len()];
        for (place, &column) in columns.iter().enumerate() {
            let [before, after] = [-STEP, STEP].map(|step| at(&self.moved(column, step)));
            for (row, &k) in matrix.iter_mut().zip(&kept) {
                row[place] = (after[k] - before[k]) / (2.0 * STEP);
            }
        }
        let finite = matrix.iter().flatten().all(|x| x.is_finite());
        let loops = kept.iter().map(|&k| loops.of_row(k)).collect();
        finite.then(|| Rows {
            loops,
            missed: kept.iter().map(|&k| here[k]).collect(),
            kept,
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

    /// All unknowns after a change.
    fn moved(&self, column: Column, step: f64) -> Vec<Vec<f64>> {
        let mut values = self.values.clone();
        self.shift(&mut values, column, step);
        values
    }

    fn shift(&self, values: &mut [Vec<f64>], (mover, way): Column, step: f64) {
        match &self.movers[mover] {
            Mover::Body { origin, .. } if way < 3 => values[*origin][way] += step * self.length,
            Mover::Body { axes, .. } => {
                let about: Vector = [0, 1, 2].map(|k| if k == way - 3 { 1.0 } else { 0.0 });
                let (sin, cos) = step.sin_cos();
                for &axis in axes {
                    let own = [0, 1, 2].map(|k| values[axis][k]);
                    let across = cross(about, own);
                    // What lies along the axis of the turn stays.
                    (0..3)
                        .filter(|&k| k != way - 3)
                        .for_each(|k| values[axis][k] = own[k] * cos + across[k] * sin);
                }
            }
            Mover::Component { unknown, component } => {
                values[*unknown][*component] += step * self.unit(*unknown);
            }
        }
    }

    /// What of an unknown counts like a radian.
    fn unit(&self, unknown: usize) -> f64 {
        match halves(&self.mechanism.unknowns[unknown].ty) {
            0 => 1.0,
            _ => self.length,
        }
    }

    /// The rows of each set that does not hold independently, none of which could be left out of it.
    fn dependent(&self, rows: &Rows, last: f64) -> Vec<Vec<usize>> {
        let transposed = null_space::transposed(&rows.matrix);
        let all = null_space::vectors(&transposed, rows.matrix.len(), last).into_iter();
        all.map(|weights| null_space::used(&weights)).collect()
    }

    /// Which loops say the same, if these rows do.
    fn dependence(&self, rows: &Rows, dependent: &[usize]) -> Option<String> {
        let loops: Vec<usize> = dependent.iter().map(|&k| rows.loops[k]).collect();
        if let Some(shape) = line::shape_of_links(self, rows, dependent) {
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

/// Axes of length 1 and perpendicular, if both are known: on a way to an assembly they are so but for what steps leave.
fn make_rigid(values: &mut [Vec<f64>], axes: [usize; 2]) {
    let [first, second]: [Vector; 2] = axes.map(|axis| [0, 1, 2].map(|k| values[axis][k]));
    let first = first.map(|x| x / norm(first));
    let along = dot(first, second);
    let second = [0, 1, 2].map(|k| second[k] - along * first[k]);
    let second = second.map(|x| x / norm(second));
    if first.iter().chain(&second).all(|x| x.is_finite()) {
        values[axes[0]] = first.to_vec();
        values[axes[1]] = second.to_vec();
    }
}

fn halves(ty: &Type) -> i32 {
    ty.dimension().map_or(0, |own| own.half_lengths)
}
