//! Sensitivities of reactions, torques and energies are the same in every direction.

use super::expect_agreement;

/// A function of angle, speed, acceleration and load. The inputs' speeds are arguments behind them.
#[track_caller]
fn expect(items: &str, quantities: &[&str]) {
    for q in quantities {
        for wrapped in [(*q).to_owned(), format!("velocity({q})")] {
            expect_agreement(
                items,
                &format!("f(phi, omega, epsilon, load) -> R {{ s: sensitivity({wrapped}) }}"),
            );
        }
    }
}

const LOADS: &str =
    "param m = 120g; param n = 300g; param i = 40kg*mm^2; param k = 2N/mm; param g = 3N*mm*s;
    argument load = 10N; gravity = (1m/s^2, -9.80665m/s^2);";

#[test]
fn two_links() {
    let items = format!(
        "{LOADS} unknown t = 20deg; unknown p = 57deg;
         loop polar(a, phi) + polar(b, t) = (d, 0) + polar(c, p);
         let q = polar(a, phi); let r = q + polar(b, t);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m at q / 2;
         body coupler = pin j2 on crank at q, turns t, mass n at q + polar(d / 2, t + lift), inertia i;
         body rocker = pin j4 on frame at (d, 0), turns p, mass m at r, inertia i at (d, e);
         pin j3 = coupler on rocker at r;
         force (load, e * k) on coupler at r;
         spring k from frame at (0mm, d) to coupler at r, free c / 2;
         damper g on j4;"
    );
    expect(
        &items,
        &[
            "reaction(j3)",
            "power()",
            "shaking_moment()",
            "driven_acceleration(phi)",
        ],
    );
    expect_agreement(
        &items,
        "f(phi, omega, epsilon, load) -> R { s: d(torque(phi), phi, m), t: sensitivity(reaction(j1)), u: d(reaction(j4), a, n), v: d(power(), k) }",
    );
    expect_agreement(
        &items,
        "f(phi, load) -> R { s: sensitivity(torque(phi)), t: sensitivity(reaction(j3)) }",
    );
}

#[test]
fn links_and_slides() {
    let slider = format!(
        "{LOADS} unknown t = -20deg; unknown x = 150mm;
         let q = polar(a, phi); let r = q + polar(b, t);
         loop r = polar(x, lift / 4) + (e, e);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m at q / 2;
         body rod = pin j2 on crank at q, turns t, mass n at (q + r) / 2, inertia i;
         body slider = slide j4 on frame at r along dir(lift / 4), mass m at r + (0, e);
         pin j3 = rod on slider at r;
         force (load, 0) on slider at r; damper k * 1s on j4;"
    );
    expect(
        &slider,
        &[
            "reaction(j4)",
            "moment(j4)",
            "torque(phi)",
            "driven_acceleration(phi)",
        ],
    );
    let block = format!(
        "{LOADS} unknown t = 170deg; unknown x = 70mm;
         let q = polar(a, phi);
         loop q = (d, 0) + rotate((x, e), t);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m at q / 2;
         body arm = pin j4 on frame at (d, 0), turns t, mass n at (d, 0) + polar(c, t), inertia i;
         body block = pin j2 on crank at q, turns t, mass m at q + polar(e, t);
         slide j3 = block on arm at q along dir(t);
         torque load * e on arm;"
    );
    expect(&block, &["reaction(j3)", "moment(j3)", "torque(phi)"]);
}

#[test]
fn a_triad() {
    let items = format!(
        "{LOADS} unknown t1 = 20deg; unknown t2 = 100deg; unknown t3 = 290deg; unknown u = 10deg;
         let q = polar(3 * e, phi); let r = q + polar(d / 2, t1);
         let z = r + polar(c - 20mm, u); let v = r + polar(c - 20mm, u + 60deg);
         loop z = (b, 0) + polar(d / 2, t2);
         loop v = (b / 2, d + 10mm) + polar(d / 2, t3);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi;
         body bar = pin j2 on crank at q, turns t1, mass m at r;
         body plate = pin j3 on bar at r, turns u, mass n at (r + z + v) / 3, inertia i;
         body second = pin j4 on frame at (b, 0), turns t2, mass m at z;
         body third = pin j5 on frame at (b / 2, d + 10mm), turns t3;
         pin j6 = plate on second at z; pin j7 = third on plate at v;
         force (load, load) on plate at v;"
    );
    for quantities in [
        "s: sensitivity(reaction(j7)), t: sensitivity(reaction(j6)), u: sensitivity(torque(phi))",
        "s: sensitivity(velocity(torque(phi)))",
    ] {
        expect_agreement(
            &items,
            &format!("f(phi, omega, epsilon, load) -> R {{ {quantities} }}"),
        );
    }
}

#[test]
fn in_space() {
    let items = "param m = 120g; param i = 40kg*mm^2; argument load = 10N; gravity = (0, 0, -9.80665m/s^2);
        unknown p = 100deg;
        let q = turn((0, a, 0), (1, 0, 0), phi); let axis = turn((0, 0, 1), (1, 0, 0), -lift);
        let lever = turn((1, 0, 0), axis, p); let r = (d, e, -e) + c * lever;
        loop distance(q, r) = b + a;
        let wing = frame((d, e, -e), lever, axis);
        body crank = pin j1 on frame at (0mm, 0mm, 0mm) about (1, 0, 0), turns phi, mass m at q / 2;
        body rod = ball j2 on crank at q, turns r - q, mass m at (2 * q + r) / 3, inertia i;
        body rocker = pin j4 on frame at (d, e, -e) about axis, turns wing, mass m at r, inertia (i, 2 * i, i / 3);
        ball j3 = rod on rocker at r;
        force (load, 0, load) on rod at r;";
    for quantities in [
        "s: sensitivity(reaction(j3)), t: sensitivity(moment(j4)), u: sensitivity(torque(phi))",
        "s: sensitivity(reaction(j2)), t: sensitivity(moment(j1)), u: sensitivity(kinetic_energy())",
        "s: sensitivity(driven_acceleration(phi)), t: sensitivity(bias(phi)), u: velocity(inertia(phi))",
        "s: sensitivity(velocity(torque(phi)))",
    ] {
        expect_agreement(
            items,
            &format!("f(phi, omega, epsilon, load) -> R {{ {quantities} }}"),
        );
    }
}

#[test]
fn friction_in_pins_and_slides() {
    let items = format!(
        "{LOADS} param mu = 0.12; unknown t = -20deg; unknown x = 150mm;
         let q = polar(a, phi); let r = q + polar(b, t);
         loop r = polar(x, lift / 4) + (e, e);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m at q / 2;
         body rod = pin j2 on crank at q, turns t, mass n at (q + r) / 2, inertia i;
         body slider = slide j4 on frame at r along dir(lift / 4), mass m at r + (0, e);
         pin j3 = rod on slider at r;
         force (load, 0) on slider at r;
         friction mu on j2, radius a / 5; friction mu / 2 on j3, radius 5mm; friction mu on j4, length b / 3;"
    );
    for quantities in ["torque(phi)", "driven_acceleration(phi)", "reaction(j3)"] {
        for wrapped in [quantities.to_owned(), format!("velocity({quantities})")] {
            expect_agreement(
                &items,
                &format!(
                    "f(phi, omega, epsilon, load) -> R {{ s: sensitivity({wrapped}, [mu, a, m]) }}"
                ),
            );
        }
    }
}
