//! Formulas of the four operations with twice the digits of a number.

use std::f64::consts::FRAC_PI_2;

use linkage_symbolic::program::{Binary, Unary};

use crate::formula::{Formula, Operation};
use crate::numbers::Values;

/// The sum of two numbers, the second below the last place of the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    high: f64,
    low: f64,
    /// All terms of sums with the same sign: what roundings are measured by.
    size: f64,
}

impl Exact {
    /// How far a number is from it, as a part of its size.
    pub(crate) fn error(&self, value: f64) -> f64 {
        let distance = ((value - self.high) - self.low).abs();
        // What twice the digits leave unknown, of all operations of a formula.
        let unknown = 16.0 * f64::EPSILON * f64::EPSILON * self.size;
        match distance <= unknown {
            true => 0.0,
            // Products of roundings.
            false => distance / self.size * (1.0 - 8.0 * f64::EPSILON),
        }
    }
}

/// The value of a formula before all rounding.
pub(crate) fn exact(formula: &Formula, values: &Values) -> Exact {
    let number = |x: f64| Exact {
        high: x,
        low: 0.0,
        size: x.abs(),
    };
    match formula {
        Formula::Number(x) => number(*x),
        Formula::Letter(letter) => number(values.of_letter(*letter)),
        Formula::Of(operation, parts) => {
            let parts: Vec<Exact> = parts.iter().map(|part| exact(part, values)).collect();
            match (operation, &parts[..]) {
                (Operation::Unary(Unary::Neg), &[a]) => negative(a),
                (Operation::Unary(Unary::Sin), &[x]) => sine(x, 0),
                (Operation::Unary(Unary::Cos), &[x]) => sine(x, 1),
                (Operation::Binary(Binary::Add), &[a, b]) => sum(a, b),
                (Operation::Binary(Binary::Sub), &[a, b]) => sum(a, negative(b)),
                (Operation::Binary(Binary::Mul), &[a, b]) => product(a, b),
                (Operation::Binary(Binary::Div), &[a, b]) => quotient(a, b),
                _ => panic!("{operation:?} is rounded in its own way"),
            }
        }
    }
}

/// The largest angle that [`sine`] knows.
pub(crate) const ANGLE: f64 = 10.0;

/// The sine of an angle and some right angles: its series about the nearest multiple of a right angle.
fn sine(x: Exact, quarters: i32) -> Exact {
    let right = Exact {
        high: FRAC_PI_2,
        low: 6.123_233_995_736_766e-17,
        size: FRAC_PI_2,
    };
    let number = |x: f64| Exact {
        high: x,
        low: 0.0,
        size: x.abs(),
    };
    let n = (x.high / FRAC_PI_2).round();
    let rest = sum(x, product(number(-n), right));
    let turns = n as i32 + quarters;
    let first = match turns.rem_euclid(2) {
        0 => rest,
        _ => number(1.0),
    };
    let square = negative(product(rest, rest));
    let (mut term, mut total) = (first, first);
    let mut k = f64::from(1 - turns.rem_euclid(2));
    for _ in 0..16 {
        term = quotient(product(term, square), number((k + 1.0) * (k + 2.0)));
        total = sum(total, term);
        k += 2.0;
    }
    let total = Exact {
        size: total.high.abs(),
        ..total
    };
    match turns.rem_euclid(4) {
        0 | 1 => total,
        _ => negative(total),
    }
}

fn negative(a: Exact) -> Exact {
    Exact {
        high: -a.high,
        low: -a.low,
        ..a
    }
}

fn sum(a: Exact, b: Exact) -> Exact {
    let high = a.high + b.high;
    let part = high - a.high;
    let lost = (a.high - (high - part)) + (b.high - part);
    normal(high, lost + (a.low + b.low), a.size + b.size)
}

fn product(a: Exact, b: Exact) -> Exact {
    let high = a.high * b.high;
    let lost = a.high.mul_add(b.high, -high);
    let cross = a.high * b.low + a.low * b.high;
    normal(high, lost + cross, a.size * b.size)
}

fn quotient(a: Exact, b: Exact) -> Exact {
    let high = a.high / b.high;
    let rest = (-high).mul_add(b.high, a.high) + (a.low - high * b.low);
    normal(high, rest / b.high, a.size / b.high.abs())
}

fn normal(high: f64, low: f64, size: f64) -> Exact {
    let sum = high + low;
    Exact {
        high: sum,
        low: low - (sum - high),
        size,
    }
}
