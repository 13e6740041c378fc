//! Continuation from position to position: coupled groups are followed from their current state,
//! whatever the ranges of the inputs.

use crate::error::Halt;
use linkage_core::Scalar;
use linkage_core::certificate::{ALLOWED_CONTRACTION, CORRECTIONS, FIRST_CORRECTION};

/// The shortest step, as a part of the path: next to a dead point.
const SHORTEST: f64 = 1e-6;

/// Greatest factor by which a step may change the determinant, from its beginning to any of its
/// corrections. If a step leads from one dead point to another assembly next to the following one,
/// corrections shrink as fast as they should, but the determinant changes.
const DETERMINANTS: f64 = 2.0;

/// Share of the determinant below which a path ends at a dead point. The shortest steps reach some
/// thousandth; with a larger share something else may end the path.
const VANISHED: f64 = 0.01;

/// The position of a coupled group's state among the inputs and states of a mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Index of the group in `STRUCTURE`.
    pub group: usize,
    /// The first number of its state.
    pub first: usize,
    /// Numbers in its state. Behind them is half of its determinant.
    pub size: usize,
}

/// A correction of a group's state.
#[derive(Clone, Copy, Debug)]
pub struct Corrected<T> {
    /// The square of its size.
    pub size2: T,
    /// The determinant where it began.
    pub determinant: T,
}

/// The end of a path before its target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The number of the coupled group that cannot be followed any further.
    pub number: usize,
    /// The possible part of the path, from 0 to 1.
    pub share: f64,
    /// The reason.
    pub why: Halt,
}

/// Puts the state of a corrected group in its place.
#[inline(always)]
pub fn put_corrected<T: Copy, const W: usize, const O: usize>(
    x: &mut [T; W],
    first: usize,
    outputs: &[T; O],
) -> Corrected<T> {
    let (state, rest) = outputs.split_at(O - 2);
    x[first..first + state.len()].copy_from_slice(state);
    Corrected {
        size2: rest[0],
        determinant: rest[1],
    }
}

/// Follows the groups on the straight path from the current position `from`, inputs with the states
/// of all groups after them, to the inputs `to`. Generated code has positions as arrays, the engine
/// as vectors.
///
/// A step is taken if in every group, in their order, the first correction is small, each of the
/// next ones at most a quarter of the one before, the last one negligible, and the determinant
/// keeps its sign and, within a factor of two, its size. Other steps are halved.
///
/// # Errors
///
/// Where no step leads any further.
#[inline(always)]
pub fn follow<T: Scalar, X: Clone + AsRef<[T]> + AsMut<[T]>>(
    from: &X,
    to: impl AsRef<[T]>,
    groups: &[Standing],
    correct: impl Fn(usize, &mut X) -> Corrected<T>,
) -> Result<X, Stop> {
    let mut here = from.clone();
    let (mut share, mut length) = (0.0, 1.0);
    while share < 1.0 {
        let next = share + length;
        let mut there = here.clone();
        let ends = to.as_ref().iter().zip(from.as_ref());
        for (position, (end, begin)) in there.as_mut().iter_mut().zip(ends) {
            *position = if next < 1.0 {
                *begin + (*end - *begin) * T::from_f64(next)
            } else {
                // The whole way, so that nothing is lost on the last step.
                *end
            };
        }
        let mut numbered = groups.iter().enumerate();
        let failed = numbered.find_map(|(number, group)| {
            let settled = settle::<T, X>(&mut there, group, |x| correct(number, x));
            Some((number, group, settled.err()?))
        });
        match failed {
            None => {
                here = there;
                share = next;
                length = (2.0 * length).min(1.0 - share);
            }
            Some((number, group, why)) if length < SHORTEST => {
                let why = if has_vanished::<T>(from.as_ref(), here.as_ref(), group) {
                    Halt::DeadPoint
                } else {
                    why
                };
                return Err(Stop { number, share, why });
            }
            Some(_) => length *= 0.5,
        }
    }
    Ok(here)
}

/// Corrects a group until it is settled; otherwise it may be somewhere else then.
#[inline(always)]
fn settle<T: Scalar, X: AsRef<[T]> + AsMut<[T]>>(
    x: &mut X,
    group: &Standing,
    correct: impl Fn(&mut X) -> Corrected<T>,
) -> Result<(), Halt> {
    let floor = group.first + group.size;
    let settled = T::LAST_CORRECTION * T::LAST_CORRECTION;
    let mut allowed = FIRST_CORRECTION * FIRST_CORRECTION;
    let mut begin: Option<T> = None;
    for _ in 0..CORRECTIONS {
        let step = correct(x);
        let begin = *begin.get_or_insert(step.determinant);
        let (mut largest, mut sound, mut finite) = (0.0, true, true);
        for lane in 0..T::LANES {
            let size2 = T::lane(step.size2, lane);
            let determinant = T::lane(step.determinant, lane);
            sound &= size2 <= allowed
                && determinant * T::lane(x.as_ref()[floor], lane) > 0.0
                && is_alike(determinant, T::lane(begin, lane));
            finite &= size2.is_finite() && determinant.is_finite();
            largest = f64::max(largest, size2);
        }
        if !finite {
            return Err(Halt::NoNumber);
        }
        if !sound {
            return Err(Halt::Uncertain);
        }
        if largest <= settled {
            let x = x.as_mut();
            x[floor] = step.determinant * T::from_f64(0.5);
            let numbers = x[group.first..=floor].iter_mut();
            // Derivatives belong to a position: they are computed again there.
            numbers.for_each(|number| *number = T::from_lanes(|lane| T::lane(*number, lane)));
            return Ok(());
        }
        allowed = ALLOWED_CONTRACTION * ALLOWED_CONTRACTION * largest;
    }
    Err(Halt::Uncertain)
}

/// True if the determinant of a group is next to nothing, compared with where the way began.
#[inline(always)]
fn has_vanished<T: Scalar>(from: &[T], here: &[T], group: &Standing) -> bool {
    let floor = group.first + group.size;
    (0..T::LANES).any(|lane| {
        let [begin, end] = [from, here].map(|x| T::lane(x[floor], lane).abs());
        end < VANISHED * begin
    })
}

/// True if two determinants are not further apart than those of one step may be.
#[inline(always)]
fn is_alike(determinant: f64, begin: f64) -> bool {
    let [determinant, begin] = [determinant.abs(), begin.abs()];
    determinant <= DETERMINANTS * begin && begin <= DETERMINANTS * determinant
}

#[cfg(test)]
mod tests {
    use super::*;

    const GROUPS: [Standing; 1] = [Standing {
        group: 0,
        first: 1,
        size: 1,
    }];

    /// `x^2 = input`: two solutions that meet at 0.
    fn correct(_: usize, x: &mut [f64; 3]) -> Corrected<f64> {
        let determinant = 2.0 * x[1];
        let step = (x[1] * x[1] - x[0]) / determinant;
        put_corrected(x, 1, &[x[1] - step, step * step, determinant])
    }

    fn from(root: f64) -> [f64; 3] {
        [root * root, root, root]
    }

    #[test]
    fn a_long_way_is_gone_in_steps_on_the_same_side() {
        for root in [1.0, -1.0] {
            let there = follow(&from(root), [25.0], &GROUPS, correct).expect("it is followed");
            assert!((there[1] - 5.0 * root).abs() < 1e-12, "{there:?}");
            assert_eq!(there[0], 25.0);
            let near = follow(&there, [1e-4], &GROUPS, correct).expect("it is followed");
            assert!((near[1] - 0.01 * root).abs() < 1e-12, "{near:?}");
        }
    }

    #[test]
    fn a_way_beyond_the_dead_point_stops_there() {
        let stop = follow(&from(1.0), [-1.0], &GROUPS, correct).expect_err("nothing is there");
        assert_eq!((stop.number, stop.why), (0, Halt::DeadPoint));
        assert!((stop.share - 0.5).abs() < 1e-4, "{stop:?}");
    }

    /// `x^3 - 3 d^2 x = input`: dead points at `-d` and `d`, and on both sides of them an assembly
    /// with the same sign of the determinant.
    #[test]
    fn two_dead_points_that_are_close_together_are_not_crossed() {
        let d: f64 = 0.004;
        let correct = |_: usize, x: &mut [f64; 3]| {
            let determinant = 3.0 * (x[1] * x[1] - d * d);
            let step = (x[1].powi(3) - 3.0 * d * d * x[1] - x[0]) / determinant;
            put_corrected(x, 1, &[x[1] - step, step * step, determinant])
        };
        let input = |x: f64| x.powi(3) - 3.0 * d * d * x;
        for k in 0..2000 {
            let begin = -d * (1.01 + 0.01 * f64::from(k));
            let from = [input(begin), begin, 1.5 * (begin * begin - d * d)];
            let end = 3.0 * d;
            let stop = follow(&from, [input(end)], &GROUPS, correct).expect_err("a dead point");
            let dead = (input(-d) - from[0]) / (input(end) - from[0]);
            assert!((stop.share - dead).abs() < 1e-4, "from {begin}: {stop:?}");
        }
    }

    #[test]
    fn nothing_is_followed_to_no_number_or_from_none() {
        for (from, to) in [(from(1.0), f64::NAN), ([1.0, f64::NAN, 1.0], 1.1)] {
            let stop = follow(&from, [to], &GROUPS, correct).expect_err("no number");
            assert_eq!((stop.share, stop.why), (0.0, Halt::NoNumber));
        }
    }

    /// The same solutions by a matrix that is eliminated in an order that does not serve beyond the
    /// input 2, far from any dead point.
    #[test]
    fn a_way_that_ends_for_another_reason_is_no_dead_point() {
        for (lost, why) in [(f64::NAN, Halt::NoNumber), (1.0, Halt::Uncertain)] {
            let unserved = |number: usize, x: &mut [f64; 3]| {
                let corrected = correct(number, x);
                let size2 = if x[0] > 2.0 { lost } else { corrected.size2 };
                Corrected { size2, ..corrected }
            };
            let stop = follow(&from(1.0), [4.0], &GROUPS, unserved).expect_err("not served");
            assert_eq!(stop.why, why);
            assert!((stop.share - 1.0 / 3.0).abs() < 1e-5, "{stop:?}");
        }
    }
}
