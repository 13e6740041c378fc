//! Gears: one shaft turns a crank at half speed, and two cranks of a five-bar are tied to each other.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

interpreted! {
    /// The rocker of a four-bar that a half-speed shaft drives turns a wheel by gears, beside a flywheel on the shaft itself.
    pub struct Geared {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param c = 80mm;
        param base = (100mm, 5mm);
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 210g;
        param m5 = 330g;
        param i0 = 90kg*mm^2;
        param i2 = 200kg*mm^2;
        param i3 = 80kg*mm^2;
        param i5 = 30kg*mm^2;
        argument load = 300N*mm;
        input phi = 80deg in 0deg..720deg at omega, epsilon;
        unknown theta = 20deg;
        unknown psi = 60deg;
        unknown chi = -150deg;
        let p2 = polar(a, phi / 2);
        let p3 = base + polar(c, psi);
        loop p2 + polar(b, theta) = p3;
        loop chi = -2.5 * psi;
        const hub = (180mm, 20mm);
        let c2 = p2 + polar(b / 3, theta + 10deg);
        let c3 = base + polar(c / 2, psi);
        let c5 = hub + polar(6mm, chi);

        gravity = (0, -9.80665m/s^2);
        body shaft = pin j0 on frame at (-50mm, 0mm), turns phi, inertia i0;
        body crank = pin j1 on frame at (0mm, 0mm), turns phi / 2, mass m1 at p2 / 2;
        body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
        body rocker = pin j4 on frame at base, turns psi, mass m3 at c3, inertia i3;
        body wheel = pin j5 on frame at hub, turns chi, mass m5 at c5, inertia i5;
        pin j3 = coupler on rocker at p3;
        torque load on wheel;
        damper 20N*mm*s on j5;
        torque load / 7 on shaft;
    }
    impl Geared {
        pub fn motion(phi) -> GearedMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, c2, c3, c5,
            wt: velocity(theta), et: acceleration(theta), wp: velocity(psi), ep: acceleration(psi), wc: velocity(chi), ec: acceleration(chi),
        }
        pub fn forces(phi, omega, epsilon, load) -> GearedForces {
            f0: reaction(j0), f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(j5),
            t: torque(phi), p: power(),
        }
        pub fn alone(phi, omega, epsilon, load) -> GearedAlone { t: torque(phi) }
        pub fn energy(phi, omega) -> GearedEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

interpreted! {
    /// A five-bar whose other crank turns with the first coupler by gears on that coupler's ends.
    pub struct Tied {
        unit mm;
        param a = 20mm;
        param b = 90mm;
        param c = 85mm;
        param d = 70mm;
        param base = (80mm, 0mm);
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 70g;
        param m4 = 40g;
        param i2 = 100kg*mm^2;
        param i3 = 70kg*mm^2;
        argument load = 30N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 60deg;
        unknown chi = 125deg;
        unknown psi = 60deg;
        let p2 = polar(a, phi);
        let p3 = p2 + polar(b, theta);
        let p4 = base + polar(d, psi);
        loop p3 = p4 + polar(c, chi);
        loop psi = 0.5 * theta + 30deg;
        let c2 = p2 + polar(b / 2, theta);
        let c3 = p4 + polar(c / 3, chi);
        let c4 = base + polar(d / 2, psi);

        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at p2 / 2;
        body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
        body arm = pin j5 on frame at base, turns psi, mass m4 at c4;
        body link = pin j4 on arm at p4, turns chi, mass m3 at c3, inertia i3;
        pin j3 = coupler on link at p3;
        force (load, load) on link at c3;
    }
    impl Tied {
        pub fn motion(phi) -> TiedMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, p4, v4: velocity(p4), a4: acceleration(p4), c2, c3, c4,
            wt: velocity(theta), et: acceleration(theta), wp: velocity(psi), ep: acceleration(psi), wc: velocity(chi), ec: acceleration(chi),
            margin: margin(),
        }
        pub fn forces(phi, omega, epsilon, load) -> TiedForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(j5), t: torque(phi), p: power(),
        }
        pub fn alone(phi, omega, epsilon, load) -> TiedAlone { t: torque(phi) }
        pub fn energy(phi, omega) -> TiedEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn half_speed_and_a_wheel() {
    each(0xb1, |m: Geared, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (2.0 * random.turn(), Rate::any(random), random.load(300.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let hub = Vector2::new(180.0, 20.0);
        let [p2, p3, c2, c3, c5] = [at.p2, at.p3, at.c2, at.c3, at.c5].map(flat);
        let side = Vector2::new(-50.0, 0.0);
        let shaft = rate.pivot(side, [1.0, 0.0]).add_inertia(disc(m.i0));
        let shaft = Some(all.body(shaft));
        let crank = rate
            .pivot(Vector2::zeros(), [0.5, 0.0])
            .add_mass(m.m1, p2 / 2.0);
        let crank = Some(all.body(crank));
        let coupler = rate
            .plane([at.p2, at.v2, at.a2], [at.wt, at.et])
            .add_mass(m.m2, c2);
        all.body(coupler.add_inertia(disc(m.i2)));
        let rocker = rate.pivot(m.base, [at.wp, at.ep]).add_mass(m.m3, c3);
        let rocker = Some(all.body(rocker.add_inertia(disc(m.i3))));
        let wheel = rate.pivot(hub, [at.wc, at.ec]).add_mass(m.m5, c5);
        let wheel = Some(all.body(wheel.add_inertia(disc(m.i5))));
        all.driven(pin(), 0, None, flat(side));
        all.driven(pin(), 1, None, Vector::zeros());
        all.joint(pin(), 2, crank, p2);
        all.joint(pin(), 2, rocker, p3);
        all.joint(pin(), 3, None, flat(m.base));
        all.joint(pin(), 4, None, flat(hub));
        // chi + 2.5 psi does no work.
        all.tie(&[(4, 1.0), (3, 2.5)]);
        all.torque([wheel, None], Vector::z() * load);
        all.torque([shaft, None], Vector::z() * (load / 7.0));
        all.turn_damper([wheel, None], Vector::z(), 20.0);

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [found.f0, found.f1, found.f2, found.f3, found.f4, found.f5];
        solution.expect_forces(forces);
        let drive = solution.drive(0) + solution.drive(1) / 2.0;
        solution.expect_torque(drive, found.t);
        let alone = linkage.alone(phi, rate.omega, rate.epsilon, load);
        solution.expect_torque(drive, alone.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered + all.dissipated, found.p, rate.omega);
        true
    });
}

#[test]
fn coupler_and_arm() {
    each(0xb2, |m: Tied, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(30.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 80.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [p2, p3, p4, c2, c3, c4] = [at.p2, at.p3, at.p4, at.c2, at.c3, at.c4].map(flat);
        let crank = rate
            .pivot(Vector2::zeros(), [1.0, 0.0])
            .add_mass(m.m1, p2 / 2.0);
        let crank = Some(all.body(crank));
        let coupler = rate
            .plane([at.p2, at.v2, at.a2], [at.wt, at.et])
            .add_mass(m.m2, c2);
        all.body(coupler.add_inertia(disc(m.i2)));
        let arm = rate.pivot(m.base, [at.wp, at.ep]).add_mass(m.m4, c4);
        let arm = Some(all.body(arm));
        let link = rate
            .plane([at.p4, at.v4, at.a4], [at.wc, at.ec])
            .add_mass(m.m3, c3);
        let link = Some(all.body(link.add_inertia(disc(m.i3))));
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 1, crank, p2);
        all.joint(pin(), 1, link, p3);
        all.joint(pin(), 3, arm, p4);
        all.joint(pin(), 2, None, flat(m.base));
        // psi - theta / 2 does no work.
        all.tie(&[(2, 1.0), (1, -0.5)]);
        all.force([link, None], c3, Vector::new(load, load, 0.0));

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [found.f1, found.f2, found.f3, found.f4, found.f5];
        solution.expect_forces(forces);
        solution.expect_torque(solution.drive(0), found.t);
        let alone = linkage.alone(phi, rate.omega, rate.epsilon, load);
        solution.expect_torque(solution.drive(0), alone.t);
        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}
