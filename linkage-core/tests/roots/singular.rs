//! Systems with multiple solutions, nearly multiple ones, and continua of solutions.

use crate::has;
use crate::laurent::{Complex, complex};
use crate::triad::{Leg, Triad, direction, point};
use linkage_core::numeric::roots::{MEETING, MOST_PATHS, System, Term, Unlisted, Variable, solve};
use linkage_random::Random;

const CASES: usize = if cfg!(debug_assertions) { 10 } else { 200 };

/// A platform in a pose in which the lines of its legs meet in a point, which makes the pose a
/// double solution.
fn at_a_turning_point(random: &mut Random) -> (Triad, [Complex; 2]) {
    let points = [complex(0.0, 0.0), point(random), point(random)];
    let (origin, platform, pole) = (point(random), direction(random), point(random));
    let joints = points.map(|place| origin + place * platform);
    let pivots = joints.map(|joint| joint + (pole - joint).scaled(random.between(0.4, 1.5)));
    let lengths = [0, 1, 2].map(|k| (joints[k] - pivots[k]).size());
    let first = (joints[0] - pivots[0]).scaled(1.0 / lengths[0]);
    let triad = Triad {
        legs: lengths.map(|length| Leg::Turning { length }),
        pivots,
        points,
    };
    (triad, [first, platform])
}

fn lengthen(triad: &mut Triad, by: f64) {
    if let Leg::Turning { length } = &mut triad.legs[2] {
        *length += by;
    }
}

#[test]
fn turning_points_are_multiple_solutions() {
    let mut random = Random::new(5);
    for index in 0..CASES {
        let (triad, pose) = at_a_turning_point(&mut random);
        let listing = triad.equations().solve();
        let listing = listing.unwrap_or_else(|e| panic!("{index}: {e}"));
        assert_eq!((listing.complex, listing.multiple), (4, 2), "{index}");
        // Both are told to be where they meet, and not among the others.
        assert_eq!(listing.meeting.len(), 2, "{index}");
        for meeting in listing.meeting {
            assert!(has(&[meeting], &pose, MEETING), "{index}");
        }
        assert!(!has(&listing.real, &pose, MEETING), "{index}");
    }
}

#[test]
fn what_meets_off_the_real_line_is_no_assembly() {
    // (x^2 + s)^2 (x - 3) = 0 for s = 1 and -1: two double solutions, at i and -i, or at 1 and -1.
    let exponents: [&[i8]; 6] = [&[5], &[4], &[3], &[2], &[1], &[0]];
    let terms = exponents.map(|exponents| Term {
        equation: 0,
        exponents,
    });
    let system = System {
        variables: &[Variable::Length],
        terms: &terms,
    };
    for (sign, met) in [(1.0, 0), (-1.0, 4)] {
        let coefficients = [1.0, -3.0, 2.0 * sign, -6.0 * sign, 1.0, -3.0];
        let listing = solve(&system, &coefficients.map(|c| [c, 0.0])).expect("a listing");
        assert_eq!((listing.complex, listing.multiple), (1, 4), "{sign}");
        assert!((listing.real[0][0][0] - 3.0).abs() < 1e-14);
        assert_eq!(listing.meeting.len(), met, "{sign}");
        for place in listing.meeting {
            assert!((place[0][0].abs() - 1.0).abs() < MEETING && place[0][1] == 0.0);
        }
    }
}

#[test]
fn solutions_near_turning_points_are_told_apart() {
    // Solutions are about as far apart as the square root of the change.
    for change in [1e-4, 1e-6, 1e-8] {
        let mut random = Random::new(6);
        let mut appearing = 0;
        for index in 0..CASES {
            let (triad, _) = at_a_turning_point(&mut random);
            let [longer, shorter] = [change, -change].map(|change| {
                let mut triad = triad.clone();
                lengthen(&mut triad, change);
                let listing = triad.equations().solve();
                let listing = listing.unwrap_or_else(|e| panic!("{change} {index}: {e}"));
                let counts = (listing.complex, listing.multiple);
                assert_eq!(counts, (6, 0), "{change} {index}");
                listing.real.len()
            });
            appearing += usize::from(longer.abs_diff(shorter) == 2);
        }
        // Unless the platform has other turning points nearby.
        assert!(
            appearing * 10 >= CASES * 8,
            "{change}: {appearing} of {CASES}"
        );
    }
}

#[test]
fn platforms_that_can_move_are_degenerate() {
    let mut random = Random::new(8);
    for index in 0..CASES {
        let kinds = ["RRR", "RFF", "RPP", "FRR"][index % 4];
        let (mut twice, _) = Triad::random(kinds, &mut random);
        twice.legs[2] = twice.legs[1];
        twice.pivots[2] = twice.pivots[1];
        twice.points[2] = twice.points[1];
        assert_eq!(
            twice.equations().solve(),
            Err(Unlisted::Degenerate),
            "{index}"
        );

        let (mut parallel, [_, platform]) = Triad::random("RRR", &mut random);
        let shift = point(&mut random);
        parallel.legs = [Leg::Turning { length: 0.7 }; 3];
        parallel.pivots = parallel.points.map(|place| place * platform + shift);
        assert_eq!(
            parallel.equations().solve(),
            Err(Unlisted::Degenerate),
            "{index}"
        );
    }
}

const UNITS: [Variable; 2] = [Variable::Unit; 2];

#[test]
fn equations_without_unknowns_are_degenerate() {
    let (triad, _) = Triad::random("RRR", &mut Random::new(9));
    let mut equations = triad.equations();
    for (term, coefficient) in equations.exponents.iter().zip(&mut equations.coefficients) {
        if term.0 == 1 {
            *coefficient = [0.0; 2];
        }
    }
    assert_eq!(equations.solve(), Err(Unlisted::Degenerate));

    let one_term = [
        Term {
            equation: 0,
            exponents: &[1, -1],
        },
        Term {
            equation: 1,
            exponents: &[1, 0],
        },
        Term {
            equation: 1,
            exponents: &[0, 1],
        },
    ];
    let system = System {
        variables: &UNITS,
        terms: &one_term,
    };
    let ones = [[1.0, 0.0]; 3];
    assert_eq!(solve(&system, &ones), Err(Unlisted::Degenerate));

    let nothing = System {
        variables: &UNITS,
        terms: &[],
    };
    assert_eq!(solve(&nothing, &[]), Err(Unlisted::Degenerate));
}

#[test]
fn numbers_that_are_none_are_refused() {
    let (triad, _) = Triad::random("RRR", &mut Random::new(9));
    for bad in [f64::NAN, f64::INFINITY] {
        let mut equations = triad.equations();
        equations.coefficients[3][1] = bad;
        assert_eq!(equations.solve(), Err(Unlisted::NotFinite));
    }
}

#[test]
fn too_many_paths_are_refused() {
    let exponents: Vec<Vec<i8>> = [-1, 1].map(|exponent| vec![exponent; 8]).into();
    let terms: Vec<Term<'_>> = (0..8)
        .flat_map(|equation| {
            exponents.iter().map(move |e| Term {
                equation,
                exponents: e,
            })
        })
        .collect();
    let variables = [Variable::Unit; 8];
    let system = System {
        variables: &variables,
        terms: &terms,
    };
    let paths = 40_320 * 256;
    let most = MOST_PATHS as u64;
    let refused = Err(Unlisted::TooManyPaths { paths, most });
    assert_eq!(solve(&system, &[[1.0, 0.0]; 16]), refused);
}

#[test]
fn zero_coefficients_lower_the_degree() {
    // Leg and platform of length zero: the first variable drops out of one equation.
    let (mut triad, [_, platform]) = Triad::random("RFF", &mut Random::new(4));
    triad.legs[0] = Leg::Turning { length: 0.5 };
    triad.points[1] = complex(0.0, 0.0);
    let height = triad.pivots[0] - triad.pivots[1];
    let Leg::FrameSlide { along } = triad.legs[1] else {
        panic!("a slide");
    };
    let listing = triad.equations().solve().expect("a listing");
    let reached = (height * along.conjugate()).im.abs() < 0.5;
    assert_eq!(listing.paths, 4);
    assert_eq!(listing.complex, 4);
    assert!(reached || listing.real.is_empty());
    assert!(!has(&listing.real, &[complex(0.0, 0.0), platform], 0.1));
}
