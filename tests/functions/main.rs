//! Generated functions: their arguments, their operations, and what they give out of reach.

mod far_sizes;
mod refusals;
mod slicing;
mod slicing_space;

use linkage::mechanism;

// Numbers that functions take at run time besides the inputs, and masses in kilograms.

mechanism! {
    pub struct Rocker {
        unit mm;
        param crank = 30mm;
        param coupler = 80mm;
        param rocker = 60mm;
        param ground = 90mm;
        param mass = 129.94g +- 5g;
        argument press = 500N;
        input phi = 30deg in 0deg..360deg at omega, epsilon;
        unknown beta = 45deg;
        unknown psi = 100deg;
        let tip = (ground, 0) + polar(rocker, psi);
        loop polar(crank, phi) + polar(coupler, beta) = tip;
        let load = press * dir(psi - 1);
    }
    impl Rocker {
        fn power(phi, omega, press) -> Power {
            power: dot(load, d(tip, phi)) * omega,
            speed: velocity(tip),
        }
        fn motion(epsilon, phi, omega) -> Motion {
            energy: 0N*mm + mass * omega * omega * dot(velocity(tip), velocity(tip)) / 2,
            force: 0N + mass * (epsilon * norm(velocity(tip))),
            by_mass: sensitivity(0N + mass * (epsilon * norm(velocity(tip))), [mass]),
        }
    }
}

const STEP: f64 = 1e-5;

#[test]
fn arguments_are_numbers() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let here = linkage.power(1.0, 3.0, 200.0);
    let twice = linkage.power(1.0, 6.0, 200.0);
    assert_eq!(twice.power, 2.0 * here.power);
    assert_eq!(twice.speed, here.speed);
    let half = linkage.power(1.0, 3.0, 100.0);
    assert_eq!(half.power, here.power / 2.0);
}

#[test]
fn velocities_are_by_the_inputs_alone() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let speed = linkage.power(1.0, 3.0, 200.0).speed;
    let numbers = linkage.motion(1.0, 1.0, 1.0);
    assert!((numbers.force - 1e-3 * 0.12994 * speed.norm()).abs() < 1e-13);
}

#[test]
fn masses_are_in_kilograms() {
    let default = Rocker::<f64>::default();
    assert_eq!(default.mass, 0.12994);
    let parameter = Rocker::PARAMETERS[Rocker::INDEX_MASS];
    assert_eq!((parameter.unit, parameter.tolerance), ("kg", 0.005));
    let linkage = default.assemble().expect("it assembles");
    let here = linkage.motion(2.0, 1.0, 5.0);
    let heavier = Rocker {
        mass: 0.12994 + STEP,
        ..default
    };
    let heavier = heavier
        .assemble()
        .expect("it assembles")
        .motion(2.0, 1.0, 5.0);
    let slope = (heavier.force - here.force) / STEP;
    assert!(
        (slope / here.by_mass[0] - 1.0).abs() < 1e-9,
        "{slope} {:?}",
        here.by_mass
    );
    // Metres per second, joules.
    let speed = linkage.power(1.0, 5.0, 1.0).speed.norm() * 5.0 / 1000.0;
    let energy = 0.12994 * speed * speed / 2.0;
    assert!((here.energy / 1000.0 / energy - 1.0).abs() < 1e-14);
}

#[test]
fn one_element_counts_for_all_positions() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let phi: Vec<f64> = (0..100).map(|k| 0.06 * f64::from(k)).collect();
    let columns = linkage.power_sweep(&phi, &[3.0], &[200.0]);
    let full = linkage.power_sweep(&phi, &[3.0; 100], &[200.0; 100]);
    assert_eq!(columns.power(), full.power());
    assert_eq!(columns.len(), 100);
    for (phi, power) in phi.iter().zip(columns.power()) {
        let single = linkage.power(*phi, 3.0, 200.0).power;
        assert!((single - power).abs() <= 1e-12 * single.abs().max(1.0));
    }
    let loads = linkage.power_sweep(&[1.0], &[3.0], &[100.0, 200.0, 300.0]);
    assert_eq!(loads.len(), 3);
    assert_eq!(linkage.power_sweep(&[1.0], &[3.0], &[100.0]).len(), 1);
    assert_eq!(linkage.power_sweep(&[], &[3.0], &[100.0]).len(), 0);
}

#[test]
#[should_panic(expected = "power_sweep: `omega` has 2 elements, `press` has 3")]
fn slices_of_different_lengths() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let _ = linkage.power_sweep(&[1.0], &[3.0; 2], &[100.0; 3]);
}

#[test]
fn over_mechanisms() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let sets = [
        Rocker::default(),
        Rocker {
            crank: 31.0,
            ..Rocker::default()
        },
    ];
    let columns = linkage.power_sweep_sets(&sets, &[1.0], &[3.0], &[100.0, 200.0]);
    let second = sets[1]
        .assemble()
        .expect("it assembles")
        .power(1.0, 3.0, 200.0);
    assert!((columns.power()[1] / second.power - 1.0).abs() < 1e-12);
}
