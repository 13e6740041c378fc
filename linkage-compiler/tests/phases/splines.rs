//! Splines and slopes of courses: continuous as they say, ends, points by parameters, words.

use linkage_compiler::check_all;

use super::parts::{checked, defaults, results, unit};

const WAYS: &str = "
    struct Ways {
        unit mm;
        param mid = 3mm;
        param at = 80deg;
        input phi = 30deg in 0deg..360deg;
        let bent = spline(phi, [(30deg, 2mm), (at, mid), (180deg, 5mm), (250deg, 1mm)], clamped, quintic);
        let free = spline(phi, [(30deg, 2mm), (at, mid), (180deg, 5mm), (250deg, 1mm)], quintic);
        let led = spline(phi, [(30deg, 2mm, mid), (at, mid, 0mm), (180deg, 5mm, -1mm)]);
        let circle = spline(phi, [(0deg, 2mm), (at, mid), (180deg, 5mm), (360deg, 2mm)], quintic);
        let law = piecewise(phi, [(0deg, 0mm), (at, mid, modified_sine), (180deg, mid), (360deg, 0mm, poly4567)]);
        let cubic = spline(phi, [(0deg, 2mm), (at, mid), (180deg, 5mm), (360deg, 2mm)]);
        let half = rise((phi - 30deg) / 90deg, cycloidal);
    }
    impl Ways {
        fn bent(phi) -> Bent { a: bent, b: velocity(bent), c: acceleration(bent), d: jerk(bent), e: velocity(jerk(bent)) }
        fn free(phi) -> Free { a: free, b: velocity(free), c: acceleration(free), d: jerk(free), e: velocity(jerk(free)) }
        fn led(phi) -> Led { a: led, b: velocity(led), c: acceleration(led), d: jerk(led), e: velocity(jerk(led)) }
        fn circle(phi) -> Circle { a: circle, b: velocity(circle), c: acceleration(circle), d: jerk(circle), e: velocity(jerk(circle)) }
        fn slopes(phi) -> Slopes {
            a: slope(law), b: slope(slope(law)), c: slope(cubic), d: slope(slope(slope(circle))), e: slope(half), f: velocity(slope(law)),
            g: slope(spline(2 * phi, [(0deg, 2mm), (at, mid), (180deg, 5mm), (720deg, 7mm)])),
        }
        fn rates(phi) -> Rates {
            a: velocity(law), b: acceleration(law), c: velocity(cubic), d: jerk(circle), e: 90deg * velocity(half), f: acceleration(law),
            g: velocity(spline(2 * phi, [(0deg, 2mm), (at, mid), (180deg, 5mm), (720deg, 7mm)])) / 2,
        }
    }";

/// So many derivatives are the same on both sides of each point, and the next one is not.
#[test]
fn quintic_splines_are_as_smooth_as_they_say() {
    let all = checked(WAYS);
    let ways = unit(&all, "Ways");
    let inner = [80.0, 180.0];
    let ends = [30.0, 250.0];
    let all_around = [0.0, 80.0, 180.0, 360.0];
    for (name, places, continuous) in [
        ("bent", &inner[..], 4),
        // Beyond its ends it rests: with it speed and acceleration.
        ("bent", &ends[..], 2),
        ("free", &inner[..], 4),
        ("free", &ends[..], 4),
        ("led", &inner[..1], 3),
        // Straight on.
        ("led", &[30.0, 180.0][..], 2),
        ("circle", &all_around[..], 4),
    ] {
        for place in places {
            let side =
                |by: f64| results(ways, name, &defaults(ways), &[f64::to_radians(place + by)]);
            let (before, behind) = (side(-1e-9), side(1e-9));
            for order in 0..5 {
                let jump = (behind[order] - before[order]).abs();
                let is_small = jump < 1e-8 * behind[order].abs().max(10.0);
                assert_eq!(
                    is_small,
                    order <= continuous,
                    "{name} at {place}, derivative {order}: {before:?} {behind:?}"
                );
                if order == continuous {
                    break;
                }
            }
        }
    }
    let far =
        |name: &str, degrees: f64| results(ways, name, &defaults(ways), &[degrees.to_radians()]);
    assert_eq!(far("bent", 300.0)[..4], [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(far("led", 0.0)[1..4], [3.0, 0.0, 0.0]);
    let [near, further] = [260.0, 300.0].map(|at| far("free", at));
    assert!((near[2] - further[2]).abs() < 1e-12 && near[2] != 0.0 && further[3] == 0.0);
    for (name, at, value) in [
        ("bent", 80.0, 3.0),
        ("free", 180.0, 5.0),
        ("led", 80.0, 3.0),
        ("circle", 180.0, 5.0),
    ] {
        let found = far(name, at)[0];
        assert!((found - value).abs() < 1e-14, "{name}: {found}");
    }
}

/// Slopes are derivatives by what the course is given along, to the rounding.
#[test]
fn slopes_are_derivatives() {
    let all = checked(WAYS);
    let ways = unit(&all, "Ways");
    for step in 0..40 {
        let phi = [0.011 + 0.157 * f64::from(step)];
        let [slopes, rates] =
            ["slopes", "rates"].map(|name| results(ways, name, &defaults(ways), &phi));
        for (k, (slope, rate)) in slopes.iter().zip(&rates).enumerate() {
            assert!(
                (slope - rate).abs() < 1e-13 * rate.abs().max(5.0),
                "{k} at {phi:?}: {slope} {rate}"
            );
        }
    }
}

/// A roller on a measured radius, here that of a circle beside the shaft: the centre of the roller is found by the slope of the profile, and is
/// where it is on a circle. The place of contact drives, the angle of the cam and the lift follow.
#[test]
fn a_measured_profile_moves_a_roller() {
    let (circle, beside, roller, offset) = (30.0_f64, 4.0_f64, 8.0_f64, 5.0_f64);
    let measured = |degrees: i32| {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        beside * cos + (circle * circle - (beside * sin).powi(2)).sqrt()
    };
    let points: String = (0..=24)
        .map(|k| format!("({}deg, {:.12}mm), ", 15 * k, measured(15 * k)))
        .collect();
    let text = format!(
        "struct Cam {{
            unit mm;
            param roller = {roller}mm;
            param offset = {offset}mm;
            input contact = 20deg in 0deg..360deg;
            unknown phi = 70deg;
            unknown lift = 40mm;
            let r = spline(contact, [{points}], quintic);
            let normal = rotate((r, -slope(r)), contact);
            let centre = polar(r, contact) + roller * unit(normal);
            loop rotate(centre, phi) = (offset, lift);
        }}
        impl Cam {{ fn lift(contact) -> Lift {{ centre, lift, phi, v: velocity(lift), w: velocity(phi) }} }}"
    );
    let all = checked(&text);
    let cam = unit(&all, "Cam");
    for step in 0..50 {
        let contact = 0.13 * f64::from(step);
        let found = results(cam, "lift", &defaults(cam), &[contact]);
        let [x, y, lift, phi, v, w] = found[..] else {
            panic!("{found:?}")
        };
        let radius = (x - beside).hypot(y);
        assert!(
            (radius - circle - roller).abs() < 1e-6,
            "{radius} at {contact}"
        );
        // Seen from the circle the roller goes around on a larger one: its centre is `phi` behind the follower's line.
        let (sin, cos) = phi.sin_cos();
        let expected =
            beside * sin + ((circle + roller).powi(2) - (offset - beside * cos).powi(2)).sqrt();
        assert!((lift - expected).abs() < 1e-6, "{lift} {expected}");
        let root = expected - beside * sin;
        let slope = beside * cos - (offset - beside * cos) * beside * sin / root;
        assert!((v / w - slope).abs() < 1e-4, "{} {slope}", v / w);
    }
}

#[test]
fn what_is_no_spline_is_told() {
    for (written, expected) in [
        (
            "spline(phi, [(0deg, 0mm, 1mm), (9deg, 2mm)])",
            "1 of 2 points of this spline have a slope, this one has none",
        ),
        (
            "spline(phi, [(0deg, 0mm, 1mm), (9deg, 2mm, 1mm)], clamped)",
            "`clamped` would give others",
        ),
        (
            "spline(phi, [(0deg, 0mm, 3deg), (9deg, 2mm, 1mm)])",
            "the slope at a point of this spline is a length, found an angle",
        ),
        (
            "spline(phi, [(0deg, 0mm), (9deg, 2mm)], quintic)",
            "at least three points, found 2",
        ),
        (
            "spline(phi, [(0deg, 0mm), (9deg, 2mm), (20deg, 0mm)], quintic, quintic)",
            "one word for its ends and one for its degree",
        ),
        (
            "spline(phi, [(0deg, 0mm), (9deg, 2mm, jump), (20deg, 0mm)], clamped)",
            "neither speed nor acceleration of a spline jumps here",
        ),
        (
            "spline(phi, [(0deg, 0mm), (9deg, 2mm, line), (20deg, 0mm)])",
            "a place, a value and perhaps a slope, found a law",
        ),
        (
            "slope(2 * phi)",
            "`slope` is taken of a course, found another expression",
        ),
        (
            "slope(rise(phi / 1deg, line), 3)",
            "`slope` is written with a course, found 2 arguments",
        ),
        (
            "slope(slope(slope(slope(rise(phi / 1deg, line)))))",
            "the slope of a course is taken 3 times at most",
        ),
    ] {
        let text = format!(
            "struct M {{ unit mm; input phi = 0deg; let s = {written}; }} impl M {{ fn f(phi) -> F {{ s }} }}"
        );
        let all = check_all(text.parse().expect("tokens"));
        let messages: Vec<&str> = all
            .iter()
            .flat_map(|own| &own.messages)
            .map(|own| own.text.as_str())
            .collect();
        assert!(
            messages.len() == 1 && messages[0].contains(expected),
            "{written}: {messages:#?}"
        );
    }
}

/// The acceleration of a clamped cubic spline jumps where it ends, unless the range does or the words accept it.
#[test]
fn ends_of_clamped_splines_are_told() {
    let warnings = |written: &str| {
        let text = format!(
            "struct M {{ unit mm; input phi = 10deg in 10deg..200deg; let s = spline(phi, {written}); }} impl M {{ fn f(phi) -> F {{ s }} }}"
        );
        let all = check_all(text.parse().expect("tokens"));
        let found = all
            .iter()
            .flat_map(|own| own.messages.iter().chain(&own.warnings));
        found.map(|own| own.text.clone()).collect::<Vec<_>>()
    };
    // By symmetry there is no curvature in the middle: 2 h c = 6 D with D = 2mm / h and h = pi / 2, so c = 6 * 2mm / (2 h^2).
    let found = warnings("[(20deg, 0mm), (110deg, 2mm), (200deg, 4mm)], clamped");
    assert_eq!(found.len(), 1, "{found:#?}");
    assert!(
        found[0]
            .starts_with("the acceleration of this course jumps at 20deg, from 0mm/rad^2 to 2.431")
            && found[0].contains("write `clamped, quintic` behind the points"),
        "{found:#?}"
    );
    for silent in [
        "[(10deg, 0mm), (110deg, 2mm), (200deg, 4mm)], clamped",
        "[(20deg, 0mm, jump), (110deg, 2mm), (190deg, 4mm, jump)], clamped",
        "[(20deg, 0mm), (110deg, 2mm), (190deg, 4mm)], clamped, quintic",
        "[(20deg, 0mm), (110deg, 2mm), (190deg, 4mm)]",
    ] {
        assert!(warnings(silent).is_empty(), "{silent}");
    }
    let both = warnings("[(20deg, 0mm), (110deg, 2mm), (190deg, 4mm)], clamped");
    assert_eq!(both.len(), 2, "{both:#?}");
}
