//! A crank and a rod between two ball joints: RSSR with a rocker, RSSP with a slider.

use super::{Body, Instant, Kind, NEWTON, Rate, Vector, each, energy_rate};
use linkage::Vector3;
use linkage_interpreted::interpreted;
use nalgebra::{Matrix3, Rotation3, Unit};

// RSSR: a crank that turns by an angle, a slender rod between two ball joints, a rocker with a frame and an inertia matrix.

interpreted! {
    pub struct Rssr {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 210g;
        param i1 = 30kg*mm^2;
        param i2 = 140kg*mm^2;
        param ixx = 20kg*mm^2;
        param iyy = 50kg*mm^2;
        param izz = 60kg*mm^2;
        param ixy = 1kg*mm^2;
        param ixz = -0.8kg*mm^2;
        param iyz = 0.5kg*mm^2;
        argument load = 20N;
        input phi = 0deg in 0deg..360deg at omega, epsilon;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let axis = turn((0, 0, 1), (1, 0, 0), -tilt);
        let lever = turn((1, 0, 0), axis, psi);
        let end = pivot + rocker * lever;
        loop distance(pin, end) = coupler;
        let wing = frame(pivot, lever, axis);
        let c1 = turn((5mm, crank / 2, 4mm), (1, 0, 0), phi);
        let c2 = pin + (end - pin) / 3;
        let c3 = point_in(wing, (rocker / 2, 5mm, -8mm));

        gravity = (1m/s^2, -2m/s^2, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm, 0mm) about (2, 0, 0), turns phi, mass m1 at c1, inertia i1;
        body rod = ball j2 on crank at pin, turns end - pin, mass m2 at c2, inertia i2;
        body rocker = pin j4 on frame at pivot about axis, turns wing, mass m3 at c3,
            inertia ((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz));
        ball j3 = rod on rocker at end;
        force (load, -load, load / 2) on rod at c2;
        force (load, 2 * load, 0) on rocker from crank at end;
        torque (0.3N*m, -0.2N*m, 1N*m) on rocker;
        spring 0.2N/mm from frame at (0mm, 100mm, 50mm) to rod at c2, free 30mm;
        spring 200N*mm on j1, free 20deg;
        damper 20N*mm*s on j4;
        damper 0.02N*s/mm from crank at c1 to rocker at end;
    }
    impl Rssr {
        pub fn motion(phi) -> RssrMotion {
            pin, vp: velocity(pin), ap: acceleration(pin), end, ve: velocity(end), ae: acceleration(end), axis, wing,
            wx: velocity(wing.x), wy: velocity(wing.y), wz: velocity(wing.z),
            ex: acceleration(wing.x), ey: acceleration(wing.y), ez: acceleration(wing.z), c1, c2, c3,
        }
        pub fn forces(phi, omega, epsilon, load) -> RssrForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), m1: moment(j1), m4: moment(j4),
            t: torque(phi), p: power(), s: shaking_force(), sm: shaking_moment(pivot),
        }
        pub fn torque(phi, omega, epsilon, load) -> RssrTorque { t: torque(phi) }
        pub fn energy(phi, omega) -> RssrEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

/// Angular velocity and acceleration from three axes with their velocities and accelerations.
pub(crate) fn spin(axes: [Vector; 3], v: [Vector; 3], a: [Vector; 3]) -> [Vector; 2] {
    let half = |rates: [Vector; 3]| {
        let parts = axes.iter().zip(&rates);
        parts.map(|(axis, rate)| axis.cross(rate)).sum::<Vector>() / 2.0
    };
    [half(v), half(a)]
}

/// The same of a rod along `u`, without spin.
pub(crate) fn swing(u: Vector, v: Vector, a: Vector) -> [Vector; 2] {
    let square = u.norm_squared();
    let fade = u.cross(&v) * (2.0 * u.dot(&v) / (square * square));
    [u.cross(&v) / square, u.cross(&a) / square - fade]
}

fn instant(m: &Rssr, at: &RssrMotion, (phi, rate): (f64, Rate), load: f64) -> Instant {
    let mut all = Instant::new(false, 100.0, NEWTON, Vector::new(1e3, -2e3, -9806.65));
    let still = [Vector::zeros(); 3];
    let about = rate.of([Vector::x(), Vector::zeros()]);
    // What a body has across a fixed axis that it turns about counts only if products of inertia are known: here none.
    let along = Vector::x() * Vector::x().transpose() * m.i1;
    let crank = Body::new(still, about).add_mass(m.m1, at.c1);
    let crank = Some(all.body(crank.add_inertia(along)));
    let [vp, ap] = rate.of([at.vp, at.ap]);
    let [ve, ae] = rate.of([at.ve, at.ae]);
    let rod = Body::new([at.pin, vp, ap], swing(at.end - at.pin, ve - vp, ae - ap));
    // Nothing that is seen depends on the inertia about the rod's line.
    let rod = rod
        .add_mass(m.m2, at.c2)
        .add_inertia(Matrix3::identity() * m.i2);
    let rod = Some(all.body(rod));
    let axes = [at.wing.x, at.wing.y, at.wing.z];
    let rates = [[at.wx, at.ex], [at.wy, at.ey], [at.wz, at.ez]].map(|own| rate.of(own));
    let turn = spin(axes, rates.map(|own| own[0]), rates.map(|own| own[1]));
    let to_space = Matrix3::from_columns(&axes);
    let own = Matrix3::new(
        m.ixx, m.ixy, m.ixz, m.ixy, m.iyy, m.iyz, m.ixz, m.iyz, m.izz,
    );
    let pivot = [m.pivot, Vector::zeros(), Vector::zeros()];
    let rocker = Body::new(pivot, turn).add_mass(m.m3, at.c3);
    let rocker = rocker.add_inertia(to_space * own * to_space.transpose());
    let rocker = Some(all.body(rocker));
    all.driven(Kind::Pin(Vector::x()), 0, None, Vector::zeros());
    all.joint(Kind::Ball, 1, crank, at.pin);
    all.joint(Kind::Ball, 1, rocker, at.end);
    all.joint(Kind::Pin(at.axis), 2, None, m.pivot);

    all.force([rod, None], at.c2, Vector::new(load, -load, load / 2.0));
    all.force([rocker, crank], at.end, Vector::new(load, 2.0 * load, 0.0));
    all.torque([rocker, None], Vector::new(300.0, -200.0, 1000.0));
    all.spring(
        [(None, Vector::new(0.0, 100.0, 50.0)), (rod, at.c2)],
        0.2,
        30.0,
    );
    all.couple(
        [crank, None],
        Vector::x() * (-200.0 * (phi - 20f64.to_radians())),
    );
    all.turn_damper([rocker, None], at.axis, 20.0);
    all.damper([(crank, at.c1), (rocker, at.end)], 0.02);
    all
}

#[test]
fn reactions_and_powers() {
    each(0xe1, |m: Rssr, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(20.0));
        let at = linkage.motion(phi);
        let all = instant(&m, &at, (phi, rate), load);
        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(0, found.m1);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        let alone = linkage.torque(phi, rate.omega, rate.epsilon, load);
        solution.expect_torque(solution.drive(0), alone.t);
        let [force, moment] = all.shaking(m.pivot);
        solution.expect_size(force, found.s);
        solution.expect_size(moment / 100.0, found.sm / 100.0);

        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}

/// The axes are where the mechanism says: by another rotation than the compiler's.
#[test]
fn axes() {
    let m = Rssr::default();
    let at = m.assemble().expect("it assembles").motion(1.0);
    let tilted = Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::x()), -m.tilt);
    assert!((tilted * Vector3::z() - at.axis).norm() < 1e-15);
    assert!((at.wing.z - at.axis).norm() < 1e-14);
}

// RSSP: a crank drives a slider along a line in space by a rod between two ball joints. The crank has a frame and an inertia matrix.

interpreted! {
    pub struct Rssp {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param away = 20mm;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 210g;
        param i2 = 140kg*mm^2;
        param ixx = 40kg*mm^2;
        param iyy = 30kg*mm^2;
        param izz = 50kg*mm^2;
        argument load = 20N;
        input phi = 10deg in 0deg..360deg at omega, epsilon;
        unknown x = 120mm;
        const way = (2, 1, -1);
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let end = x * unit(way) + (0, away, 10mm);
        loop distance(pin, end) = coupler;
        let wheel = frame((0mm, 0mm, 0mm), turn((0, 1, 0), (1, 0, 0), phi), turn((0, 0, 1), (1, 0, 0), phi));
        let c1 = point_in(wheel, (3mm, 5mm, -8mm));
        let c2 = (pin + end) / 2;
        let c3 = end + (10mm, -7mm, 5mm);
        gravity = (0, 0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm, 0mm) about (1, 0, 0), turns wheel, mass m1 at c1, inertia (ixx, iyy, izz);
        body ram = slide j4 on frame at end along way, mass m3 at c3;
        body rod = ball j3 on ram at end, turns end - pin, mass m2 at c2, inertia i2;
        ball j2 = crank on rod at pin;
        force (-load, load, 0) on ram at c3;
        spring 0.4N/mm on j4, free 100mm;
        damper 0.03N*s/mm on j4;
    }
    impl Rssp {
        pub fn motion(phi) -> RsspMotion {
            pin, vp: velocity(pin), ap: acceleration(pin), end, ve: velocity(end), ae: acceleration(end), wheel,
            wx: velocity(wheel.x), wy: velocity(wheel.y), wz: velocity(wheel.z),
            ex: acceleration(wheel.x), ey: acceleration(wheel.y), ez: acceleration(wheel.z), c1, c2, c3,
        }
        pub fn forces(phi, omega, epsilon, load) -> RsspForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), m1: moment(j1), m4: moment(j4),
            t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> RsspEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn reactions_and_powers_with_a_slider() {
    each(0xf1, |m: Rssp, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(20.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(false, 100.0, NEWTON, Vector::new(0.0, 0.0, -9806.65));
        let axes = [at.wheel.x, at.wheel.y, at.wheel.z];
        let rates = [[at.wx, at.ex], [at.wy, at.ey], [at.wz, at.ez]].map(|own| rate.of(own));
        let turn = spin(axes, rates.map(|own| own[0]), rates.map(|own| own[1]));
        let to_space = Matrix3::from_columns(&axes);
        let own = Matrix3::from_diagonal(&Vector::new(m.ixx, m.iyy, m.izz));
        let crank = Body::new([Vector::zeros(); 3], turn).add_mass(m.m1, at.c1);
        let crank = all.body(crank.add_inertia(to_space * own * to_space.transpose()));
        let [vp, ap] = rate.of([at.vp, at.ap]);
        let [ve, ae] = rate.of([at.ve, at.ae]);
        let ram = Body::new([at.end, ve, ae], [Vector::zeros(); 2]).add_mass(m.m3, at.c3);
        let ram = Some(all.body(ram));
        let rod = Body::new([at.end, ve, ae], swing(at.end - at.pin, ve - vp, ae - ap));
        let rod = rod
            .add_mass(m.m2, at.c2)
            .add_inertia(Matrix3::identity() * m.i2);
        let rod = all.body(rod);
        let way = Vector::new(2.0, 1.0, -1.0).normalize();
        all.driven(Kind::Pin(Vector::x()), crank, None, Vector::zeros());
        all.joint(Kind::Ball, crank, Some(rod), at.pin);
        all.joint(Kind::Ball, rod, ram, at.end);
        all.joint(Kind::Slide(way), 1, None, at.end);
        all.force([ram, None], at.c3, Vector::new(-load, load, 0.0));
        all.pair(
            [ram, None],
            at.end,
            way * (-0.4 * (at.end.dot(&way) - 100.0)),
        );
        all.slide_damper([ram, None], (at.end, way), 0.03);

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(0, found.m1);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}
