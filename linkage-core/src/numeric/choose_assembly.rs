//! The choice among several assemblies by start estimates.

/// The largest error of a listed meeting of assemblies: a path may be so far from the multiple
/// solution at which it ends.
pub const MEETING: f64 = 0.01;

/// When estimates do not choose: the two least distances differ by at most this share of the
/// second.
///
/// The compiler and `assemble()` ask for different shares on purpose.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Ambiguity(f64);

impl Ambiguity {
    /// The share at the defaults, while compiling. Estimates are read off a drawing, so a narrow
    /// choice may not be the intended one. It is refused while the user can still move the
    /// estimates.
    pub const AS_WRITTEN: Self = Self(0.01);

    /// The share at run time, for a coupled group with other dimensions. Nobody can move the
    /// estimates there, so even a narrow choice is taken. Only a choice by rounding, as between
    /// mirror images, is refused.
    pub const AT_RUN_TIME: Self = Self(1e-6);
}

/// The assembly nearest to the estimates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its index; that of the first one if several are equally near.
    pub index: usize,
    /// True if another one is so near that the estimates do not choose.
    pub ambiguous: bool,
}

/// Chooses among assemblies by their distances from the estimates; `None` if there is none. A
/// distance that is NaN is the largest of all.
///
/// ```
/// use linkage_core::numeric::choose_assembly::{Ambiguity, Choice, choose_assembly};
///
/// let clear = choose_assembly([3.0, 0.2, 1.5], Ambiguity::AS_WRITTEN);
/// assert_eq!(clear, Some(Choice { index: 1, ambiguous: false }));
/// // Half a percent apart.
/// let close = |share| choose_assembly([1.0, 1.005], share).unwrap().ambiguous;
/// assert!(close(Ambiguity::AS_WRITTEN) && !close(Ambiguity::AT_RUN_TIME));
/// ```
pub fn choose_assembly(
    distances: impl IntoIterator<Item = f64>,
    Ambiguity(share): Ambiguity,
) -> Option<Choice> {
    let mut candidates = distances.into_iter().enumerate();
    let mut first = candidates.next()?;
    let mut second: Option<f64> = None;
    for next in candidates {
        let farther = match next.1.total_cmp(&first.1).is_lt() {
            true => core::mem::replace(&mut first, next).1,
            false => next.1,
        };
        second = match second {
            Some(second) if second.total_cmp(&farther).is_le() => Some(second),
            _ => Some(farther),
        };
    }
    let ambiguous = second.is_some_and(|second| second - first.1 <= share * second);
    Some(Choice {
        index: first.0,
        ambiguous,
    })
}

/// Returns whether the estimates may mean assemblies that meet at a dead point, about at this
/// distance from them, although another one is the nearest of the listed ones.
///
/// ```
/// use linkage_core::numeric::choose_assembly::{Ambiguity, may_be_meant};
///
/// assert!(!may_be_meant(1.5, 0.2, Ambiguity::AS_WRITTEN));
/// assert!(may_be_meant(0.2, 1.5, Ambiguity::AS_WRITTEN));
/// // Where assemblies meet is not known to the last digit.
/// assert!(may_be_meant(0.31, 0.3, Ambiguity::AT_RUN_TIME));
/// ```
pub fn may_be_meant(meeting: f64, nearest: f64, Ambiguity(share): Ambiguity) -> bool {
    // An angle may be off by both its components.
    let at_least = meeting - 2.0 * MEETING;
    // What has no distance may be anywhere.
    !(meeting.is_finite() && at_least - nearest > share * at_least)
}

#[cfg(test)]
mod tests {
    use super::{Ambiguity, Choice, choose_assembly, may_be_meant};

    const NAN: f64 = f64::NAN;

    fn choice(distances: &[f64]) -> Option<(usize, bool)> {
        let nearest = choose_assembly(distances.iter().copied(), Ambiguity::AS_WRITTEN);
        nearest.map(|Choice { index, ambiguous }| (index, ambiguous))
    }

    #[test]
    fn the_nearest_is_taken() {
        assert_eq!(choice(&[]), None);
        assert_eq!(choice(&[7.0]), Some((0, false)));
        assert_eq!(choice(&[7.0, 2.0, 3.0, 2.5]), Some((1, false)));
        assert_eq!(choice(&[2.0, 3.0, 7.0]), Some((0, false)));
        assert_eq!(choice(&[3.0, 7.0, 0.0]), Some((2, false)));
    }

    #[test]
    fn distances_that_hardly_differ_choose_nothing() {
        assert_eq!(choice(&[1.0, 1.0]), Some((0, true)));
        assert_eq!(choice(&[1.0, 9.0, 0.995]), Some((2, true)));
        assert_eq!(choice(&[0.995, 9.0, 1.0]), Some((0, true)));
        assert_eq!(choice(&[0.98, 9.0, 1.0]), Some((0, false)));
        assert_eq!(choice(&[0.0, 0.0]), Some((0, true)));
        assert_eq!(choice(&[0.989, 1.0]), Some((0, false)));
    }

    /// A difference larger than rounding decides at run time.
    #[test]
    fn at_run_time_rounding_alone_chooses_nothing() {
        let ambiguous = |less: f64| {
            let found = choose_assembly([1.0, 1.0 - less], Ambiguity::AT_RUN_TIME);
            found.map(|found| (found.index, found.ambiguous))
        };
        assert_eq!(ambiguous(0.9e-6), Some((1, true)));
        assert_eq!(ambiguous(1.1e-6), Some((1, false)));
    }

    #[test]
    fn what_meets_is_left_aside_only_if_it_is_clearly_farther() {
        let meant = |meeting| may_be_meant(meeting, 0.5, Ambiguity::AS_WRITTEN);
        for meeting in [0.0, 0.4, 0.5, 0.52, NAN, f64::INFINITY] {
            assert!(meant(meeting), "{meeting}");
        }
        assert!(!meant(0.53) && !meant(3.0));
    }

    #[test]
    fn what_has_no_distance_is_not_chosen() {
        assert_eq!(choice(&[NAN, 2.0]), Some((1, false)));
        assert_eq!(choice(&[2.0, NAN]), Some((0, false)));
        assert_eq!(choice(&[NAN, NAN]), Some((0, false)));
    }
}
