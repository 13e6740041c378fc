//! A rocker that may slide along its axis, its link hinged to the crank: an angle and a slide together, no closed form.

use linkage::Vector3;
use linkage_interpreted::interpreted;
use std::f64::consts::{PI, TAU};

use super::{close, differences, newton, turned};

interpreted! {
    pub struct Sleeve {
        unit mm;
        param crank = 30mm;
        param rod = 120mm;
        param r = 50mm;
        param pivot = (90mm, 40mm, 0mm);
        const axis = (0, 0.6, 0.8);
        input phi = 40deg in 0deg..360deg;
        unknown psi = 100deg;
        unknown s = 80mm;
        let pin = (crank * cos(phi), crank * sin(phi), 0);
        let end = pivot + s * axis + turn((r, 0, 0), axis, psi);
        let hinge = turn((0, 0, 1), (1, 0, 0), 20deg);
        loop dot(end - pin, hinge) = 0;
        loop distance(pin, end) = rod;
    }

    impl Sleeve {
        pub fn place(phi) -> Place { pin, end, psi, s }
        pub fn motion(phi) -> Motion { v: velocity(s), a: acceleration(psi), w: velocity(psi) }
    }
}

fn end(psi: f64, s: f64) -> Vector3<f64> {
    let axis = Vector3::new(0.0, 0.6, 0.8);
    Vector3::new(90.0, 40.0, 0.0) + axis * s + turned(Vector3::x() * 50.0, axis, psi)
}

#[test]
fn all_assemblies_are_found() {
    let phi: f64 = 40f64.to_radians();
    let hinge = turned(Vector3::z(), Vector3::x(), 20f64.to_radians());
    let rod = |[psi, s]: [f64; 2]| {
        let pin = Vector3::new(phi.cos(), phi.sin(), 0.0) * 30.0;
        end(psi, s) - pin
    };
    let independent = newton::all(
        |x| [rod(x).dot(&hinge), rod(x).norm() - 120.0],
        [[-PI, -200.0], [PI, 200.0]],
        |x, y| {
            let turn = (x[0] - y[0] + PI).rem_euclid(TAU) - PI;
            turn.abs() < 1e-5 && (x[1] - y[1]).abs() < 1e-4
        },
        1000,
    );
    let assemblies = Sleeve::default().assemblies().expect("they are listed");
    assert_eq!(assemblies.len(), independent.len());
    for assembly in assemblies {
        let place = assembly.place(phi);
        let known = |x: &[f64; 2]| (x[1] - place.s).abs() < 1e-7;
        assert!(independent.iter().any(known));
    }
}

#[test]
fn a_whole_turn() {
    let sleeve = Sleeve::default().assemble().expect("it assembles");
    let hinge = turned(Vector3::z(), Vector3::x(), 20f64.to_radians());
    for k in 1..72 {
        let phi = f64::from(5 * k).to_radians();
        let place = sleeve.place(phi);
        let rod = place.end - place.pin;
        close(rod.norm(), 120.0, 1e-13);
        close(rod.dot(&hinge), 0.0, 1e-11);
        assert!((place.end - end(place.psi, place.s)).norm() < 1e-11);
        let motion = sleeve.motion(phi);
        let [v, _] = differences(|x| sleeve.place(x).s, phi, 1e-5);
        let [w, a] = differences(|x| sleeve.place(x).psi, phi, 1e-4);
        close(motion.v, v, 1e-7);
        close(motion.w, w, 1e-6);
        close(motion.a, a, 1e-5);
    }
}
