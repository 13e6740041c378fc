//! RRP and PRR: a link and a slide along a guide of known direction, at rest or moving.

mod stress;

use linkage_reference::{
    Big, Depth, Form, Limits, Output, Plan, Plane, Position, System, Unknown, compare, data, forms,
    proportion_cases, reach_gap,
};

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 100.0, 100.0]);

const SLIDER_CRANK: System = System {
    name: "slider-crank",
    data: data! {
        length "crank" 30.0, "rod" 100.0, "guide.x" 0.0, "guide.y" 10.0;
        degrees "gamma" 5.0;
        ratio "ratio" 0.0;
        degrees "phi" 30.0;
    },
    parameters: 5,
    unknowns: &[Unknown::angle("theta", 3.0), Unknown::slide("s", 126.0)],
    residual: slider_residual,
    further: pin,
    gap: slider_gap,
    turned: guide_angle,
    pairs: &[(0, 1), (4, 4)],
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

fn guide_angle(p: &Position) -> Big {
    p.value("gamma") + p.value("ratio") * p.value("phi")
}

fn guide_direction(p: &Position) -> Plane {
    Plane::direction(&guide_angle(p))
}

fn slider_residual(p: &Position) -> Vec<Big> {
    let slide = guide_direction(p).times(p.slide("s"));
    let closure = p.polar("crank", "phi") + p.polar("rod", "theta") - p.point("guide") - slide;
    vec![closure.x, closure.y]
}

fn pin(p: &Position) -> Vec<Output> {
    let pin = p.polar("crank", "phi") + p.polar("rod", "theta");
    Output::lengths([pin.x, pin.y])
}

fn slider_gap(p: &Position) -> Big {
    let known = p.polar("crank", "phi") - p.point("guide");
    reach_gap(p.value("rod"), &guide_direction(p).cross(&known))
}

macro_rules! slider_crank {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, s, pin];
            pairs crank rod, gamma gamma;
            fields |g| { crank: g[0], rod: g[1], guide: [g[2], g[3]], gamma: g[4] }
            {
                unit mm;
                param crank = 30mm;
                param rod = 100mm;
                param guide = (0mm, 10mm);
                param gamma = 5deg;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

slider_crank!(plain {
    unknown theta = 3deg;
    unknown s = 126mm;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop pin = guide + s * dir(gamma);
});

slider_crank!(slide_first {
    unknown s = 126mm;
    unknown theta = 3deg;
    let pin = polar(crank, phi) + rotate((rod, 0), theta);
    loop guide + polar(s, gamma) - rotate((rod, 0), theta) = rotate((crank, 0), phi);
});

slider_crank!(negative_slide {
    unknown t = -126mm;
    unknown theta = 3deg;
    let s = -t;
    let pin = polar(crank, phi) + dir(theta) * rod;
    loop guide = pin + t * dir(gamma);
});

slider_crank!(backward_guide {
    unknown t = -126mm;
    unknown turned = 183deg;
    let theta = turned - 180deg;
    let s = -t;
    let pin = polar(crank, phi) - polar(rod, turned);
    loop polar(crank, phi) - polar(rod, turned) - guide - polar(t, gamma + 180deg) = 0;
});

slider_crank!(along_and_across {
    unknown theta = 3deg;
    unknown s = 126mm;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop dot(dir(gamma), pin - guide) = s;
    loop cross(dir(gamma), pin - guide) = 0;
});

slider_crank!(one_angle {
    unknown theta = 3deg;
    let pin = polar(crank, phi) + polar(rod, theta);
    loop cross(dir(gamma), pin - guide) = 0;
    let s = dot(dir(gamma), pin - guide);
});

slider_crank!(one_slide {
    unknown s = 126mm;
    let a = polar(crank, phi);
    let pin = guide + s * dir(gamma);
    loop distance(a, pin) = rod;
    let theta = angle(pin - a);
});

slider_crank!(unknown_point {
    unknown pin = (126mm, 21mm);
    let a = polar(crank, phi);
    loop distance(a, pin) = rod;
    loop cross(dir(gamma), pin - guide) = 0;
    let theta = angle(pin - a);
    let s = dot(dir(gamma), pin - guide);
});

slider_crank!(relative_angle {
    unknown bend = -2deg;
    unknown s = 126mm;
    let theta = gamma + bend;
    let pin = polar(crank, phi) + polar(rod, gamma + bend);
    loop rotate(polar(rod, bend) - (s, 0mm), gamma) = guide - polar(crank, phi);
});

/// Everything but the ratio, for the guide's angle at the reference input.
fn geometry(random: &mut linkage_reference::Random, spread: f64, ratio: f64) -> Vec<f64> {
    let [crank, rod, s] = [0; 3].map(|_| random.length(spread));
    let gamma = random.angle();
    let phi = 30f64.to_radians();
    let guide = gamma + ratio * phi;
    // The link makes an acute angle with the guide; a negative length turns it by half a turn.
    let theta = guide
        + random.between(-1.5, 1.5)
        + if rod < 0.0 {
            core::f64::consts::PI
        } else {
            0.0
        };
    let x = crank * phi.cos() + rod * theta.cos() - s * guide.cos();
    let y = crank * phi.sin() + rod * theta.sin() - s * guide.sin();
    vec![crank, rod, x, y, gamma, ratio]
}

const FIXED_PLAN: Plan = Plan {
    geometry: |random, spread| geometry(random, spread, 0.0),
    dead_points: &[(1, 1e-3), (0, 60.0)],
};

const FIXED: &[Form] = forms![
    plain, slide_first, negative_slide, backward_guide, along_and_across, one_angle, relative_angle;
    where |g| g[1] > 0.0 => one_slide, unknown_point
];

/// How many of them come before those with an unknown point or a distance.
const FITTING: usize = 7;

linkage_reference::sets! { SLIDER_CRANK, FIXED;
    slider_crank_cycles "cycles": cycle_cases(&FIXED_PLAN, 30, 11), Full, LIMITS;
    slider_crank_dead_points "dead points": dead_point_cases(&FIXED_PLAN, 8, 12), Full, LIMITS;
}

#[test]
fn slider_crank_proportions() {
    let cases = proportion_cases(&SLIDER_CRANK, &FIXED_PLAN, 30, 13);
    let (fitting, points) = FIXED.split_at(FITTING);
    compare(&SLIDER_CRANK, fitting, &cases, Depth::Full)
        .check("proportions", &LIMITS.any_proportions());
    compare(&SLIDER_CRANK, points, &cases, Depth::Full)
        .check("proportions", &LIMITS.any_proportions().times(25.0));
}

linkage_reference::sets! { SLIDER_CRANK, FIXED;
    slider_crank_scales "scales": scale_cases(&FIXED_PLAN, 8, 14), Full, LIMITS;
}
