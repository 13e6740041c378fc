//! How points move where nothing closes the loops: each unknown by itself, as its name says. So what is written as one link is told from
//! what is only held together by others.

use crate::algebra::translate;
use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId, Vn};

use crate::algebra::{Algebra, Bound, Nominal, Translate};
use crate::machine::{Machine, Reference, other_inputs, scattered};
use crate::model::{Dimension, Expr, ExprKind, Loop};

use super::samples::divided;

/// Vectors at several places or of several motions.
pub(super) type Track = Vec<Vec<f64>>;

/// Steps of differences, in radians and in shares of the longest length: their error is of the second order, 1e-10, and as large as
/// that of rounding.
const STEP: f64 = 1e-5;

/// How far from where the mechanism closes it is looked at, in radians and shares of the longest length: links that happen to lie on one
/// line there do not turn each other, and do not seem to be one.
const APART: f64 = 0.01;

/// A velocity is zero, and a rate follows from others, if what is left is a smaller share: far above the error of differences.
const NOTHING: f64 = 1e-6;

/// Motions at each place; more than the rates that one is compared with.
const MOTIONS: usize = 12;

pub(super) struct Free<'a> {
    machine: &'a Machine,
    /// Near the places where the mechanism closes.
    places: Vec<Values>,
    /// All motions at the first place, then at the next.
    motions: Vec<Motion>,
    /// At each place.
    count: usize,
    /// Rates at which angles leave the relations between them, by relation: zero in every motion that is meant.
    relations: Vec<Vec<f64>>,
}

/// Inputs and unknowns.
type Values = (Vec<f64>, Map<SymbolId, f64>);

/// Both sides of a place.
struct Motion {
    sides: [Values; 2],
}

impl<'a> Free<'a> {
    pub(super) fn new(algebra: &mut Algebra, reference: &'a Reference, nominal: &Nominal) -> Self {
        let machine = &reference.machine;
        let mechanism = algebra.mechanism;
        let loops = mechanism.loops.iter().filter(|own| relates_angles(own));
        let loops: Vec<Ex> = loops
            .map(|own| {
                let [left, right] = [&own.left, &own.right].map(|side| {
                    let value = algebra.translate(side);
                    translate::number(algebra, &value)
                });
                left - right
            })
            .collect();
        let count = MOTIONS + loops.len();
        let places = other_inputs(nominal, mechanism, reference.longest).into_iter();
        let places = places.filter_map(|place| Place::at(algebra, reference, place));
        let places: Vec<Place> = places.map(|place| place.moved(APART, count)).collect();
        let motions = places.iter().flat_map(|place| {
            (0..count).map(move |number| Motion {
                sides: [-1.0, 1.0].map(|side| place.moved(side * STEP, number).values()),
            })
        });
        let mut free = Self {
            machine,
            motions: motions.collect(),
            places: places.iter().map(Place::values).collect(),
            count,
            relations: Vec::new(),
        };
        let relations = loops.into_iter().map(|own| free.rates(&[own]).concat());
        free.relations = relations.collect();
        free
    }

    /// Where points are at each place, then their velocities in each motion.
    pub(super) fn courses(&self, vectors: &[Vn]) -> Vec<Track> {
        let numbers: Vec<Ex> = vectors.iter().flat_map(|own| own.iter()).collect();
        let places = self.places.iter();
        let places = places.map(|(inputs, unknowns)| {
            let machine = self.machine;
            machine.evaluate_open(&numbers, inputs, unknowns)
        });
        divided(&places.chain(self.rates(&numbers)).collect(), vectors)
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

    /// Whether a point does not move, in a picture of this size.
    pub(super) fn rests(&self, course: &Track, size: f64) -> bool {
        course[self.places.len()..]
            .iter()
            .flatten()
            .all(|speed| speed.abs() <= NOTHING * size)
    }

    /// The rate of half the square of the distance of two points, in each motion.
    pub(super) fn stretching(&self, ends: [&Track; 2]) -> Rate {
        let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let minus =
            |[a, b]: [&Vec<f64>; 2]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
        let mut rate = Rate::default();
        for motion in 0..self.motions.len() {
            let between = minus(ends.map(|own| &own[motion / self.count]));
            let speeds = ends.map(|own| &own[self.places.len() + motion]);
            let product = between.iter().zip(minus(speeds)).map(|(x, v)| x * v);
            rate.values.push(product.sum());
            let fastest: f64 = speeds.iter().map(|own| norm(own)).sum();
            rate.sizes.push(norm(&between) * fastest);
        }
        rate
    }

    /// Whether a rate is zero whenever the others are: place by place it is a sum of multiples of them.
    pub(super) fn follows(&self, rate: &Rate, others: &[&Rate]) -> bool {
        let others = others.iter().map(|own| &own.values);
        let columns: Vec<&Vec<f64>> = self.relations.iter().chain(others).collect();
        (0..self.places.len()).all(|place| {
            let own = place * self.count..(place + 1) * self.count;
            let mut rest = rate.values[own.clone()].to_vec();
            let mut basis: Vec<Vec<f64>> = Vec::new();
            for column in &columns {
                let mut column = column[own.clone()].to_vec();
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
            length(&rest) <= NOTHING * length(&rate.sizes[own])
        })
    }
}

/// How fast a distance changes in each motion, and how fast its ends move.
#[derive(Clone, Debug, Default)]
pub(super) struct Rate {
    values: Vec<f64>,
    sizes: Vec<f64>,
}

/// Inputs and unknowns where the mechanism closes.
struct Place {
    inputs: Vec<(f64, f64)>,
    /// Cosine, sine and value.
    angles: Vec<([SymbolId; 3], f64)>,
    lengths: Vec<(SymbolId, f64, f64)>,
}

impl Place {
    fn at(algebra: &Algebra, reference: &Reference, inputs: Vec<f64>) -> Option<Self> {
        let machine = &reference.machine;
        let unit = |dimension: Dimension| match dimension.fits(Dimension::LENGTH) {
            true => reference.longest,
            false => 1.0,
        };
        let mut place = Self {
            inputs: Vec::new(),
            angles: Vec::new(),
            lengths: Vec::new(),
        };
        let unknowns = 0..algebra.names.bound.len();
        let numbers: Vec<Vec<Ex>> = unknowns.map(|own| algebra.names.numbers_of(own)).collect();
        let all = machine.evaluate(&numbers.concat(), &inputs);
        if all.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let mut all = all.into_iter();
        for (unknown, (bound, numbers)) in algebra.names.bound.iter().zip(&numbers).enumerate() {
            let values: Vec<f64> = all.by_ref().take(numbers.len()).collect();
            match bound {
                Bound::Angle(angle) => {
                    let symbols = algebra.names.angles[*angle].symbols();
                    place.angles.push((symbols, values[1].atan2(values[0])));
                }
                Bound::Lengths(symbols) => {
                    let dimension = algebra.mechanism.unknowns[unknown].ty.dimension();
                    let unit = dimension.map_or(1.0, unit);
                    let each = symbols.iter().zip(values);
                    let each = each.map(|((symbol, _), value)| (*symbol, value, unit));
                    place.lengths.extend(each);
                }
            }
        }
        let own = inputs.iter().zip(&algebra.mechanism.inputs);
        place.inputs = own.map(|(x, input)| (*x, unit(input.dimension))).collect();
        Some(place)
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
pub(super) fn relates_angles(own: &Loop) -> bool {
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
    let angle = own
        .left
        .ty
        .dimension()
        .is_some_and(|own| own.half_lengths == 0);
    angle && simple(&own.left) && simple(&own.right)
}

fn remove(rest: &mut [f64], unit: &[f64]) {
    let share: f64 = rest.iter().zip(unit).map(|(x, u)| x * u).sum();
    rest.iter_mut().zip(unit).for_each(|(x, u)| *x -= share * u);
}

fn length(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
