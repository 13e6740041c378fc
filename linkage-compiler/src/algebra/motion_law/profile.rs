//! Laws of motion as expressions: one polynomial and one sine, whose numbers are chosen by zone and
//! by piece.

use linkage_symbolic::Ex;
use linkage_symbolic::program::Unary;

use crate::algebra::motion_law::piecewise::Choice;
use crate::algebra::motion_law::zones::{ORDERS, Zone};
use crate::algebra::motion_law::{piecewise, zones};
use crate::model::Law;

/// `s(x)` of the law that `choice` takes, one for each of its pieces, and its derivatives.
pub(crate) fn profile<'m>(x: Ex<'m>, choice: &Choice<'_, 'm>, laws: &[Law]) -> [Ex<'m>; ORDERS] {
    let coefficients = Coefficients { x, choice, laws };
    let y = x - coefficients.chosen(|zone| Some(zone.origin));
    let degree = laws
        .iter()
        .flat_map(|law| zones::zones(*law))
        .map(|zone| zone.polynomial.len() - 1);
    let degree = degree.max().unwrap_or(0);
    let polynomial: Vec<Ex> = (0..=degree)
        .map(|k| {
            coefficients.chosen(move |zone| Some(zone.polynomial.get(k).copied().unwrap_or(0.0)))
        })
        .collect();
    let waves = laws
        .iter()
        .flat_map(|law| zones::zones(*law))
        .any(|zone| zone.wave.is_some());
    let waves = waves.then(|| coefficients.waves(y));
    // The last one comes first: each derivative is known when the expression is made whose slope it
    // is.
    let mut all = [x; ORDERS];
    for order in (0..ORDERS).rev() {
        let slopes = polynomial.iter().enumerate().skip(order);
        let slopes: Vec<Ex> = slopes.map(|(k, &c)| zones::falling(k, order) * c).collect();
        let mut sum = evaluated(&slopes, y);
        if let Some(waves) = &waves {
            sum = match order {
                0 | 1 => sum - waves[order],
                _ => sum + waves[order],
            };
        }
        all[order] = match all.get(order + 1) {
            Some(&slope) => sum.with_slope(x, slope),
            None => sum,
        };
    }
    all
}

/// The numbers of laws as expressions.
struct Coefficients<'c, 'm> {
    x: Ex<'m>,
    choice: &'c Choice<'c, 'm>,
    laws: &'c [Law],
}

impl<'m> Coefficients<'_, 'm> {
    /// A number of the zone in which `x` lies, of the law that is chosen. A zone that needs none
    /// takes that of its neighbour, a law without any that of another.
    fn chosen(&self, of: impl Fn(&Zone) -> Option<f64>) -> Ex<'m> {
        let of_law = |law: &Law| {
            let zones = zones::zones(*law);
            let values: Vec<Option<f64>> = zones.iter().map(&of).collect();
            let first = values.iter().flatten().next()?;
            let values = piecewise::filled(&values, first).into_iter();
            let values: Vec<Ex> = values.map(|value| self.x.number(*value)).collect();
            let borders: Vec<Ex> = zones[1..]
                .iter()
                .map(|zone| self.x.number(zone.from))
                .collect();
            Some(Choice::new(self.x, &borders).among_pieces(&values))
        };
        let values: Vec<Option<Ex>> = self.laws.iter().map(of_law).collect();
        let Some(first) = values.iter().flatten().next() else {
            return self.x.number(0.0);
        };
        let values: Vec<Ex> = piecewise::filled(&values, first)
            .into_iter()
            .copied()
            .collect();
        self.choice.among_pieces(&values)
    }

    /// The sine and its derivatives, without the signs that these have.
    fn waves(&self, y: Ex<'m>) -> [Ex<'m>; ORDERS] {
        let frequency = self.chosen(|zone| zone.wave.as_ref().map(|wave| wave.frequency));
        let phase = frequency * y;
        let [sin, cos] = [Unary::Sin, Unary::Cos].map(|op| phase.unary(op));
        let amplitude = |order: usize| {
            self.chosen(move |zone| {
                Some(
                    zone.wave
                        .as_ref()
                        .map_or(0.0, |wave| wave.amplitudes[order]),
                )
            })
        };
        let first = amplitude(0);
        let mut amplitudes = [first; ORDERS];
        for order in 1..ORDERS {
            amplitudes[order] = match first.constant_value() {
                Some(_) => amplitude(order),
                // A product costs less than another choice.
                None => amplitudes[order - 1] * frequency,
            };
        }
        let [value, first, second, third] = amplitudes;
        [value * sin, first * cos, second * sin, third * cos]
    }
}

/// A polynomial; one with only odd or even powers is one in `y^2`.
fn evaluated<'m>(coefficients: &[Ex<'m>], y: Ex<'m>) -> Ex<'m> {
    let Some((&constant, powers)) = coefficients.split_first() else {
        return y.number(0.0);
    };
    let every_second = |from: usize| {
        powers
            .iter()
            .skip(from)
            .step_by(2)
            .copied()
            .collect::<Vec<Ex>>()
    };
    let (odd, even) = (every_second(0), every_second(1));
    let none = |powers: &[Ex]| powers.iter().all(|c| c.is_zero());
    let square = y * y;
    match (none(&odd), none(&even)) {
        (true, true) => constant,
        (false, true) => constant + y * scheme(&odd, square),
        (true, false) => constant + square * scheme(&even, square),
        (false, false) => constant + y * scheme(powers, y),
    }
}

/// Horner's scheme.
pub(crate) fn scheme<'m>(coefficients: &[Ex<'m>], y: Ex<'m>) -> Ex<'m> {
    let zero = y.number(0.0);
    coefficients.iter().rev().fold(zero, |sum, &c| c + y * sum)
}
