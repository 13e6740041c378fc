//! Other numbers than `f64` in space: dual numbers as a second check of the derivatives, single
//! precision, sweeps.

use linkage::Dual;
use linkage_reference::{ROUNDOFF, Random};
use num_dual::{Dual2_64, Dual64};

linkage::mechanism! {
    /// RSSR, RSSP on the rocker, a point on three spheres and a direction.
    struct Everything {
        unit mm;
        param crank = 10mm;
        param coupler = 50mm;
        param pivot = (40mm, 10mm, 5mm);
        param gamma = 50deg;
        param rod = 90mm;
        param leg = 60mm;
        input phi = 60deg in 0deg..360deg;
        unknown psi = 76deg;
        unknown s = 115mm;
        unknown p = (20mm, 31mm, 53mm);
        unknown n = (-0.3, -0.4, 0.9);
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let axis = turn((0, 0, 1), (0, 1, 0), gamma);
        let end = pivot + turn((0mm, 30mm, 0mm), axis, psi - 90deg);
        loop distance(pin, end) = coupler;
        loop distance(end, (30mm, 0mm, -60mm) + s * (0.9, 0.3, 0.4)) = rod;
        loop distance(p, end) = leg;
        loop distance(p, pin) = leg;
        loop distance(p, (0mm, 50mm, 0mm)) = leg;
        loop norm(n) = 1;
        loop dot(n, axis) = cos(70deg);
        loop dot(n, p) = 30mm;
    }

    impl Everything {
        fn values(phi) -> Values { psi, s, p, n }
        fn first(phi) -> First { psi: velocity(psi), s: velocity(s), p: velocity(p), n: velocity(n) }
        fn second(phi) -> Second {
            psi: acceleration(psi), s: acceleration(s), p: acceleration(p), n: acceleration(n),
        }
        fn by_crank(phi) -> ByCrank {
            psi: d(psi, crank), s: d(s, crank), p: d(p, crank), n: d(n, crank),
        }
    }
}

/// The quantities of a function as one list.
macro_rules! list {
    ($v:expr) => {{
        let v = $v;
        [v.psi, v.s, v.p.x, v.p.y, v.p.z, v.n.x, v.n.y, v.n.z]
    }};
}

const SIZES: [f64; 8] = [1.0, 100.0, 100.0, 100.0, 100.0, 1.0, 1.0, 1.0];

fn inputs() -> Vec<f64> {
    let mut random = Random::new(331);
    (0..100)
        .map(|_| random.between(0.0, core::f64::consts::TAU))
        .collect()
}

/// Asserts that lists agree to so many roundoffs of their sizes.
#[track_caller]
fn close(found: [f64; 8], expected: [f64; 8], roundoffs: f64) {
    for ((found, expected), size) in found.into_iter().zip(expected).zip(SIZES) {
        let allowed = roundoffs * ROUNDOFF * expected.abs().max(size);
        let error = (found - expected).abs();
        assert!(error <= allowed, "{found:e}, expected {expected:e}");
    }
}

#[test]
fn dual_numbers_give_the_same_derivatives() {
    let real = Everything::default().assemble().expect("closes");
    let one = Everything::default().cast::<Dual<Dual64>>();
    let one = one.assemble().expect("closes");
    let two = Everything::default().cast::<Dual<Dual2_64>>();
    let two = two.assemble().expect("closes");
    let mut longer = Everything::default().cast::<Dual<Dual64>>();
    longer.crank.0.eps = 1.0;
    let longer = longer.assemble().expect("closes");
    for phi in inputs() {
        let by_one = list!(one.values(Dual(Dual64::new(phi, 1.0))));
        let by_two = list!(two.values(Dual(Dual2_64::new(phi, 1.0, 0.0))));
        let by_crank = list!(longer.values(Dual(Dual64::new(phi, 0.0))));
        close(by_one.map(|x| x.0.re), list!(real.values(phi)), 20.0);
        close(by_one.map(|x| x.0.eps), list!(real.first(phi)), 100.0);
        close(by_two.map(|x| x.0.v2), list!(real.second(phi)), 1000.0);
        close(by_crank.map(|x| x.0.eps), list!(real.by_crank(phi)), 100.0);
    }
}

#[test]
fn single_precision_has_errors_of_single_roundoffs() {
    let real = Everything::default().assemble().expect("closes");
    let single = Everything::default().cast::<f32>();
    let single = single.assemble().expect("closes");
    let ratio = f64::from(f32::EPSILON) / f64::EPSILON;
    for phi in inputs() {
        let phi = phi as f32;
        let (values, first) = (list!(single.values(phi)), list!(single.first(phi)));
        let expected = f64::from(phi);
        close(
            values.map(f64::from),
            list!(real.values(expected)),
            30.0 * ratio,
        );
        close(
            first.map(f64::from),
            list!(real.first(expected)),
            200.0 * ratio,
        );
    }
}

#[test]
fn sweeps_give_the_same() {
    let real = Everything::default().assemble().expect("closes");
    let rows = real.second_sweep(&inputs());
    assert_eq!(rows.len(), 100);
    for (row, phi) in rows.iter().zip(inputs()) {
        close(list!(row), list!(real.second(phi)), 200.0);
    }
}
