//! The error that tolerances cause in a quantity, as a figure that a design makes small.

use alloc::boxed::Box;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{Curve, Figure, Motion, Piece, Pieces, Place};
use crate::tolerance::Tolerances;

/// The largest error of a quantity over some inputs that tolerances cause, to first order: its slopes by the parameters are second derivatives.
pub struct ErrorOf<'a, A, const N: usize> {
    curve: Curve<'a, A, N>,
    second: Second<'a, A, N>,
    tolerances: [f64; N],
    inputs: Vec<f64>,
    worst_case: bool,
}

type Second<'a, A, const N: usize> = Box<dyn Fn(&A, f64) -> [[f64; N]; N] + Send + Sync + 'a>;

/// The size of a sensitivity is smoothed below this part of the largest one, upwards: at zero it has no derivative.
const SMOOTH: f64 = 1e-3;

impl<'a, A, const N: usize> ErrorOf<'a, A, N> {
    /// The worst case, in which the effects of all tolerances add: at these inputs, of which the largest counts. `second` gives the second
    /// derivatives by the parameters, `sensitivity(sensitivity(q))`.
    ///
    /// It is never below the worst case, and above it by no more than a thousandth of the largest effect for each parameter.
    pub fn worst_case(
        curve: Curve<'a, A, N>,
        second: impl Fn(&A, f64) -> [[f64; N]; N] + Send + Sync + 'a,
        tolerances: &Tolerances<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        let (second, inputs) = (Box::new(second), inputs.into_iter().collect());
        Self {
            curve,
            second,
            tolerances: tolerances.values(),
            inputs,
            worst_case: true,
        }
    }

    /// The root of the sum of squares of all effects: a standard deviation, if tolerances are standard deviations.
    pub fn root_sum_square(
        curve: Curve<'a, A, N>,
        second: impl Fn(&A, f64) -> [[f64; N]; N] + Send + Sync + 'a,
        tolerances: &Tolerances<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        Self {
            worst_case: false,
            ..Self::worst_case(curve, second, tolerances, inputs)
        }
    }

    fn piece(&self, assembly: &A, nth: usize, input: f64) -> Piece<N> {
        let (slopes, second) = (
            self.curve.slopes(assembly, input),
            (self.second)(assembly, input),
        );
        let effects: [f64; N] = core::array::from_fn(|k| slopes[k] * self.tolerances[k]);
        // What the error grows by with each effect.
        let (value, weights): (f64, [f64; N]) = if self.worst_case {
            let largest = effects
                .iter()
                .fold(0.0, |most: f64, effect| most.max(effect.abs()));
            let size = |effect: f64| effect.hypot(SMOOTH * largest);
            // The largest effect smooths all others, and has a part in their sizes.
            let part: f64 = effects
                .iter()
                .map(|&effect| SMOOTH * SMOOTH * largest / size(effect))
                .sum();
            let weight = |effect: f64| {
                let more = if effect.abs() == largest {
                    part.copysign(effect)
                } else {
                    0.0
                };
                effect / size(effect) + more
            };
            let weights = if largest > 0.0 {
                effects.map(weight)
            } else {
                [0.0; N]
            };
            (effects.iter().map(|&effect| size(effect)).sum(), weights)
        } else {
            let value = effects
                .iter()
                .map(|effect| effect * effect)
                .sum::<f64>()
                .sqrt();
            (
                value,
                effects.map(|effect| if value > 0.0 { effect / value } else { 0.0 }),
            )
        };
        let along = |j: usize| {
            (0..N)
                .map(|k| weights[k] * self.tolerances[k] * second[k][j])
                .sum()
        };
        Piece {
            place: Place::Nth(nth),
            value,
            parameters: core::array::from_fn(along),
            own: Vec::new(),
        }
    }
}

impl<A, const N: usize> Figure<A, N> for ErrorOf<'_, A, N> {
    fn title(&self) -> String {
        let kind = if self.worst_case {
            "error in the worst case"
        } else {
            "root sum square of errors"
        };
        kind.to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        let piece = |(nth, &input): (usize, &f64)| self.piece(motion.assembly, nth, input);
        let pieces: Vec<Piece<N>> = self.inputs.iter().enumerate().map(piece).collect();
        pieces
            .iter()
            .all(|piece| piece.value.is_finite())
            .then_some(Pieces::Largest(pieces))
    }
}
