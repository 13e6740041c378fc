//! A hydraulic cylinder: the input is a slide inside a turning link, so the loop is an RRR dyad of
//! moving lengths.

use linkage_reference::{
    Form, Limits, Output, Plan, Plane, System, Unknown, data, forms, triangle_gap,
};

const LIMITS: Limits = Limits::new([10.0, 10.0, 10.0], [30.0, 30.0, 30.0]);

/// The rod's eye stands `shift` beside the cylinder's axis: a ternary link whose length moves.
const BOOM: System = System {
    name: "boom",
    data: data! {
        length "pivot.x" 90.0, "pivot.y" 20.0, "arm" 60.0, "shift" 8.0, "load" 150.0;
        degrees "lift" -20.0;
        length "stroke" 110.0;
    },
    parameters: 6,
    unknowns: &[Unknown::angle("theta", 40.0), Unknown::angle("psi", 90.0)],
    residual: |p| {
        let rod = Plane::new(p.value("stroke").clone(), p.value("shift").clone());
        let closure = rod.turned(&p.direction("theta")) - p.point("pivot") - p.polar("arm", "psi");
        vec![closure.x, closure.y]
    },
    further: |p| {
        let tip = p.point("pivot") + p.polar("load", "psi").turned(&p.direction("lift"));
        Output::lengths([tip.x, tip.y])
    },
    gap: |p| {
        let rod = Plane::new(p.value("stroke").clone(), p.value("shift").clone());
        triangle_gap(&rod.norm(), p.value("arm"), &p.point("pivot").norm())
    },
    pairs: &[(2, 3), (3, 3)],
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

macro_rules! boom {
    ($name:ident { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(stroke) -> [theta, psi, tip];
            pairs arm shift, shift shift;
            fields |g| {
                pivot: [g[0], g[1]], arm: g[2], shift: g[3], load: g[4], lift: g[5]
            }
            {
                unit mm;
                param pivot = (90mm, 20mm);
                param arm = 60mm;
                param shift = 8mm;
                param load = 150mm;
                param lift = -20deg;
                input stroke = 110mm in 80mm..140mm;
                $($items)*
            }
        }
    };
}

boom!(two_terms {
    unknown theta = 40deg;
    unknown psi = 90deg;
    let tip = pivot + polar(load, psi + lift);
    loop polar(stroke, theta) + polar(shift, theta + 90deg) = pivot + polar(arm, psi);
});

boom!(one_vector {
    unknown psi = 90deg;
    unknown theta = 40deg;
    let tip = pivot + rotate(polar(load, lift), psi);
    loop pivot - rotate((stroke, shift), theta) + rotate((arm, 0), psi) = 0;
});

boom!(turned_frame {
    unknown back = -140deg;
    unknown psi = 90deg;
    let theta = back + 180deg;
    let tip = pivot + dir(psi + lift) * load;
    loop pivot + stroke * dir(back) = shift * dir(back + 270deg) - polar(arm, psi);
});

boom!(distances {
    unknown eye = (90mm, 80mm);
    loop distance(eye, pivot) = arm;
    loop norm(eye) = sqrt(stroke * stroke + shift * shift);
    let psi = angle(eye - pivot);
    let theta = angle(eye) - atan2(shift, stroke);
    let tip = pivot + polar(load, psi + lift);
});

const PLAN: Plan = Plan {
    geometry: |random, spread| {
        let stroke: f64 = 110.0;
        let [arm, load] = [0; 2].map(|_| random.length(spread));
        // Not negligible beside the stroke, nor the stroke beside it: a change of the shorter one
        // all but turns the link, so that the derivative of everything else is a small difference.
        let shift = random.between(-1.0, 1.0) * stroke;
        let axis = random.angle();
        let bend = random.between(0.05, 3.1) * arm.signum();
        // The arm stands counter-clockwise of the line from the cylinder's pivot to the rod's eye.
        let psi = axis + shift.atan2(stroke) + bend;
        let x = stroke * axis.cos() - shift * axis.sin() - arm * psi.cos();
        let y = stroke * axis.sin() + shift * axis.cos() - arm * psi.sin();
        vec![x, y, arm, shift, load, random.angle()]
    },
    dead_points: &[(2, 30.0), (2, 0.01)],
};

const FORMS: &[Form] = forms![
    two_terms, one_vector, turned_frame;
    where |g| g[2] > 0.0 => distances
];

linkage_reference::sets! { BOOM, FORMS;
    strokes "strokes": cycle_cases(&PLAN, 30, 51), Full, LIMITS;
    dead_points "dead points": dead_point_cases(&PLAN, 6, 52), Full, LIMITS.any_proportions();
    proportions "proportions": proportion_cases(&PLAN, 20, 53), Full, LIMITS.any_proportions();
}
