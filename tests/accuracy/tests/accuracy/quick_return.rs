//! Identities between results, and a quick return against its closed form.

use linkage_reference::{
    Depth, Form, Limits, Output, Random, System, compare, data, forms, identities, nearby_cases,
    unknowns,
};

// A quick-return drive: an RPR dyad and an RRP dyad in a row.

/// The uncertainty is that of both loops together; the second one differentiates the first one's
/// rounded results.
const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 30.0, 30.0]);

const QUICK_RETURN: System = System {
    name: "quick return",
    data: data! {
        length "crank" 40.0, "pivot.x" 0.0, "pivot.y" -100.0, "offset" 5.0, "lever" 180.0,
            "rod" 90.0, "height" 90.0;
        degrees "phi" 30.0;
    },
    parameters: 7,
    unknowns: unknowns! {
        angle "psi" 72.0;
        slide "s" 125.0;
        angle "theta" 12.0;
        slide "ram" 145.0;
    },
    residual: |p| {
        let line = p.direction("psi");
        let block =
            p.point("pivot") + line.times(p.slide("s")) + line.quarter().times(p.value("offset"))
                - p.polar("crank", "phi");
        let pin = p.point("pivot") + p.polar("lever", "psi") + p.polar("rod", "theta");
        vec![
            block.x,
            block.y,
            pin.x - p.slide("ram"),
            pin.y - p.value("height"),
        ]
    },
    further: |p| {
        let end = p.point("pivot") + p.polar("lever", "psi");
        Output::lengths([end.x, end.y])
    },
    pairs: &[(0, 3), (4, 5)],
    ..System::PLAIN
};

macro_rules! quick_return {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [psi, s, theta, ram, end];
            pairs crank offset, lever rod;
            fields |g| {
                crank: g[0], pivot: [g[1], g[2]], offset: g[3], lever: g[4],
                rod: g[5], height: g[6]
            }
            {
                unit mm;
                param crank = 40mm;
                param pivot = (0mm, -100mm);
                param offset = 5mm;
                param lever = 180mm;
                param rod = 90mm;
                param height = 90mm;
                input phi = 30deg in 0deg..360deg;
                $($items)*
            }
        }
    };
}

quick_return!(plain_quick_return {
    unknown psi = 72deg;
    unknown s = 125mm;
    unknown theta = 12deg;
    unknown ram = 145mm;
    loop pivot + rotate((s, offset), psi) = polar(crank, phi);
    let end = pivot + polar(lever, psi);
    loop end + polar(rod, theta) = (ram, height);
});

quick_return!(scalar_quick_return {
    unknown s = 125mm;
    unknown psi = 72deg;
    unknown theta = 12deg;
    let end = pivot + dir(psi) * lever;
    let block = s * dir(psi) + polar(offset, psi + 90deg);
    loop polar(crank, phi) - block - pivot = 0;
    loop end.y + rod * sin(theta) = height;
    let ram = end.x + rod * cos(theta);
});

#[test]
fn quick_return() {
    const FORMS: &[Form] = forms![plain_quick_return, scalar_quick_return];
    compare(
        &QUICK_RETURN,
        FORMS,
        &nearby_cases(&QUICK_RETURN, 20, 62),
        Depth::Full,
    )
    .check("quick return", &LIMITS);
}

// Euler's theorem on homogeneous functions: where every length is a parameter, an angle and its
// derivatives do not change when all lengths grow alike, and a coordinate and its derivatives grow
// with them: `sum r_i d(angle)/d r_i = 0`, `sum r_i d(x)/d r_i = x`.

/// Numbers within 3 % of those given.
fn near(random: &mut Random, numbers: &[f64]) -> Vec<f64> {
    let mut near = |x: &f64| x * random.between(0.97, 1.03);
    numbers.iter().map(&mut near).collect()
}

identities!(
    four_bar(phi), angles [psi psi_by], lengths [tracer tracer_by],
    |random| [near(random, &[140.0, 3.0, 50.0, 120.0, 100.0, 70.0]), vec![random.angle()]].concat(),
    {
        unit mm;
        param pivot_d = (140mm, 3mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param arm = 70mm;
        param lift = 25deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
);

identities!(
    slider_crank(phi), angles [theta theta_by], lengths [s s_by],
    |random| near(random, &[30.0, 100.0, 10.0, 0.1]),
    {
        unit mm;
        param crank = 30mm;
        param rod = 100mm;
        param offset = 10mm;
        param gamma = 5deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 3deg;
        unknown s = 126mm;
        loop polar(crank, phi) + polar(rod, theta) = polar(offset, gamma + 90deg) + polar(s, gamma);
    }
);

identities!(
    swinging_block(phi), angles [psi psi_by], lengths [s s_by],
    |random| near(random, &[80.0, -20.0, 30.0, 10.0]),
    {
        unit mm;
        param pivot = (80mm, -20mm);
        param crank = 30mm;
        param offset = 10mm;
        input phi = 40deg in 0deg..360deg;
        unknown psi = 137deg;
        unknown s = 68mm;
        loop pivot + rotate((s, offset), psi) = polar(crank, phi);
    }
);

identities!(
    trammel(phi), angles [], lengths [s s_by, t t_by],
    |random| near(random, &[30.0, 20.0, -15.0, 0.2, 1.7]),
    {
        unit mm;
        param crank = 30mm;
        param pivot = (20mm, -15mm);
        param alpha = 10deg;
        param beta = 100deg;
        input phi = 30deg in 0deg..360deg;
        unknown s = -10mm;
        unknown t = 30mm;
        loop polar(crank, phi) + s * dir(alpha) = pivot + t * dir(beta + 0.1 * phi);
    }
);

// The coupler point of a four-bar drives a second dyad.
identities!(
    six_bar(phi), angles [beta beta_by], lengths [tip tip_by],
    |random| near(random, &[140.0, 5.0, 50.0, 120.0, 100.0, 70.0, -60.0, 150.0, 160.0, 120.0]),
    {
        unit mm;
        param pivot_d = (140mm, 5mm);
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param arm = 70mm;
        param pivot_g = (-60mm, 150mm);
        param link = 160mm;
        param out = 120mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown alpha = 109deg;
        unknown beta = 48deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tip = pivot_g + polar(out, beta);
        loop a + polar(arm, theta + 25deg) + polar(link, alpha) = tip;
    }
);
