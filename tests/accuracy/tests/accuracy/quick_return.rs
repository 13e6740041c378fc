//! A quick-return drive: an RPR dyad and an RRP dyad in a row.

use linkage_reference::{
    Big, Datum, Depth, Form, Limits, Output, System, Unknown, compare, forms, nearby_cases,
};

/// The uncertainty is that of both loops together; the second one differentiates the first one's
/// rounded results.
const LIMITS: Limits = Limits {
    condition: 10.0,
    value: 10.0,
    margin: 10.0,
    first: 30.0,
    second: 30.0,
    third: 30.0,
};

const QUICK_RETURN: System = System {
    name: "quick return",
    data: &[
        Datum::length("crank", 40.0),
        Datum::length("pivot.x", 0.0),
        Datum::length("pivot.y", -100.0),
        Datum::length("offset", 5.0),
        Datum::length("lever", 180.0),
        Datum::length("rod", 90.0),
        Datum::length("height", 90.0),
        Datum::degrees("phi", 30.0),
    ],
    parameters: 7,
    unknowns: &[
        Unknown::angle("psi", 72.0),
        Unknown::slide("s", 125.0),
        Unknown::angle("theta", 12.0),
        Unknown::slide("ram", 145.0),
    ],
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
    outputs: |p| {
        let end = p.point("pivot") + p.polar("lever", "psi");
        vec![
            Output::Angle(p.direction("psi")),
            Output::Value(p.slide("s").clone()),
            Output::Angle(p.direction("theta")),
            Output::Value(p.slide("ram").clone()),
            Output::Value(end.x),
            Output::Value(end.y),
        ]
    },
    gap: |_| Big::one(),
    turned: |_| linkage_reference::Big::one(),
    pairs: &[(0, 3), (4, 5)],
    linear: false,
    margin: None,
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
