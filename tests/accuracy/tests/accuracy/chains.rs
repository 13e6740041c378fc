//! Dyads that build on dyads: a six-bar and a guide on a moving link.

use linkage_reference::{
    Big, Depth, Form, Limits, Output, Plane, Position, System, compare, data, forms, nearby_cases,
    unknowns,
};

/// The uncertainty is that of both loops together; the second one differentiates the first one's
/// rounded results.
const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 30.0, 30.0]);

fn closure(p: &Position) -> [Big; 2] {
    let closure = p.polar("crank", "phi") + p.polar("coupler", "theta")
        - p.polar("rocker", "psi")
        - p.point("pivot_d");
    [closure.x, closure.y]
}

fn tracer(p: &Position) -> Plane {
    p.polar("crank", "phi") + p.polar("arm", "theta").turned(&p.direction("lift"))
}

const SIX_BAR: System = System {
    name: "six-bar",
    data: data! {
        length "pivot_d.x" 140.0, "pivot_d.y" 5.0, "crank" 50.0, "coupler" 120.0, "rocker" 100.0,
            "arm" 70.0;
        degrees "lift" 25.0;
        length "pivot_g.x" -60.0, "pivot_g.y" 150.0, "link" 160.0, "out" 120.0;
        degrees "phi" 30.0;
    },
    parameters: 11,
    unknowns: unknowns! {
        angle "theta" 40.0, "psi" 80.0, "alpha" 109.0, "beta" 48.0;
    },
    residual: |p| {
        let second =
            tracer(p) + p.polar("link", "alpha") - p.polar("out", "beta") - p.point("pivot_g");
        let [x, y] = closure(p);
        vec![x, y, second.x, second.y]
    },
    further: |p| {
        let tip = tracer(p) + p.polar("link", "alpha");
        Output::lengths([tip.x, tip.y])
    },
    pairs: &[(2, 9), (5, 10)],
    ..System::PLAIN
};

macro_rules! six_bar {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, psi, alpha, beta, tip];
            pairs crank link, arm out;
            fields |g| {
                pivot_d: [g[0], g[1]], crank: g[2], coupler: g[3], rocker: g[4],
                arm: g[5], lift: g[6],
                pivot_g: [g[7], g[8]], link: g[9], out: g[10]
            }
            {
                unit mm;
                param pivot_d = (140mm, 5mm);
                param crank = 50mm;
                param coupler = 120mm;
                param rocker = 100mm;
                param arm = 70mm;
                param lift = 25deg;
                param pivot_g = (-60mm, 150mm);
                param link = 160mm;
                param out = 120mm;
                input phi = 30deg in 0deg..360deg;
                let a = polar(crank, phi);
                $($items)*
            }
        }
    };
}

six_bar!(plain_six_bar {
    unknown theta = 40deg;
    unknown psi = 80deg;
    unknown alpha = 109deg;
    unknown beta = 48deg;
    loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
    let tracer = a + polar(arm, theta + lift);
    let tip = pivot_g + polar(out, beta);
    loop tracer + polar(link, alpha) = tip;
});

six_bar!(backward_six_bar {
    unknown beta = 48deg;
    unknown alpha = 109deg;
    unknown psi = 80deg;
    unknown theta = 40deg;
    let tracer = a + rotate(polar(arm, lift), theta);
    let tip = tracer + dir(alpha) * link;
    loop pivot_g - tip + rotate((out, 0), beta) = 0;
    loop rotate((coupler, 0), theta) - polar(rocker, psi) = pivot_d - a;
});

six_bar!(unknown_tip {
    unknown tip = (20mm, 239mm);
    unknown theta = 40deg;
    unknown psi = 80deg;
    let tracer = a + polar(arm, theta + lift);
    loop a + polar(coupler, theta) - polar(rocker, psi) = pivot_d;
    loop distance(tip, tracer) = link;
    loop distance(pivot_g, tip) = out;
    let alpha = angle(tip - tracer);
    let beta = angle(tip - pivot_g);
});

const MOVING_GUIDE: System = System {
    name: "guide on a coupler",
    data: data! {
        length "pivot_d.x" 140.0, "pivot_d.y" 5.0, "crank" 50.0, "coupler" 120.0, "rocker" 100.0,
            "arm" 70.0;
        degrees "lift" 25.0;
        length "pivot_g.x" -40.0, "pivot_g.y" 60.0;
        degrees "gamma" 120.0;
        length "out" 250.0;
        degrees "phi" 30.0;
    },
    parameters: 11,
    unknowns: unknowns! {
        angle "theta" 40.0, "psi" 80.0;
        slide "t" 338.0;
        angle "beta" 145.0;
    },
    residual: |p| {
        let guide = p.direction("theta").turned(&p.direction("gamma"));
        let second =
            tracer(p) + guide.times(p.slide("t")) - p.polar("out", "beta") - p.point("pivot_g");
        let [x, y] = closure(p);
        vec![x, y, second.x, second.y]
    },
    further: |p| {
        let tip = p.point("pivot_g") + p.polar("out", "beta");
        Output::lengths([tip.x, tip.y])
    },
    pairs: &[(2, 9), (5, 10)],
    ..System::PLAIN
};

macro_rules! moving_guide {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [theta, psi, t, beta, tip];
            pairs crank gamma, arm out;
            fields |g| {
                pivot_d: [g[0], g[1]], crank: g[2], coupler: g[3], rocker: g[4],
                arm: g[5], lift: g[6],
                pivot_g: [g[7], g[8]], gamma: g[9], out: g[10]
            }
            {
                unit mm;
                param pivot_d = (140mm, 5mm);
                param crank = 50mm;
                param coupler = 120mm;
                param rocker = 100mm;
                param arm = 70mm;
                param lift = 25deg;
                param pivot_g = (-40mm, 60mm);
                param gamma = 120deg;
                param out = 250mm;
                input phi = 30deg in 0deg..360deg;
                unknown theta = 40deg;
                unknown psi = 80deg;
                let a = polar(crank, phi);
                let tracer = a + polar(arm, theta + lift);
                loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
                $($items)*
            }
        }
    };
}

moving_guide!(plain_guide {
    unknown t = 338mm;
    unknown beta = 145deg;
    let tip = tracer + polar(t, theta + gamma);
    loop tip = pivot_g + polar(out, beta);
});

moving_guide!(across_the_guide {
    unknown beta = 145deg;
    let guide = dir(gamma + theta);
    let tip = pivot_g + rotate((out, 0), beta);
    loop cross(guide, tip - tracer) = 0;
    let t = dot(guide, tip - tracer);
});

#[test]
fn six_bar() {
    const FORMS: &[Form] = forms![plain_six_bar, backward_six_bar, unknown_tip];
    compare(&SIX_BAR, FORMS, &nearby_cases(&SIX_BAR, 6, 61), Depth::Full).check("six bar", &LIMITS);
}

#[test]
fn guide_on_a_coupler() {
    const FORMS: &[Form] = forms![plain_guide, across_the_guide];
    compare(
        &MOVING_GUIDE,
        FORMS,
        &nearby_cases(&MOVING_GUIDE, 6, 63),
        Depth::Full,
    )
    .check("guide on a coupler", &LIMITS);
}
