//! A unit vector at given angles to two known vectors.

use super::{LIMITS, direction};
use linkage_reference::{
    Big, Form, Plan, Position, Random, Space, System, data, edge, forms, line_gap, planes_line,
    unknowns,
};
use nalgebra::Vector3;

const PHI: f64 = 60.0 * core::f64::consts::PI / 180.0;

/// The moving vector: it goes around a cone.
fn arm(p: &Position) -> Space {
    let reach = p.polar("reach", "phi");
    Space::new(reach.x, reach.y, p.value("lift").clone())
}

/// The fixed one, of length 1.
fn fixed(p: &Position) -> Space {
    let tilt = p.direction("tilt");
    Space::new(tilt.y, 0.0, tilt.x)
}

/// A residual without dimension as a length.
fn as_length(p: &Position, number: Big) -> Big {
    number * p.value("reach").abs()
}

const NORMAL: System = System {
    name: "unit vector at two angles",
    data: data! {
        length "reach" 20.0, "lift" 50.0, "shadow" 15.0;
        degrees "tilt" 75.0, "beta" 80.0, "phi" 60.0;
    },
    parameters: 5,
    unknowns: unknowns! {
        number "n.x" 0.2, "n.y" 0.97, "n.z" -0.1;
    },
    residual: |p| {
        let n = p.space("n");
        vec![
            as_length(p, n.norm() - 1.0),
            n.dot(&arm(p)) - p.value("shadow"),
            as_length(p, n.dot(&fixed(p)) - p.direction("beta").x),
        ]
    },
    gap: |p| {
        let (arm, fixed, cosine) = (arm(p), fixed(p), p.direction("beta").x);
        let planes = [(&arm, p.value("shadow")), (&fixed, &cosine)];
        let (on_line, direction) = planes_line(planes);
        let origin = Space::new(0.0, 0.0, 0.0);
        line_gap(&Big::one(), &origin, (&on_line, &direction))
    },
    pairs: &[(0, 2), (4, 4)],
    ..System::PLAIN
};

macro_rules! normal {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [n];
            $($pairs)*
            fields |g| { reach: g[0], lift: g[1], shadow: g[2], tilt: g[3], beta: g[4] }
            {
                unit mm;
                param reach = 20mm;
                param lift = 50mm;
                param shadow = 15mm;
                param tilt = 75deg;
                param beta = 80deg;
                input phi = 60deg in 0deg..360deg;
                unknown n = (0.2, 0.97, -0.1);
                let arm = turn((reach, 0mm, lift), (0, 0, 1), phi);
                let fixed = (sin(tilt), 0, cos(tilt));
                $($items)*
            }
        }
    };
}

normal!(norm_first [pairs reach shadow, beta beta;] {
    loop norm(n) = 1;
    loop dot(n, arm) = shadow;
    loop dot(n, fixed) = cos(beta);
});

normal!(square_last [] {
    loop cos(beta) - dot(fixed, n) = 0;
    loop shadow = n.x * arm.x + n.y * arm.y + n.z * arm.z;
    loop dot(n, n) = 1;
});

/// The geometry in which the unit vector, or its mirror image, is found at the reference input.
fn closed([reach, lift]: [f64; 2], tilt: f64, n: Vector3<f64>) -> Vec<f64> {
    let arm = Vector3::new(reach * PHI.cos(), reach * PHI.sin(), lift);
    let fixed = Vector3::new(tilt.sin(), 0.0, tilt.cos());
    let across = arm.cross(&fixed);
    let side = n.dot(&across);
    let n = if side < 0.0 {
        n - 2.0 * side / across.norm_squared() * across
    } else {
        n
    };
    vec![reach, lift, n.dot(&arm), tilt, n.dot(&fixed).acos()]
}

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let lengths = [0; 2].map(|_| random.length(spread));
        closed(lengths, random.angle(), direction(random))
    },
    dead_points: &[(2, 1e3), (2, -1e3)],
};

/// Two known vectors that are all but parallel: both near the z axis.
fn near_parallel(random: &mut Random, angle: f64) -> Vec<f64> {
    let lift = random.length(6.0);
    let reach = random.length(6.0) * angle;
    let tilt = angle * random.between(-1.0, 1.0);
    closed([reach, lift], tilt, direction(random))
}

const FORMS: &[Form] = forms![norm_first, square_last];

linkage_reference::sets! { NORMAL, FORMS;
    cycles "cycles": cycle_cases(&PLAN, 15, 261), Full, LIMITS, at least 35;
    dead_points "dead points": dead_point_cases(&PLAN, 4, 262), Full, LIMITS, at least 35;
    nearly_parallel_vectors "nearly parallel vectors":
        decade_cases(near_parallel, 3, 263), Usual, LIMITS.any_proportions(), at least 25;
    scales "scales": scale_cases(&PLAN, 5, 264), Usual, LIMITS, at least 25;
}

#[test]
fn both_sides_of_the_dead_point() {
    edge(&NORMAL, FORMS, &PLAN, 3, 265).check("unit vector at two angles");
}
