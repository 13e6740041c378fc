//! Coupled groups with other numbers than `f64`: dual numbers as a second check of all derivatives, lanes;
//! and Euler's theorem on homogeneous functions: where every length is a parameter, an angle does not change when
//! all of them grow alike, and a coordinate grows with them.

use crate::scalars::{close, other_numbers};
use linkage::{Dual, Lanes, Scalar};
use linkage_reference::Random;
use num_dual::{Dual2_64, Dual3_64, Dual64};
use simba::simd::{AutoF64x4, WideF64x4};

linkage::mechanism! {
    /// A triad with a slider on the frame and one on the ternary link, and a dyad behind it.
    struct Drive {
        unit mm;
        param crank = 27mm;
        param a2 = (96mm, -1mm);
        param a3 = (28mm, 84mm);
        param b = 97mm;
        param c = 42mm;
        param kappa = 30deg;
        param q1 = 102mm;
        param q2 = 170deg;
        param q3 = -35deg;
        param rod = 160mm;
        param rail = 30mm;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = -21deg;
        unknown x2 = -121mm;
        unknown x3 = 153mm;
        unknown theta = 1deg;
        unknown beta = 0deg;
        unknown s = 300mm;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e3 = e1 + polar(c, theta + kappa);
        loop e1 + polar(b, theta) = a2 + polar(x2, q2);
        loop e3 = a3 + polar(x3, theta + q3);
        loop e3 + polar(rod, beta) = (s, rail);
    }

    impl Drive {
        fn values(phi) -> Values { theta, x2, x3, s, e3, margin: margin() }
        fn first(phi) -> First {
            theta: velocity(theta), x2: velocity(x2), x3: velocity(x3), s: velocity(s),
            e3: velocity(e3),
        }
        fn second(phi) -> Second {
            theta: acceleration(theta), x2: acceleration(x2), x3: acceleration(x3),
            s: acceleration(s), e3: acceleration(e3),
        }
        fn third(phi) -> Third {
            theta: jerk(theta), x2: jerk(x2), x3: jerk(x3), s: jerk(s), e3: jerk(e3),
        }
        fn accuracy(phi) -> Accuracy {
            theta: sensitivity(theta), x2: sensitivity(x2), x3: sensitivity(x3), s: sensitivity(s),
            e3: sensitivity(e3),
        }
        fn mixed(phi) -> Mixed {
            theta: sensitivity(velocity(theta)), x2: sensitivity(velocity(x2)),
            x3: sensitivity(velocity(x3)), s: sensitivity(velocity(s)), e3: sensitivity(velocity(e3)),
        }
    }
}

/// The quantities of a function as one list.
macro_rules! list {
    ($v:expr) => {{
        let v = $v;
        [v.theta, v.x2, v.x3, v.s, v.e3.x, v.e3.y]
    }};
}

/// The derivatives by one parameter.
macro_rules! by {
    ($v:expr, $p:expr) => {{
        let (v, p) = (&$v, $p);
        [v.theta[p], v.x2[p], v.x3[p], v.s[p], v.e3[p].x, v.e3[p].y]
    }};
}

const SIZES: [f64; 6] = [1.0, 200.0, 200.0, 200.0, 200.0, 200.0];

fn inputs() -> Vec<f64> {
    let mut random = Random::new(101);
    (0..100).map(|_| random.between(-4.0, 9.0)).collect()
}

other_numbers!(Drive, list, SIZES, inputs);

#[test]
fn dual_parameters_give_the_sensitivities() {
    let real = Drive::default().assemble().expect("closes");
    for parameter in 0..Drive::PARAMETERS.len() {
        let mut mechanism = Drive::default().cast::<Dual<Dual64>>();
        {
            let m = &mut mechanism;
            let [[a2x, a2y]] = &mut m.a2.data.0;
            let [[a3x, a3y]] = &mut m.a3.data.0;
            let numbers = [
                &mut m.crank,
                a2x,
                a2y,
                a3x,
                a3y,
                &mut m.b,
                &mut m.c,
                &mut m.kappa,
                &mut m.q1,
                &mut m.q2,
                &mut m.q3,
                &mut m.rod,
                &mut m.rail,
            ];
            let moved = numbers.into_iter().nth(parameter);
            moved.expect("thirteen parameters").0.eps = 1.0;
        }
        let dual = mechanism.assemble().expect("closes");
        let angle = Drive::PARAMETERS[parameter].unit == "rad";
        for phi in inputs().into_iter().take(20) {
            let expected = by!(real.accuracy(phi), parameter);
            let rates = by!(real.mixed(phi), parameter);
            let found = list!(dual.values(Dual::from_f64(phi)));
            let moving = list!(dual.first(Dual::from_f64(phi)));
            for k in 0..SIZES.len() {
                let size = if angle { SIZES[k] } else { SIZES[k] / 100.0 };
                close(found[k].0.eps, expected[k], size, 100.0);
                close(moving[k].0.eps, rates[k], size, 400.0);
            }
        }
    }
}

/// Four mechanisms of different dimensions in the lanes of one.
#[test]
fn lanes_may_differ_in_their_dimensions() {
    let mut random = Random::new(102);
    for _ in 0..20 {
        let four: [Drive; 4] = std::array::from_fn(|_| Drive {
            crank: 27.0 * random.between(0.97, 1.03),
            q1: 102.0 * random.between(0.97, 1.03),
            ..Drive::default()
        });
        let mut mechanism = Drive::default().cast::<Lanes<AutoF64x4>>();
        mechanism.crank = Lanes::from_lanes(|lane| four[lane].crank);
        mechanism.q1 = Lanes::from_lanes(|lane| four[lane].q1);
        let lanes = mechanism.assemble().expect("closes");
        let phi = random.between(0.0, 6.0);
        let values = list!(lanes.values(Lanes::from_f64(phi)));
        for (lane, one) in four.iter().enumerate() {
            let expected = list!(one.assemble().expect("closes").values(phi));
            for (k, size) in SIZES.into_iter().enumerate() {
                close(values[k].lane(lane), expected[k], size, 30.0);
            }
        }
    }
}

#[test]
fn lengths_that_grow_alike() {
    let mut random = Random::new(103);
    for _ in 0..100 {
        let mut near = |x: f64| x * random.between(0.98, 1.02);
        let m = Drive::default();
        let mechanism = Drive {
            crank: near(m.crank),
            b: near(m.b),
            c: near(m.c),
            q1: near(m.q1),
            rod: near(m.rod),
            a2: m.a2.map(&mut near),
            a3: m.a3.map(&mut near),
            ..m
        };
        let m = &mechanism;
        let lengths = [
            m.crank, m.a2.x, m.a2.y, m.a3.x, m.a3.y, m.b, m.c, 0.0, m.q1, 0.0, 0.0, m.rod, m.rail,
        ];
        let linkage = mechanism.assemble().expect("closes");
        let phi = random.angle();
        let accuracy = linkage.accuracy(phi);
        homogeneous(
            &list!(linkage.values(phi)),
            &lengths,
            |p| by!(accuracy, p),
            100.0,
        );
        let mixed = linkage.mixed(phi);
        homogeneous(
            &list!(linkage.first(phi)),
            &lengths,
            |p| by!(mixed, p),
            200.0,
        );
    }
}

/// The identity for the angle that comes first in the list and the lengths behind it.
fn homogeneous(values: &[f64; 6], lengths: &[f64], by: impl Fn(usize) -> [f64; 6], roundoffs: f64) {
    for (k, value) in values.iter().enumerate() {
        let terms: Vec<f64> = lengths
            .iter()
            .enumerate()
            .map(|(p, x)| x * by(p)[k])
            .collect();
        let expected = if k == 0 { 0.0 } else { *value };
        let size = SIZES[k] + terms.iter().map(|term| term.abs()).sum::<f64>();
        close(terms.iter().sum(), expected, size, roundoffs);
    }
}
