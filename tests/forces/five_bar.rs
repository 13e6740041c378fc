//! Two inputs, each with its own speed and acceleration.

use linkage::Vector2;
use linkage_interpreted::interpreted;

use super::{Body, Instant, NEWTON, Vector, disc, each, flat, pin};

interpreted! {
    pub struct FiveBar {
        unit mm;
        param crank = 30mm;
        param arm = 35mm;
        param left = 80mm;
        param right = 75mm;
        param base = (60mm, 5mm);
        param m1 = 130g;
        param m2 = 90g;
        param m3 = 70g;
        param m4 = 40g;
        param i2 = 50kg*mm^2;
        param i3 = 40kg*mm^2;
        argument load = 30N;
        input phi = 100deg in 60deg..120deg at w1, e1;
        input psi = 70deg in 60deg..120deg at w2, e2;
        unknown alpha = 40deg;
        unknown beta = 120deg;
        let p1 = polar(crank, phi);
        let p2 = base + polar(arm, psi);
        let p = p1 + polar(left, alpha);
        loop p = p2 + polar(right, beta);
        let c1 = p1 + polar(left / 2, alpha);
        let c2 = p2 + polar(right / 3, beta + 10deg);
        gravity = (0, -9.80665m/s^2);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m1 at p1 / 3;
        body arm = pin j2 on frame at base, turns psi, mass m2 at (p2 + base) / 2;
        body left = pin j3 on crank at p1, turns alpha, mass m3 at c1, inertia i2;
        body right = pin j4 on arm at p2, turns beta, mass m4 at c2, inertia i3;
        pin j5 = left on right at p;
        force (load, -load / 2) on left at p;
        damper 0.03N*s/mm from frame at (30mm, 200mm) to left at p;
    }
    impl FiveBar {
        pub fn motion(phi, psi) -> FiveBarMotion {
            p1, v1: velocity(p1), a1: acceleration(p1), p2, v2: velocity(p2), a2: acceleration(p2), p, c1, c2, m2: (p2 + base) / 2,
            wa: velocity(alpha), ea: acceleration(alpha), wb: velocity(beta), eb: acceleration(beta),
        }
        pub fn forces(phi, psi, w1, e1, w2, e2, load) -> FiveBarForces {
            f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), f5: reaction(j5),
            t1: torque(phi), t2: torque(psi), p: power(),
        }
        pub fn half(phi, psi, w2, load) -> FiveBarHalf { f5: reaction(j5), t1: torque(phi), p: power() }
        pub fn energy(phi, psi, w1, w2) -> FiveBarEnergy { k: kinetic_energy(), kv: velocity(kinetic_energy()) }
        pub fn height(phi, psi) -> FiveBarHeight { uv: velocity(potential_energy()) }
    }
}

/// Speeds and accelerations of both inputs.
#[derive(Clone, Copy)]
struct Rates {
    speeds: [f64; 2],
    gains: [f64; 2],
}

type Plane = Vector2<f64>;

impl Rates {
    fn of(&self, v: [Vector; 2], a: [[Vector; 2]; 2]) -> [Vector; 2] {
        let [w1, w2] = self.speeds;
        let [e1, e2] = self.gains;
        let curved = a[0][0] * (w1 * w1) + (a[0][1] + a[1][0]) * (w1 * w2) + a[1][1] * (w2 * w2);
        [v[0] * w1 + v[1] * w2, curved + v[0] * e1 + v[1] * e2]
    }

    fn body(
        &self,
        (p, v, a): (Plane, [Plane; 2], [[Plane; 2]; 2]),
        (w, e): ([f64; 2], [[f64; 2]; 2]),
    ) -> Body {
        let [v, a] = self.of(v.map(flat), a.map(|row| row.map(flat)));
        let about = |x| Vector::z() * x;
        Body::new(
            [flat(p), v, a],
            self.of(w.map(about), e.map(|row| row.map(about))),
        )
    }
}

fn instant(m: &FiveBar, at: &FiveBarMotion, rates: Rates, load: f64) -> Instant {
    let zero = Vector2::zeros();
    let still = ([zero; 2], [[zero; 2]; 2]);
    let mut all = Instant::new(true, 80.0, NEWTON, Vector::new(0.0, -9806.65, 0.0));
    let [p1, p2, p, c1, c2] = [at.p1, at.p2, at.p, at.c1, at.c2].map(flat);
    let own = |input: usize| {
        (
            [0, 1].map(|k| f64::from(u8::from(k == input))),
            [[0.0; 2]; 2],
        )
    };
    let crank = rates
        .body((zero, still.0, still.1), own(0))
        .add_mass(m.m1, p1 / 3.0);
    let crank = Some(all.body(crank));
    let arm = rates
        .body((m.base, still.0, still.1), own(1))
        .add_mass(m.m2, flat(at.m2));
    let arm = Some(all.body(arm));
    let left = rates
        .body((at.p1, at.v1, at.a1), (at.wa, at.ea))
        .add_mass(m.m3, c1);
    let left = Some(all.body(left.add_inertia(disc(m.i2))));
    let right = rates
        .body((at.p2, at.v2, at.a2), (at.wb, at.eb))
        .add_mass(m.m4, c2);
    let right = Some(all.body(right.add_inertia(disc(m.i3))));
    all.driven(pin(), 0, None, Vector::zeros());
    all.driven(pin(), 1, None, flat(m.base));
    all.joint(pin(), 2, crank, p1);
    all.joint(pin(), 3, arm, p2);
    all.joint(pin(), 2, right, p);
    all.force([left, None], p, Vector::new(load, -load / 2.0, 0.0));
    all.damper([(None, Vector::new(30.0, 200.0, 0.0)), (left, p)], 0.03);
    all
}

#[test]
fn reactions_and_powers() {
    each(0xc1, |m: FiveBar, random| {
        let Ok(linkage) = m.assemble() else {
            return false;
        };
        let [phi, psi] = [0, 1].map(|_| random.between(1.1, 2.0));
        let rates = Rates {
            speeds: [0, 1].map(|_| random.load(30.0)),
            gains: [0, 1].map(|_| random.load(500.0)),
        };
        let ([w1, w2], [e1, e2], load) = (rates.speeds, rates.gains, random.load(30.0));
        let at = linkage.motion(phi, psi);
        let all = instant(&m, &at, rates, load);
        let solution = all.solve();
        let found = linkage.forces(phi, psi, w1, e1, w2, e2, load);
        let forces = [found.f1, found.f2, found.f3, found.f4, found.f5];
        solution.expect_forces(forces);
        solution.expect_torque(solution.drive(0), found.t1);
        solution.expect_torque(solution.drive(1), found.t2);
        let speed = w1.abs().max(w2.abs());
        solution.expect_power(solution.power(&all), found.p, speed);

        // The energy is quadratic in the speeds: differences give its derivatives by them exactly.
        let energy = linkage.energy(phi, psi, w1, w2);
        solution.expect_torque(all.kinetic_energy(), energy.k);
        let at_speeds = |w1, w2| linkage.energy(phi, psi, w1, w2).k;
        let by_w1 = (at_speeds(2.0 * w1, w2) - at_speeds(0.0, w2)) / (2.0 * w1);
        let by_w2 = (at_speeds(w1, 2.0 * w2) - at_speeds(w1, 0.0)) / (2.0 * w2);
        let height = linkage.height(phi, psi);
        let moved = (energy.kv[0] + height.uv[0]) * w1 + (energy.kv[1] + height.uv[1]) * w2;
        let stored = moved + by_w1 * e1 + by_w2 * e2;
        solution.expect_power(stored + all.dissipated + all.delivered, found.p, speed);

        // One input at rest.
        let rates = Rates {
            speeds: [0.0, w2],
            gains: [0.0; 2],
        };
        let all = instant(&m, &at, rates, load);
        let solution = all.solve();
        let found = linkage.half(phi, psi, w2, load);
        solution.expect_force(4, found.f5);
        solution.expect_torque(solution.drive(0), found.t1);
        solution.expect_power(solution.power(&all), found.p, w2);
        true
    });
}
