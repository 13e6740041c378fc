//! Euler's theorem on homogeneous functions, in space: all sensitivities of values, velocities and
//! accelerations at once.

use linkage_reference::{Random, identities};

/// Numbers within 3 % of those given.
fn near(random: &mut Random, numbers: &[f64]) -> Vec<f64> {
    let mut near = |x: &f64| x * random.between(0.97, 1.03);
    numbers.iter().map(&mut near).collect()
}

// RSSR, and RSSP on the rocker.
identities!(
    rssr_and_rssp(phi), angles [psi psi_by], lengths [end end_by, s s_by],
    |random| near(random, &[
        10.0, 50.0, 30.0, 3.0, 40.0, 10.0, 5.0, 50f64.to_radians(), 10f64.to_radians(), 90.0,
        30.0, 1.0, -60.0, 0.9, 0.3, 0.4,
    ]),
    {
        unit mm;
        param crank = 10mm;
        param coupler = 50mm;
        param rocker = 30mm;
        param lift = 3mm;
        param pivot = (40mm, 10mm, 5mm);
        param gamma1 = 50deg;
        param gamma2 = 10deg;
        param rod = 90mm;
        param rail = (30mm, 0mm, -60mm);
        param guide = (0.9, 0.3, 0.4);
        input phi = 60deg in 0deg..360deg;
        unknown psi = 100deg;
        unknown s = 0mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let x = turn((1, 0, 0), (0, 1, 0), gamma1);
        let axis = turn(turn((0, 0, 1), (0, 1, 0), gamma1), x, gamma2);
        let end = pivot + turn(rocker * x + lift * axis, axis, psi);
        loop distance(pin, end) = coupler;
        loop distance(end, rail + s * guide) = rod;
    }
);

// A tripod whose feet stand on a crank and on the frame, and a bar from its top to a plane.
identities!(
    tripod(phi), angles [], lengths [p p_by, q q_by],
    |random| near(random, &[
        10.0, 60.0, 5.0, 3.0, 20.0, 55.0, -2.0, 45.0, 57.0, 52.0, 70.0, 80.0, 0.1, 0.9, 0.2, 13.0,
    ]),
    {
        unit mm;
        param crank = 10mm;
        param two = (60mm, 5mm, 3mm);
        param three = (20mm, 55mm, -2mm);
        param l1 = 45mm;
        param l2 = 57mm;
        param l3 = 52mm;
        param bar = 70mm;
        param arm = 80mm;
        param normal = (0.1, 0.9, 0.2);
        param height = 13mm;
        input phi = 30deg in 0deg..360deg;
        unknown p = (26mm, 20mm, -40mm);
        unknown q = (90mm, 13mm, -60mm);
        let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
        loop distance(p, one) = l1;
        loop distance(p, two) = l2;
        loop distance(p, three) = l3;
        loop distance(q, p) = bar;
        loop distance(q, two) = arm;
        loop dot(normal, q) = height;
    }
);

// Two slides and a link in a loop of three rows; a direction square to the link's arm; then
// three slides.
identities!(
    loops_of_three_rows(phi), angles [psi psi_by, n n_by], lengths [s s_by, v v_by],
    |random| near(random, &[
        15.0, 60.0, 30.0, -15.0, 25.0, 10f64.to_radians(), 60f64.to_radians(), 25f64.to_radians(),
        15.0, 90.0, 70.0, 80.0,
    ]),
    {
        unit mm;
        param crank = 15mm;
        param link = 60mm;
        param base = (30mm, -15mm, 25mm);
        param one = 10deg;
        param two = 60deg;
        param tilt = 25deg;
        param shadow = 15mm;
        param far = (90mm, 70mm, 80mm);
        input phi = 30deg in 0deg..360deg;
        unknown s = 60mm;
        unknown t = 10mm;
        unknown psi = 37deg;
        unknown n = (0.5, 0.5, 0.5);
        unknown u = 270mm;
        unknown v = 90mm;
        unknown w = -190mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let axis = (sin(tilt), 0, cos(tilt));
        let arm = turn(link * (cos(tilt), 0, -sin(tilt)), axis, psi);
        loop pin + s * (cos(one), sin(one), 0) + t * (0, cos(two), sin(two)) = base + arm;
        loop norm(n) = 1;
        loop dot(n, arm) = shadow;
        loop dot(n, axis) = 0.3;
        loop base + arm + u * n + v * (1, 0, 0) + w * (0.1, 1, 0.2) = far;
    }
);
