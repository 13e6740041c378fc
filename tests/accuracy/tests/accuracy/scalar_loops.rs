//! Loops of one equation and one unknown.

use linkage_reference::{
    Big, Depth, Form, Limits, Output, Plan, Plane, Position, System, Unknown, compare, cycle_cases,
    data, dead_point_cases, forms, reach_gap, scale_cases,
};

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 30.0, 30.0]);

/// A link whose end stays on a line: `A cos psi + B sin psi = C`.
const ON_A_LINE: System = System {
    name: "link on a line",
    data: data! {
        length "link" 90.0, "crank" 20.0, "distance" 15.0;
        degrees "normal" 70.0, "phi" 30.0;
    },
    parameters: 4,
    unknowns: &[Unknown::angle("psi", 340.0)],
    residual: |p| {
        let end = p.polar("crank", "phi") + p.polar("link", "psi");
        vec![end.dot(&p.direction("normal")) - p.value("distance")]
    },
    further: |p| {
        let end = p.polar("crank", "phi") + p.polar("link", "psi");
        Output::lengths([end.x, end.y])
    },
    gap: |p| {
        let known = p.value("distance") - p.polar("crank", "phi").dot(&p.direction("normal"));
        reach_gap(p.value("link"), &known)
    },
    pairs: &[(0, 1), (2, 3)],
    ..System::PLAIN
};

macro_rules! on_a_line {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, end];
            pairs link crank, distance normal;
            fields |g| { link: g[0], crank: g[1], distance: g[2], normal: g[3] }
            {
                unit mm;
                param link = 90mm;
                param crank = 20mm;
                param distance = 15mm;
                param normal = 70deg;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

on_a_line!(product {
    unknown psi = 340deg;
    let end = polar(crank, phi) + polar(link, psi);
    loop dot(dir(normal), end) = distance;
});

on_a_line!(sines {
    unknown psi = -20deg;
    let end = polar(crank, phi) + rotate((link, 0), psi);
    loop crank * cos(phi - normal) - distance = -link * cos(psi - normal);
});

on_a_line!(mixed_angles {
    unknown bend = 250deg;
    let psi = bend + 90deg;
    let end = polar(crank, phi) + polar(link, bend + 90deg);
    loop cross(dir(normal - 90deg), end) - distance = 0;
});

const LINE_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let [link, crank] = [0; 2].map(|_| random.length(spread));
        let normal = random.angle();
        // The link lies clockwise of the normal, as in the mechanism as written.
        let psi = normal - random.between(0.05, 3.1) * link.signum();
        let phi = 30f64.to_radians();
        let distance = crank * (phi - normal).cos() + link * (psi - normal).cos();
        vec![link, crank, distance, normal]
    },
    dead_points: &[(0, 1e-3), (2, 1e3)],
};

const LINE_FORMS: &[Form] = forms![product, sines, mixed_angles];

linkage_reference::sets! { ON_A_LINE, LINE_FORMS;
    link_on_a_line "link on a line": cycle_cases(&LINE_PLAN, 40, 41), Full, LIMITS;
}

#[test]
fn link_on_a_line_hard_cases() {
    let mut cases = dead_point_cases(&ON_A_LINE, &LINE_PLAN, 8, 42);
    cases.extend(scale_cases(&ON_A_LINE, &LINE_PLAN, 6, 43));
    compare(&ON_A_LINE, LINE_FORMS, &cases, Depth::Full)
        .check("link on a line hard cases", &LIMITS.any_proportions());
}

/// A gear pair as a loop of angles, with a point on the driven wheel.
const GEARS: System = System {
    name: "gears",
    data: data! {
        ratio "ratio" 2.5;
        degrees "offset" 12.0;
        length "radius" 25.0;
        degrees "phi" 30.0;
    },
    parameters: 3,
    unknowns: &[Unknown::angle("psi", 87.0)],
    residual: |p| {
        let wheel = Plane::direction(&wheel_angle(p));
        vec![wheel.cross(&p.direction("psi")) * p.value("radius")]
    },
    further: |p| {
        let pin = p.polar("radius", "psi");
        Output::lengths([pin.x, pin.y])
    },
    turned: wheel_angle,
    pairs: &[(0, 2), (0, 1)],
    linear: true,
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

fn wheel_angle(p: &Position) -> Big {
    p.value("ratio") * p.value("phi") + p.value("offset")
}

macro_rules! gears {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, pin];
            pairs ratio radius, ratio offset;
            fields |g| { ratio: g[0], offset: g[1], radius: g[2] }
            {
                unit mm;
                param ratio = 2.5;
                param offset = 12deg;
                param radius = 25mm;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

gears!(angle_relation {
    unknown psi = 87deg;
    loop psi = ratio * phi + offset;
    let pin = polar(radius, psi);
});

gears!(turned_around {
    unknown psi = 87deg;
    loop offset - psi + ratio * phi = 0;
    let pin = rotate((radius, 0mm), psi);
});

gears!(doubled {
    unknown psi = 87deg;
    loop 2 * ratio * phi = 2 * psi - offset - offset;
    let pin = radius * dir(psi);
});

#[test]
fn gear_pair() {
    let plan = Plan {
        geometry: |random, spread| {
            let ratio = random.between(-3.0, 3.0);
            vec![ratio, random.angle(), random.length(spread)]
        },
        dead_points: &[],
    };
    let mut cases = cycle_cases(&GEARS, &plan, 40, 44);
    cases.extend(scale_cases(&GEARS, &plan, 6, 45));
    let forms = forms![angle_relation, turned_around, doubled];
    compare(&GEARS, forms, &cases, Depth::Full).check("gear pair", &LIMITS);
}
