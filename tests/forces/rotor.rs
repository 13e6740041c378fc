//! Driven chains in space, where only inertia acts: a rotor with products of inertia on a turning arm, a plate fixed to it; a cylindrical pair.

use super::{Body, Instant, Kind, NEWTON, Random, Vector};
use linkage::Vector3;
use linkage_interpreted::interpreted;
use nalgebra::{Matrix3, Rotation3, Unit};

interpreted! {
    pub struct Rotor {
        unit mm;
        param m1 = 1kg;
        param m2 = 2kg;
        param m3 = 0.3kg;
        param i1 = 400kg*mm^2;
        input phi = 10deg in 0deg..360deg at w1, e1;
        input psi = 40deg in 0deg..360deg at w2, e2;
        const up = (0, 0, 1);
        let out = turn((1, 0, 0), up, phi);
        let side = turn((0, 1, 0), up, phi);
        let hub = 200mm * out;
        let y = turn(side, out, psi);
        let z = turn(up, out, psi);
        let disc = frame(hub, out, z);
        let c2 = point_in(disc, (10mm, 3mm, -2mm));
        let c3 = point_in(disc, (40mm, 30mm, 20mm));
        gravity = (0, 0, -9.80665m/s^2);
        body arm = pin j1 on frame at (0mm, 0mm, 0mm) about up, turns phi, mass m1 at 0.5 * hub, inertia i1;
        body rotor = pin j2 on arm at hub about out, turns disc, mass m2 at c2,
            inertia ((900kg*mm^2, 30kg*mm^2, -20kg*mm^2), (30kg*mm^2, 700kg*mm^2, 50kg*mm^2), (-20kg*mm^2, 50kg*mm^2, 800kg*mm^2));
        body plate = fixed j3 on rotor at hub + 50mm * y, mass m3 at c3;
        damper 30N*mm*s on j2;
    }
    impl Rotor {
        pub fn motion(phi, psi) -> RotorMotion { out, hub, disc, y, c2, c3 }
        pub fn forces(phi, psi, w1, e1, w2, e2) -> RotorForces {
            f1: reaction(j1), m1: moment(j1), f2: reaction(j2), m2: moment(j2), f3: reaction(j3), m3: moment(j3),
            t1: torque(phi), t2: torque(psi), p: power(), k: kinetic_energy(),
        }
    }
}

/// Angular velocity of the disc and how it changes, of the arm, by the inputs' speeds.
fn turns(phi: f64, w: [f64; 2], e: [f64; 2]) -> [[Vector; 2]; 2] {
    let up = Vector::z();
    let out = Vector::new(phi.cos(), phi.sin(), 0.0);
    let moved = up.cross(&out) * w[0];
    [
        [up * w[0], up * e[0]],
        [
            up * w[0] + out * w[1],
            up * e[0] + out * e[1] + moved * w[1],
        ],
    ]
}

#[test]
fn gyroscopic_moments() {
    let m = Rotor::default();
    let linkage = m.assemble().expect("it assembles");
    let mut random = Random::new(0x1f1);
    for _ in 0..120 {
        let [phi, psi] = [random.turn(), random.turn()];
        let w = [0, 1].map(|_| random.load(30.0));
        let e = [0, 1].map(|_| random.load(500.0));
        let at = linkage.motion(phi, psi);
        let [arm, disc] = turns(phi, w, e);
        let mut all = Instant::new(false, 100.0, NEWTON, Vector::new(0.0, 0.0, -9806.65));
        let up = Vector::z();
        let along = up * up.transpose() * m.i1;
        let own = Body::new([Vector::zeros(); 3], arm).add_mass(m.m1, at.hub / 2.0);
        all.body(own.add_inertia(along));
        // The hub runs on a circle about the arm's axis.
        let hub_speed = arm[0].cross(&at.hub);
        let hub_gain = arm[1].cross(&at.hub) + arm[0].cross(&hub_speed);
        let about = Rotation3::from_axis_angle(&Unit::new_normalize(at.out), psi);
        let side = up.cross(&at.out);
        let axes = Matrix3::from_columns(&[at.out, about * side, about * up]);
        let own = Matrix3::new(900.0, 30.0, -20.0, 30.0, 700.0, 50.0, -20.0, 50.0, 800.0);
        let hub = [at.hub, hub_speed, hub_gain];
        let rotor = Body::new(hub, disc).add_mass(m.m2, at.c2);
        all.body(rotor.add_inertia(axes * own * axes.transpose()));
        let seat = at.hub + about * side * 50.0;
        let plate = Body::new(hub, disc).add_mass(m.m3, at.c3);
        all.body(plate);
        all.driven(Kind::Pin(up), 0, None, Vector::zeros());
        all.driven(Kind::Pin(at.out), 1, Some(0), at.hub);
        all.joint(Kind::Fixed, 2, Some(1), seat);
        all.turn_damper([Some(1), Some(0)], at.out, 30.0);

        let solution = all.solve();
        let found = linkage.forces(phi, psi, w[0], e[0], w[1], e[1]);
        for (joint, (force, moment)) in [
            (found.f1, found.m1),
            (found.f2, found.m2),
            (found.f3, found.m3),
        ]
        .into_iter()
        .enumerate()
        {
            solution.expect_force(joint, force);
            solution.expect_moment(joint, moment);
        }
        solution.expect_torque(solution.drive(0), found.t1);
        solution.expect_torque(solution.drive(1), found.t2);
        solution.expect_torque(all.kinetic_energy(), found.k);
        let speed = w[0].abs().max(w[1].abs());
        solution.expect_power(solution.power(&all), found.p, speed);
    }
}

// A disc in space with a mass beside the plane in which its inertia is given: by hand.

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
