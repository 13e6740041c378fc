//! A linear drive: a hydraulic cylinder lifts a boom.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

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
fn reactions_and_powers() {
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
