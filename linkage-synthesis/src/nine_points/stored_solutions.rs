//! Nine points whose solutions are stored: one of each three cognates, with the digits of a
//! single-precision number.
//!
//! The points are real, so that complex solutions are pairs of conjugates, of which one is stored.
//! How the file is made is in `tests/generator.rs`.

use super::equations::{Shifts, Unknowns, with_turns};
use linkage_core::numeric::complex::Complex;
use std::vec::Vec;

/// Two numbers: of real triples, and of complex ones that are their own conjugates (each cognate
/// that of another one). Then the real ones, `x`, `a`, `y`, `b` as real and imaginary part; the
/// others with the hats, too, of pairs of conjugates one.
static STORED: &[u8] = include_bytes!("starts.bin");

/// Bytes of a number.
const NUMBER: usize = 4;

/// Points 1 to 8 against point 0, thirty-seconds of the unit: without pattern, not too close to
/// each other.
#[rustfmt::skip]
const POINTS: [[i8; 2]; 8] =
    [[40, 23], [0, 33], [26, -21], [-25, -10], [-34, 16], [34, 1], [40, -37], [-35, 40]];

/// The points against the first one.
pub(super) fn shifts() -> Shifts<Complex> {
    POINTS.map(|point| {
        let [x, y] = point.map(|number| f64::from(number) / 32.0);
        [Complex::new(x, y), Complex::new(x, -y)]
    })
}

/// The solutions to the first digits, as many as there are.
pub(super) fn solutions() -> Vec<Unknowns<Complex>> {
    decoded(STORED)
}

pub(super) fn decoded(stored: &[u8]) -> Vec<Unknowns<Complex>> {
    let mut words = stored
        .chunks_exact(NUMBER)
        .map(|word| [word[0], word[1], word[2], word[3]]);
    let mut count = || words.next().map_or(0, u32::from_le_bytes) as usize;
    let (real, self_conjugate) = (count(), count());
    let numbers: Vec<f64> = words.map(|word| f32::from_le_bytes(word).into()).collect();
    let (first, others) = numbers.split_at(8 * real);
    let shifts = shifts();
    let mut solutions = Vec::new();
    for joints in first.chunks_exact(8) {
        let point = |i: usize| Complex::new(joints[2 * i], joints[2 * i + 1]);
        let joints = core::array::from_fn(|i| {
            let point = point(i / 2);
            if i % 2 == 0 { point } else { point.conjugate() }
        });
        solutions.push(with_turns(&joints, &shifts));
    }
    for (i, joints) in others.chunks_exact(16).enumerate() {
        let joints = core::array::from_fn(|i| Complex::new(joints[2 * i], joints[2 * i + 1]));
        let mirrored = core::array::from_fn(|i: usize| joints[i ^ 1].conjugate());
        solutions.push(with_turns(&joints, &shifts));
        if i >= self_conjugate {
            solutions.push(with_turns(&mirrored, &shifts));
        }
    }
    solutions
}
