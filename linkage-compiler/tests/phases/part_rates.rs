//! Speeds and accelerations of a part's inputs follow from those around it.

use linkage_compiler::check_all;

use super::parts::{checked, defaults, results_of, unit};

const ROTOR: &str = "
    struct Rotor {
        unit mm;
        param long = 40mm;
        param drag = 3N*s;
        input phi = 10deg at omega, epsilon;
        let tip = polar(long, phi);
        let speed = omega;
        let gain = epsilon;
        body arm = pin hub on frame at (0, 0), turns phi, mass 2kg at tip;
        force (drag * omega, 0) on arm at tip;
    }
    impl Rotor {
        fn torque(phi, omega, epsilon) -> RotorTorque { t: torque(phi) }
    }
    struct Pair {
        unit mm;
        input turn = 0deg at rate, growth;
        part inner: Rotor { phi = turn / 2 };
    }
    struct Whole {
        unit mm;
        param lead = 30deg;
        param ratio = 1.5;
        input shaft = 30deg at w, e;
        input other = 10deg at v, g;
        let sum = shaft + lead;
        let square = sqrt(ratio) * (-(shaft - other / 3)) * shaft;
        part straight: Rotor { phi = shaft };
        part ahead: Rotor { phi = sum };
        part still: Rotor { phi = lead * sqrt(ratio) };
        part geared: Rotor { phi = -ratio * sum };
        part product: Rotor { phi = square };
        part quotient: Rotor { phi = lead / (5 + shaft) };
        part given: Rotor { phi = shaft, omega = 7rad/s, epsilon = 8rad/s^2 };
        part pair: Pair { turn = 3 * shaft - 2 * other };
        part held: Pair { turn = shaft, rate = 4rad/s, growth = 6rad/s^2 };
    }
    impl Whole {
        fn rates(shaft, other, w, e, v, g) -> WholeRates {
            a: straight.speed, b: straight.gain, c: ahead.speed, d: ahead.gain, f: still.speed, h: still.gain,
            i: geared.speed, j: geared.gain, k: product.speed, l: product.gain, m: quotient.speed, n: quotient.gain,
            o: given.speed, p: given.gain, q: pair.inner.speed, r: pair.inner.gain, s: held.inner.speed, t: held.inner.gain,
        }
    }
    struct Geared {
        unit mm;
        input shaft = 30deg at w, e;
        part rotor: Rotor { phi = 2 * shaft + 15deg };
    }
    impl Geared {
        fn torque(shaft, w, e) -> GearedTorque { t: torque(shaft) }
    }";

/// Sums, products, quotients and parts of parts, differentiated by hand.
#[test]
fn speeds_follow_by_the_chain_rule() {
    let all = checked(ROTOR);
    let whole = unit(&all, "Whole");
    let ([s, o], rates) = ([0.7, -0.4], [1.3, -0.6, 0.9, 2.1]);
    let [w, e, v, g] = rates;
    let (lead, ratio, root) = (30f64.to_radians(), 1.5, 1.5f64.sqrt());
    // -root (s - o / 3) s = root (o s / 3 - s^2)
    let product = root * ((v * s + o * w) / 3.0 - 2.0 * s * w);
    let product_gain = root * ((g * s + 2.0 * v * w + o * e) / 3.0 - 2.0 * w * w - 2.0 * s * e);
    let below: f64 = 5.0 + s;
    let expected = [
        [w, e],
        [w, e],
        [0.0, 0.0],
        [-ratio * w, -ratio * e],
        [product, product_gain],
        [
            -lead * w / below.powi(2),
            lead * (2.0 * w * w / below.powi(3) - e / below.powi(2)),
        ],
        [7.0, 8.0],
        [1.5 * w - v, 1.5 * e - g],
        [2.0, 3.0],
    ];
    let found = results_of(whole, "rates", &defaults(whole), &[s, o], &rates);
    for (place, (found, expected)) in found.iter().zip(expected.as_flattened()).enumerate() {
        let error = (found - expected).abs();
        assert!(
            error <= 1e-14 * expected.abs(),
            "{place}: {found} and {expected}"
        );
    }
}

/// Laws, splines and functions of numbers, against what functions of the machine are told of the same inputs.
#[test]
fn speeds_follow_through_laws_and_functions() {
    let given = [
        "piecewise(shaft, [(0deg, 0deg), (120deg, lead, modified_sine), (150deg, lead), (360deg, 0deg, poly345)])",
        "piecewise(2 * shaft + other, [(0deg, 0deg), (100deg, 2 * lead, cycloidal), (360deg, 0deg, modified_trapezoid)])",
        "spline(shaft, [(0deg, 0deg), (90deg, lead), (200deg, 80deg), (360deg, 0deg)])",
        "shaft + spline(shaft, [(0deg, 0deg), (90deg, lead), (200deg, 80deg), (360deg, 0deg)], quintic)",
        "rise(shaft * other / 4, harmonic)",
        "slope(spline(shaft, [(0deg, 0deg), (90deg, lead), (200deg, 80deg), (360deg, 0deg)], quintic))",
        "lead * sin(3 * shaft - other)",
        "cos(shaft) * tan(other / 3)",
        "asin(shaft / 4) - acos(other / 5)",
        "atan(shaft * other) + atan2(shaft, other + 3)",
        "sqrt(2 + shaft) * hypot(shaft, other)",
        "abs(shaft - 4) / ratio",
    ];
    let mut text = ROTOR[..ROTOR.find("struct Pair").expect("it is there")].to_owned();
    text += "struct Whole { unit mm; param lead = 40deg; param ratio = 1.5;
        input shaft = 30deg at w, e; input other = 50deg at v, g;";
    let mut asked = String::new();
    let mut known = String::new();
    for (k, given) in given.iter().enumerate() {
        text += &format!("let q{k} = {given}; part p{k}: Rotor {{ phi = q{k} }};");
        asked += &format!("a{k}: p{k}.speed, b{k}: p{k}.gain,");
        known += &format!("a{k}: velocity(q{k}), b{k}: acceleration(q{k}),");
    }
    text += &format!(
        "}} impl Whole {{ fn rates(shaft, other, w, e, v, g) -> R {{ {asked} }} fn known(shaft, other) -> K {{ {known} }} }}"
    );
    let all = checked(&text);
    let whole = unit(&all, "Whole");
    let rates = [1.3, -0.6, 0.9, 2.1];
    let [w, e, v, g] = rates;
    for step in 0..12 {
        let places = [0.07 + 0.31 * f64::from(step), 1.9 - 0.17 * f64::from(step)];
        let found = results_of(whole, "rates", &defaults(whole), &places, &rates);
        let known = results_of(whole, "known", &defaults(whole), &places, &[]);
        // Of each: by both inputs, then the matrix of second derivatives.
        for (k, (found, known)) in found.chunks(2).zip(known.chunks(6)).enumerate() {
            let speed = known[0] * w + known[1] * v;
            let squares = known[2] * w * w + (known[3] + known[4]) * w * v + known[5] * v * v;
            let gain = squares + known[0] * e + known[1] * g;
            for (found, expected) in found.iter().zip([speed, gain]) {
                assert!(
                    (found - expected).abs() < 1e-12 * expected.abs().max(1.0),
                    "{} at {places:?}: {found} and {expected}",
                    given[k]
                );
            }
        }
    }
}

/// An arm that a law moves, with mass and drag: the power of the shaft is what the arm takes alone.
#[test]
fn a_law_drives_masses() {
    let law = "piecewise(shaft, [(0deg, 10deg), (120deg, 60deg, modified_sine), (150deg, 60deg), (360deg, 10deg, poly4567)])";
    let mut text = ROTOR[..ROTOR.find("struct Pair").expect("it is there")].to_owned();
    text += &format!(
        "struct Servo {{ unit mm; input shaft = 30deg at w, e; part arm: Rotor {{ phi = {law} }}; }}
         impl Servo {{ fn torque(shaft, w, e) -> ServoTorque {{ t: torque(shaft) }}
            fn law(shaft) -> ServoLaw {{ s: arm.phi, v: velocity(arm.phi), a: acceleration(arm.phi) }} }}"
    );
    let all = checked(&text);
    let (rotor, servo) = (unit(&all, "Rotor"), unit(&all, "Servo"));
    let (w, e) = (3.0, 1.4);
    let mut largest: f64 = 0.0;
    for step in 0..40 {
        let shaft = 0.05 + 0.155 * f64::from(step);
        let law = results_of(servo, "law", &defaults(servo), &[shaft], &[]);
        let [s, v, a] = law[..] else {
            panic!("{law:?}")
        };
        let here = results_of(servo, "torque", &defaults(servo), &[shaft], &[w, e])[0];
        let speeds = [v * w, a * w * w + v * e];
        let alone = results_of(rotor, "torque", &defaults(rotor), &[s], &speeds)[0];
        largest = largest.max(here.abs());
        assert!(
            (here - alone * v).abs() < 1e-12 * largest,
            "{shaft}: {here} {}",
            alone * v
        );
    }
    assert!(largest > 1.0);
}

/// A drag within the part is the power that the shaft gives it.
#[test]
fn a_geared_part_takes_the_power_that_it_takes_alone() {
    let all = checked(ROTOR);
    let (rotor, geared) = (unit(&all, "Rotor"), unit(&all, "Geared"));
    let (s, w, e) = (0.7, 1.3, -0.6);
    let phi = 2.0 * s + 15f64.to_radians();
    let alone = results_of(
        rotor,
        "torque",
        &defaults(rotor),
        &[phi],
        &[2.0 * w, 2.0 * e],
    );
    let here = results_of(geared, "torque", &defaults(geared), &[s], &[w, e]);
    assert!(
        (here[0] - 2.0 * alone[0]).abs() < 1e-12 * here[0].abs(),
        "{here:?} {alone:?}"
    );
}

/// Where a speed does not follow, and something is written with it, the message names it and says why.
#[test]
fn a_speed_that_does_not_follow_is_named() {
    let text = ROTOR.replace(
        "let sum =",
        "input deaf = 0deg; input slow = 0deg at u;
        part sine: Rotor { phi = max(shaft, 20deg) };
        part silent: Rotor { phi = shaft + deaf };
        part half: Rotor { phi = 2 * slow };
        part told: Rotor { phi = deaf, omega = w, epsilon = e };
        let sum =",
    );
    let all = check_all(text.parse().expect("tokens"));
    let messages = all.iter().flat_map(|own| &own.messages);
    let texts: Vec<&str> = messages.map(|own| own.text.as_str()).collect();
    let expected = [
        (
            "omega",
            "sine",
            "quotients, laws, splines and functions of numbers like `sin`, which is a limit of linkage",
        ),
        (
            "epsilon",
            "sine",
            "quotients, laws, splines and functions of numbers like `sin`, which is a limit of linkage",
        ),
        (
            "omega",
            "silent",
            "or give `deaf` one: `input deaf = ... at speed, acceleration`",
        ),
        (
            "epsilon",
            "silent",
            "or give `deaf` one: `input deaf = ... at speed, acceleration`",
        ),
        (
            "epsilon",
            "half",
            "or give `slow` one: `input slow = ... at speed, acceleration`",
        ),
    ];
    assert_eq!(texts.len(), expected.len(), "{texts:#?}");
    for (text, (name, part, why)) in texts.iter().zip(expected) {
        let fact = format!("the argument `{name}` of `Rotor` is left open in the part `{part}`");
        assert!(text.starts_with(&fact) && text.contains(why), "{text}");
    }
}
