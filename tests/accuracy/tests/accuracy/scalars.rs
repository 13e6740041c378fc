//! Other numbers than `f64`: dual numbers as a second check of the derivatives, lanes, single
//! precision.

use linkage::{Dual, Lanes, Scalar};
use linkage_reference::Random;
use num_dual::{Dual2_64, Dual3_64, Dual64};
use simba::simd::{AutoF64x4, WideF64x4};

linkage::mechanism! {
    /// A four-bar, a slider on its coupler's guide and a swinging block: every kind of dyad in one
    /// mechanism.
    struct Everything {
        unit mm;
        param pivot_d = (140mm, 3mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param arm = 70mm;
        param lift = 25deg;
        param rod = 250mm;
        param offset = 9mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown t = 300mm;
        unknown beta = 30deg;
        unknown chi = 150deg;
        unknown s = 250mm;
        let a = polar(crank, phi);
        let b = a + polar(coupler, theta);
        loop b = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
        // RRP along a fixed guide, then RPR.
        loop tracer + polar(rod, beta) = (t, 200mm);
        loop (300mm, -80mm) + rotate((s, offset), chi) = b;
    }

    impl Everything {
        fn values(phi) -> Values { theta, psi, t, beta, chi, s, tracer, margin: margin() }
        fn first(phi) -> First {
            psi: velocity(psi), t: velocity(t), s: velocity(s), tracer: velocity(tracer),
        }
        fn second(phi) -> Second {
            psi: acceleration(psi), t: acceleration(t), s: acceleration(s),
            tracer: acceleration(tracer),
        }
        fn third(phi) -> Third { psi: jerk(psi), t: jerk(t), s: jerk(s), tracer: jerk(tracer) }
        fn accuracy(phi) -> Accuracy {
            psi: sensitivity(psi), t: sensitivity(t), s: sensitivity(s),
            tracer: sensitivity(tracer),
        }
    }
}

/// Asserts that two numbers agree to so many roundoffs of the larger of their size and `size`.
#[track_caller]
pub(crate) fn close(found: f64, expected: f64, size: f64, roundoffs: f64) {
    let allowed = roundoffs * linkage_reference::ROUNDOFF * expected.abs().max(size);
    assert!(
        (found - expected).abs() <= allowed,
        "{found:e}, expected {expected:e}"
    );
}

/// The quantities of a mechanism as one list.
macro_rules! list {
    ($v:expr) => {{
        let v = $v;
        [v.psi, v.t, v.s, v.tracer.x, v.tracer.y]
    }};
}

const SIZES: [f64; 5] = [1.0, 200.0, 200.0, 200.0, 200.0];

/// Random inputs over some turns.
fn inputs() -> Vec<f64> {
    let mut random = Random::new(91);
    (0..200).map(|_| random.between(-4.0, 9.0)).collect()
}

/// Tests of a mechanism on dual numbers and on lanes: its type, the macro that lists the quantities of a function, their sizes, and inputs.
///
/// The sine and cosine of lanes are those of their own type.
macro_rules! other_numbers {
    ($Mechanism:ident, $list:ident, $SIZES:ident, $inputs:ident) => {
        #[test]
        fn dual_numbers_give_the_same_derivatives() {
            let dimensions = $Mechanism::default();
            let real = dimensions.assemble().expect("closes");
            let one = dimensions
                .cast::<Dual<Dual64>>()
                .assemble()
                .expect("closes");
            let two = dimensions
                .cast::<Dual<Dual2_64>>()
                .assemble()
                .expect("closes");
            let three = dimensions
                .cast::<Dual<Dual3_64>>()
                .assemble()
                .expect("closes");
            for phi in $inputs() {
                let expected = [
                    $list!(real.values(phi)),
                    $list!(real.first(phi)),
                    $list!(real.second(phi)),
                    $list!(real.third(phi)),
                ];
                let by_one = $list!(one.values(Dual(Dual64::new(phi, 1.0))));
                let by_two = $list!(two.values(Dual(Dual2_64::new(phi, 1.0, 0.0))));
                let by_three = $list!(three.values(Dual(Dual3_64::new(phi, 1.0, 0.0, 0.0))));
                for (k, size) in $SIZES.into_iter().enumerate() {
                    close(by_one[k].0.re, expected[0][k], size, 20.0);
                    close(by_one[k].0.eps, expected[1][k], size, 100.0);
                    close(by_two[k].0.v1, expected[1][k], size, 100.0);
                    close(by_two[k].0.v2, expected[2][k], size, 400.0);
                    close(by_three[k].0.v3, expected[3][k], size, 2000.0);
                }
            }
        }

        fn lanes_agree<S>()
        where
            Lanes<S>: Scalar,
        {
            let real = $Mechanism::default().assemble().expect("closes");
            let lanes = $Mechanism::default()
                .cast::<Lanes<S>>()
                .assemble()
                .expect("closes");
            for four in $inputs().chunks_exact(4) {
                let phi = Lanes::<S>::from_lanes(|lane| four[lane]);
                let (values, second) = ($list!(lanes.values(phi)), $list!(lanes.second(phi)));
                for (lane, &phi) in four.iter().enumerate() {
                    let expected = [$list!(real.values(phi)), $list!(real.second(phi))];
                    for (k, size) in $SIZES.into_iter().enumerate() {
                        close(values[k].lane(lane), expected[0][k], size, 30.0);
                        close(second[k].lane(lane), expected[1][k], size, 400.0);
                    }
                }
            }
        }

        #[test]
        fn automatic_lanes_agree_with_scalars() {
            lanes_agree::<AutoF64x4>();
        }

        #[test]
        fn wide_lanes_agree_with_scalars() {
            lanes_agree::<WideF64x4>();
        }
    };
}
pub(crate) use other_numbers;

other_numbers!(Everything, list, SIZES, inputs);

#[test]
fn dual_parameters_give_the_sensitivities() {
    let real = Everything::default().assemble().expect("closes");
    for parameter in 0..Everything::PARAMETERS.len() {
        let mut mechanism = Everything::default().cast::<Dual<Dual64>>();
        let [x, y] = &mut mechanism.pivot_d.data.0[0];
        let moved = [
            x,
            y,
            &mut mechanism.crank,
            &mut mechanism.coupler,
            &mut mechanism.rocker,
            &mut mechanism.arm,
            &mut mechanism.lift,
            &mut mechanism.rod,
            &mut mechanism.offset,
        ];
        let number = moved.into_iter().nth(parameter).expect("nine parameters");
        number.0.eps = 1.0;
        let dual = mechanism.assemble().expect("closes");
        for phi in inputs().into_iter().take(40) {
            let accuracy = real.accuracy(phi);
            let expected = [
                accuracy.psi[parameter],
                accuracy.t[parameter],
                accuracy.s[parameter],
                accuracy.tracer[parameter].x,
                accuracy.tracer[parameter].y,
            ];
            let found = list!(dual.values(Dual::from_f64(phi)));
            let size = if parameter == 6 { 100.0 } else { 1.0 };
            for (found, expected) in found.into_iter().zip(expected) {
                close(found.0.eps, expected, size, 100.0);
            }
        }
    }
}

#[test]
fn single_precision_has_errors_of_single_roundoffs() {
    let real = Everything::default().assemble().expect("closes");
    let single = Everything::default()
        .cast::<f32>()
        .assemble()
        .expect("closes");
    let ratio = f64::from(f32::EPSILON) / f64::EPSILON;
    for phi in inputs() {
        let phi = phi as f32;
        let expected = list!(real.values(f64::from(phi)));
        let first = list!(real.first(f64::from(phi)));
        let values = list!(single.values(phi));
        let rates = list!(single.first(phi));
        for k in 0..5 {
            close(f64::from(values[k]), expected[k], SIZES[k], 30.0 * ratio);
            close(f64::from(rates[k]), first[k], SIZES[k], 100.0 * ratio);
        }
    }
}

#[test]
fn positions_apart_are_nan_in_their_own_lane_only() {
    let mechanism = Everything {
        coupler: 60.0,
        rocker: 90.0,
        ..Everything::default()
    };
    let real = mechanism.assemble().expect("closes at the reference");
    let lanes = mechanism
        .cast::<Lanes<AutoF64x4>>()
        .assemble()
        .expect("closes");
    let mut apart = 0;
    for four in inputs().chunks_exact(4) {
        let values = list!(lanes.values(Lanes::<AutoF64x4>::from_lanes(|lane| four[lane])));
        for (lane, &phi) in four.iter().enumerate() {
            let expected = list!(real.values(phi));
            apart += usize::from(expected[0].is_nan());
            for k in 0..5 {
                assert_eq!(values[k].lane(lane).is_nan(), expected[k].is_nan());
            }
        }
    }
    assert!(apart > 10 && apart < 190, "{apart}");
}
