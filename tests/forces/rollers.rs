//! Rollers: a crank's pin in the slot of a swinging arm, in motion against Newton's and Euler's
//! equations of both bodies; a ladder on two rollers, one of them driven.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Instant, Kind, NEWTON, Rate, Vector, disc, each, energy_rate, flat, pin};

interpreted! {
    pub struct Slotted {
        unit mm;
        param a = 40mm;
        param e = 7mm;
        param reach = 180mm;
        param base = (10mm, -90mm);
        param m1 = 130g;
        param m3 = 0.5kg;
        param i3 = 800000g*mm^2;
        argument cut = 50N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 75deg;
        unknown x = 110mm;
        let p2 = polar(a, phi);
        loop p2 = base + rotate((x, e), theta);
        let end = base + polar(reach, theta);
        let c1 = polar(a / 4, phi + 200deg);
        let c3 = base + rotate((80mm, -6mm), theta);

        gravity = (0.3m/s^2, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi, mass m1 at c1;
        body arm = pin b4 on frame at base, turns theta, mass m3 at c3, inertia i3;
        roller b3 = crank on arm at p2 along dir(theta);
        force (-cut, cut / 4) on arm at end;
    }
    impl Slotted {
        pub fn motion(phi) -> SlottedMotion { p2, w: velocity(theta), e: acceleration(theta), theta, c1, c3, end }
        pub fn forces(phi, omega, epsilon, cut) -> SlottedForces {
            f1: reaction(b1), f3: reaction(b3), f4: reaction(b4), t: torque(phi), p: power(),
        }
        pub fn energy(phi, omega) -> SlottedEnergy {
            k: kinetic_energy(), u: potential_energy(), kv: velocity(kinetic_energy()), uv: velocity(potential_energy()),
        }
    }
}

#[test]
fn pin_in_a_slot() {
    each(0x171, |m: Slotted, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let (phi, rate, cut) = (random.turn(), Rate::any(random), random.load(50.0));
        let at = linkage.motion(phi);
        let mut all = Instant::new(true, 100.0, NEWTON, Vector::new(300.0, -9806.65, 0.0));
        let [p2, base, c1, c3, end] = [at.p2, m.base, at.c1, at.c3, at.end].map(flat);
        let crank = rate.pivot(Vector2::zeros(), [1.0, 0.0]);
        let crank = Some(all.body(crank.add_mass(m.m1, c1)));
        let arm = rate.pivot(m.base, [at.w, at.e]);
        let arm = Some(all.body(arm.add_mass(m.m3, c3).add_inertia(disc(m.i3))));
        let way = Vector::new(at.theta.cos(), at.theta.sin(), 0.0);
        all.driven(pin(), 0, None, Vector::zeros());
        all.joint(Kind::Roller(way), 0, arm, p2);
        all.joint(pin(), 1, None, base);
        all.force([arm, None], end, Vector::new(-cut, cut / 4.0, 0.0));
        assert_eq!(crank, Some(0));

        let solution = all.solve();
        let found = linkage.forces(phi, rate.omega, rate.epsilon, cut);
        solution.expect_forces([found.f1, found.f3, found.f4]);
        solution.expect_torque(solution.drive(0), found.t);
        solution.expect_power(solution.power(&all), found.p, rate.omega);
        let energy = linkage.energy(phi, rate.omega);
        let stored = energy_rate(energy.k, energy.kv, rate) + energy.uv * rate.omega;
        solution.expect_power(stored + all.delivered, found.p, rate.omega);
        true
    });
}

interpreted! {
    /// A ladder on floor and wall; its foot is pushed.
    pub struct Ladder {
        unit mm;
        param long = 500mm;
        argument load = 200N;
        input x = 300mm in 100mm..450mm;
        unknown theta = 127deg;
        unknown y = 400mm;
        loop (x, 0) + polar(long, theta) = (0, y);
        body ladder = roller a on frame at (x, 0) along (1, 0), turns theta;
        roller b = ladder on frame at (0, y) along (0, 1);
        force (0, -load) on ladder at (x, y) / 2;
    }
    impl Ladder {
        pub fn forces(x, load) -> LadderForces { y, f: force(x), a: reaction(a), b: reaction(b) }
        pub fn alone(x, load) -> LadderAlone { f: force(x) }
    }
}

#[test]
fn ladder_on_two_rollers() {
    let ladder = Ladder::default();
    let linkage = ladder.assemble().unwrap();
    for (x, load) in [(100.0, 200.0), (300.0, -35.0), (450.0, 1e4)] {
        let found = linkage.forces(x, load);
        let y = (ladder.long * ladder.long - x * x).sqrt();
        // Moments about the foot: the load's arm is half of `x`, that of the wall's force is `y`.
        let wall = 0.5 * load * x / y;
        let limit = 1e-12 * load.abs();
        let alone = linkage.alone(x, load).f;
        assert!((found.y - y).abs() < 1e-12 * ladder.long, "{} {y}", found.y);
        assert!(
            (found.a - Vector2::new(0.0, load)).norm() < limit,
            "{:?}",
            found.a
        );
        assert!(
            (found.b - Vector2::new(wall, 0.0)).norm() < limit,
            "{:?}",
            found.b
        );
        assert!((found.f + wall).abs() < limit, "{} {wall}", found.f);
        assert!((alone + wall).abs() < limit, "{alone} {wall}");
    }
}
