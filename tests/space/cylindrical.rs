//! Rockers in space: with cylindrical pairs, with a sleeve that slides, and next to groups of the plane.

use super::{all_solutions, close, differences, turned};
use linkage::{Vector2, Vector3};
use linkage_interpreted::interpreted;
use std::f64::consts::{PI, TAU};

// RCCC: a crank and three cylindrical pairs. The directions are a spherical four-bar, the slides follow from one loop of three rows.

interpreted! {
    pub struct Rccc {
        unit mm;
        param a12 = 30mm;
        param a23 = 100mm;
        param a34 = 80mm;
        param t12 = 20deg;
        param t23 = 60deg;
        param t34 = 70deg;
        param t41 = 80deg;
        param base = (90mm, 10mm, 20mm);
        input phi = 40deg in 0deg..360deg;
        unknown psi = 70deg;
        unknown s2 = 70mm;
        unknown s3 = 10mm;
        unknown s4 = -70mm;
        let z1 = (0, 0, 1);
        let z4 = turn(z1, (1, 0, 0), t41);
        let n12 = turn((1, 0, 0), z1, phi);
        let z2 = turn(z1, n12, t12);
        let n34 = turn((1, 0, 0), z4, psi);
        let z3 = turn(z4, n34, t34);
        loop dot(z2, z3) = cos(t23);
        let n23 = unit(cross(z2, z3));
        loop a12 * n12 + s2 * z2 + a23 * n23 + s3 * z3 = base + s4 * z4 + a34 * n34;
    }

    impl Rccc {
        pub fn lines(phi) -> Lines { z2, z3, z4, p2: a12 * n12, p3: base + s4 * z4 + a34 * n34, n23, s2, s3, s4, psi }
        pub fn motion(phi) -> Motion { v: velocity(s4), a: acceleration(s3), w: acceleration(psi) }
        pub fn accuracy(phi) -> Accuracy { s: sensitivity(s2, [t12, a23]) }
    }
}

#[test]
fn lines_keep_their_distances_and_angles() {
    let rccc = Rccc::default().assemble().expect("it assembles");
    for k in 0..36 {
        let phi = f64::from(10 * k).to_radians();
        let lines = rccc.lines(phi);
        close(lines.z2.dot(&lines.z3), 60f64.to_radians().cos(), 1e-14);
        close(lines.z3.dot(&lines.z4), 70f64.to_radians().cos(), 1e-14);
        // The common normal of the coupler's lines is as long as the coupler.
        let between = lines.p3 - lines.p2;
        close(between.dot(&lines.n23), 100.0, 1e-13);
        let whole = lines.z2 * lines.s2 + lines.n23 * 100.0 + lines.z3 * lines.s3;
        assert!((whole - between).norm() < 1e-11);
        let motion = rccc.motion(phi);
        let [v, _] = differences(|x| rccc.lines(x).s4, phi, 1e-5);
        let [_, a] = differences(|x| rccc.lines(x).s3, phi, 1e-4);
        let [_, w] = differences(|x| rccc.lines(x).psi, phi, 1e-4);
        close(motion.v, v, 1e-6);
        close(motion.a, a, 1e-5);
        close(motion.w, w, 1e-5);
    }
}

#[test]
fn sensitivities_are_differences() {
    let found = Rccc::default()
        .assemble()
        .expect("it assembles")
        .accuracy(0.7)
        .s;
    let at = |t12: f64, a23: f64| {
        let mut changed = Rccc::default();
        changed.t12 += t12;
        changed.a23 += a23;
        changed.assemble().expect("it assembles").lines(0.7).s2
    };
    close(found[0], (at(1e-6, 0.0) - at(-1e-6, 0.0)) / 2e-6, 1e-7);
    close(found[1], (at(0.0, 1e-4) - at(0.0, -1e-4)) / 2e-4, 1e-9);
}

// A rocker that may slide along its axis, its link hinged to the crank: an angle and a slide together, no closed form.

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
        pub fn place(phi) -> SleevePlace { pin, end, psi, s }
        pub fn motion(phi) -> SleeveMotion { v: velocity(s), a: acceleration(psi), w: velocity(psi) }
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
    let independent = all_solutions(
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

// Plane and space in one mechanism: a planar four-bar drives a rocker in space, which drives a planar slider.

interpreted! {
    pub struct Mixed {
        unit mm;
        param crank = 20mm;
        param coupler = 70mm;
        param rocker = 50mm;
        param ground = 75mm;
        param rod = 120mm;
        param arm = 60mm;
        param pivot = (100mm, 30mm, 80mm);
        param tilt = 60deg;
        param push = 90mm;
        input phi = 30deg in 0deg..720deg;
        unknown theta = 40deg;
        unknown chi = 90deg;
        unknown psi = 100deg;
        unknown y = 160mm;
        unknown alpha = 120deg;
        loop polar(crank, phi) + polar(coupler, theta) = (ground, 0) + polar(rocker, chi);
        let tip = (ground, 0) + polar(1.2 * rocker, chi);
        let axis = turn((0, 0, 1), (0, 1, 0), tilt);
        let ball = pivot + turn((0, arm, 0), axis, psi);
        loop distance((tip.x, tip.y, 0), ball) = rod;
        loop (ball.y, ball.z) + polar(push, alpha) = (0, y) + (20mm, 0);
    }

    impl Mixed {
        pub fn place(phi) -> MixedPlace { tip, ball, y, psi }
        pub fn motion(phi) -> MixedMotion { v: velocity(y), a: acceleration(y) }
        pub fn accuracy(phi) -> MixedAccuracy { s: sensitivity(y, [crank, tilt, pivot.z]) }
    }
}

#[test]
fn all_links_keep_their_lengths() {
    let mixed = Mixed::default().assemble().expect("it assembles");
    let mut strokes: Vec<f64> = Vec::new();
    for k in 0..72 {
        let phi = f64::from(10 * k).to_radians();
        let place = mixed.place(phi);
        let tip = Vector3::new(place.tip.x, place.tip.y, 0.0);
        close((place.ball - tip).norm(), 120.0, 1e-13);
        let axis = turned(Vector3::z(), Vector3::y(), 60f64.to_radians());
        let arm = turned(Vector3::y() * 60.0, axis, place.psi);
        let pivot = Vector3::new(100.0, 30.0, 80.0);
        assert!((pivot + arm - place.ball).norm() < 1e-11);
        let push = Vector2::new(20.0 - place.ball.y, place.y - place.ball.z);
        close(push.norm(), 90.0, 1e-13);
        let motion = mixed.motion(phi);
        let inside = phi.clamp(0.01, 12.5);
        let [v, a] = differences(|x| mixed.place(x).y, inside, 1e-4);
        if inside == phi {
            close(motion.v, v, 1e-5);
            close(motion.a, a, 1e-4);
        }
        strokes.push(place.y);
    }
    // The second turn repeats the first.
    (0..36).for_each(|k| close(strokes[k + 36], strokes[k], 1e-12));
}

#[test]
fn sensitivities_across_the_plane_are_differences() {
    let found = Mixed::default()
        .assemble()
        .expect("it assembles")
        .accuracy(1.0)
        .s;
    let at = |change: [f64; 3]| {
        let mut changed = Mixed::default();
        changed.crank += change[0];
        changed.tilt += change[1];
        changed.pivot.z += change[2];
        changed.assemble().expect("it assembles").place(1.0).y
    };
    for (k, found) in found.into_iter().enumerate() {
        let step = |size: f64| std::array::from_fn(|i| if i == k { size } else { 0.0 });
        close(found, (at(step(1e-5)) - at(step(-1e-5))) / 2e-5, 1e-7);
    }
}
