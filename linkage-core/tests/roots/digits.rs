//! Systems that numbers of 16 digits determine, but are not enough to solve.

use crate::has;
use crate::laurent::{Complex, Equations, Laurent, complex};
use crate::triad::{Leg, Triad, direction, point};
use linkage_core::numeric::roots::{Listing, Unlisted, Variable};
use linkage_random::Random;

const CASES: usize = if cfg!(debug_assertions) { 10 } else { 200 };

/// A platform on parallel legs, which would move if one pivot were not off by so much, and the two poses of parallel legs in which it closes.
/// Roundings of the coefficients move them by about a rounding over `off`.
fn nearly_movable(random: &mut Random, off: f64) -> (Triad, [[Complex; 2]; 2]) {
    const LENGTH: f64 = 0.7;
    let (mut triad, [_, platform]) = Triad::random("RRR", random);
    let (shift, first, aside) = (point(random), direction(random), direction(random));
    triad.pivots = triad.points.map(|place| place * platform + shift);
    triad.pivots[2] += aside.scaled(off);
    // The change of length by itself: subtracted from the length it would keep few digits.
    let closing = first.scaled(LENGTH) - aside.scaled(off);
    triad.legs = [LENGTH, LENGTH, closing.size()].map(|length| Leg::Turning { length });
    let mirrored = aside * aside * first.conjugate();
    (triad, [[first, platform], [mirrored, platform]])
}

/// Where a circle meets one that is nearly the same: `x^2 + y^2 = 1`, and the same plus `share (x y - 1/4) = 0`; so `x y = 1/4`.
fn nearly_the_same(share: f64) -> Result<Listing, Unlisted> {
    let [x, y] = [0, 1].map(|k| Laurent::variable(k, 2));
    let number = |value: f64| Laurent::constant(complex(value, 0.0), 2);
    let circle = x.times(&x).plus(&y.times(&y)).minus(&number(1.0));
    let other = x.times(&y).minus(&number(0.25));
    let second = circle.plus(&other.scaled(complex(share, 0.0)));
    Equations::new(&[Variable::Number; 2], &[circle, second]).solve()
}

#[test]
fn platforms_that_nearly_move_have_six_poses() {
    for off in [1e-8, 1e-9, 1e-10] {
        let mut random = Random::new(12);
        let mut known = 0;
        for index in 0..CASES {
            let (triad, poses) = nearly_movable(&mut random, off);
            // Otherwise some are close together.
            let Some(listing) = triad
                .equations()
                .solve()
                .ok()
                .filter(|own| own.multiple == 0)
            else {
                continue;
            };
            known += 1;
            assert_eq!((listing.complex, listing.blurred), (6, 0), "{off} {index}");
            for pose in poses {
                let found = has(&listing.real, &pose, 1e-12 / off);
                assert!(found, "{off} {index}: {pose:?} {:?}", listing.real);
            }
        }
        assert!(known * 10 >= CASES * 9, "{off}: {known} of {CASES}");
    }
}

/// Ways around ends are wide: a path may turn off within them to what is real.
#[test]
fn what_is_real_is_listed_or_nothing_is() {
    let mut listed = 0;
    for power in 6..=16 {
        let off = 10_f64.powi(-power);
        match nearly_the_same(off) {
            Ok(listing) => {
                listed += 1;
                assert_eq!((listing.real.len(), listing.complex), (4, 4), "{off}");
            }
            Err(Unlisted::Lost { .. } | Unlisted::Degenerate) => {}
            Err(other) => panic!("{off}: {other}"),
        }
        let mut random = Random::new(13);
        for index in 0..CASES {
            let (triad, poses) = nearly_movable(&mut random, off);
            match triad.equations().solve() {
                Ok(listing) if listing.multiple == 0 => {
                    listed += 1;
                    // No more than two digits are known of the last ones.
                    let near =
                        |pose: &[Complex; 2]| has(&listing.real, pose, (1e-12 / off).min(0.1));
                    assert!(
                        poses.iter().all(near),
                        "{off} {index}: {poses:?} {listing:?}"
                    );
                }
                Ok(_) | Err(Unlisted::Lost { .. } | Unlisted::Degenerate) => {}
                Err(other) => panic!("{off} {index}: {other}"),
            }
        }
    }
    assert!(listed > 5 * CASES, "{listed}");
}
