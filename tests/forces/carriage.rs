//! Which joints an input drives, and a driven carriage in motion.

use super::{Body, Instant, Kind, NEWTON, Rate, Vector, disc, each, flat, pin};
use linkage::Vector2;
use linkage_interpreted::interpreted;

// A driven carriage with a plate fixed to it, which carries a crank that a second input turns, and a bar that a loop ties to the frame.

interpreted! {
    pub struct Carriage {
        unit mm;
        param lean = 15deg;
        param a = 40mm;
        param b = 160mm;
        param high = 50mm;
        param m1 = 3kg;
        param m2 = 1kg;
        param m3 = 0.4kg;
        param m4 = 0.2kg;
        param m5 = 0.6kg;
        param i3 = 700kg*mm^2;
        param i4 = 400kg*mm^2;
        argument load = 30N;
        input x = 50mm in 0mm..100mm at v, a_x;
        input phi = 30deg in 0deg..360deg at omega, epsilon;
        unknown theta = -10deg;
        unknown y = 250mm;
        let o = polar(x, lean);
        let q = o + (20mm, 30mm);
        let p = q + polar(a, phi);
        let end = (y, -high);
        loop p + polar(b, theta) = end;
        let c1 = o + (10mm, -5mm);
        let c2 = o + (5mm, 40mm);
        let c3 = q + polar(a / 2, phi);
        let c4 = p + polar(b / 2, theta);
        gravity = (0, -9.80665m/s^2);
        body carriage = slide j1 on frame at o along dir(lean), mass m1 at c1;
        body plate = fixed j2 on carriage at q, mass m2 at c2;
        body crank = pin j3 on plate at q, turns phi, mass m3 at c3, inertia i3;
        body bar = pin j4 on crank at p, turns theta, mass m4 at c4, inertia i4;
        body shoe = pin j5 on bar at end, turns 0deg, mass m5 at end;
        slide j6 = shoe on frame at end along (1, 0);
        force (-load, load) on shoe at end;
        torque load * 3mm on crank from carriage;
    }
    impl Carriage {
        pub fn motion(x, phi) -> CarriageMotion {
            o, ov: velocity(o), oa: acceleration(o), q, qv: velocity(q), qa: acceleration(q), p, pv: velocity(p), pa: acceleration(p),
            end, sv: velocity(end), sa: acceleration(end), w: velocity(theta), e: acceleration(theta), c1, c2, c3, c4,
        }
        pub fn forces(x, phi, v, a_x, omega, epsilon, load) -> CarriageForces {
            f1: reaction(j1), m1: moment(j1), f2: reaction(j2), m2: moment(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(j5),
            f6: reaction(j6), m6: moment(j6), f: force(x), t: torque(phi), p: power(),
        }
        pub fn drives(x, phi, v, a_x, omega, epsilon, load) -> CarriageDrives { f: force(x), t: torque(phi) }
    }
}

/// Speeds and accelerations of both inputs, as in `five_bar`.
fn in_time(v: [Vector; 2], a: [[Vector; 2]; 2], [w, e]: [[f64; 2]; 2]) -> [Vector; 2] {
    let curved =
        a[0][0] * (w[0] * w[0]) + (a[0][1] + a[1][0]) * (w[0] * w[1]) + a[1][1] * (w[1] * w[1]);
    [
        v[0] * w[0] + v[1] * w[1],
        curved + v[0] * e[0] + v[1] * e[1],
    ]
}

#[test]
fn reactions_and_drives() {
    each(0x111, |m: Carriage, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (x, phi, load) = (random.between(0.0, 100.0), random.turn(), random.load(30.0));
        let rates = [
            [random.load(500.0), random.load(20.0)],
            [random.load(5000.0), random.load(300.0)],
        ];
        let at = linkage.motion(x, phi);
        let body = |p: Vector2<f64>, v: [Vector2<f64>; 2], a: [[Vector2<f64>; 2]; 2], turn| {
            let [v, a] = in_time(v.map(flat), a.map(|row| row.map(flat)), rates);
            Body::new([flat(p), v, a], turn)
        };
        let still = [Vector::zeros(); 2];
        let turning = [Vector::z() * rates[0][1], Vector::z() * rates[1][1]];
        let about = |x| Vector::z() * x;
        let swaying = in_time(at.w.map(about), at.e.map(|row| row.map(about)), rates);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let carriage = body(at.o, at.ov, at.oa, still).add_mass(m.m1, flat(at.c1));
        let carriage = Some(all.body(carriage));
        let plate = body(at.q, at.qv, at.qa, still).add_mass(m.m2, flat(at.c2));
        let plate = Some(all.body(plate));
        let crank = body(at.q, at.qv, at.qa, turning).add_mass(m.m3, flat(at.c3));
        let crank = Some(all.body(crank.add_inertia(disc(m.i3))));
        let bar = body(at.p, at.pv, at.pa, swaying).add_mass(m.m4, flat(at.c4));
        let bar = Some(all.body(bar.add_inertia(disc(m.i4))));
        let shoe = body(at.end, at.sv, at.sa, still).add_mass(m.m5, flat(at.end));
        let shoe = Some(all.body(shoe));
        let way = Vector::new(m.lean.cos(), m.lean.sin(), 0.0);
        all.driven(Kind::Slide(way), 0, None, flat(at.o));
        all.joint(Kind::Fixed, 1, carriage, flat(at.q));
        all.driven(pin(), 2, plate, flat(at.q));
        all.joint(pin(), 3, crank, flat(at.p));
        all.joint(pin(), 4, bar, flat(at.end));
        all.joint(Kind::Slide(Vector::x()), 4, None, flat(at.end));
        all.force([shoe, None], flat(at.end), Vector::new(-load, load, 0.0));
        all.torque([crank, carriage], Vector::z() * (3.0 * load));

        let solution = all.solve();
        let ([v, omega], [a_x, epsilon]) = (rates[0], rates[1]);
        let found = linkage.forces(x, phi, v, a_x, omega, epsilon, load);
        let forces = [found.f1, found.f2, found.f3, found.f4, found.f5, found.f6];
        solution.expect_forces(forces);
        for (joint, moment) in [(0, found.m1), (1, found.m2), (5, found.m6)] {
            solution.expect_moment(joint, moment);
        }
        let alone = linkage.drives(x, phi, v, a_x, omega, epsilon, load);
        for (force, torque) in [(found.f, found.t), (alone.f, alone.t)] {
            solution.expect_size(Vector::x() * solution.drive(0), Vector::x() * force);
            solution.expect_torque(solution.drive(2), torque);
        }
        let speed = omega.abs().max(v.abs() / 100.0);
        solution.expect_power(solution.power(&all), found.p, speed);
        true
    });
}

// Which joints an input drives: one whose angle a loop ties to the input is, one that another link holds is not.

interpreted! {
    /// A crank at half speed, by a loop; a driven crank, a parallel one that follows, and the coupler between them.
    pub struct Parallel {
        unit mm;
        param a = 50mm;
        param base = 100mm;
        param m0 = 130g;
        param m1 = 100g;
        param m2 = 80g;
        param m3 = 200g;
        argument load = 10N;
        input phi = 80deg in 0deg..720deg at omega, epsilon;
        unknown psi = 40deg;
        loop psi = phi / 2;
        let g = polar(a, psi);
        let p = polar(a, phi);
        let q = p + (base, 0mm);
        let c = p + (30mm, 20mm);
        gravity = (0, -9.80665m/s^2);
        body slow = pin j0 on frame at (0mm, 0mm), turns psi, mass m0 at g;
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at p / 2;
        body other = pin j2 on frame at (base, 0mm), turns phi, mass m2 at q;
        body coupler = pin j3 on crank at p, turns 0deg, mass m3 at c;
        pin j4 = coupler on other at q;
        force (load, load) on coupler at c;
    }
    impl Parallel {
        pub fn motion(phi) -> ParallelMotion { g, p, v: velocity(p), a: acceleration(p), q, c }
        pub fn forces(phi, omega, epsilon, load) -> ParallelForces {
            f0: reaction(j0), f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), t: torque(phi), p: power(),
        }
        pub fn alone(phi, omega, epsilon, load) -> ParallelAlone { t: torque(phi) }
    }
}

#[test]
fn half_speed_and_a_parallelogram() {
    each(0x141, |m: Parallel, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (2.0 * random.turn(), Rate::any(random), random.load(10.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let zero = Vector2::zeros();
        let far = Vector2::new(m.base, 0.0);
        all.body(rate.pivot(zero, [0.5, 0.0]).add_mass(m.m0, flat(at.g)));
        all.body(
            rate.pivot(zero, [1.0, 0.0])
                .add_mass(m.m1, flat(at.p) / 2.0),
        );
        all.body(rate.pivot(far, [1.0, 0.0]).add_mass(m.m2, flat(at.q)));
        let coupler: Body = rate.plane([at.p, at.v, at.a], [0.0, 0.0]);
        let coupler = all.body(coupler.add_mass(m.m3, flat(at.c)));
        all.driven(pin(), 0, None, Vector::zeros());
        all.driven(pin(), 1, None, Vector::zeros());
        all.joint(pin(), 2, None, flat(far));
        all.joint(pin(), 3, Some(1), flat(at.p));
        all.joint(pin(), 3, Some(2), flat(at.q));
        all.force(
            [Some(coupler), None],
            flat(at.c),
            Vector::new(load, load, 0.0),
        );

        // In a line the coupler's forces along it are open.
        if phi.sin().abs() < 0.05 {
            return false;
        }
        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [found.f0, found.f1, found.f2, found.f3, found.f4];
        solution.expect_forces(forces);
        let torque = solution.drive(0) / 2.0 + solution.drive(1);
        let alone = linkage.alone(phi, rate.omega, rate.epsilon, load);
        solution.expect_torque(torque, found.t);
        solution.expect_torque(torque, alone.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        true
    });
}
