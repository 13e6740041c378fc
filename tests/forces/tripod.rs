//! Three legs that carry one link: a triad of the plane, and a tripod in space.

use super::rssr::swing;
use super::{Body, Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};
use linkage::{Vector2, Vector3};
use linkage_interpreted::interpreted;
use nalgebra::Matrix3;

// Three driven legs in space meet in a point: barrels on ball joints, rods that slide in them, the load in the point.

interpreted! {
    pub struct Tripod {
        unit mm;
        param foot = 100mm;
        param m1 = 0.3kg;
        param m2 = 0.2kg;
        param i1 = 200kg*mm^2;
        argument load = 40N;
        input l1 = 200mm in 180mm..220mm at v1, a1;
        input l2 = 200mm in 180mm..220mm at v2, a2;
        input l3 = 200mm in 180mm..220mm at v3, a3;
        unknown tip = (0mm, 0mm, 170mm);
        const up = (0, 0, 1);
        let f1 = (foot, 0mm, 0mm);
        let f2 = turn(f1, up, 120deg);
        let f3 = turn(f1, up, 240deg);
        loop distance(tip, f1) = l1;
        loop distance(tip, f2) = l2;
        loop distance(tip, f3) = l3;
        let c1 = f1 + 60mm * (tip - f1) / l1;
        let c2 = f2 + 60mm * (tip - f2) / l2;
        let c3 = f3 + 60mm * (tip - f3) / l3;
        gravity = (0, 0, -9.80665m/s^2);
        body barrel1 = ball j1 on frame at f1, turns tip - f1, mass m1 at c1, inertia i1;
        body barrel2 = ball j2 on frame at f2, turns tip - f2, mass m1 at c2, inertia i1;
        body barrel3 = ball j3 on frame at f3, turns tip - f3, mass m1 at c3, inertia i1;
        body rod1 = slide s1 on barrel1 at tip along tip - f1, mass m2 at tip;
        body rod2 = slide s2 on barrel2 at tip along tip - f2, mass m2 at tip;
        body rod3 = slide s3 on barrel3 at tip along tip - f3, mass m2 at tip;
        ball k2 = rod2 on rod1 at tip;
        ball k3 = rod3 on rod1 at tip;
        force (load, -load, -2 * load) on rod1 at tip;
    }
    impl Tripod {
        pub fn motion(l1, l2, l3) -> TripodMotion {
            tip, v: velocity(tip), a: acceleration(tip), f1, f2, f3, c1, c2, c3, margin: margin(),
        }
        pub fn forces(l1, l2, l3, v1, a1, v2, a2, v3, a3, load) -> TripodForces {
            j1: reaction(j1), j2: reaction(j2), j3: reaction(j3), s1: reaction(s1), t1: moment(s1), k2: reaction(k2), k3: reaction(k3),
            d1: force(l1), d2: force(l2), d3: force(l3), p: power(),
        }
    }
}

#[test]
fn legs() {
    each(0x131, |m: Tripod, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let lengths = [0, 1, 2].map(|_| random.between(185.0, 215.0));
        let v: [f64; 3] = [0, 1, 2].map(|_| random.load(100.0));
        let a: [f64; 3] = [0, 1, 2].map(|_| random.load(2000.0));
        let load = random.load(40.0);
        let at = linkage.motion(lengths[0], lengths[1], lengths[2]);
        let (mut speed, mut gain): (Vector3<f64>, Vector3<f64>) =
            (Vector::zeros(), Vector::zeros());
        for i in 0..3 {
            speed += at.v[i] * v[i];
            gain += at.v[i] * a[i];
            for j in 0..3 {
                gain += at.a[i][j] * (v[i] * v[j]);
            }
        }
        let mut all = Instant::new(false, 150.0, NEWTON, Vector::new(0.0, 0.0, -9806.65));
        let legs = [(at.f1, at.c1), (at.f2, at.c2), (at.f3, at.c3)];
        for (foot, centre) in legs {
            let turn = swing(at.tip - foot, speed, gain);
            let barrel = Body::new([foot, Vector::zeros(), Vector::zeros()], turn);
            all.body(
                barrel
                    .add_mass(m.m1, centre)
                    .add_inertia(Matrix3::identity() * m.i1),
            );
        }
        for (foot, _) in legs {
            let turn = swing(at.tip - foot, speed, gain);
            all.body(Body::new([at.tip, speed, gain], turn).add_mass(m.m2, at.tip));
        }
        for (leg, (foot, _)) in legs.into_iter().enumerate() {
            all.joint(Kind::Ball, leg, None, foot);
        }
        for (leg, (foot, _)) in legs.into_iter().enumerate() {
            all.driven(Kind::Slide(at.tip - foot), 3 + leg, Some(leg), at.tip);
        }
        all.joint(Kind::Ball, 4, Some(3), at.tip);
        all.joint(Kind::Ball, 5, Some(3), at.tip);
        all.force(
            [Some(3), None],
            at.tip,
            Vector::new(load, -load, -2.0 * load),
        );

        let solution = all.solve();
        let [l1, l2, l3] = lengths;
        let found = linkage.forces(l1, l2, l3, v[0], a[0], v[1], a[1], v[2], a[2], load);
        solution.expect_forces([found.j1, found.j2, found.j3, found.s1]);
        solution.expect_moment(3, found.t1);
        solution.expect_force(6, found.k2);
        solution.expect_force(7, found.k3);
        for (leg, drive) in [found.d1, found.d2, found.d3].into_iter().enumerate() {
            solution.expect_size(Vector::x() * solution.drive(3 + leg), Vector::x() * drive);
        }
        let fastest = v.into_iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        solution.expect_power(solution.power(&all), found.p, fastest / 150.0);
        true
    });
}

// A triad: a ternary link on three legs.

interpreted! {
    pub struct Platform {
        unit mm;
        param crank = 40mm;
        param leg = 50mm;
        param m1 = 130g;
        param ma = 50g;
        param mb = 60g;
        param mc = 70g;
        param mp = 0.4kg;
        param ia = 12000g*mm^2;
        param ip = 300kg*mm^2;
        argument load = 20N;
        input phi = 60deg in 40deg..80deg at omega, epsilon;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        const foot_b = (120mm, 0mm);
        const foot_c = (60mm, 110mm);
        let o = polar(crank, phi);
        let a = o + polar(leg, leg_a);
        let b = a + polar(60mm, tilt);
        let c = a + polar(60mm, tilt + 60deg);
        loop b = foot_b + polar(leg, leg_b);
        loop c = foot_c + polar(leg, leg_c);
        let ga = o + polar(leg / 2, leg_a);
        let gb = foot_b + polar(leg / 3, leg_b + 20deg);
        let gc = foot_c + polar(leg / 2, leg_c);
        let gp = a + polar(30mm, tilt + 25deg);

        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at polar(crank / 2, phi);
        body bar_a = pin j2 on crank at o, turns leg_a, mass ma at ga, inertia ia;
        body plate = pin j3 on bar_a at a, turns tilt, mass mp at gp, inertia ip;
        body bar_b = pin j4 on frame at foot_b, turns leg_b, mass mb at gb;
        body bar_c = pin j5 on frame at foot_c, turns leg_c, mass mc at gc;
        pin j6 = plate on bar_b at b;
        pin j7 = bar_c on plate at c;
        force (load, -load) on plate at gp;
    }
    impl Platform {
        pub fn motion(phi) -> PlatformMotion {
            o, ov: velocity(o), oa: acceleration(o), a, av: velocity(a), aa: acceleration(a), b, c, g1: polar(crank / 2, phi), ga, gb, gc, gp,
            wa: velocity(leg_a), ea: acceleration(leg_a), wb: velocity(leg_b), eb: acceleration(leg_b),
            wc: velocity(leg_c), ec: acceleration(leg_c), wp: velocity(tilt), ep: acceleration(tilt),
        }
        pub fn forces(phi, omega, epsilon, load) -> PlatformForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(j5), f6: reaction(j6), f7: reaction(j7),
            t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> PlatformEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn reactions_and_powers() {
    each(0x91, |m: Platform, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let phi = random.between(0.7, 1.39);
        let (rate, load) = (Rate::any(random), random.load(20.0));
        let at = linkage.motion(phi);
        if !at.ep.is_finite() {
            return false;
        }
        let mut all = Instant::new(true, 60.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [foot_b, foot_c] = [Vector2::new(120.0, 0.0), Vector2::new(60.0, 110.0)];
        let [g1, ga, gb, gc, gp] = [at.g1, at.ga, at.gb, at.gc, at.gp].map(flat);
        let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]).add_mass(m.m1, g1);
        let crank = Some(all.body(crank));
        let bar_a = rate
            .plane([at.o, at.ov, at.oa], [at.wa, at.ea])
            .add_mass(m.ma, ga);
        let bar_a = Some(all.body(bar_a.add_inertia(disc(m.ia))));
        let plate = rate
            .plane([at.a, at.av, at.aa], [at.wp, at.ep])
            .add_mass(m.mp, gp);
        let plate = Some(all.body(plate.add_inertia(disc(m.ip))));
        let bar_b = Some(all.body(rate.pivot(foot_b, [at.wb, at.eb]).add_mass(m.mb, gb)));
        all.body(rate.pivot(foot_c, [at.wc, at.ec]).add_mass(m.mc, gc));
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 1, crank, flat(at.o));
        all.joint(pin(), 2, bar_a, flat(at.a));
        all.joint(pin(), 3, None, flat(foot_b));
        all.joint(pin(), 4, None, flat(foot_c));
        all.joint(pin(), 2, bar_b, flat(at.b));
        all.joint(pin(), 4, plate, flat(at.c));
        all.force([plate, None], gp, Vector::new(load, -load, 0.0));

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [
            found.f1, found.f2, found.f3, found.f4, found.f5, found.f6, found.f7,
        ];
        solution.expect_forces(forces);
        solution.expect_torque(solution.drive(0), found.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}
