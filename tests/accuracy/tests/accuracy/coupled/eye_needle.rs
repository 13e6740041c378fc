//! The eye-needle drive in two written forms, and towards its turning points.

use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{
    Big, Depth, Form, Output, Plane, Position, Reference, System, compare, concatenate, data,
    forms, unknowns,
};

macro_rules! eye_needle {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [phi23, phi34, phi64, phi75, p8];
            $($pairs)*
            fields |g| {
                l12: g[0], l23: g[1], l34: g[2], l45: g[3], l35: g[4], l46: g[5], l57: g[6],
                l78: g[7], angle_578: g[8], p6: [g[9], g[10]], p7: [g[11], g[12]]
            }
            {
                unit mm;
                param l12 = 50mm;
                param l23 = 272.5mm;
                param l34 = 81mm;
                param l45 = 104.5mm;
                param l35 = 174mm;
                param l46 = 104.5mm;
                param l57 = 261mm;
                param l78 = 136.8mm;
                param angle_578 = -25deg;
                param p6 = (195mm, 226mm);
                param p7 = (46mm, 533mm);
                input phi = 0deg in 0deg..360deg;
                let p2 = polar(l12, phi);
                let corner = triangle_angle(l34, l35, l45);
                $($items)*
            }
        }
    };
}

eye_needle!(plain [pairs l23 l45, l35 l35;] {
    unknown phi23 = 62deg;
    unknown phi34 = 146deg;
    unknown phi64 = 144deg;
    unknown phi75 = -99deg;
    let p3 = p2 + polar(l23, phi23);
    loop p3 + polar(l34, phi34) = p6 + polar(l46, phi64);
    loop p3 + polar(l35, phi34 + corner) = p7 + polar(l57, phi75);
    let p8 = p7 + polar(l78, phi75 + angle_578);
});

// The chains end at the needle; the second loop goes around the ternary link.
eye_needle!(around_the_link [] {
    unknown phi75 = -99deg;
    unknown phi64 = 144deg;
    unknown phi34 = 146deg;
    unknown phi23 = 62deg;
    let p5 = p7 + rotate((l57, 0), phi75);
    let p4 = p6 + dir(phi64) * l46;
    loop p5 - polar(l35, corner + phi34) + polar(l34, phi34) = p4;
    loop 0 = p2 - p5 + l23 * dir(phi23) + rotate(polar(l35, corner), phi34);
    let p8 = p7 + l78 / l57 * rotate(p5 - p7, angle_578);
});

const FORMS: &[Form] = forms![plain, around_the_link];

#[test]
fn cycle() {
    compare(
        &EYE_NEEDLE,
        FORMS,
        &cases(&EYE_NEEDLE, 0.01, 6, 71),
        Depth::Full,
    )
    .check("cycle", &LIMITS);
}

#[test]
fn all_sizes() {
    compare(
        &EYE_NEEDLE,
        FORMS,
        &sizes(&EYE_NEEDLE, 0.003, 72),
        Depth::Usual,
    )
    .check("sizes", &LIMITS);
}

// The eye-needle drive as the reference sees it: three binary legs on a ternary link that is given by its
// sides.

fn third(p: &Position) -> Plane {
    p.polar("l12", "phi") + p.polar("l23", "phi23")
}

/// The unit vector of the angle between the sides 34 and 35.
fn corner(p: &Position) -> Plane {
    let [a, b, c] = ["l34", "l35", "l45"].map(|name| p.value(name));
    let cosine = (a * a + b * b - c * c) / (a * b * 2.0);
    let sine = (Big::one() - &cosine * &cosine).sqrt();
    Plane { x: cosine, y: sine }
}

const EYE_NEEDLE: System = System {
    name: "eye-needle drive, RR-RR-RR",
    data: data! {
        length "l12" 50.0, "l23" 272.5, "l34" 81.0, "l45" 104.5, "l35" 174.0, "l46" 104.5,
            "l57" 261.0, "l78" 136.8;
        degrees "angle_578" -25.0;
        length "p6.x" 195.0, "p6.y" 226.0, "p7.x" 46.0, "p7.y" 533.0;
        degrees "phi" 0.0;
    },
    parameters: 13,
    unknowns: unknowns! {
        angle "phi23" 62.0, "phi34" 146.0, "phi64" 144.0, "phi75" -99.0;
    },
    residual: |p| {
        let fourth = third(p) + p.polar("l34", "phi34") - p.point("p6") - p.polar("l46", "phi64");
        let fifth = third(p) + p.polar("l35", "phi34").turned(&corner(p))
            - p.point("p7")
            - p.polar("l57", "phi75");
        vec![fourth.x, fourth.y, fifth.x, fifth.y]
    },
    further: |p| {
        let needle = p.point("p7") + p.polar("l78", "phi75").turned(&p.direction("angle_578"));
        Output::lengths([needle.x, needle.y])
    },
    pairs: &[(1, 3), (4, 4)],
    ..System::PLAIN
};

// Towards a turning point, where two assemblies meet: accurate as far as data allow, then NaN, never the
// other assembly.

linkage_interpreted::interpreted! {
    struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param l78 = 136.8mm;
        param angle_578 = -25deg;
        param p6 = (195mm, 226mm);
        param p7 = (46mm, 533mm);
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;
        let p3 = polar(l12, phi) + polar(l23, phi23);
        loop p3 + polar(l34, phi34) = p6 + polar(l46, phi64);
        loop p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45)) = p7 + polar(l57, phi75);
        let p8 = p7 + polar(l78, phi75 + angle_578);
    }

    impl EyeNeedle {
        fn values(phi) -> Values { phi23, phi34, phi64, phi75, p8, margin: margin() }
        fn first(phi) -> First {
            phi23: velocity(phi23), phi34: velocity(phi34), phi64: velocity(phi64),
            phi75: velocity(phi75), p8: velocity(p8),
        }
    }
}

/// The largest errors that are accepted: of values and of first derivatives.
const LIMITS_NEAR_A_TURN: [f64; 2] = [10.0, 30.0];
/// Between its turning points at 34.3 and 57.5 degrees this one has a mirror image close by.
const START: f64 = 45.0 / 180.0 * std::f64::consts::PI;
/// Nearer than this to the turning point, in radians, a position may be NaN.
const REACH: f64 = 1e-4;

fn short_lived() -> [EyeNeedleAssembly; 2] {
    let found = EyeNeedle::default()
        .assemblies_at(START)
        .expect("they can be listed");
    let at = |degrees: f64| {
        let near = |assembly: &&EyeNeedleAssembly| {
            let turned = assembly.values(START).phi34 - degrees.to_radians();
            (turned / 2.0).sin().abs() < 0.01
        };
        found
            .iter()
            .find(near)
            .expect("an assembly with that angle")
            .clone()
    };
    [at(44.181), at(59.511)]
}

/// Its turning points, from a solution in 40 digits.
const ENDS: [f64; 2] = [0.597_237_822_533_881, 1.002_585_760_895_766_6];

#[test]
fn towards_turning_points() {
    for linkage in &short_lived() {
        ENDS.iter().for_each(|end| towards(linkage, *end));
    }
}

/// Halves the way to the end again and again.
fn towards(linkage: &EyeNeedleAssembly, end: f64) {
    let values = |phi: f64| {
        let v = linkage.values(phi);
        concatenate(&[&v.phi23, &v.phi34, &v.phi64, &v.phi75, &v.p8])
    };
    let mut phi = START;
    let mut guess = values(START)[..4].to_vec();
    let (mut largest, mut nearest) = ([0.0_f64; 2], f64::INFINITY);
    for _ in 0..35 {
        let mut data = EYE_NEEDLE.default_geometry();
        data.push(phi);
        let mut reference = Reference::new(&EYE_NEEDLE, &data, &guess).expect("a solution near by");
        let (found, slopes, rest) = (values(phi), reference.derivative(&[13]), end - phi);
        if found[0].is_nan() {
            assert!(
                rest.abs() < REACH,
                "NaN at {phi}, {rest:e} from the turning point"
            );
        } else {
            nearest = nearest.min(rest.abs());
            let first = linkage.first(phi);
            let rates = concatenate(&[
                &first.phi23,
                &first.phi34,
                &first.phi64,
                &first.phi75,
                &first.p8,
            ]);
            let uncertain = [&[][..], &[13]].map(|by| reference.joint_uncertainty(by));
            for k in 0..found.len() {
                let errors = [
                    reference.error(k, found[k]),
                    &slopes[k] - &Big::from(rates[k]),
                ];
                for (order, error) in errors.iter().enumerate() {
                    let ratio = (error.abs() / &uncertain[order][k]).to_f64();
                    largest[order] = largest[order].max(ratio);
                }
            }
        }
        // The unknowns change as the root of the rest.
        for (k, guess) in guess.iter_mut().enumerate() {
            let whole = 2.0 * rest * slopes[k].to_f64();
            *guess = reference.value(k) + whole * (1.0 - 0.5_f64.sqrt());
        }
        phi += rest / 2.0;
    }
    println!(
        "to {nearest:.1e} from {end:.6}: value {:.2}, derivative {:.2}",
        largest[0], largest[1]
    );
    assert!(
        largest[0] < LIMITS_NEAR_A_TURN[0] && largest[1] < LIMITS_NEAR_A_TURN[1],
        "{largest:?}"
    );
    for beyond in [1e-6, 1e-4, 1e-2, 0.05] {
        let found = values(end + (end - START).signum() * beyond);
        assert!(
            found.iter().all(|x| x.is_nan()),
            "{beyond} beyond: {found:?}"
        );
    }
}
