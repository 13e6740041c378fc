//! The same with a guide that turns with the input.

use super::{LIMITS, SLIDER_CRANK, geometry};
use linkage_reference::{
    Datum, Depth, Form, Plan, System, Unknown, compare, cycle_cases, dead_point_cases, forms,
    proportion_cases, scale_cases,
};

const MOVING_GUIDE: System = System {
    name: "moving guide",
    data: &[
        Datum::length("crank", 30.0),
        Datum::length("rod", 100.0),
        Datum::length("guide.x", 0.0),
        Datum::length("guide.y", 10.0),
        Datum::degrees("gamma", 5.0),
        Datum::ratio("ratio", 0.25),
        Datum::degrees("phi", 30.0),
    ],
    parameters: 6,
    unknowns: &[Unknown::angle("theta", 3.0), Unknown::slide("s", 126.0)],
    pairs: &[(0, 1), (4, 5)],
    ..SLIDER_CRANK
};

macro_rules! moving_guide {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, s, pin];
            pairs crank rod, gamma ratio;
            fields |g| {
                crank: g[0], rod: g[1], guide: [g[2], g[3]], gamma: g[4], ratio: g[5]
            }
            {
                unit mm;
                param crank = 30mm;
                param rod = 100mm;
                param guide = (0mm, 10mm);
                param gamma = 5deg;
                param ratio = 0.25;
                input phi = 30deg in 0deg..360deg;
                let wheel = gamma + ratio * phi;
                $($items)*
            }
        }
    };
}

moving_guide!(moving_plain {
    unknown theta = 10deg;
    unknown s = 126mm;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop pin = guide + s * dir(wheel);
});

moving_guide!(moving_other_order {
    unknown s = 126mm;
    unknown theta = 10deg;
    let pin = rotate((crank, 0mm), phi) + polar(rod, theta);
    loop -polar(rod, theta) + rotate((s, 0), wheel) + guide = rotate((crank, 0mm), phi);
});

moving_guide!(moving_across {
    unknown theta = 10deg;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop dot(dir(wheel + 90deg), pin) = dot(dir(wheel + 90deg), guide);
    let s = dot(pin - guide, dir(wheel));
});

const MOVING_PLAN: Plan = Plan {
    geometry: |random, spread| {
        let ratio = random.between(-2.0, 2.0);
        geometry(random, spread, ratio)
    },
    dead_points: &[(1, 1e-3)],
};

const MOVING: &[Form] = forms![moving_plain, moving_other_order, moving_across];

#[test]
fn moving_guide_cycles() {
    let cases = cycle_cases(&MOVING_GUIDE, &MOVING_PLAN, 30, 15);
    compare(&MOVING_GUIDE, MOVING, &cases, Depth::Full).check("cycles", &LIMITS);
}

#[test]
fn moving_guide_hard_cases() {
    let mut cases = dead_point_cases(&MOVING_GUIDE, &MOVING_PLAN, 6, 16);
    cases.extend(scale_cases(&MOVING_GUIDE, &MOVING_PLAN, 4, 17));
    cases.extend(proportion_cases(&MOVING_GUIDE, &MOVING_PLAN, 20, 18));
    compare(&MOVING_GUIDE, MOVING, &cases, Depth::Full).check(
        "dead points, proportions, scales",
        &LIMITS.any_proportions(),
    );
}
