//! Four-bars whose joints are cut elsewhere, and one of welded halves with gears beside a guide.

use super::{Instant, Kind, NEWTON, Random, Rate, Vector, disc, each, flat, pin};
use linkage::Vector2;
use linkage_interpreted::interpreted;

// One four-bar with its joints cut elsewhere, its bodies in other orders: the same forces. The drive needs a body that hangs by its joint.

macro_rules! four_bar {
    ($name:ident, $forces:ident, $($bodies:tt)*) => {
        linkage_interpreted::interpreted! {
            pub struct $name {
                unit mm;
                param a = 40mm;
                param b = 120mm;
                param c = 80mm;
                param base = (100mm, 5mm);
                param m1 = 130g;
                param m2 = 90g;
                param m3 = 0.21kg;
                param i2 = 50000g*mm^2;
                argument pull = 20N;
                input phi = 40deg in 0deg..360deg at omega, epsilon;
                unknown theta = 20deg;
                unknown psi = 60deg;
                let p2 = polar(a, phi);
                let p3 = base + polar(c, psi);
                loop p2 + polar(b, theta) = p3;
                let c1 = polar(a / 3, phi + 20deg);
                let c2 = p2 + polar(b / 2, theta - 10deg);
                let c3 = base + polar(c / 2, psi + 5deg);
                const o = (0mm, 0mm);
                gravity = (0, -9.80665m/s^2);
                $($bodies)*
                force (pull, -2 * pull) on coupler from rocker at c2;
                torque pull * 5mm on rocker from crank;
                spring 20N*mm on j3;
                damper 2N*mm*s on j4;
            }
            impl $name {
                pub fn forces(phi, omega, epsilon, pull) -> $forces {
                    f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), t: torque(phi), p: power(),
                }
            }
        }
    };
}

four_bar! { Usual, UsualForces,
    body crank = pin j1 on frame at o, turns phi, mass m1 at c1;
    body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
    body rocker = pin j4 on frame at base, turns psi, mass m3 at c3;
    pin j3 = coupler on rocker at p3;
}

four_bar! { OnRocker, OnRockerForces,
    body coupler = pin j3 on rocker at p3, turns theta, mass m2 at c2, inertia i2;
    body rocker = pin j4 on frame at base, turns psi, mass m3 at c3;
    pin j2 = coupler on crank at p2;
    body crank = pin j1 on frame at o, turns phi, mass m1 at c1;
}

four_bar! { OpenPivot, OpenPivotForces,
    body crank = pin j1 on frame at o, turns phi, mass m1 at c1;
    body rocker = pin j3 on coupler at p3, turns psi, mass m3 at c3;
    body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
    pin j4 = rocker on frame at base;
}

four_bar! { Turned, TurnedForces,
    body rocker = pin j4 on frame at base, turns psi, mass m3 at c3;
    body crank = pin j1 on frame at o, turns phi, mass m1 at c1;
    body coupler = pin j2 on crank at p2, turns theta, mass m2 at c2, inertia i2;
    pin j3 = rocker on coupler at p3;
}

/// Forces, torque and power; those of joints that other bodies own have the other sign.
macro_rules! numbers {
    ($forces:expr, $signs:expr) => {{
        let (forces, signs): (_, [f64; 4]) = ($forces, $signs);
        let [f1, f2, f3, f4] = [
            forces.f1 * signs[0],
            forces.f2 * signs[1],
            forces.f3 * signs[2],
            forces.f4 * signs[3],
        ];
        [
            f1.x, f1.y, f2.x, f2.y, f3.x, f3.y, f4.x, f4.y, forces.t, forces.p,
        ]
    }};
}

#[test]
fn forces_do_not_depend_on_the_tree() {
    let usual = Usual::default().assemble().expect("it assembles");
    let on_rocker = OnRocker::default().assemble().expect("it assembles");
    let open_pivot = OpenPivot::default().assemble().expect("it assembles");
    let turned = Turned::default().assemble().expect("it assembles");
    let mut random = Random::new(0x101);
    for _ in 0..200 {
        let (phi, rate, pull) = (random.turn(), Rate::any(&mut random), random.load(20.0));
        let (omega, epsilon) = (rate.omega, rate.epsilon);
        let expected = numbers!(usual.forces(phi, omega, epsilon, pull), [1.0; 4]);
        let force = expected[..8]
            .iter()
            .fold(0.0_f64, |size, x| size.max(x.abs()));
        // The spring in j3 turns back what stands first: it is zero where both are parallel, whoever stands first.
        let others = [
            numbers!(on_rocker.forces(phi, omega, epsilon, pull), [1.0; 4]),
            numbers!(
                open_pivot.forces(phi, omega, epsilon, pull),
                [1.0, 1.0, -1.0, 1.0]
            ),
            numbers!(
                turned.forces(phi, omega, epsilon, pull),
                [1.0, 1.0, -1.0, 1.0]
            ),
        ];
        for (tree, other) in others.into_iter().enumerate() {
            for (k, (found, expected)) in other.into_iter().zip(expected).enumerate() {
                let size = [force, 100.0 * force, 100.0 * force * omega.abs()][k.saturating_sub(7)];
                let near = (found - expected).abs() <= 1e-10 * size;
                assert!(near, "tree {tree}, number {k}: {found:e}, not {expected:e}");
            }
        }
    }
}

// Gears beside a guide: block and lever turn alike because of the slide, the wheel on the lever because of its teeth. The coupler of a
// four-bar in two welded halves.

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
