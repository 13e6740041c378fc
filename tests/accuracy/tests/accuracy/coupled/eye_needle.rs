//! The eye-needle drive in two written forms.

use crate::coupled::drive::EYE_NEEDLE;
use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{Depth, Form, compare, forms};

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
