//! A chain of ten dyads: the errors of each go into the next.

use linkage_reference::{
    Big, Depth, Form, Limits, Output, Plane, Position, System, compare, data, forms, nearby_cases,
    unknowns,
};

/// The errors of all groups before one add up; the condition number counts them, as it is the sum
/// over all loops. What is left is as for one dyad.
const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 100.0, 100.0]);

/// A dyad on a moving point, and the point that it moves.
enum Stage {
    /// A coupler from the point to a rocker of 70 mm, whose lever carries the next point.
    Rrr { pivot: [f64; 2], lever: f64 },
    /// A rod from the point to a slider, which is the next point.
    Rrp { guide: [f64; 2], degrees: f64 },
    /// The point slides along a turning lever, the end of which is the next point.
    Rpr { pivot: [f64; 2], lever: f64 },
}

const STAGES: [Stage; 10] = [
    Stage::Rrr {
        pivot: [90.0, -30.0],
        lever: 63.0,
    },
    Stage::Rrp {
        guide: [87.0, 56.0],
        degrees: 10.0,
    },
    Stage::Rpr {
        pivot: [122.0, 115.0],
        lever: 121.0,
    },
    Stage::Rrr {
        pivot: [298.0, 92.0],
        lever: 67.0,
    },
    Stage::Rrp {
        guide: [226.0, 145.0],
        degrees: 70.0,
    },
    Stage::Rpr {
        pivot: [322.0, 305.0],
        lever: 198.0,
    },
    Stage::Rrr {
        pivot: [258.0, 152.0],
        lever: 249.0,
    },
    Stage::Rrp {
        guide: [240.0, 385.0],
        degrees: 130.0,
    },
    Stage::Rpr {
        pivot: [102.0, 506.0],
        lever: 392.0,
    },
    Stage::Rrr {
        pivot: [500.0, 327.0],
        lever: 65.0,
    },
];

const CHAIN: System = System {
    name: "chain of ten",
    data: data! {
        length "crank" 20.0, "coupler_1" 100.0, "rod_2" 110.0, "offset_3" 9.0, "coupler_4" 100.0,
            "rod_5" 110.0, "offset_6" 9.0, "coupler_7" 100.0, "rod_8" 110.0, "offset_9" 9.0,
            "coupler_10" 100.0;
        degrees "phi" 30.0;
    },
    parameters: 11,
    unknowns: unknowns! {
        angle "theta_1" 14.9, "psi_1" 70.0, "theta_2" 26.2;
        slide "s_2" 125.2;
        angle "psi_3" -28.3;
        slide "s_3" 95.4;
        angle "theta_4" 70.5, "psi_4" 121.1, "theta_5" 87.8;
        slide "s_5" 121.6;
        angle "psi_6" -147.2;
        slide "s_6" 70.5;
        angle "theta_7" 13.8, "psi_7" 94.4, "theta_8" 134.6;
        slide "s_8" 122.2;
        angle "psi_9" -32.6;
        slide "s_9" 64.9;
        angle "theta_10" 69.9, "psi_10" 118.7;
    },
    residual: |p| {
        points(p)
            .into_iter()
            .flat_map(|(_, miss)| [miss.x, miss.y])
            .collect()
    },
    further: |p| {
        let points = points(p)
            .into_iter()
            .flat_map(|(point, _)| [point.x, point.y]);
        points.map(Output::Value).collect()
    },
    ..System::PLAIN
};

/// The points that the stages move, and by how much their loops are missed.
fn points(p: &Position) -> Vec<(Plane, Plane)> {
    let mut point = p.polar("crank", "phi");
    let mut result = Vec::new();
    for (index, stage) in STAGES.iter().enumerate() {
        let name = |what: &str| format!("{what}_{}", index + 1);
        let turned = |length: f64| p.direction(&name("psi")).times(&Big::from(length));
        let (next, miss) = match *stage {
            Stage::Rrr { pivot, lever } => {
                let pivot = Plane::new(pivot[0], pivot[1]);
                let coupler = p.polar(&name("coupler"), &name("theta"));
                let miss = point + coupler - pivot.clone() - turned(70.0);
                (pivot + turned(lever), miss)
            }
            Stage::Rrp { guide, degrees } => {
                let along = Plane::direction(&Big::from(degrees.to_radians()));
                let slider = Plane::new(guide[0], guide[1]) + along.times(p.slide(&name("s")));
                let rod = p.polar(&name("rod"), &name("theta"));
                (slider.clone(), point + rod - slider)
            }
            Stage::Rpr { pivot, lever } => {
                let pivot = Plane::new(pivot[0], pivot[1]);
                let direction = p.direction(&name("psi"));
                let line = direction.times(p.slide(&name("s")))
                    + direction.quarter().times(p.value(&name("offset")));
                (pivot.clone() + turned(lever), pivot + line - point)
            }
        };
        result.push((next.clone(), miss));
        point = next;
    }
    result
}

linkage_reference::form! {
    chain(phi) -> [
        theta_1, psi_1, theta_2, s_2, psi_3, s_3, theta_4, psi_4, theta_5, s_5, psi_6, s_6, theta_7, psi_7, theta_8, s_8, psi_9, s_9, theta_10, psi_10,
        p1, p2, p3, p4, p5, p6, p7, p8, p9, p10,
    ];
    fields |g| {
        crank: g[0], coupler_1: g[1], rod_2: g[2], offset_3: g[3], coupler_4: g[4], rod_5: g[5], offset_6: g[6], coupler_7: g[7], rod_8: g[8], offset_9: g[9], coupler_10: g[10],
    }
    {
        unit mm;
        param crank = 20mm;
        param coupler_1 = 100mm;
        param rod_2 = 110mm;
        param offset_3 = 9mm;
        param coupler_4 = 100mm;
        param rod_5 = 110mm;
        param offset_6 = 9mm;
        param coupler_7 = 100mm;
        param rod_8 = 110mm;
        param offset_9 = 9mm;
        param coupler_10 = 100mm;
        input phi = 30deg in 0deg..360deg;
        let p0 = polar(crank, phi);
        unknown theta_1 = 15deg;
        unknown psi_1 = 70deg;
        loop p0 + polar(coupler_1, theta_1) = (90mm, -30mm) + polar(70mm, psi_1);
        let p1 = (90mm, -30mm) + polar(63mm, psi_1);
        unknown theta_2 = 26deg;
        unknown s_2 = 125mm;
        let p2 = (87mm, 56mm) + polar(s_2, 10deg);
        loop p1 + polar(rod_2, theta_2) = p2;
        unknown psi_3 = -28deg;
        unknown s_3 = 95mm;
        loop (122mm, 115mm) + rotate((s_3, offset_3), psi_3) = p2;
        let p3 = (122mm, 115mm) + polar(121mm, psi_3);
        unknown theta_4 = 71deg;
        unknown psi_4 = 121deg;
        loop p3 + polar(coupler_4, theta_4) = (298mm, 92mm) + polar(70mm, psi_4);
        let p4 = (298mm, 92mm) + polar(67mm, psi_4);
        unknown theta_5 = 88deg;
        unknown s_5 = 122mm;
        let p5 = (226mm, 145mm) + polar(s_5, 70deg);
        loop p4 + polar(rod_5, theta_5) = p5;
        unknown psi_6 = -147deg;
        unknown s_6 = 70mm;
        loop (322mm, 305mm) + rotate((s_6, offset_6), psi_6) = p5;
        let p6 = (322mm, 305mm) + polar(198mm, psi_6);
        unknown theta_7 = 14deg;
        unknown psi_7 = 94deg;
        loop p6 + polar(coupler_7, theta_7) = (258mm, 152mm) + polar(70mm, psi_7);
        let p7 = (258mm, 152mm) + polar(249mm, psi_7);
        unknown theta_8 = 135deg;
        unknown s_8 = 122mm;
        let p8 = (240mm, 385mm) + polar(s_8, 130deg);
        loop p7 + polar(rod_8, theta_8) = p8;
        unknown psi_9 = -33deg;
        unknown s_9 = 65mm;
        loop (102mm, 506mm) + rotate((s_9, offset_9), psi_9) = p8;
        let p9 = (102mm, 506mm) + polar(392mm, psi_9);
        unknown theta_10 = 70deg;
        unknown psi_10 = 119deg;
        loop p9 + polar(coupler_10, theta_10) = (500mm, 327mm) + polar(70mm, psi_10);
        let p10 = (500mm, 327mm) + polar(65mm, psi_10);
    }
}

const FORMS: &[Form] = forms![chain];

#[test]
fn positions_and_derivatives() {
    let cases = nearby_cases(&CHAIN, 4, 141);
    compare(&CHAIN, FORMS, &cases, Depth::Usual).check("numbers within 3 %", &LIMITS);
}
