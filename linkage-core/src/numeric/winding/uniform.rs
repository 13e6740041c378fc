//! Turns of an angle whose closed form gives its mean rate, so that it need not be followed.

use crate::scalar::Scalar;
use core::f64::consts::TAU;

/// The vectors beside the longest one turn their sum from its direction by at most `0.45 pi`, where
/// their lengths add up to no more than this part of its length, the sine of that. With the quarter
/// turn of the angle itself it strays by `0.95 pi` then, as in [`follow`](super::follow).
const MOST_BESIDE: f64 = 0.987_688_340_595_137_8;

/// Centre and turns of an angle that keeps within a quarter turn of the sum of vectors, by one that
/// is longer than all others together: the angle turns with it, for all inputs for which it exists.
/// `vectors` are those at inputs of 0, `turns` says how many turns each of them makes for a turn of
/// each input, or `None` for one that turns with something else, too; the angle is `here` at the
/// inputs `start`.
///
/// `None` if no vector decides.
///
/// ```
/// use linkage_core::numeric::winding::uniform;
///
/// // Seen from a pivot at (-10, 0), a crank of 40 that turns with the input; across of that the angle at 0.6 rad.
/// let base = [[0.0, 10.0], [0.0, 40.0]];
/// let turns = [Some([0.0]), Some([1.0])];
/// let (centre, turns) = uniform(&base, &turns, &[0.6], 2.5).unwrap();
/// assert_eq!(turns, [1.0]);
/// assert!((centre - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// assert!(uniform(&[[40.0, 0.0], [39.9, 0.0]], &[None, Some([1.0])], &[0.0], 0.0).is_none());
/// ```
pub fn uniform<X: AsRef<[f64]> + Clone>(
    vectors: &[[f64; 2]],
    turns: &[Option<X>],
    start: &X,
    here: f64,
) -> Option<(f64, X)> {
    let length = |[x, y]: [f64; 2]| Scalar::hypot(x, y);
    let sum: f64 = vectors.iter().map(|vector| length(*vector)).sum();
    let mut phases = vectors.iter().zip(turns);
    let decides = |length: f64| length > 0.0 && sum - length <= MOST_BESIDE * length;
    let (&[x, y], turns) = phases.find(|(vector, _)| decides(length(**vector)))?;
    let turns = turns.clone()?;
    let pairs = turns.as_ref().iter().zip(start.as_ref());
    let turned: f64 = pairs.map(|(turns, x)| turns * x).sum();
    let centre = Scalar::atan2(y, x);
    let behind = here - (centre + turned);
    Some((centre + TAU * whole(behind / TAU), turns))
}

/// The nearest integer.
pub(super) fn whole(x: f64) -> f64 {
    // Adding and subtracting 1.5 * 2^52 rounds to an integer.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    (x + ROUND) - ROUND
}
