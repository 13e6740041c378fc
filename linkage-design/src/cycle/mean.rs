//! The root mean square of a quantity over the cycle.

use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use super::{Curve, Figure, Motion, Piece, PieceKey, Pieces};

/// The root mean square of a quantity over the range, by the trapezoidal rule at the positions of
/// the search: over a full turn its error falls exponentially with their number.
pub struct RootMeanSquare<'a, A, const N: usize>(pub Curve<'a, A, N>);

impl<A, const N: usize> Figure<A, N> for RootMeanSquare<'_, A, N> {
    fn title(&self) -> String {
        "root mean square".to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        let (low, high) = motion.range;
        let closed = motion.closed;
        let steps = motion.positions - 1;
        let (mut square, mut parameters) = (0.0, [0.0; N]);
        for i in 0..steps + usize::from(!closed) {
            let input = low + (high - low) * i as f64 / steps as f64;
            let end = !closed && (i == 0 || i == steps);
            let weight = if end { 0.5 } else { 1.0 } / steps as f64;
            let [value, ..] = self.0.jet(motion.assembly, input);
            square += weight * value * value;
            let slopes = self.0.slopes(motion.assembly, input);
            for (sum, slope) in parameters.iter_mut().zip(slopes) {
                *sum += weight * value * slope;
            }
        }
        let value = square.sqrt();
        value.is_finite().then(|| {
            // At zero the slopes are those of a square, and so zero.
            let over = if value > 0.0 { 1.0 / value } else { 0.0 };
            let parameters = parameters.map(|sum| sum * over);
            Pieces::Largest(vec![Piece {
                key: PieceKey::Nth(0),
                value,
                parameters,
                auxiliary: Vec::new(),
            }])
        })
    }
}
