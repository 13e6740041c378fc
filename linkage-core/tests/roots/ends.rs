//! Ends of paths that are no isolated solutions of the ordinary kind: where several paths meet, far out, at infinity.

use crate::has;
use crate::laurent::{Complex, Equations, Laurent, complex, unit};
use linkage_core::numeric::roots::{Listing, MEETING, System, Term, Variable, solve};

/// The product of `(u - root)^power`, as coefficients from the constant up.
fn product(factors: &[(Complex, usize)]) -> Vec<Complex> {
    let mut product = vec![complex(1.0, 0.0)];
    for &(root, power) in factors {
        for _ in 0..power {
            let mut next = vec![complex(0.0, 0.0); product.len() + 1];
            for (k, &own) in product.iter().enumerate() {
                next[k + 1] += own;
                next[k] = next[k] - own * root;
            }
            product = next;
        }
    }
    product
}

fn listed(variable: Variable, coefficients: &[Complex]) -> Listing {
    let exponents: Vec<[i8; 1]> = (0..coefficients.len()).map(|k| [k as i8]).collect();
    let terms: Vec<Term<'_>> = exponents
        .iter()
        .map(|exponents| Term {
            equation: 0,
            exponents,
        })
        .collect();
    let system = System {
        variables: &[variable],
        terms: &terms,
    };
    let coefficients: Vec<[f64; 2]> = coefficients.iter().map(|c| [c.re, c.im]).collect();
    solve(&system, &coefficients).expect("a listing")
}

/// Paths that meet run around each other as often as they are many: in a root of that order of what is left of the way.
#[test]
fn paths_that_meet_in_twos_threes_and_sixes_end_where_they_meet() {
    let (met, other) = (unit(0.7), unit(-2.0));
    for together in 2..=6 {
        let listing = listed(Variable::Unit, &product(&[(met, together), (other, 1)]));
        let counts = (listing.complex, listing.multiple, listing.blurred);
        assert_eq!(counts, (1, together, 0), "{together}");
        assert!(has(&listing.real, &[other], 1e-12));
        assert_eq!(listing.meeting.len(), together);
        for meeting in listing.meeting {
            assert!(has(&[meeting], &[met], MEETING), "{together}");
        }
    }
}

#[test]
fn many_that_meet_off_the_real_line_do_not_hide_what_is_real() {
    let inner = complex(-0.3, 0.1);
    let outer = inner.scaled(1.0 / (inner.size() * inner.size()));
    let ends = [unit(0.4), unit(2.5)];
    let all = [(inner, 5), (outer, 5), (ends[0], 1), (ends[1], 1)];
    let listing = listed(Variable::Unit, &product(&all));
    assert_eq!((listing.paths, listing.complex), (12, 2));
    assert_eq!(listing.multiple + listing.blurred, 10);
    assert_eq!((listing.real.len(), listing.meeting.len()), (2, 0));
    for end in ends {
        assert!(has(&listing.real, &[end], 1e-9));
    }
}

/// Of `y^3 (y - 8) = 0` with `y = (x^2 + 1)^3`: nine solutions meet at `i` and nine at `-i`, of which a ninth root of the last place is known.
#[test]
fn ends_that_numbers_cannot_tell_are_known_to_be_none_that_is_real() {
    let variables = [Variable::Length; 2];
    let number = |value: f64| Laurent::constant(complex(value, 0.0), 2);
    let [x, y] = [0, 1].map(|k| Laurent::variable(k, 2));
    let base = x.times(&x).plus(&number(1.0));
    let first = y.minus(&base.times(&base).times(&base));
    let second = y.times(&y).times(&y).times(&y.minus(&number(8.0)));
    let listing = Equations::new(&variables, &[first, second]).solve();
    let listing = listing.expect("a listing");
    assert_eq!((listing.paths, listing.complex), (24, 6));
    assert_eq!((listing.multiple, listing.blurred), (0, 18));
    assert_eq!(listing.real.len(), 2);
    for x in [-1.0, 1.0] {
        let known = [complex(x, 0.0), complex(8.0, 0.0)];
        assert!(has(&listing.real, &known, 1e-12));
    }
}

/// `y = x^2` meets another parabola in a point at infinity, where two, three or four paths end.
#[test]
fn paths_to_infinity_end_there_however_often_they_meet() {
    let variables = [Variable::Length; 2];
    let number = |value: f64| Laurent::constant(complex(value, 0.0), 2);
    let [x, y] = [0, 1].map(|k| Laurent::variable(k, 2));
    let square = x.times(&x);
    let first = y.minus(&square);
    let cases = [
        // y = 2 x^2 - 1
        (
            y.minus(&square.plus(&square)).plus(&number(1.0)),
            vec![-1.0, 1.0],
        ),
        // y = x^2 + x
        (y.minus(&square).minus(&x), vec![0.0]),
        // y = x^2 + 1
        (y.minus(&square).minus(&number(1.0)), vec![]),
    ];
    for (second, known) in cases {
        let listing = Equations::new(&variables, &[first.clone(), second]).solve();
        let listing = listing.expect("a listing");
        assert_eq!((listing.paths, listing.complex), (4, known.len()));
        assert_eq!((listing.multiple, listing.blurred), (0, 0));
        assert_eq!(listing.real.len(), known.len());
        for (found, known) in listing.real.iter().zip(known) {
            assert!(
                (found[0][0] - known).abs() < 1e-12 && (found[1][0] - known * known).abs() < 1e-12
            );
        }
    }
}
