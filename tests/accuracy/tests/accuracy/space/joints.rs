//! The spherical four-bar and the universal joint: mechanisms without a length.

use super::LIMITS;
use linkage_reference::{
    Big, Datum, Depth, Form, Output, Plan, Position, Space, System, Unknown, compare, cycle_cases,
    data, dead_point_cases, edge, forms,
};

/// The unit vector on the output shaft whose axis is bent away from z towards x.
fn output(p: &Position, along_axis: &Big, across: &Big) -> Space {
    let bend = p.direction("bend");
    let x = Space::new(bend.x.clone(), 0.0, -&bend.y);
    let z = Space::new(bend.y, 0.0, bend.x);
    let y = Space::new(0.0, 1.0, 0.0);
    z.times(along_axis) + Space::in_plane(&p.direction("psi"), &x, &y).times(across)
}

fn spherical_output(p: &Position) -> Space {
    let beta = p.direction("beta");
    output(p, &beta.x, &beta.y)
}

fn spherical_input(p: &Position) -> Space {
    let (phi, eta) = (p.direction("phi"), p.direction("eta"));
    Space::new(phi.x * &eta.y, phi.y * &eta.y, eta.x)
}

const SPHERICAL: System = System {
    name: "spherical four-bar",
    data: data! {
        degrees "eta" 25.0, "alpha" 75.0, "beta" 60.0, "bend" 70.0, "phi" 60.0;
    },
    parameters: 4,
    unknowns: &[Unknown::angle("psi", 65.0)],
    residual: |p| {
        let cosine = spherical_input(p).dot(&spherical_output(p));
        vec![cosine - p.direction("alpha").x]
    },
    further: |p| {
        spherical_output(p)
            .components()
            .map(Output::Number)
            .to_vec()
    },
    gap: |p| {
        // The angle between the bars' ends: from their cones' nearest to their farthest.
        let bend = p.direction("bend");
        let axis = Space::new(bend.y, 0.0, bend.x);
        let (u, beta) = (spherical_input(p), p.direction("beta"));
        let along = u.dot(&axis) * &beta.x;
        let across = u.cross(&axis).norm() * beta.y.abs();
        let cosine = p.direction("alpha").x;
        let (near, far) = (&along + &across - &cosine, &cosine - &along + &across);
        if near < far { near } else { far }
    },
    pairs: &[(0, 1), (2, 3)],
    ..System::PLAIN
};

macro_rules! spherical {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, w];
            $($pairs)*
            fields |g| { eta: g[0], alpha: g[1], beta: g[2], bend: g[3] }
            {
                param eta = 25deg;
                param alpha = 75deg;
                param beta = 60deg;
                param bend = 70deg;
                input phi = 60deg in 0deg..360deg;
                unknown psi = 65deg;
                $($items)*
            }
        }
    };
}

spherical!(turned [pairs eta alpha, beta bend;] {
    let u = turn((sin(eta), 0, cos(eta)), (0, 0, 1), phi);
    let axis = (sin(bend), 0, cos(bend));
    let w = turn(turn((sin(beta), 0, cos(beta)), (0, 1, 0), bend), axis, psi);
    loop dot(u, w) = cos(alpha);
});

spherical!(components [] {
    let u = (sin(eta) * cos(phi), sin(eta) * sin(phi), cos(eta));
    let across = sin(beta) * cos(psi);
    let along = cos(beta);
    let w = (
        across * cos(bend) + along * sin(bend),
        sin(beta) * sin(psi),
        along * cos(bend) - across * sin(bend),
    );
    loop cos(alpha) - w.x * u.x - w.y * u.y - w.z * u.z = 0;
});

const PLAN: Plan = Plan {
    geometry: |random, _| {
        let phi = 60f64.to_radians();
        loop {
            let [eta, beta, bend, psi] = [0; 4].map(|_| random.between(0.2, 2.9));
            let psi = psi * if random.chance(0.5) { 1.0 } else { -1.0 };
            let u = [eta.sin() * phi.cos(), eta.sin() * phi.sin(), eta.cos()];
            let x = u[0] * bend.cos() - u[2] * bend.sin();
            let z = u[0] * bend.sin() + u[2] * bend.cos();
            let slope = beta.sin() * (u[1] * psi.cos() - x * psi.sin());
            let cosine = beta.sin() * (x * psi.cos() + u[1] * psi.sin()) + beta.cos() * z;
            if slope > 0.05 {
                return vec![eta, cosine.acos(), beta, bend];
            }
        }
    },
    dead_points: &[(1, 1e-2), (2, 1e-2), (2, 3.0)],
};

/// Both shafts' arms are square to their axes and to each other.
const UNIVERSAL: System = System {
    name: "universal joint",
    data: &[Datum::degrees("bend", 30.0), Datum::degrees("phi", 45.0)],
    parameters: 1,
    unknowns: &[Unknown::angle("psi", 41.0)],
    residual: |p| {
        let phi = p.direction("phi");
        let u = Space::new(-&phi.y, phi.x, 0.0);
        vec![u.dot(&output(p, &Big::zero(), &Big::one()))]
    },
    pairs: &[(0, 0), (0, 0)],
    ..System::PLAIN
};

linkage_reference::form! {
    universal(phi) -> [psi];
    pairs bend bend, bend bend;
    fields |g| { bend: g[0] }
    {
        param bend = 30deg;
        input phi = 45deg in 0deg..360deg;
        unknown psi = 41deg;
        let u = turn((0, 1, 0), (0, 0, 1), phi);
        let axis = (sin(bend), 0, cos(bend));
        let w = turn((cos(bend), 0, -sin(bend)), axis, psi);
        loop dot(u, w) = 0;
    }
}

const FORMS: &[Form] = forms![turned, components];

linkage_reference::sets! { SPHERICAL, FORMS;
    spherical_cycles "cycles": cycle_cases(&PLAN, 25, 271), Full, LIMITS, at least 60;
}

#[test]
fn spherical_dead_points() {
    let cases = dead_point_cases(&SPHERICAL, &PLAN, 5, 272);
    // The loop gives the cosine of the angle between the arms: of a small angle it has lost digits.
    compare(&SPHERICAL, FORMS, &cases, Depth::Full)
        .at_least(65)
        .check("dead points", &LIMITS.times(3.0));
}

linkage_reference::sets! { SPHERICAL, FORMS;
    spherical_far_inputs "inputs to 1e6 rad":
        far_input_cases(&PLAN, 30, 273), Usual, LIMITS, at least 35;
}

#[test]
fn spherical_both_sides_of_the_dead_point() {
    edge(&SPHERICAL, FORMS, &PLAN, 3, 274).check("spherical four-bar");
}

#[test]
fn universal_joint() {
    let plan = Plan {
        geometry: |random, _| vec![random.between(0.2, 1.45)],
        dead_points: &[],
    };
    let cases = cycle_cases(&UNIVERSAL, &plan, 60, 275);
    compare(&UNIVERSAL, forms![universal], &cases, Depth::Full)
        .at_least(200)
        .check("cycles", &LIMITS);
}
