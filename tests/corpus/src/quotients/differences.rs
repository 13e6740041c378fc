//! Derivatives against differences of positions.

use super::{DIMENSIONS, LEAVES, Quotients, leaves};

/// Positions of the crank, degrees: pages have rows at whole degrees.
const POSITIONS: [f64; 3] = [37.0, 151.0, 289.0];

/// The step of differences by the crank's angle, degrees.
const STEP: f64 = 1.0;

/// Weights of the values 1, 2 and 3 steps to either side, for a first derivative: exact to the sixth power of the step.
const FIRST: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];

/// The same for a second derivative, and the weight of the value in the middle.
const SECOND: [f64; 3] = [270.0 / 180.0, -27.0 / 180.0, 2.0 / 180.0];
const MIDDLE: f64 = -490.0 / 180.0;

/// The numbers that a language computes with, and how far derivatives may be from differences, as a part of the largest value in the difference and of
/// the derivative.
#[derive(Clone, Copy, Debug)]
pub struct Precision {
    /// The step of differences by a dimension, as a part of the dimension.
    part: f64,
    value: f64,
    first: f64,
    second: f64,
}

impl Precision {
    /// Numbers of 53 bits.
    pub const DOUBLE: Self = Self {
        part: 2e-3,
        value: 1e-12,
        first: 2e-6,
        second: 2e-5,
    };

    /// Numbers of 24 bits.
    pub const SINGLE: Self = Self {
        part: 1e-2,
        value: 1e-4,
        first: 3e-3,
        second: 6e-2,
    };
}

/// Dimensions and the crank's angle in degrees, for which a language computes the results of the function.
#[derive(Clone, Debug)]
pub struct Call {
    /// In the order of the parameters.
    pub dimensions: Vec<f64>,
    /// The crank's angle, whole degrees.
    pub degrees: f64,
}

/// The results at a position, and those of one to three steps to either side.
struct Stencil<'r> {
    middle: &'r [f64],
    sides: [[&'r [f64]; 2]; 3],
    step: f64,
}

impl Stencil<'_> {
    fn first(&self, column: usize) -> f64 {
        let sides = self.sides.iter().zip(FIRST);
        sides
            .map(|([low, high], weight)| weight * (high[column] - low[column]))
            .sum::<f64>()
            / self.step
    }

    fn second(&self, column: usize) -> f64 {
        let sides = self.sides.iter().zip(SECOND);
        let sum: f64 = sides
            .map(|([low, high], weight)| weight * (high[column] + low[column]))
            .sum();
        (sum + MIDDLE * self.middle[column]) / (self.step * self.step)
    }

    /// The largest of the values.
    fn size(&self, column: usize) -> f64 {
        let sides = self.sides.iter().flatten();
        sides
            .map(|own| own[column].abs())
            .fold(self.middle[column].abs(), f64::max)
    }
}

/// Steps of each stencil besides the position itself, in the order of [`Stencil::sides`].
const STEPS: [f64; 6] = [-1.0, 1.0, -2.0, 2.0, -3.0, 3.0];

impl Quotients {
    /// What a language has to compute: for each position the results there, then at the steps by the crank's angle and by each dimension.
    #[must_use]
    pub fn calls(&self, precision: Precision) -> Vec<Call> {
        let mut calls = Vec::new();
        for degrees in POSITIONS {
            let dimensions = DIMENSIONS.to_vec();
            calls.push(Call {
                dimensions: dimensions.clone(),
                degrees,
            });
            calls.extend(STEPS.map(|step| Call {
                dimensions: dimensions.clone(),
                degrees: degrees + STEP * step,
            }));
            for changed in 0..DIMENSIONS.len() {
                calls.extend(STEPS.map(|step| {
                    let mut dimensions = dimensions.clone();
                    dimensions[changed] *= 1.0 + step * precision.part;
                    Call {
                        dimensions,
                        degrees,
                    }
                }));
            }
        }
        calls
    }

    /// Compares what a language computed for the [`calls`](Self::calls), in their order.
    ///
    /// # Panics
    /// If a derivative is not the difference of positions, or a random quantity is not the value of its expression.
    pub fn check(&self, language: &str, precision: Precision, results: &[Vec<f64>]) {
        let block = 1 + STEPS.len() * (1 + DIMENSIONS.len());
        assert_eq!(
            results.len(),
            block * POSITIONS.len(),
            "{language}: a result for each call"
        );
        let count = self.quantities;
        for (block, degrees) in results.chunks(block).zip(POSITIONS) {
            let what = format!("{language}, {} at {degrees} degrees", self.given.name);
            self.check_values(&what, degrees, &block[0], precision.value);
            let stencil = |number: usize, step: f64| {
                let own = &block[1 + STEPS.len() * number..][..STEPS.len()];
                let sides = [0, 2, 4].map(|k| [&own[k][..], &own[k + 1][..]]);
                Stencil {
                    middle: &block[0],
                    sides,
                    step,
                }
            };
            let by_angle = stencil(0, STEP.to_radians());
            let compare = |kind: &str, index: usize, difference: f64, size: f64, part: f64| {
                let own = block[0][index];
                let near = (own - difference).abs() <= part * (size + own.abs());
                assert!(
                    near,
                    "{what}, {kind}: {own:e}, by differences {difference:e}"
                );
            };
            for q in 0..count {
                let (velocity, acceleration) = (count + q, 2 * count + q);
                let size = by_angle.size(q);
                compare(
                    &format!("velocity of {q}"),
                    velocity,
                    by_angle.first(q),
                    size,
                    precision.first,
                );
                compare(
                    &format!("acceleration of {q}"),
                    acceleration,
                    by_angle.second(q),
                    size,
                    precision.second,
                );
                for (p, dimension) in DIMENSIONS.into_iter().enumerate() {
                    let by_dimension = stencil(1 + p, dimension * precision.part);
                    for (kind, of, first) in [
                        ("", q, 3 * count),
                        (" of the velocity", velocity, (3 + DIMENSIONS.len()) * count),
                    ] {
                        let kind = format!("sensitivity{kind} of {q} to dimension {p}");
                        let index = first + DIMENSIONS.len() * q + p;
                        // A derivative by a length is small where the length is large.
                        let size = by_dimension.size(of) / dimension;
                        compare(&kind, index, by_dimension.first(of), size, precision.first);
                    }
                }
            }
        }
    }

    /// Compares random quantities with the values of their expressions.
    fn check_values(&self, what: &str, degrees: f64, results: &[f64], part: f64) {
        let leaves = leaves(&DIMENSIONS, degrees.to_radians(), results[0]);
        for (tree, own) in self.trees.iter().zip(&results[1..]) {
            let expected = tree.value(&leaves);
            let near = (own - expected).abs() <= part * (1.0 + expected.abs());
            assert!(
                near,
                "{what}, {}: {own:e}, expected {expected:e}",
                tree.text(&LEAVES)
            );
        }
    }
}
