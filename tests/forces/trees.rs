//! One four-bar with its joints cut elsewhere, its bodies in other orders: the same forces. The drive needs a body that hangs by its joint.

use super::{Random, Rate};

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
