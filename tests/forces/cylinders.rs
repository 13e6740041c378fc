//! Cylinders: a hydraulic one that lifts a boom, and RCCC, a crank and three cylindrical pairs.

use super::rssr::spin;
use super::{Body, Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};
use linkage::Vector2;
use linkage_interpreted::interpreted;
use nalgebra::Matrix3;

// RCCC: a crank and three cylindrical pairs, its coupler a body with a frame, its rocker one that turns by an angle.

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
        param m1 = 0.2kg;
        param m2 = 0.3kg;
        param m3 = 0.4kg;
        param ixx = 200kg*mm^2;
        param iyy = 350kg*mm^2;
        param izz = 300kg*mm^2;
        param i3 = 500kg*mm^2;
        argument load = 20N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
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
        let p2 = a12 * n12 + s2 * z2;
        let foot = base + s4 * z4;
        loop p2 + a23 * n23 + s3 * z3 = foot + a34 * n34;
        let p3 = p2 + a23 * n23;
        let link = frame(p2, n23, z2);
        let c2 = point_in(link, (a23 / 2, 5mm, 7mm));
        let c3 = foot + (a34 / 2) * n34;

        gravity = (0, 3m/s^2, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm, 0mm) about z1, turns phi, mass m1 at a12 * n12;
        body coupler = cylinder j2 on crank at p2 along z2, turns link, mass m2 at c2, inertia (ixx, iyy, izz);
        body rocker = cylinder j4 on frame at foot about z4, turns psi, mass m3 at c3, inertia i3;
        cylinder j3 = coupler on rocker at p3 along z3;
        force (load, -load, 2 * load) on coupler at c2;
    }
    impl Rccc {
        pub fn motion(phi) -> RcccMotion {
            z2, z3, z4, p2, vp: velocity(p2), ap: acceleration(p2), p3, foot, vf: velocity(foot), af: acceleration(foot), link,
            wx: velocity(link.x), wy: velocity(link.y), wz: velocity(link.z),
            ex: acceleration(link.x), ey: acceleration(link.y), ez: acceleration(link.z),
            w: velocity(psi), e: acceleration(psi), c1: a12 * n12, c2, c3, margin: margin(),
        }
        pub fn forces(phi, omega, epsilon, load) -> RcccForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4),
            m1: moment(j1), m2: moment(j2), m3: moment(j3), m4: moment(j4), t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> RcccEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn reactions_and_powers() {
    each(0x121, |m: Rccc, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(20.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(false, 100.0, NEWTON, Vector::new(0.0, 3e3, -9806.65));
        let crank = Body::new(
            [Vector::zeros(); 3],
            rate.of([Vector::z(), Vector::zeros()]),
        );
        all.body(crank.add_mass(m.m1, at.c1));
        let axes = [at.link.x, at.link.y, at.link.z];
        let rates = [[at.wx, at.ex], [at.wy, at.ey], [at.wz, at.ez]].map(|own| rate.of(own));
        let turn = spin(axes, rates.map(|own| own[0]), rates.map(|own| own[1]));
        let to_space = Matrix3::from_columns(&axes);
        let own = Matrix3::from_diagonal(&Vector::new(m.ixx, m.iyy, m.izz));
        let [vp, ap] = rate.of([at.vp, at.ap]);
        let coupler = Body::new([at.p2, vp, ap], turn).add_mass(m.m2, at.c2);
        let coupler = all.body(coupler.add_inertia(to_space * own * to_space.transpose()));
        let [vf, af] = rate.of([at.vf, at.af]);
        let rocker = Body::new([at.foot, vf, af], rate.of([at.z4 * at.w, at.z4 * at.e]));
        let along = at.z4 * at.z4.transpose() * m.i3;
        all.body(rocker.add_mass(m.m3, at.c3).add_inertia(along));
        all.driven(Kind::Pin(Vector::z()), 0, None, Vector::zeros());
        all.joint(Kind::Cylinder(at.z2), 1, Some(0), at.p2);
        all.joint(Kind::Cylinder(at.z3), 1, Some(2), at.p3);
        all.joint(Kind::Cylinder(at.z4), 2, None, at.foot);
        all.force(
            [Some(coupler), None],
            at.c2,
            Vector::new(load, -load, 2.0 * load),
        );

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let pairs = [
            (found.f1, found.m1),
            (found.f2, found.m2),
            (found.f3, found.m3),
            (found.f4, found.m4),
        ];
        for (joint, (force, moment)) in pairs.into_iter().enumerate() {
            solution.expect_force(joint, force);
            solution.expect_moment(joint, moment);
        }
        solution.expect_torque(solution.drive(0), found.t);
        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}

// A linear drive: a hydraulic cylinder lifts a boom.

interpreted! {
    pub struct Boom {
        unit mm;
        param arm = 300mm;
        param reach = 900mm;
        param bend = 15deg;
        param foot = (350mm, -100mm);
        param m1 = 4kg;
        param m2 = 3kg;
        param m3 = 30kg;
        param i1 = 0.05kg*m^2;
        param i3 = 4kg*m^2;
        param leak = 0.7N*s/mm;
        argument load = 400N;
        input x = 350mm in 300mm..450mm at v, a;
        unknown theta = 120deg;
        unknown psi = 50deg;
        let end = polar(arm, psi);
        let p = foot + polar(x, theta);
        loop p = end;
        let hook = polar(reach, psi + bend);
        let c1 = foot + polar(100mm, theta);
        let c2 = p - polar(80mm, theta);
        let c3 = polar(0.5 * reach, psi + 5deg);
        gravity = (0, -9.80665m/s^2);
        body barrel = pin j1 on frame at foot, turns theta, mass m1 at c1, inertia i1;
        body rod = slide j2 on barrel at p along dir(theta), mass m2 at c2;
        body boom = pin j3 on frame at (0mm, 0mm), turns psi, mass m3 at c3, inertia i3;
        pin j4 = rod on boom at p;
        force (0, -load) on boom at hook;
        spring 2N/mm on j2, free 400mm;
        damper leak on j2;
    }
    impl Boom {
        pub fn motion(x) -> BoomMotion {
            p, pv: velocity(p), pa: acceleration(p), w1: velocity(theta), e1: acceleration(theta), w3: velocity(psi), e3: acceleration(psi),
            theta, hook, c1, c2, c3,
        }
        pub fn forces(x, v, a, load) -> BoomForces {
            f1: reaction(j1), f2: reaction(j2), m2: moment(j2), f3: reaction(j3), f4: reaction(j4), f: force(x), p: power(),
        }
        pub fn energy(x, v) -> BoomEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn reactions_and_powers_of_the_boom() {
    each(0xd1, |m: Boom, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (x, load) = (random.between(300.0, 450.0), random.load(400.0));
        let rate = Rate {
            omega: random.load(200.0),
            epsilon: random.load(2000.0),
        };
        let at = linkage.motion(x);
        let mut all = Instant::new(true, 500.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [p, c1, c2, c3] = [at.p, at.c1, at.c2, at.c3].map(flat);
        let barrel = rate.pivot(m.foot, [at.w1, at.e1]).add_mass(m.m1, c1);
        let barrel = Some(all.body(barrel.add_inertia(disc(m.i1))));
        let rod = rate
            .plane([at.p, at.pv, at.pa], [at.w1, at.e1])
            .add_mass(m.m2, c2);
        let rod = Some(all.body(rod));
        let boom = rate
            .pivot(Vector2::zeros(), [at.w3, at.e3])
            .add_mass(m.m3, c3);
        let boom = Some(all.body(boom.add_inertia(disc(m.i3))));
        let way = Vector::new(at.theta.cos(), at.theta.sin(), 0.0);
        all.joint(pin(), 0, None, flat(m.foot));
        all.driven(Kind::Slide(way), 1, barrel, p);
        all.joint(pin(), 2, None, Vector::zeros());
        all.joint(pin(), 1, boom, p);
        all.force([boom, None], flat(at.hook), Vector::new(0.0, -load, 0.0));
        all.pair([rod, barrel], p, way * (-2.0 * (x - 400.0)));
        all.slide_damper([rod, barrel], (p, way), m.leak);

        let solution = all.solve();
        let found = linkage.forces(x, rate.omega, rate.epsilon, load);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(1, found.m2);
        solution.expect_size(Vector::x() * solution.drive(1), Vector::x() * found.f);
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        let energy = linkage.energy(x, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}
