//! Several organs on one shaft: cyclograms, clearances and phases against references of 40 digits; parts that turn with a body.

mod clearance;
mod cyclogram;
mod phases;
mod turning;
mod waves;

use linkage::Parameter;
use linkage_interpreted::interpreted;
use serde_json::Value;

type Outcome = Result<(), Box<dyn std::error::Error>>;

// Published numbers, computed with 60 digits.

pub(crate) fn cyclogram() -> Value {
    read(include_str!("cyclogram.json"))
}

pub(crate) fn mutual() -> Value {
    read(include_str!("mutual.json"))
}

fn read(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

/// A number, which is written as a string of digits unless it is a whole one.
pub(crate) fn number(value: &Value) -> f64 {
    if let Some(whole) = value.as_i64() {
        return whole as f64;
    }
    value
        .as_str()
        .and_then(|digits| digits.parse().ok())
        .unwrap_or_else(|| panic!("a number: {value}"))
}

/// The number in radians.
pub(crate) fn radians(value: &Value) -> f64 {
    number(value).to_radians()
}

/// The derivatives by the parameters, in their order. `member` stands before the names of the reference: `hook` and
/// `P1x` are `hook_p1.x`. 0 for a parameter of another organ.
pub(crate) fn derivatives(value: &Value, member: &str, parameters: &[Parameter]) -> Vec<f64> {
    let plain = |name: &str| name.replace(['.', '_'], "").to_lowercase();
    let known = value.as_object().expect("an object");
    let mut used = 0;
    let of = |parameter: &Parameter| {
        let mut own = known
            .iter()
            .filter(|(name, _)| plain(&format!("{member}{name}")) == plain(parameter.name));
        own.next().map_or(0.0, |(_, value)| {
            used += 1;
            number(value)
        })
    };
    let found = parameters.iter().map(of).collect();
    // Lengths and angles that only the reference has do nothing.
    let idle = known
        .iter()
        .filter(|(_, value)| number(value) == 0.0)
        .count();
    assert!(
        used + idle >= known.len(),
        "{used} of {} {member}",
        known.len()
    );
    found
}

// The drives of a warp-knitting machine on one shaft.

interpreted! {
    /// Hook needle and eye needle on one main shaft, which turns once in a cycle; the eye needle's frame is placed
    /// beside the hook needle's.
    pub struct TwoNeedles {
        unit mm;
        param hook_p1 = (0mm, 0mm) +- 20um;
        param hook_p4 = (5mm, 150mm) +- 20um;
        param hook_p7 = (112.5mm, 3.5mm) +- 20um;
        param hook_l12 = 5mm +- 8um;
        param hook_l23 = 46.5mm +- 15um;
        param hook_l34 = 123mm +- 20um;
        param hook_l45 = 13.5mm +- 10um;
        param hook_l78 = 10mm +- 10um;
        param hook_l89 = 160mm +- 20um;
        param hook_l910 = 122.5mm +- 20um;
        param hook_u345 = -62.5deg +- 30arcsec;
        param hook_u456 = 90deg +- 30arcsec;
        param hook_phi01 = -90deg +- 30arcsec;
        param hook_phi04 = 60deg +- 30arcsec;

        param eye_l12 = 50mm +- 12um;
        param eye_l23 = 272.5mm +- 26um;
        param eye_l34 = 81mm +- 17um;
        param eye_l45 = 104.5mm +- 17um;
        param eye_l35 = 174mm +- 20um;
        param eye_l46 = 104.5mm +- 17um;
        param eye_l57 = 261mm +- 26um;
        param eye_l78 = 136.8mm +- 20um;
        param eye_u578 = -25deg +- 30arcsec;
        param eye_x6 = 195mm +- 23um;
        param eye_y6 = 226mm +- 23um;
        param eye_x7 = 46mm +- 12um;
        param eye_y7 = 533mm +- 35um;

        param lead = 10deg +- 5arcmin;
        param dx = -68mm +- 50um;
        param dy = 649.5mm +- 50um;
        param ang = 175deg +- 1arcmin;

        input theta = 0deg in 0deg..360deg;

        let phi12 = hook_phi01 - 2 * theta;
        let phi78 = hook_phi04 + theta;
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let h2 = hook_p1 + polar(hook_l12, phi12);
        let h3 = h2 + polar(hook_l23, phi23);
        loop h3 = hook_p4 + polar(hook_l34, phi43);
        let phi56 = phi43 + hook_u345 + hook_u456;
        let h5 = hook_p4 + polar(hook_l45, phi43 + hook_u345);
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let h9 = hook_p7 + polar(hook_l78, phi78) + polar(hook_l89, phi89);
        loop h9 = h5 + polar(slide, phi56);
        let bar = phi56 + 180deg;
        let hook = h9 + polar(hook_l910, bar);

        unknown eye23 = 54deg;
        unknown eye34 = 146deg;
        unknown eye64 = 144deg;
        unknown eye75 = -99deg;
        let e2 = polar(eye_l12, theta + lead);
        let e3 = e2 + polar(eye_l23, eye23);
        let e4 = e3 + polar(eye_l34, eye34);
        let e5 = e3 + polar(eye_l35, eye34 + triangle_angle(eye_l34, eye_l35, eye_l45));
        let e7 = (eye_x7, eye_y7);
        loop e4 = (eye_x6, eye_y6) + polar(eye_l46, eye64);
        loop e5 = e7 + polar(eye_l57, eye75);
        let e8 = e7 + polar(eye_l78, eye75 + eye_u578);
        let eye = (dx, dy) + rotate(e8, ang);

        // The eye needle's point as the hook needle's bar sees it: the difference, turned back.
        let seen = rotate(eye - hook, -bar);
    }

    impl TwoNeedles {
        /// Both points with their derivatives.
        pub fn tips(theta) -> Tips {
            hook, hook_v: velocity(hook), hook_a: acceleration(hook),
            eye, eye_v: velocity(eye), eye_a: acceleration(eye),
        }
        /// What all dimensions do to them.
        pub fn accuracy(theta) -> Accuracy { hook: sensitivity(hook), eye: sensitivity(eye) }
        /// And to their velocities.
        pub fn rates(theta) -> Rates { hook: sensitivity(velocity(hook)), eye: sensitivity(velocity(eye)) }
        /// The hook needle alone.
        pub fn hook(theta) -> Hook { p: hook, v: velocity(hook), a: acceleration(hook) }
        /// The eye needle alone.
        pub fn eye(theta) -> Eye { p: eye, v: velocity(eye), a: acceleration(eye) }
        /// The hook needle's height.
        pub fn height(theta) -> Height { y: hook.y, v: velocity(hook.y), a: acceleration(hook.y) }
        pub fn height_accuracy(theta) -> HeightAccuracy { e: sensitivity(hook.y) }
        pub fn height_rate(theta) -> HeightRate { e: sensitivity(velocity(hook.y)) }
        /// The way of the eye needle on its circle.
        pub fn arc(theta) -> Arc {
            s: eye_l78 * eye75, v: velocity(eye_l78 * eye75), a: acceleration(eye_l78 * eye75),
        }
        pub fn arc_accuracy(theta) -> ArcAccuracy { e: sensitivity(eye_l78 * eye75) }
        pub fn arc_rate(theta) -> ArcRate { e: sensitivity(velocity(eye_l78 * eye75)) }
        /// The eye needle's point in the frame of the hook needle's bar.
        pub fn seen(theta) -> Seen { seen, v: velocity(seen), bar }
    }
}

interpreted! {
    /// The straight-line drive with two cranks.
    pub struct TwoCranks {
        unit mm;
        param triad_l12 = 13mm +- 10um;
        param triad_l67 = 11mm +- 10um;
        param triad_p7 = (82mm, 22mm) +- 15um;
        param triad_l23 = 68mm +- 15um;
        param triad_l64 = 85mm +- 15um;
        param triad_l34 = 66mm +- 15um;
        param triad_l35 = 40mm +- 15um;
        param triad_u435 = -65deg +- 30arcsec;
        param triad_n1 = (28mm, 0mm) +- 15um;
        param triad_alpha = 90deg +- 30arcsec;
        param triad_m10 = 0deg +- 1arcmin;
        param triad_m20 = 0deg +- 1arcmin;

        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 105deg;
        unknown phi34 = 29deg;
        unknown phi64 = 118deg;
        unknown s = 42mm;
        let p3 = polar(triad_l12, triad_m10 - phi) + polar(triad_l23, phi23);
        let p4 = p3 + polar(triad_l34, phi34);
        loop p4 = triad_p7 + polar(triad_l67, triad_m20 + phi) + polar(triad_l64, phi64);
        loop p3 + polar(triad_l35, phi34 + triad_u435) = triad_n1 + polar(s, triad_alpha);
    }
    impl TwoCranks {
        pub fn slide(phi) -> Slide { s, v: velocity(s), a: acceleration(s) }
        pub fn slide_accuracy(phi) -> SlideAccuracy { e: sensitivity(s) }
        pub fn slide_rate(phi) -> SlideRate { e: sensitivity(velocity(s)) }
    }
}
