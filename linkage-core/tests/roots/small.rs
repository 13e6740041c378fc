//! Systems whose solutions are known.

use crate::has;
use crate::laurent::{Complex, Equations, Laurent, complex, unit};
use crate::triad::direction;
use linkage_core::numeric::roots::Variable;
use linkage_random::Random;

#[test]
fn a_length_may_be_zero() {
    // s (s - 0.25) = 0
    let s = Laurent::variable(0, 1);
    let equation = s.times(&s).minus(&s.scaled(complex(0.25, 0.0)));
    let listing = Equations::new(&[Variable::Length], &[equation]).solve();
    let listing = listing.expect("a listing");
    assert_eq!((listing.paths, listing.complex), (2, 2));
    assert!(has(&listing.real, &[complex(0.0, 0.0)], 1e-15));
    assert!(has(&listing.real, &[complex(0.25, 0.0)], 1e-15));
}

#[test]
fn a_point_may_be_at_the_origin() {
    // The crossings of two circles, one of them the origin.
    let variables = [Variable::Point, Variable::Conjugate];
    let place = Laurent::variable(0, 2);
    let circle = |centre: Complex| {
        let radius = complex(centre.size() * centre.size(), 0.0);
        let way = place.minus(&Laurent::constant(centre, 2));
        way.square(&variables).minus(&Laurent::constant(radius, 2))
    };
    let equations = [circle(complex(1.0, 0.0)), circle(complex(0.0, 1.0))];
    let listing = Equations::new(&variables, &equations).solve();
    let listing = listing.expect("a listing");
    assert_eq!(
        (listing.paths, listing.complex, listing.real.len()),
        (2, 2, 2)
    );
    assert!(has(&listing.real, &[complex(0.0, 0.0); 2], 1e-14));
    let other = [complex(1.0, 1.0), complex(1.0, -1.0)];
    assert!(has(&listing.real, &other, 1e-14));
}

#[test]
fn an_angle_of_high_degree() {
    // The polynomial with these angles and some that are not real.
    let angles = [-2.5, -1.0, 0.2, 0.3, 2.0];
    let complex_pairs = [(0.6, 1.0), (0.3, -2.0)];
    let x = Laurent::variable(0, 1);
    let mut equation = Laurent::constant(complex(1.0, 0.0), 1);
    let mut roots: Vec<Complex> = angles.map(unit).into();
    for (size, angle) in complex_pairs {
        roots.extend([unit(angle).scaled(size), unit(angle).scaled(1.0 / size)]);
    }
    for &root in &roots {
        equation = equation.times(&x.minus(&Laurent::constant(root, 1)));
    }
    let listing = Equations::new(&[Variable::Unit], &[equation]).solve();
    let listing = listing.expect("a listing");
    assert_eq!((listing.paths, listing.complex), (9, 9));
    assert_eq!(listing.real.len(), angles.len());
    for angle in angles {
        assert!(has(&listing.real, &[unit(angle)], 1e-11), "{angle}");
    }
}

#[test]
fn eight_variables() {
    // Every angle depends on the one before it.
    let mut random = Random::new(1);
    let variables = [Variable::Unit; 8];
    let pose: [Complex; 8] = std::array::from_fn(|_| direction(&mut random));
    let mut equations = Vec::new();
    for j in 0..8 {
        let [a, b] = [direction(&mut random), direction(&mut random)];
        let mut sum = Laurent::variable(j, 8).scaled(a);
        let mut value = pose[j] * a;
        if j > 0 {
            sum = sum.plus(&Laurent::variable(j - 1, 8).scaled(b.scaled(0.4)));
            value += pose[j - 1] * b.scaled(0.4);
        }
        let shift = complex(0.0, value.im);
        let sum = sum.minus(&Laurent::constant(shift, 8));
        equations.push(sum.imaginary(&variables));
    }
    let listing = Equations::new(&variables, &equations).solve();
    let listing = listing.expect("a listing");
    assert_eq!(listing.paths, 256);
    assert_eq!(listing.complex, 256);
    assert!(has(&listing.real, &pose, 1e-9));
}

#[test]
fn listings_without_real_solutions_are_empty() {
    // x + 1/x = 3
    let x = Laurent::variable(0, 1);
    let sum = x.plus(&x.conjugate(&[Variable::Unit]));
    let equation = sum.minus(&Laurent::constant(complex(3.0, 0.0), 1));
    let listing = Equations::new(&[Variable::Unit], &[equation]).solve();
    let listing = listing.expect("a listing");
    assert_eq!((listing.complex, listing.real.len()), (2, 0));
}
