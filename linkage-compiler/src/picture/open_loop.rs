//! The motion of points if nothing closes the loops: each unknown changes alone. So a link that is
//! written as one is distinguished from points that only other links hold together.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId, Vn};

use crate::algebra::{Algebra, Bound, Nominal, Translate, scalar};
use crate::machine::{Machine, Reference, other_inputs, scattered};
use crate::model::{Dimension, Expr, ExprKind, Loop};
use crate::picture::track::{self, Track};

/// Steps of differences, in radians and in shares of the longest length: their error is of the
/// second order, 1e-10, and as large as that of rounding.
const STEP: f64 = 1e-5;

/// The distance of the sampled states from the closed mechanism, in radians and shares of the
/// longest length. Links that lie on one line in the closed state do not turn each other there, and
/// do not seem to be one.
const APART: f64 = 0.01;

/// A velocity is zero, and a rate follows from others, if the remainder is a smaller share: far
/// above the error of differences.
const NOTHING: f64 = 1e-6;

/// Motions at each place; more than the rates that one is compared with.
const MOTIONS: usize = 12;

pub(super) struct OpenLoop<'a> {
    machine: &'a Machine,
    /// Near the places where the mechanism closes.
    places: Vec<Values>,
    /// All motions at the first place, then at the next.
    motions: Vec<Motion>,
    /// At each place.
    count: usize,
    /// Rates at which angles leave the relations between them, by relation: zero in every motion
    /// that is meant.
    relations: Vec<Vec<f64>>,
}

/// Inputs and unknowns.
type Values = (Vec<f64>, Map<SymbolId, f64>);

/// Both sides of a place.
struct Motion {
    sides: [Values; 2],
}

impl<'a> OpenLoop<'a> {
    pub(super) fn new(algebra: &mut Algebra, reference: &'a Reference, nominal: &Nominal) -> Self {
        let machine = &reference.machine;
        let mechanism = algebra.mechanism;
        let loops = mechanism
            .loops
            .iter()
            .filter(|equation| relates_angles(equation));
        let loops: Vec<Ex> = loops
            .map(|equation| {
                let [left, right] = [&equation.left, &equation.right].map(|side| {
                    let value = algebra.translate(side);
                    scalar::number(&algebra.names, &value)
                });
                left - right
            })
            .collect();
        let count = MOTIONS + loops.len();
        let places = other_inputs(nominal, mechanism, reference.longest).into_iter();
        let places = places.filter_map(|inputs| OpenState::at_closure(algebra, reference, inputs));
        let places: Vec<OpenState> = places.map(|state| state.moved(APART, count)).collect();
        let motions = places.iter().flat_map(|state| {
            (0..count).map(move |number| Motion {
                sides: [-1.0, 1.0].map(|side| state.moved(side * STEP, number).values()),
            })
        });
        let mut free = Self {
            machine,
            motions: motions.collect(),
            places: places.iter().map(OpenState::values).collect(),
            count,
            relations: Vec::new(),
        };
        let relations = loops
            .into_iter()
            .map(|difference| free.rates(&[difference]).concat());
        free.relations = relations.collect();
        free
    }

    /// Positions of points at each place, then their velocities in each motion.
    pub(super) fn courses(&self, vectors: &[Vn]) -> Vec<Track> {
        let numbers: Vec<Ex> = vectors.iter().flat_map(|vector| vector.iter()).collect();
        let places = self.places.iter();
        let places = places.map(|(inputs, unknowns)| {
            let machine = self.machine;
            machine.evaluate_open(&numbers, inputs, unknowns)
        });
        track::divided(&places.chain(self.rates(&numbers)).collect(), vectors)
    }

    fn rates(&self, numbers: &[Ex]) -> Track {
        let rate = |motion: &Motion| -> Vec<f64> {
            let [low, high] = motion
                .sides
                .each_ref()
                .map(|(inputs, unknowns)| self.machine.evaluate_open(numbers, inputs, unknowns));
            let pairs = low.iter().zip(&high);
            pairs.map(|(a, b)| (b - a) / (2.0 * STEP)).collect()
        };
        self.motions.iter().map(rate).collect()
    }

    /// True if a point does not move, in a picture of this size.
    pub(super) fn rests(&self, course: &Track, size: f64) -> bool {
        course[self.places.len()..]
            .iter()
            .flatten()
            .all(|speed| speed.abs() <= NOTHING * size)
    }

    /// Returns true if a unit vector does not turn, as far as the relations between angles hold.
    pub(super) fn stays(&self, course: &Track) -> bool {
        let speeds = &course[self.places.len()..];
        let components = 0..speeds.first().map_or(0, Vec::len);
        components.into_iter().all(|component| {
            let values = speeds.iter().map(|speed| speed[component]);
            let rate = Rate {
                values: values.collect(),
                sizes: vec![1.0; speeds.len()],
            };
            self.follows(&rate, &[])
        })
    }

    /// The rate of half the square of the distance of two points, in each motion.
    pub(super) fn stretching(&self, ends: [&Track; 2]) -> Rate {
        let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let minus =
            |[a, b]: [&Vec<f64>; 2]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
        let mut rate = Rate::default();
        for motion in 0..self.motions.len() {
            let between = minus(ends.map(|track| &track[motion / self.count]));
            let speeds = ends.map(|track| &track[self.places.len() + motion]);
            let product = between.iter().zip(minus(speeds)).map(|(x, v)| x * v);
            rate.values.push(product.sum());
            let fastest: f64 = speeds.iter().map(|speed| norm(speed)).sum();
            rate.sizes.push(norm(&between) * fastest);
        }
        rate
    }

    /// True if a rate is zero whenever the others are: place by place it is a sum of multiples of
    /// them.
    pub(super) fn follows(&self, rate: &Rate, others: &[&Rate]) -> bool {
        let others = others.iter().map(|rate| &rate.values);
        let columns: Vec<&Vec<f64>> = self.relations.iter().chain(others).collect();
        (0..self.places.len()).all(|index| {
            let range = index * self.count..(index + 1) * self.count;
            let mut rest = rate.values[range.clone()].to_vec();
            let mut basis: Vec<Vec<f64>> = Vec::new();
            for column in &columns {
                let mut column = column[range.clone()].to_vec();
                let before = length(&column);
                basis.iter().for_each(|unit| remove(&mut column, unit));
                let after = length(&column);
                if after > NOTHING * before {
                    column.iter_mut().for_each(|x| *x /= after);
                    basis.push(column);
                }
            }
            // Once more for what rounding left.
            for _ in 0..2 {
                basis.iter().for_each(|unit| remove(&mut rest, unit));
            }
            length(&rest) <= NOTHING * length(&rate.sizes[range])
        })
    }
}

/// The rate of a distance in each motion, and the speed of its ends.
#[derive(Clone, Debug, Default)]
pub(super) struct Rate {
    values: Vec<f64>,
    sizes: Vec<f64>,
}

/// Inputs and unknowns where the mechanism closes.
struct OpenState {
    inputs: Vec<(f64, f64)>,
    /// Cosine, sine and value.
    angles: Vec<([SymbolId; 3], f64)>,
    lengths: Vec<(SymbolId, f64, f64)>,
}

impl OpenState {
    fn at_closure(algebra: &Algebra, reference: &Reference, inputs: Vec<f64>) -> Option<Self> {
        let machine = &reference.machine;
        let unit = |dimension: Dimension| {
            if dimension.fits(Dimension::LENGTH) {
                reference.longest
            } else {
                1.0
            }
        };
        let mut state = Self {
            inputs: Vec::new(),
            angles: Vec::new(),
            lengths: Vec::new(),
        };
        let unknowns = 0..algebra.names.bound.len();
        let numbers: Vec<Vec<Ex>> = unknowns
            .map(|unknown| algebra.names.numbers_of(unknown))
            .collect();
        let values = machine.evaluate(&numbers.concat(), &inputs);
        if values.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let mut values = values.into_iter();
        for (unknown, (bound, numbers)) in algebra.names.bound.iter().zip(&numbers).enumerate() {
            let values: Vec<f64> = values.by_ref().take(numbers.len()).collect();
            match bound {
                Bound::Angle(angle) => {
                    let symbols = algebra.names.angles[*angle].symbols();
                    state.angles.push((symbols, values[1].atan2(values[0])));
                }
                Bound::Lengths(symbols) => {
                    let dimension = algebra.mechanism.unknowns[unknown].ty.dimension();
                    let unit = dimension.map_or(1.0, unit);
                    let each = symbols.iter().zip(values);
                    let each = each.map(|((symbol, _), value)| (*symbol, value, unit));
                    state.lengths.extend(each);
                }
            }
        }
        let pairs = inputs.iter().zip(&algebra.mechanism.inputs);
        state.inputs = pairs
            .map(|(x, input)| (*x, unit(input.dimension)))
            .collect();
        Some(state)
    }

    /// Everything moved a step, each by itself.
    fn moved(&self, step: f64, number: usize) -> Self {
        let mut shares = (0..).map(|index| step * scattered(index, number));
        let mut next = || shares.next().expect("there are infinitely many");
        let inputs = self.inputs.iter();
        let inputs = inputs.map(|(x, unit)| (x + unit * next(), *unit)).collect();
        let angles = self.angles.iter();
        let angles = angles
            .map(|(symbols, angle)| (*symbols, angle + next()))
            .collect();
        let lengths = self.lengths.iter();
        let lengths = lengths.map(|(symbol, x, unit)| (*symbol, x + unit * next(), *unit));
        Self {
            inputs,
            angles,
            lengths: lengths.collect(),
        }
    }

    fn values(&self) -> Values {
        let mut unknowns = Map::new();
        for ([cos, sin, value], angle) in &self.angles {
            unknowns.insert(*cos, angle.cos());
            unknowns.insert(*sin, angle.sin());
            unknowns.insert(*value, *angle);
        }
        for (symbol, length, _) in &self.lengths {
            unknowns.insert(*symbol, *length);
        }
        (self.inputs.iter().map(|(x, _)| *x).collect(), unknowns)
    }
}

/// `psi = 2 * theta + 30deg`: nothing but names and numbers, which no link is.
pub(super) fn relates_angles(equation: &Loop) -> bool {
    let simple = |expr: &Expr| {
        expr.parts().all(|part| {
            matches!(
                part.kind,
                ExprKind::Number(_)
                    | ExprKind::Name(_)
                    | ExprKind::Negate(_)
                    | ExprKind::Binary(..)
            )
        })
    };
    let angle = equation
        .left
        .ty
        .dimension()
        .is_some_and(|dimension| dimension.half_lengths == 0);
    angle && simple(&equation.left) && simple(&equation.right)
}

fn remove(rest: &mut [f64], unit: &[f64]) {
    let share: f64 = rest.iter().zip(unit).map(|(x, u)| x * u).sum();
    rest.iter_mut().zip(unit).for_each(|(x, u)| *x -= share * u);
}

fn length(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
