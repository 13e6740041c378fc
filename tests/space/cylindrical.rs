//! RCCC: a crank and three cylindrical pairs. The directions are a spherical four-bar, the slides follow from one loop of three rows.

use linkage_interpreted::interpreted;

use super::{close, differences};

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
