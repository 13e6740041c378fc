//! A disc in space with a mass beside the plane in which its inertia is given: by hand.

use linkage::Vector3;
use linkage_interpreted::interpreted;

use super::{NEWTON, Random};

interpreted! {
    pub struct Disc {
        unit mm;
        param radius = 30mm;
        param beside = 12mm;
        param m = 200g;
        param own = 400kg*mm^2;
        input phi = 10deg in 0deg..360deg at omega, epsilon;
        const up = (0, 0, 1);
        let out = turn((1, 0, 0), up, phi);
        let at = radius * out + beside * up;
        body disc = pin j on frame at (0mm, 0mm, 0mm) about up, turns phi, mass m at at, inertia own at (0mm, 0mm, 0mm);
    }
    impl Disc {
        pub fn forces(phi, omega, epsilon) -> DiscForces { f: reaction(j), m: moment(j), t: torque(phi), k: kinetic_energy() }
    }
}

/// An inertia about the axis says how the disc speeds up, and nothing about the couple of masses beside the bearing.
#[test]
fn a_mass_beside_its_bearing() {
    let m = Disc::default();
    let linkage = m.assemble().expect("it assembles");
    let mut random = Random::new(0x1e1);
    for _ in 0..20 {
        let (phi, omega, epsilon) = (random.turn(), random.load(30.0), random.load(500.0));
        let found = linkage.forces(phi, omega, epsilon);
        let (out, up) = (Vector3::new(phi.cos(), phi.sin(), 0.0), Vector3::z());
        let gain = (up.cross(&out) * epsilon - out * (omega * omega)) * m.radius;
        let force = gain * (m.m * NEWTON);
        let moment = (up * m.beside).cross(&force);
        assert!((found.f - force).norm() <= 1e-12 * force.norm());
        assert!((found.m - moment).norm() <= 1e-12 * moment.norm());
        let torque = m.own * NEWTON * epsilon;
        assert!((found.t - torque).abs() <= 1e-12 * torque.abs());
        let energy = m.own * NEWTON * omega * omega / 2.0;
        assert!((found.k - energy).abs() <= 1e-12 * energy);
    }
}
