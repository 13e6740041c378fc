//! What comes along with a part: turns of its angles, laws of motion.

use super::{checked, defaults, results, unit};

/// A part's angles count the turns that they would alone, on the way from its own reference to where the machine has it.
#[test]
fn angles_of_parts_count_the_turns_from_their_own_reference() {
    let estimates = |shaft: &str| {
        let text = format!(
            "struct Drag {{
                unit mm;
                param base = 20mm; param crank = 60mm; param coupler = 50mm; param driven = 55mm;
                input phi = 10deg in 0deg..360deg;
                unknown theta = 100deg; unknown psi = 60deg;
                loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(driven, psi);
            }}
            struct Machine {{
                unit cm;
                input shaft = {shaft};
                part first: Drag {{ phi = shaft }};
                part second: Drag {{ phi = first.psi, crank = 61mm }};
            }}
            impl Machine {{ fn angle(shaft) -> Angle {{ first: first.psi, second: second.psi }} }}"
        );
        let all = checked(&text);
        let angles = unit(&all, "Machine").angles.iter();
        angles.map(|own| own.estimate).collect::<Vec<f64>>()
    };
    let (near, far) = (estimates("15deg"), estimates("-705deg"));
    assert_eq!(near.len(), 2);
    for (near, far) in near.into_iter().zip(far) {
        assert!(
            (near - far - 2.0 * std::f64::consts::TAU).abs() < 1e-9,
            "{near} and {far}"
        );
    }
}

/// A law of motion within a part, whose knots are the part's dimensions, and one as the input of a part.
#[test]
fn laws_of_motion_come_along_and_drive_parts() {
    let text = "
        struct Press {
            unit mm;
            param lift = 20mm;
            param crank = 30mm;
            input phi = 10deg in 0deg..360deg;
            let rise = piecewise(phi, [(0deg, 0mm), (120deg, lift, modified_sine), (200deg, lift), (360deg, 0mm, poly345)]);
            let tip = polar(crank, phi) + (0, rise);
        }
        impl Press { fn tip(phi) -> Tip { tip, v: velocity(tip), a: acceleration(tip), e: sensitivity(tip) } }
        struct Machine {
            unit mm;
            input shaft = 10deg in 0deg..360deg;
            part press: Press { phi = shaft };
            part servo: Press { phi = piecewise(shaft, [(0deg, 0deg), (180deg, 90deg, cycloidal), (360deg, 0deg, cycloidal)]) };
        }
        impl Machine {
            fn tip(shaft) -> PressTip {
                tip: press.tip, v: velocity(press.tip), a: acceleration(press.tip), e: sensitivity(press.tip, [press.lift, press.crank])
            }
            fn servo(shaft) -> Servo { phi: servo.phi, tip: servo.tip, v: velocity(servo.tip) }
        }";
    let all = checked(text);
    let [press, machine] = ["Press", "Machine"].map(|name| unit(&all, name));
    let quarter = std::f64::consts::FRAC_PI_2;
    for step in 0..72 {
        let shaft = [f64::from(step) * 0.0873];
        let alone = results(press, "tip", &defaults(press), &shaft);
        assert_eq!(
            alone,
            results(machine, "tip", &defaults(machine), &shaft),
            "{shaft:?}"
        );
        // The cycloidal law forth and back within a turn.
        let x = (shaft[0] / (2.0 * quarter)) % 2.0;
        let rise = |x: f64| x - (4.0 * quarter * x).sin() / (4.0 * quarter);
        let phi = quarter
            * if x < 1.0 {
                rise(x)
            } else {
                1.0 - rise(x - 1.0)
            };
        let servo = results(machine, "servo", &defaults(machine), &shaft);
        assert!((servo[0] - phi).abs() < 1e-14, "{servo:?}, {phi}");
        let there = results(press, "tip", &defaults(press), &[servo[0]]);
        for axis in 0..2 {
            assert!((servo[1 + axis] - there[axis]).abs() < 1e-12 * 50.0);
        }
    }
}
