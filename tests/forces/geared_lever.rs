//! Gears beside a guide: block and lever turn alike because of the slide, the wheel on the lever because of its teeth. The coupler of a
//! four-bar in two welded halves.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, flat, pin};

interpreted! {
    pub struct GearedLever {
        unit mm;
        param a = 40mm;
        param base = (10mm, -90mm);
        param high = 60mm;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 0.5kg;
        param m4 = 0.2kg;
        param i2 = 2000g*mm^2;
        param i3 = 800000g*mm^2;
        param i4 = 50kg*mm^2;
        argument load = 300N*mm;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 75deg;
        unknown x = 110mm;
        unknown chi = -150deg;
        let p2 = polar(a, phi);
        let hub = base + polar(high, theta);
        loop p2 = base + polar(x, theta);
        loop chi = -2 * theta;
        let c4 = hub + polar(5mm, chi);
        gravity = (0, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at p2 / 3;
        body lever = pin b4 on frame at base, turns theta, mass m3 at hub, inertia i3;
        body block = pin b2 on crank at p2, turns theta, mass m2 at p2, inertia i2;
        slide b3 = block on lever at p2 along dir(theta);
        body wheel = pin b5 on lever at hub, turns chi, mass m4 at c4, inertia i4;
        torque load on wheel;
    }
    impl GearedLever {
        pub fn motion(phi) -> GearedLeverMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), w: velocity(theta), e: acceleration(theta), theta, hub, vh: velocity(hub), ah: acceleration(hub),
            wc: velocity(chi), ec: acceleration(chi), c4,
        }
        pub fn forces(phi, omega, epsilon, load) -> GearedLeverForces {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), f5: reaction(b5), m3: moment(b3), t: torque(phi),
        }
        pub fn alone(phi, omega, epsilon, load) -> GearedLeverAlone { t: torque(phi) }
    }
}

interpreted! {
    pub struct Welded {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param c = 80mm;
        param base = (100mm, 5mm);
        param m2 = 90g;
        param m3 = 0.21kg;
        param m4 = 0.3kg;
        param i2 = 50000g*mm^2;
        argument load = 20N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let p2 = polar(a, phi);
        let p3 = base + polar(c, psi);
        loop p2 + polar(b, theta) = p3;
        let weld = p2 + polar(b / 3, theta) + polar(7mm, theta + 90deg);
        let c2 = p2 + polar(b / 6, theta);
        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi;
        body half = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
        body rocker = pin j4 on frame at base, turns psi, mass m4 at p3;
        body other = pin j3 on rocker at p3, turns theta, mass m3 at weld;
        fixed w = half on other at weld;
        force (load, -2 * load) on other at weld;
        damper 3N*mm*s on j3;
    }
    impl Welded {
        pub fn motion(phi) -> WeldedMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, v3: velocity(p3), a3: acceleration(p3), wt: velocity(theta), et: acceleration(theta),
            wp: velocity(psi), ep: acceleration(psi), weld, c2,
        }
        pub fn forces(phi, omega, epsilon, load) -> WeldedForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(w), m5: moment(w), t: torque(phi),
        }
    }
}

#[test]
fn a_wheel_on_a_guided_lever() {
    each(0x171, |m: GearedLever, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(300.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [p2, hub, base, c4] = [at.p2, at.hub, m.base, at.c4].map(flat);
        let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]);
        let crank = Some(all.body(crank.add_mass(m.m1, p2 / 3.0)));
        let lever = rate.pivot(m.base, [at.w, at.e]).add_mass(m.m3, hub);
        let lever = Some(all.body(lever.add_inertia(disc(m.i3))));
        let block = rate.plane([at.p2, at.v2, at.a2], [at.w, at.e]);
        all.body(block.add_mass(m.m2, p2).add_inertia(disc(m.i2)));
        let wheel = rate.plane([at.hub, at.vh, at.ah], [at.wc, at.ec]);
        let wheel = Some(all.body(wheel.add_mass(m.m4, c4).add_inertia(disc(m.i4))));
        let way = Vector::new(at.theta.cos(), at.theta.sin(), 0.0);
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 2, crank, p2);
        all.joint(Kind::Slide(way), 2, lever, p2);
        all.joint(pin(), 1, None, base);
        all.joint(pin(), 3, lever, hub);
        // chi + 2 theta does no work.
        all.tie(&[(3, 1.0), (1, 2.0)]);
        all.torque([wheel, None], Vector::z() * load);

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [found.f1, found.f2, found.f3, found.f4, found.f5];
        solution.expect_forces(forces);
        solution.expect_moment(2, found.m3);
        let alone = linkage.alone(phi, rate.omega, rate.epsilon, load);
        for torque in [found.t, alone.t] {
            solution.expect_torque(solution.drive(0), torque);
        }
        true
    });
}

#[test]
fn two_halves() {
    each(0x172, |m: Welded, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, load) = (random.turn(), Rate::any(random), random.load(20.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [p2, p3, weld, c2] = [at.p2, at.p3, at.weld, at.c2].map(flat);
        let crank = Some(all.body(rate.pivot(Vector2::zeros(), [1.0, 0.0])));
        let half = rate.plane([at.p2, at.v2, at.a2], [at.wt, at.et]);
        all.body(half.add_mass(m.m2, c2).add_inertia(disc(m.i2)));
        let rocker = rate.pivot(m.base, [at.wp, at.ep]).add_mass(m.m4, p3);
        let rocker = Some(all.body(rocker));
        let other = rate.plane([at.p3, at.v3, at.a3], [at.wt, at.et]);
        let other = Some(all.body(other.add_mass(m.m3, weld)));
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 1, crank, p2);
        all.joint(pin(), 3, rocker, p3);
        all.joint(pin(), 2, None, flat(m.base));
        all.joint(Kind::Fixed, 1, other, weld);
        all.force([other, None], weld, Vector::new(load, -2.0 * load, 0.0));
        all.turn_damper([other, rocker], Vector::z(), 3.0);

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, load);
        let forces = [found.f1, found.f2, found.f3, found.f4, found.f5];
        solution.expect_forces(forces);
        solution.expect_moment(4, found.m5);
        solution.expect_torque(solution.drive(0), found.t);
        true
    });
}
