//! Groups in space: sweeps over positions and over mechanisms, in all scalars.

use super::Random;
use linkage::{Scalar, mechanism};

mechanism! {
    /// A crank, a tilted rocker, a slider on an oblique rail, and a point on three rods.
    pub struct Space {
        unit mm;
        param crank = 20mm;
        param coupler = 100mm;
        param rocker = 60mm;
        param pivot = (80mm, 20mm, 10mm);
        param tilt = 25deg;
        param rod = 150mm;
        param rail = (60mm, 90mm, 100mm);
        param leg = 200mm;
        input phi = 60deg in 0deg..360deg;
        unknown psi = 70deg;
        unknown s = 40mm;
        unknown p = (80mm, -60mm, 140mm);
        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        let end = pivot + turn((rocker, 0, 0), turn((0, 0, 1), (0, 1, 0), tilt), psi);
        loop distance(pin, end) = coupler;
        let slider = rail + s * unit((1, 2, 0.5));
        loop distance(end, slider) = rod;
        loop distance(p, (-40mm, -120mm, 0)) = leg;
        loop distance(p, end) = leg;
        loop distance(p, slider - (s - 200mm, 190mm, 100mm)) = leg;
    }

    impl Space {
        pub fn motion(phi) -> SpaceMotion { psi, end, s, p, v: velocity(p), margin: margin() }
    }
}

const WIDTH: usize = 12;

fn numbers<T: Scalar>(motion: &SpaceMotion<T>) -> [T; WIDTH] {
    let SpaceMotion {
        psi,
        end,
        s,
        p,
        v,
        margin,
    } = *motion;
    [
        psi, end.x, end.y, end.z, s, p.x, p.y, p.z, v.x, v.y, v.z, margin,
    ]
}

/// Dimensions within a per cent of the default ones.
fn similar<T: Scalar>(random: &mut Random) -> Space<T> {
    let mut of = |nominal: f64| T::from_f64(nominal * random.between(0.99, 1.01));
    let mut space = Space::default().cast::<T>();
    space.crank = of(20.0);
    space.coupler = of(100.0);
    space.pivot.y = of(20.0);
    space.tilt = of(25f64.to_radians());
    space.rail.z = of(100.0);
    space.leg = of(200.0);
    space
}

/// Rows agree to some hundred units of roundoff of the sizes.
fn check<T: Scalar>(found: [T; WIDTH], known: [T; WIDTH], unit: f64) {
    for (found, known) in found.into_iter().zip(known) {
        let (found, known) = (found.lane(0), known.lane(0));
        let near = (found - known).abs() <= 400.0 * unit * (1.0 + known.abs());
        assert!(near, "{found}, not {known}");
    }
}

fn inputs_and_sets<T: Scalar>(unit: f64) {
    let linkage = Space::default().cast::<T>().assemble();
    let linkage = linkage.expect("it assembles");
    let mut random = Random::new(3);
    for len in [0, 1, 7, 8, 31, 32, 33, 64, 65, 100] {
        let phi: Vec<T> = (0..len)
            .map(|_| T::from_f64(random.between(0.0, 6.2)))
            .collect();
        let rows = linkage.motion_sweep(&phi);
        assert_eq!(rows.len(), len);
        for (row, &phi) in rows.iter().zip(&phi) {
            check(numbers(&row), numbers(&linkage.motion(phi)), unit);
        }
        let sets: Vec<Space<T>> = (0..len).map(|_| similar(&mut random)).collect();
        let rows = linkage.motion_sweep_sets(&sets, &phi);
        assert_eq!(rows.len(), len);
        for ((row, set), &phi) in rows.iter().zip(&sets).zip(&phi) {
            let alone = set.assemble().expect("it assembles");
            check(numbers(&row), numbers(&alone.motion(phi)), unit);
        }
    }
}

#[test]
fn double_and_single_precision() {
    inputs_and_sets::<f64>(f64::EPSILON);
    inputs_and_sets::<f32>(f32::EPSILON.into());
}

#[test]
fn nothing_is_given_where_a_link_is_too_short() {
    let mut sets = vec![Space::default(); 40];
    sets[5].coupler = 30.0;
    sets[6].rod = 20.0;
    sets[7].leg = 30.0;
    let linkage = Space::default().assemble().expect("it assembles");
    let rows: Vec<SpaceMotion> = linkage.motion_sweep_sets(&sets, &[1.0]).iter().collect();
    let [coupler, rod, leg] = [5, 6, 7].map(|row| numbers(&rows[row]));
    assert!(coupler.iter().all(|x| x.is_nan()));
    assert!(rod[..4].iter().all(|x| x.is_finite()) && rod[4..].iter().all(|x| x.is_nan()));
    assert!(leg[..5].iter().all(|x| x.is_finite()) && leg[5..].iter().all(|x| x.is_nan()));
    assert!(numbers(&rows[8]).iter().all(|x| x.is_finite()));
}

#[test]
fn dual_numbers() {
    use linkage::Dual;
    use num_dual::Dual64;

    let linkage = Space::default().cast().assemble().expect("it assembles");
    for k in 0..40 {
        let motion = linkage.motion(Dual(Dual64::new(0.15 * f64::from(k), 1.0)));
        for axis in 0..3 {
            let (by_dual, v) = (motion.p[axis].0.eps, motion.v[axis].0.re);
            assert!((by_dual - v).abs() < 1e-11, "{by_dual} {v}");
        }
    }
}

#[test]
fn lanes() {
    use linkage::Lanes;
    use simba::simd::WideF64x4;

    let linkage = Space::default().cast::<Lanes<WideF64x4>>().assemble();
    let linkage = linkage.expect("it assembles");
    let single = Space::default().assemble().expect("it assembles");
    let phi = [0.3, 1.7, 3.9, 5.8];
    let all = numbers(&linkage.motion(Lanes::from_lanes(|lane| phi[lane])));
    for (lane, phi) in phi.into_iter().enumerate() {
        let alone = numbers(&single.motion(phi));
        for (found, known) in all.iter().zip(alone) {
            let found = found.lane(lane);
            let near = (found - known).abs() <= 1e-13 * (1.0 + known.abs());
            assert!(near, "{found}, not {known}");
        }
    }
}
