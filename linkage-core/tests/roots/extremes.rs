//! Proportions that no mechanism has.

use crate::has;
use crate::laurent::{Complex, complex};
use crate::triad::{Leg, Triad, direction, point};
use linkage_core::numeric::roots::Unlisted;
use linkage_random::Random;

const CASES: usize = if cfg!(debug_assertions) { 20 } else { 1000 };

/// A platform whose dimensions differ by powers of ten, and a pose of it.
fn disproportionate(random: &mut Random, powers: f64) -> (Triad, [Complex; 2]) {
    let mut place = || {
        let size = 10_f64.powf(random.between(-powers, powers));
        point(random).scaled(size)
    };
    let points = [complex(0.0, 0.0), place(), place()];
    let (origin, ways) = (place(), [place(), place(), place()]);
    let platform = direction(random);
    let legs = ways.map(|way| Leg::Turning { length: way.size() });
    let pivots = [0, 1, 2].map(|k| origin + points[k] * platform - ways[k]);
    let first = ways[0].scaled(1.0 / ways[0].size());
    let triad = Triad {
        legs,
        pivots,
        points,
    };
    (triad, [first, platform])
}

#[test]
fn dimensions_may_differ_by_two_powers_of_ten() {
    let mut random = Random::new(2);
    for index in 0..CASES {
        let (triad, pose) = disproportionate(&mut random, 1.0);
        let listing = triad.equations().solve();
        let listing = listing.unwrap_or_else(|e| panic!("{index}: {e}"));
        assert_eq!((listing.complex, listing.multiple), (6, 0), "{index}");
        assert!(has(&listing.real, &pose, 1e-6), "{index}");
    }
}

#[test]
fn what_is_beyond_the_accuracy_of_numbers_is_not_passed_off_as_a_listing() {
    for powers in [2.0, 3.0, 6.0] {
        let mut random = Random::new(2);
        let [mut found, mut multiple, mut refused] = [0; 3];
        for index in 0..CASES {
            let (triad, pose) = disproportionate(&mut random, powers);
            match triad.equations().solve() {
                Ok(listing) if listing.multiple > 0 => multiple += 1,
                Ok(listing) => {
                    // A pose is as uncertain as the coefficients make it.
                    let found_pose = has(&listing.real, &pose, 1e-2) || listing.complex < 6;
                    assert!(found_pose, "{powers} {index}: {listing:?} {pose:?}");
                    // With the length of a leg two of them appear or vanish.
                    let even = listing.real.len() % 2 == 0;
                    assert!(even, "{powers} {index}: {listing:?}");
                    found += 1;
                }
                Err(Unlisted::Degenerate | Unlisted::Lost { .. }) => refused += 1,
                Err(other) => panic!("{powers} {index}: {other}"),
            }
        }
        println!("10^{powers}: {found} listed, {multiple} with doubles, {refused} refused");
    }
}

#[test]
fn units_do_not_matter() {
    let (triad, pose) = Triad::random("RRR", &mut Random::new(1));
    for scale in [1e-100, 1e-6, 1.0, 1e6, 1e100] {
        let mut equations = triad.equations();
        for part in equations.coefficients.iter_mut().flatten() {
            *part *= scale;
        }
        let listing = equations.solve().expect("a listing");
        assert!(has(&listing.real, &pose, 1e-12));
    }
}
