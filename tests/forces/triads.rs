//! A triad: a ternary link on three legs.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

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
