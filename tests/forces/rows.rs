//! Sweeps over positions, speeds and loads; over mechanisms; single precision; dual numbers.

use linkage::{Scalar, mechanism};

use super::Random;

mechanism! {
    pub struct Press {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 0.5kg;
        param i2 = 150000g*mm^2;
        argument load = 50N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = -10deg;
        unknown x = 150mm;
        let p2 = polar(a, phi);
        let p3 = p2 + polar(b, theta);
        loop p3 = (x, 0);
        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at p2 / 2;
        body rod = pin j2 on crank at p2, turns theta, mass m2 at (2 * p2 + p3) / 3, inertia i2;
        body slider = slide j4 on frame at p3 along (1, 0), mass m3 at p3 + (0mm, 10mm);
        pin j3 = rod on slider at p3;
        force (-load, 0) on slider at p3;
        damper 0.02N*s/mm on j4;
    }
    impl Press {
        pub fn forces(phi, omega, epsilon, load) -> PressForces {
            f1: reaction(j1), f3: reaction(j3), m4: moment(j4), t: torque(phi), p: power(),
        }
        pub fn slopes(phi, omega, epsilon, load) -> PressSlopes { t: velocity(torque(phi)), m: d(torque(phi), m3) }
    }
}

const WIDTH: usize = 7;

fn numbers<T: Scalar>(forces: &PressForces<T>) -> [T; WIDTH] {
    let PressForces { f1, f3, m4, t, p } = *forces;
    [f1.x, f1.y, f3.x, f3.y, m4, t, p]
}

/// Of forces of this size.
fn sizes(forces: &[f64; WIDTH], omega: f64) -> [f64; WIDTH] {
    let force = forces[..4]
        .iter()
        .fold(1.0_f64, |size, x| size.max(x.abs()));
    let moment = 100.0 * force;
    [
        force,
        force,
        force,
        force,
        moment,
        moment,
        moment * omega.abs(),
    ]
}

fn columns<T: Scalar>(rows: usize, random: &mut Random) -> [Vec<T>; 4] {
    let mut column = |f: fn(&mut Random) -> f64| -> Vec<T> {
        (0..rows).map(|_| T::from_f64(f(random))).collect()
    };
    [
        column(Random::turn),
        column(|random| random.between(5.0, 60.0)),
        column(|random| random.between(-500.0, 500.0)),
        column(|random| random.between(-100.0, 100.0)),
    ]
}

fn sweeps_are_single_calls<T: Scalar>(roundoff: f64) {
    let mechanism = Press::default().cast::<T>();
    let linkage = mechanism.assemble().expect("it assembles");
    let mut random = Random::new(0x99);
    for rows in [1, 7, 31, 32, 33, 64, 200] {
        let [phi, omega, epsilon, load] = columns::<T>(rows, &mut random);
        let sweep = linkage.forces_sweep(&phi, &omega, &epsilon, &load);
        let sets = vec![mechanism; rows];
        let sets = linkage.forces_sweep_sets(&sets, &phi, &omega, &epsilon, &load);
        assert_eq!((sweep.len(), sets.len()), (rows, rows));
        for row in 0..rows {
            let single = linkage.forces(phi[row], omega[row], epsilon[row], load[row]);
            let single = numbers(&single).map(|x| x.lane(0));
            let sizes = sizes(&single, omega[row].lane(0));
            for found in [sweep.get(row), sets.get(row)] {
                let found = numbers(&found).map(|x| x.lane(0));
                for ((found, single), size) in found.into_iter().zip(single).zip(sizes) {
                    let near = (found - single).abs() <= 64.0 * roundoff * size;
                    assert!(near, "row {row} of {rows}: {found}, not {single}");
                }
            }
        }
    }
}

#[test]
fn sweeps() {
    sweeps_are_single_calls::<f64>(f64::EPSILON);
    sweeps_are_single_calls::<f32>(f32::EPSILON.into());
}

/// A row is the same to the last bit wherever it stands; sweeps of up to three rows are single calls.
#[test]
fn places() {
    let linkage = Press::default().assemble().expect("it assembles");
    let [phi, omega, epsilon, load] = columns::<f64>(150, &mut Random::new(0x9a));
    let bits = |columns: &PressForcesColumns| -> Vec<[u64; WIDTH]> {
        columns
            .iter()
            .map(|row| numbers(&row).map(f64::to_bits))
            .collect()
    };
    let all = bits(&linkage.forces_sweep(&phi, &omega, &epsilon, &load));
    for (start, end) in [(0, 4), (3, 70), (31, 36), (100, 150)] {
        let part = linkage.forces_sweep(
            &phi[start..end],
            &omega[start..end],
            &epsilon[start..end],
            &load[start..end],
        );
        assert_eq!(bits(&part), all[start..end]);
    }
}

#[test]
fn single_precision() {
    let double = Press::default().assemble().expect("it assembles");
    let single = Press::default()
        .cast::<f32>()
        .assemble()
        .expect("it assembles");
    let mut random = Random::new(0x9b);
    for _ in 0..200 {
        let (phi, omega) = (random.turn(), random.between(5.0, 60.0));
        let (epsilon, load) = (random.between(-500.0, 500.0), random.between(-100.0, 100.0));
        let exact = numbers(&double.forces(phi, omega, epsilon, load));
        let found = single.forces(phi as f32, omega as f32, epsilon as f32, load as f32);
        let sizes = sizes(&exact, omega);
        for ((found, exact), size) in numbers(&found).into_iter().zip(exact).zip(sizes) {
            assert!(
                (f64::from(found) - exact).abs() < 3e-6 * size,
                "{found}, not {exact}"
            );
        }
    }
}

#[test]
fn dual_numbers() {
    use linkage::Dual;
    use num_dual::Dual64;

    let plain = Press::default().assemble().expect("it assembles");
    let constant = |x: f64| Dual(Dual64::from(x));
    let variable = |x: f64| Dual(Dual64::new(x, 1.0));
    let by_angle = Press::default()
        .cast::<Dual<Dual64>>()
        .assemble()
        .expect("it assembles");
    let mut heavy = Press::default().cast::<Dual<Dual64>>();
    heavy.m3 = variable(0.5);
    let by_mass = heavy.assemble().expect("it assembles");
    for k in 0..20 {
        let (phi, omega, epsilon, load) = (0.1 + 0.3 * f64::from(k), 30.0, 200.0, 40.0);
        let slopes = plain.slopes(phi, omega, epsilon, load);
        let rest = [constant(omega), constant(epsilon), constant(load)];
        let turned = by_angle.forces(variable(phi), rest[0], rest[1], rest[2]).t;
        let heavier = by_mass.forces(constant(phi), rest[0], rest[1], rest[2]).t;
        assert!((turned.0.eps - slopes.t).abs() < 1e-10 * (1e4 + slopes.t.abs()));
        assert!((heavier.0.eps - slopes.m).abs() < 1e-10 * (1e4 + slopes.m.abs()));
        // Power is torque times speed.
        let spun = by_angle.forces(constant(phi), variable(omega), rest[1], rest[2]);
        assert!(
            (spun.p.0.eps - spun.t.0.re - spun.t.0.eps * omega).abs() < 1e-10 * spun.p.0.eps.abs()
        );
    }
}
