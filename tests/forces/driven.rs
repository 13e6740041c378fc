//! Which joints an input drives: one whose angle a loop ties to the input is, one that another link holds is not.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Body, Instant, NEWTON, Rate, Vector, each, flat, pin};

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
