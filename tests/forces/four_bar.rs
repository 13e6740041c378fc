//! Dyad RRR, with everything that the plane knows: several masses, inertia about a point, springs and dampers between points and in joints, loads
//! as arguments.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

interpreted! {
    pub struct FourBar {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param c = 80mm;
        param base = (100mm, 5mm);
        param lift = 20deg;
        param rest = 35deg;
        param free = 45mm;
        param m1 = 130g;
        param m2 = 90g;
        param m4 = 20g;
        param m3 = 0.21kg;
        param i1 = 310000g*mm^2;
        param i2 = 50000g*mm^2;
        param i3 = 80kg*mm^2;
        param rate = 2.5N/mm;
        param twist = 300N*mm;
        param coil = 120N*mm;
        param drag = 0.02N*s/mm;
        param brake = 5N*mm*s;
        param slow = 3N*mm*s;
        argument pull = 20N;
        argument load = 300N*mm;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 20deg;
        unknown psi = 60deg;
        const anchor = (20mm, 150mm);
        let p2 = polar(a, phi);
        let p3 = base + polar(c, psi);
        loop p2 + polar(b, theta) = p3;
        let c1 = polar(a / 3, phi + lift);
        let c2 = p2 + polar(b / 2, theta - lift);
        let c4 = p2 + polar(b + 10mm, theta + lift);
        let c3 = base + polar(c / 2, psi + lift);

        gravity = (1m/s^2, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at c1, inertia i1 at (0mm, 0mm);
        body coupler = pin b2 on crank at p2, turns theta, mass m2 at c2, mass m4 at c4, inertia i2;
        body rocker = pin b4 on frame at base, turns psi, inertia i3, mass m3 at c3;
        pin b3 = coupler on rocker at p3;
        force (pull, -2 * pull) on coupler from rocker at c4;
        force (3N, pull) on rocker at c3;
        torque load on crank from coupler;
        torque 0.5 * load on rocker;
        spring rate from frame at anchor to rocker at p3, free free;
        spring rate / 3 from crank at c1 to rocker at c3;
        spring twist on b4, free rest;
        spring coil on b3;
        damper drag from frame at anchor to coupler at c4;
        damper brake on b4;
        damper slow on b2;
    }
    impl FourBar {
        pub fn motion(phi) -> FourBarMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, c1, c2, c3, c4, theta, psi,
            w2: velocity(theta), e2: acceleration(theta), w3: velocity(psi), e3: acceleration(psi), margin: margin(),
        }
        pub fn forces(phi, omega, epsilon, pull, load) -> FourBarForces {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), t: torque(phi), p: power(),
            s: shaking_force(), m: shaking_moment(), n: shaking_moment(base),
        }
        pub fn steady(phi, omega, pull, load) -> FourBarSteady {
            f1: reaction(b1), f3: reaction(b3), t: torque(phi), p: power(),
        }
        pub fn statics(phi, pull, load) -> FourBarStatics {
            f1: reaction(b1), f2: reaction(b2), f3: reaction(b3), f4: reaction(b4), t: torque(phi),
        }
        pub fn start(phi, epsilon, pull, load) -> FourBarStart { f3: reaction(b3), t: torque(phi) }
        pub fn energy(phi, omega) -> FourBarEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

/// Newton-Euler equations at one position; the joints are b1 to b4.
fn instant(m: &FourBar, at: &FourBarMotion, rate: Rate, [pull, load]: [f64; 2]) -> Instant {
    let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(1e3, -9806.65, 0.0));
    let [c1, c2, c3, c4] = [at.c1, at.c2, at.c3, at.c4].map(flat);
    let [p2, p3, base] = [at.p2, at.p3, m.base].map(flat);
    let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]).add_mass(m.m1, c1);
    let crank = all.body(crank.inertia_about(disc(m.i1), Vector::zeros()));
    let coupler = rate.plane([at.p2, at.v2, at.a2], [at.w2, at.e2]);
    let coupler = coupler.add_mass(m.m2, c2).add_mass(m.m4, c4);
    // Without a point it adds to what the masses have as points.
    let coupler = all.body(coupler.add_inertia(disc(m.i2)));
    let rocker = rate.pivot(m.base, [at.w3, at.e3]).add_mass(m.m3, c3);
    let rocker = all.body(rocker.add_inertia(disc(m.i3)));
    let [crank, coupler, rocker] = [crank, coupler, rocker].map(Some);
    all.driven(pin(), 0, None, Vector::zeros());
    all.joint(pin(), 1, crank, p2);
    all.joint(pin(), 1, rocker, p3);
    all.joint(pin(), 2, None, base);

    all.force([coupler, rocker], c4, Vector::new(pull, -2.0 * pull, 0.0));
    all.force([rocker, None], c3, Vector::new(3.0, pull, 0.0));
    all.torque([crank, coupler], Vector::z() * load);
    all.torque([rocker, None], Vector::z() * (0.5 * load));
    let anchor = Vector::new(20.0, 150.0, 0.0);
    all.spring([(None, anchor), (rocker, p3)], m.rate, m.free);
    all.spring([(crank, c1), (rocker, c3)], m.rate / 3.0, 0.0);
    all.couple([rocker, None], Vector::z() * (-m.twist * (at.psi - m.rest)));
    all.couple(
        [coupler, rocker],
        Vector::z() * (-m.coil * (at.theta - at.psi)),
    );
    all.damper([(None, anchor), (coupler, c4)], m.drag);
    all.turn_damper([rocker, None], Vector::z(), m.brake);
    all.turn_damper([coupler, crank], Vector::z(), m.slow);
    all
}

#[test]
fn reactions_and_powers() {
    each(0x51, |m: FourBar, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate) = (random.turn(), Rate::any(random));
        let loads = [random.load(20.0), random.load(300.0)];
        let at = linkage.motion(phi);
        let all = instant(&m, &at, rate, loads);
        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, loads[0], loads[1]);
        solution.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        solution.expect_torque(solution.drive(0), found.t);
        let [force, moment] = all.shaking(Vector::zeros());
        let [_, about_base] = all.shaking(flat(m.base));
        solution.expect_size(force, found.s);
        solution.expect_torque(moment.z, found.m);
        solution.expect_torque(about_base.z, found.n);

        let energy = linkage.energy(phi, rate.omega);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, rate.omega);
        true
    });
}

#[test]
fn speeds_that_are_not_listed_are_zero() {
    each(0x52, |m: FourBar, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate) = (random.turn(), Rate::any(random));
        let loads = [random.load(20.0), random.load(300.0)];
        let at = linkage.motion(phi);

        let still = instant(&m, &at, Rate::REST, loads).solve();
        let found = linkage.statics(phi, loads[0], loads[1]);
        still.expect_forces([found.f1, found.f2, found.f3, found.f4]);
        still.expect_torque(still.drive(0), found.t);

        let all = instant(&m, &at, rate.steady(), loads);
        let steady = all.solve();
        let found = linkage.steady(phi, rate.omega, loads[0], loads[1]);
        steady.expect_force(0, found.f1);
        steady.expect_force(2, found.f3);
        steady.expect_torque(steady.drive(0), found.t);
        steady.expect_power(steady.power(&all), found.p, rate.omega);

        let starting = Rate { omega: 0.0, ..rate };
        let start = instant(&m, &at, starting, loads).solve();
        let found = linkage.start(phi, rate.epsilon, loads[0], loads[1]);
        start.expect_force(2, found.f3);
        start.expect_torque(start.drive(0), found.t);
        true
    });
}
