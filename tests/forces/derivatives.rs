//! Derivatives of forces by dimensions and by the input against differences of the same functions.

use linkage::Dimensions;
use linkage_interpreted::interpreted;

interpreted! {
    pub struct Rocking {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param c = 80mm;
        param base = (100mm, 5mm);
        param lift = 20deg;
        param m2 = 90g;
        param m3 = 0.21kg;
        param i2 = 50000g*mm^2;
        param rate = 2.5N/mm;
        param free = 45mm;
        param drag = 0.02N*s/mm;
        argument pull = 20N;
        input phi = 40deg in 0deg..360deg at omega, epsilon;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let p2 = polar(a, phi);
        let p3 = base + polar(c, psi);
        loop p2 + polar(b, theta) = p3;
        gravity = (0, -9.80665m/s^2);
        body crank = pin b1 on frame at (0mm, 0mm), turns phi;
        body coupler = pin b2 on crank at p2, turns theta, mass m2 at p2 + polar(b / 2, theta - lift), inertia i2;
        body rocker = pin b4 on frame at base, turns psi, mass m3 at base + polar(c / 2, psi + lift);
        pin b3 = coupler on rocker at p3;
        force (pull, -2 * pull) on coupler at p3;
        spring rate from frame at (20mm, 150mm) to rocker at p3, free free;
        damper drag from frame at (20mm, 150mm) to coupler at p3;
    }
    impl Rocking {
        pub fn forces(phi, omega, epsilon, pull) -> RockingForces { f: reaction(b3), t: torque(phi), s: shaking_force(), k: kinetic_energy() }
        pub fn slopes(phi, omega, epsilon, pull) -> RockingSlopes {
            f: sensitivity(reaction(b3)), t: sensitivity(torque(phi)), fv: velocity(reaction(b3)), tv: velocity(torque(phi)),
        }
        pub fn parts(phi, omega, epsilon, pull) -> RockingParts {
            a: d(torque(phi), a), m: d(reaction(b3), m2), s: sensitivity(shaking_force(), [m2, m3]), i: d(kinetic_energy(), i2),
            bent: d(torque(phi), phi, m3),
        }
        pub fn dynamics(phi, omega, pull) -> RockingDynamics {
            j: inertia(phi), h: bias(phi), q: generalised_force(phi), a: driven_acceleration(phi),
        }
        pub fn dynamics_slopes(phi, omega, pull) -> RockingDynamicsSlopes {
            j: sensitivity(inertia(phi)), h: sensitivity(bias(phi)), q: sensitivity(generalised_force(phi)),
            a: sensitivity(driven_acceleration(phi)), jv: velocity(inertia(phi)), hv: velocity(bias(phi)),
            qv: velocity(generalised_force(phi)), av: velocity(driven_acceleration(phi)), ja: acceleration(inertia(phi)),
        }
    }
}

interpreted! {
    pub struct Swinging {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param m2 = 90g;
        param i2 = 140kg*mm^2;
        param i3 = 60kg*mm^2;
        input phi = 0deg in 0deg..360deg at omega;
        unknown psi = 100deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let lever = turn((1, 0, 0), (0, 0.3, 1), psi);
        let end = pivot + rocker * lever;
        loop distance(pin, end) = coupler;
        body crank = pin j1 on frame at (0mm, 0mm, 0mm) about (1, 0, 0), turns phi;
        body rod = ball j2 on crank at pin, turns end - pin, mass m2 at (pin + end) / 2, inertia i2;
        body rocker = pin j4 on frame at pivot about (0, 0.3, 1), turns frame(pivot, lever, (0, 0.3, 1)), inertia (i3 / 4, i3, i3);
        ball j3 = rod on rocker at end;
    }
    impl Swinging {
        pub fn forces(phi, omega) -> SwingingForces { f: reaction(j2), m: moment(j4), t: torque(phi) }
        pub fn slopes(phi, omega) -> SwingingSlopes { f: sensitivity(reaction(j2)), m: sensitivity(moment(j4)), t: sensitivity(torque(phi)), v: velocity(reaction(j2)) }
    }
}

/// Central differences by every parameter, of fourth order.
fn by_parameters<M: Dimensions<N>, const N: usize, const K: usize>(
    mechanism: &M,
    f: impl Fn(&M) -> [f64; K],
) -> [[f64; K]; N] {
    let values = mechanism.values();
    std::array::from_fn(|parameter| {
        let step = 1e-3 * values[parameter].abs();
        let at = |steps: f64| {
            let mut moved = values;
            moved[parameter] += steps * step;
            f(&M::from_values(&moved))
        };
        difference(at, step)
    })
}

fn difference<const K: usize>(at: impl Fn(f64) -> [f64; K], step: f64) -> [f64; K] {
    let [far_back, back, front, far_front] = [-2.0, -1.0, 1.0, 2.0].map(at);
    std::array::from_fn(|k| {
        let near = 8.0 * (front[k] - back[k]);
        (near - (far_front[k] - far_back[k])) / (12.0 * step)
    })
}

/// Within 1e-6 of the number, or of what rounding leaves of a difference of numbers of that size.
#[track_caller]
fn close(found: f64, expected: f64, rest: f64) {
    let near = (found - expected).abs() <= 1e-6 * expected.abs() + rest;
    assert!(near, "{found:e} instead of {expected:e}");
}

/// What differences by a value leave of numbers of that size.
fn rest(size: f64, value: f64) -> f64 {
    1e-9 * size / value.abs()
}

#[test]
fn in_the_plane() {
    let mechanism = Rocking::default();
    let linkage = mechanism.assemble().expect("it assembles");
    let values = mechanism.values();
    for k in 0..12 {
        let (phi, omega, epsilon, pull) = (0.2 + 0.5 * f64::from(k), 40.0, -300.0, 15.0);
        let numbers = |m: &Rocking, phi: f64| {
            let at = m
                .assemble()
                .expect("it assembles")
                .forces(phi, omega, epsilon, pull);
            [at.f.x, at.f.y, at.t, at.s.x, at.s.y, at.k]
        };
        let expected = by_parameters(&mechanism, |m| numbers(m, phi));
        let size = linkage.forces(phi, omega, epsilon, pull);
        let sizes = [size.f.norm() + pull, 100.0 * (size.f.norm() + pull)];
        let found = linkage.slopes(phi, omega, epsilon, pull);
        for (parameter, expected) in expected.iter().enumerate() {
            let rests = sizes.map(|size| rest(size, values[parameter]));
            close(found.f[parameter].x, expected[0], rests[0]);
            close(found.f[parameter].y, expected[1], rests[0]);
            close(found.t[parameter], expected[2], rests[1]);
        }
        let by_phi = difference(|steps| numbers(&mechanism, phi + 1e-3 * steps), 1e-3);
        close(found.fv.x, by_phi[0], rest(sizes[0], 1.0));
        close(found.fv.y, by_phi[1], rest(sizes[0], 1.0));
        close(found.tv, by_phi[2], rest(sizes[1], 1.0));

        let parts = linkage.parts(phi, omega, epsilon, pull);
        let of = |parameter: usize| rest(sizes[1], values[parameter]);
        let [a, m2, m3, i2] = [
            Rocking::INDEX_A,
            Rocking::INDEX_M2,
            Rocking::INDEX_M3,
            Rocking::INDEX_I2,
        ];
        close(parts.a, expected[a][2], of(a));
        close(parts.m.x, expected[m2][0], of(m2));
        close(parts.m.y, expected[m2][1], of(m2));
        close(parts.s[0].x, expected[m2][3], of(m2));
        close(parts.s[1].y, expected[m3][4], of(m3));
        close(parts.i, expected[i2][5], of(i2));
        let torques = |steps: f64| [linkage.slopes(phi + 1e-3 * steps, omega, epsilon, pull).t[m3]];
        close(parts.bent, difference(torques, 1e-3)[0], of(m3));
    }
}

#[test]
fn of_the_equation_of_motion() {
    let mechanism = Rocking::default();
    let linkage = mechanism.assemble().expect("it assembles");
    let values = mechanism.values();
    for k in 0..12 {
        let (phi, omega, pull) = (0.2 + 0.5 * f64::from(k), 40.0, 15.0);
        let numbers = |m: &Rocking, phi: f64| {
            let linkage = m.assemble().expect("it assembles");
            let at = linkage.dynamics(phi, omega, pull);
            [at.j, at.h, at.q, at.a]
        };
        let expected = by_parameters(&mechanism, |m| numbers(m, phi));
        let sizes = numbers(&mechanism, phi).map(|x| 10.0 * x.abs());
        let found = linkage.dynamics_slopes(phi, omega, pull);
        for (parameter, expected) in expected.iter().enumerate() {
            let of = [found.j, found.h, found.q, found.a].map(|slopes| slopes[parameter]);
            for (index, found) in of.into_iter().enumerate() {
                close(
                    found,
                    expected[index],
                    rest(sizes[index], values[parameter]),
                );
            }
        }
        let by_phi = difference(|steps| numbers(&mechanism, phi + 1e-3 * steps), 1e-3);
        let of = [found.jv, found.hv, found.qv, found.av];
        for (index, found) in of.into_iter().enumerate() {
            close(found, by_phi[index], rest(sizes[index], 1.0));
        }
        let slope = |steps: f64| [linkage.dynamics_slopes(phi + 1e-3 * steps, omega, pull).jv];
        close(found.ja, difference(slope, 1e-3)[0], rest(sizes[0], 1.0));
    }
}

#[test]
fn in_space() {
    let mechanism = Swinging::default();
    let linkage = mechanism.assemble().expect("it assembles");
    let values = mechanism.values();
    for k in 0..12 {
        let (phi, omega) = (0.2 + 0.5 * f64::from(k), 40.0);
        let numbers = |m: &Swinging, phi: f64| {
            let at = m.assemble().expect("it assembles").forces(phi, omega);
            [at.f.x, at.f.y, at.f.z, at.m.x, at.m.y, at.m.z, at.t]
        };
        let expected = by_parameters(&mechanism, |m| numbers(m, phi));
        let force = linkage.forces(phi, omega).f.norm();
        let found = linkage.slopes(phi, omega);
        for (parameter, expected) in expected.iter().enumerate() {
            let (f, m) = (found.f[parameter], found.m[parameter]);
            let own = [f.x, f.y, f.z, m.x, m.y, m.z, found.t[parameter]];
            for (place, (found, expected)) in own.into_iter().zip(expected).enumerate() {
                let size = if place < 3 { force } else { 100.0 * force };
                close(found, *expected, rest(size, values[parameter]));
            }
        }
        let by_phi = difference(|steps| numbers(&mechanism, phi + 1e-3 * steps), 1e-3);
        for (found, expected) in [found.v.x, found.v.y, found.v.z].into_iter().zip(by_phi) {
            close(found, expected, rest(force, 1.0));
        }
    }
}
