//! Dyads of two slides. RPP: a block on the crank's pin in the slot of a yoke that slides on the frame. PRP: a block in a slot of the crank,
//! pinned to a slider on the frame.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

interpreted! {
    pub struct Yoke {
        unit mm;
        param a = 40mm;
        param lean = 20deg;
        param slot = 110deg;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 0.5kg;
        param drag = 0.02N*s/mm;
        param rate = 0.7N/mm;
        argument push = 50N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown x = 30mm;
        unknown y = 25mm;
        let p2 = polar(a, phi);
        let o3 = polar(x, lean);
        loop o3 + polar(y, slot) = p2;
        let c2 = p2 + (3mm, 5mm);
        let c3 = o3 + (12mm, -9mm);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at p2 / 3;
        body yoke = slide b4 on frame at o3 along dir(lean), mass m3 at c3;
        body block = pin b2 on crank at p2, turns 0deg, mass m2 at c2;
        slide b3 = block on yoke at p2 along dir(slot);
        force (push, push / 3) on yoke at c3;
        damper drag on b4;
        spring rate on b3;
    }
    impl Yoke {
        pub fn motion(phi) -> YokeMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), o3, v3: velocity(o3), a3: acceleration(o3), c2, c3, y,
        }
        pub fn forces(phi, omega, epsilon, push) -> YokeForces {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), m3: moment(b3), m4: moment(b4), t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> YokeEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

interpreted! {
    pub struct Cross {
        unit mm;
        param high = 60mm;
        param skew = 80deg;
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 0.5kg;
        param i1 = 90000g*mm^2;
        param i2 = 2000g*mm^2;
        argument push = 50N;
        input phi = 20deg in -35deg..35deg at omega, epsilon;
        unknown x = -10mm;
        unknown y = 60mm;
        let q = (x, high);
        loop q = polar(y, phi + skew);
        let c2 = q + polar(5mm, phi);
        let c3 = q + (12mm, -9mm);
        gravity = (0, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at polar(20mm, phi), inertia i1;
        body block = slide b2 on crank at q along dir(phi + skew), mass m2 at c2, inertia i2;
        body slider = slide b4 on frame at q along (1, 0), mass m3 at c3;
        pin b3 = block on slider at q;
        force (push, push / 3) on slider at c3;
    }
    impl Cross {
        pub fn motion(phi) -> CrossMotion { q, v: velocity(q), a: acceleration(q), c1: polar(20mm, phi), c2, c3 }
        pub fn forces(phi, omega, epsilon, push) -> CrossForces {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), m2: moment(b2), m4: moment(b4), t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> CrossEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn yoke() {
    each(0x81, |m: Yoke, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, push) = (random.turn(), Rate::any(random), random.load(50.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 40.0, NEWTON, Vector::zeros());
        let [p2, o3, c2, c3] = [at.p2, at.o3, at.c2, at.c3].map(flat);
        let crank = rate
            .pivot(Vector2::zeros(), [1.0, 0.0])
            .add_mass(m.m1, p2 / 3.0);
        let crank = Some(all.body(crank));
        let yoke = rate
            .plane([at.o3, at.v3, at.a3], [0.0, 0.0])
            .add_mass(m.m3, c3);
        let yoke = Some(all.body(yoke));
        let block = rate
            .plane([at.p2, at.v2, at.a2], [0.0, 0.0])
            .add_mass(m.m2, c2);
        let block = Some(all.body(block));
        let [lean, slot] = [m.lean, m.slot].map(|angle| Vector::new(angle.cos(), angle.sin(), 0.0));
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 2, crank, p2);
        all.joint(Kind::Slide(slot), 2, yoke, p2);
        all.joint(Kind::Slide(lean), 1, None, o3);
        all.force([yoke, None], c3, Vector::new(push, push / 3.0, 0.0));
        all.slide_damper([yoke, None], (o3, lean), m.drag);
        all.pair([block, yoke], p2, slot * (-m.rate * at.y));

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, push);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(2, found.m3);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}

#[test]
fn cross() {
    each(0x82, |m: Cross, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, push) = (
            random.between(-0.6, 0.6),
            Rate::any(random),
            random.load(50.0),
        );
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 60.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [q, c1, c2, c3] = [at.q, at.c1, at.c2, at.c3].map(flat);
        let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]).add_mass(m.m1, c1);
        let crank = Some(all.body(crank.add_inertia(disc(m.i1))));
        let block = rate
            .plane([at.q, at.v, at.a], [1.0, 0.0])
            .add_mass(m.m2, c2);
        all.body(block.add_inertia(disc(m.i2)));
        let slider = rate
            .plane([at.q, at.v, at.a], [0.0, 0.0])
            .add_mass(m.m3, c3);
        let slider = Some(all.body(slider));
        let slot = Vector::new((phi + m.skew).cos(), (phi + m.skew).sin(), 0.0);
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(Kind::Slide(slot), 1, crank, q);
        all.joint(pin(), 1, slider, q);
        all.joint(Kind::Slide(Vector::x()), 2, None, q);
        all.force([slider, None], c3, Vector::new(push, push / 3.0, 0.0));

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, push);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_moment(1, found.m2);
        solution.expect_moment(3, found.m4);
        solution.expect_torque(solution.drive(0), found.t);
        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}
