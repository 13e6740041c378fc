//! RSSP: a crank drives a slider along a line in space by a rod between two ball joints. The crank has a frame and an inertia matrix.

use linkage_interpreted::interpreted;
use nalgebra::Matrix3;

use super::rssr::{spin, swing};
use super::{Body, Instant, Kind, NEWTON, Rate, Vector, each, energy_rate};

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
fn reactions_and_powers() {
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
