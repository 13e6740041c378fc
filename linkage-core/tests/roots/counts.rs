//! How many solutions random groups have.

use crate::groups::Twins;
use crate::has;
use crate::laurent::complex;
use crate::triad::Triad;
use linkage_random::Random;
use std::time::{Duration, Instant};

/// Random cases of a kind: few without optimisation.
const CASES: usize = if cfg!(debug_assertions) { 20 } else { 800 };
/// Those of them in which real solutions are counted in another way too.
const SCANNED: usize = if cfg!(debug_assertions) { 3 } else { 60 };

/// Degree of the characteristic polynomial of every kind of triad. The first letter is the leg
/// whose coordinate is kept.
const DEGREES: [(&str, usize); 15] = [
    ("RRR", 6),
    ("RRF", 6),
    ("RRP", 6),
    ("RFP", 6),
    ("RFF", 4),
    ("RPP", 4),
    ("FFP", 4),
    ("FPP", 4),
    ("FFF", 2),
    ("PPP", 2),
    ("FRR", 6),
    ("PRR", 6),
    ("FRP", 6),
    ("PRF", 6),
    ("PFF", 4),
];

#[test]
fn triads_have_as_many_solutions_as_their_polynomials() {
    for (kinds, degree) in DEGREES {
        let mut random = Random::new(7);
        let mut time = Duration::ZERO;
        for index in 0..CASES {
            let (triad, pose) = Triad::random(kinds, &mut random);
            let equations = triad.equations();
            let start = Instant::now();
            let listing = equations.solve();
            time += start.elapsed();
            let listing = listing.unwrap_or_else(|e| panic!("{kinds} {index}: {e}"));
            assert_eq!(listing.complex, degree, "{kinds} {index}");
            assert_eq!(listing.multiple, 0, "{kinds} {index}");
            assert!(
                has(&listing.real, &pose, 1e-7),
                "{kinds} {index}: {listing:?}"
            );
            assert_eq!(listing.real.len() % 2, 0, "{kinds} {index}");
            if index < SCANNED {
                assert_eq!(listing.real.len(), count_poses(&triad, listing.real.len()));
            }
        }
        println!("{kinds}: {:.0} us", 1e6 * time.as_secs_f64() / CASES as f64);
    }
}

/// Counts finely only where a coarse count misses some that are close together.
fn count_poses(triad: &Triad, expected: usize) -> usize {
    let coarse = triad.count_poses(2000);
    if coarse == expected {
        coarse
    } else {
        triad.count_poses(200_000)
    }
}

#[test]
fn many_random_triads_are_never_lost() {
    const MANY: usize = if cfg!(debug_assertions) { 30 } else { 4000 };
    let mut random = Random::new(11);
    for index in 0..MANY {
        let kinds = DEGREES[index % DEGREES.len()].0;
        let (triad, pose) = Triad::random(kinds, &mut random);
        let listing = triad.equations().solve();
        let listing = listing.unwrap_or_else(|e| panic!("{kinds} {index}: {e}"));
        assert!(has(&listing.real, &pose, 1e-6), "{kinds} {index}");
    }
}

#[test]
fn two_platforms_have_the_same_poses_in_angles_and_in_points() {
    const CASES: usize = if cfg!(debug_assertions) { 3 } else { 100 };
    let mut random = Random::new(3);
    let mut time = [Duration::ZERO; 2];
    for index in 0..CASES {
        let (twins, pose) = Twins::random(&mut random);
        let both = [twins.equations(), twins.equations_of_points()];
        let [angles, points] = [0, 1].map(|k| {
            let start = Instant::now();
            let listing = both[k].solve();
            time[k] += start.elapsed();
            listing.unwrap_or_else(|e| panic!("{index}: {e}"))
        });
        assert_eq!([angles.paths, points.paths], [32, 32]);
        assert_eq!([angles.complex, points.complex], [18, 18], "{index}");
        assert!(has(&angles.real, &pose, 1e-7), "{index}");
        assert_eq!(angles.real.len(), points.real.len(), "{index}");
        for solution in &angles.real {
            let pose = [0, 1, 2].map(|j| complex(solution[j][0], solution[j][1]));
            let [shared, third] = twins.joints(pose);
            let values = [
                pose[1],
                shared,
                shared.conjugate(),
                third,
                third.conjugate(),
            ];
            assert!(has(&points.real, &values, 1e-6), "{index}");
        }
    }
    let [angles, points] = time.map(|time| 1e6 * time.as_secs_f64() / CASES as f64);
    println!("two platforms: {angles:.0} us in angles, {points:.0} us in points");
}
