//! Two chains on each other, as in a sewing machine's needle drive: a rocker carries the guide of a needle that a second crank drives by a rod.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

interpreted! {
    pub struct NeedleDrive {
        unit mm;
        param a = 12mm;
        param b = 60mm;
        param c = 45mm;
        param base = (60mm, -20mm);
        param side = 50mm;
        param shift = 70deg;
        param crank_2 = 14mm;
        param phase = 25deg;
        param rod = 55mm;
        param m1 = 30g;
        param m2 = 20g;
        param m3 = 60g;
        param m5 = 15g;
        param m6 = 25g;
        param i1 = 3000g*mm^2;
        param i3 = 40000g*mm^2;
        param i5 = 5000g*mm^2;
        param i6 = 9000g*mm^2;
        argument press = 5N;
        input phi = 0deg in 0deg..360deg at omega, epsilon;
        unknown theta = 24deg;
        unknown psi = 81deg;
        unknown tilt = 60deg;
        unknown x = 30mm;
        let p2 = polar(a, phi);
        let p3 = base + polar(c, psi);
        loop p2 + polar(b, theta) = p3;
        let p8 = polar(crank_2, phi + phase);
        let p6 = base + polar(side, psi + shift);
        let p9 = p6 + polar(x, psi + 20deg) + polar(4mm, psi + 110deg);
        loop p8 + polar(rod, tilt) = p9;
        let c1 = p2 / 2 + p8 / 4;
        let c2 = p2 + polar(b / 2, theta);
        let c3 = base + polar(30mm, psi + 15deg);
        let c5 = p8 + polar(rod / 2, tilt);
        let c6 = p9 + polar(20mm, psi + 30deg);
        let tip = p9 + polar(40mm, psi + 25deg);

        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at c1, inertia i1;
        body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2;
        body rocker = pin j4 on frame at base, turns psi, mass m3 at c3, inertia i3;
        body rod = pin j8 on crank at p8, turns tilt, mass m5 at c5, inertia i5;
        body needle = slide j11 on rocker at p9 along dir(psi + 20deg), mass m6 at c6, inertia i6;
        pin j3 = coupler on rocker at p3;
        pin j9 = rod on needle at p9;
        force (press, -2 * press) on needle at tip;
    }
    impl NeedleDrive {
        pub fn motion(phi) -> NeedleDriveMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, p8, v8: velocity(p8), a8: acceleration(p8),
            p9, v9: velocity(p9), a9: acceleration(p9), c1, c2, c3, c5, c6, tip, psi,
            wt: velocity(theta), et: acceleration(theta), wp: velocity(psi), ep: acceleration(psi), wr: velocity(tilt), er: acceleration(tilt),
        }
        pub fn forces(phi, omega, epsilon, press) -> NeedleDriveForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f8: reaction(j8), f9: reaction(j9),
            f11: reaction(j11), m11: moment(j11), t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> NeedleDriveEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn reactions_and_powers() {
    each(0xa1, |m: NeedleDrive, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, press) = (random.turn(), Rate::any(random), random.load(5.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 50.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
        let [c1, c2, c3, c5, c6] = [at.c1, at.c2, at.c3, at.c5, at.c6].map(flat);
        let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]).add_mass(m.m1, c1);
        let crank = Some(all.body(crank.add_inertia(disc(m.i1))));
        all.body(
            rate.plane([at.p2, at.v2, at.a2], [at.wt, at.et])
                .add_mass(m.m2, c2),
        );
        let rocker = rate.pivot(m.base, [at.wp, at.ep]).add_mass(m.m3, c3);
        let rocker = Some(all.body(rocker.add_inertia(disc(m.i3))));
        let rod = rate
            .plane([at.p8, at.v8, at.a8], [at.wr, at.er])
            .add_mass(m.m5, c5);
        all.body(rod.add_inertia(disc(m.i5)));
        let needle = rate
            .plane([at.p9, at.v9, at.a9], [at.wp, at.ep])
            .add_mass(m.m6, c6);
        let needle = Some(all.body(needle.add_inertia(disc(m.i6))));
        let guide = at.psi + 20f64.to_radians();
        let guide = Kind::Slide(Vector::new(guide.cos(), guide.sin(), 0.0));
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(pin(), 1, crank, flat(at.p2));
        all.joint(pin(), 1, rocker, flat(at.p3));
        all.joint(pin(), 2, None, flat(m.base));
        all.joint(pin(), 3, crank, flat(at.p8));
        all.joint(pin(), 3, needle, flat(at.p9));
        all.joint(guide, 4, rocker, flat(at.p9));
        all.force(
            [needle, None],
            flat(at.tip),
            Vector::new(press, -2.0 * press, 0.0),
        );

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, press);
        let forces = [
            found.f1, found.f2, found.f3, found.f4, found.f8, found.f9, found.f11,
        ];
        solution.expect_forces(forces);
        solution.expect_moment(6, found.m11);
        solution.expect_torque(solution.drive(0), found.t);
        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}
