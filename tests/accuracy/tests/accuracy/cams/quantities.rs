//! Cams as quantities of the language: against 25 digits, and with derivatives and sensitivities.

use crate::cams::{cam, references};

linkage_interpreted::interpreted! {
    /// The cam of a roller on a guide.
    struct RollerCam {
        unit mm;
        param lift = 18mm;
        param base = 40mm;
        param offset = 7mm;
        param roller = 9mm;
        param rise = 150deg;
        input theta = 60deg in 0deg..360deg;
        let s = piecewise(theta, [
            (0deg, 0mm), (40deg, 0mm), (rise, lift, modified_sine), (190deg, lift), (310deg, 0mm, poly345),
            (360deg, 0mm),
        ]);
        let height = sqrt(base * base - offset * offset) + s;
        let pitch = rotate((offset, height), -theta);
    }

    impl RollerCam {
        fn cam(theta) -> PlateContact {
            pitch,
            profile: pitch - roller / norm(velocity(pitch)) * (-velocity(pitch).y, velocity(pitch).x),
            pressure: atan2(velocity(s) - offset, height),
            curvature: -cross(velocity(pitch), acceleration(pitch))
                / (norm(velocity(pitch)) * dot(velocity(pitch), velocity(pitch))),
            sliding: norm(velocity(pitch)) - roller,
        }
        fn accuracy(theta) -> Accuracy {
            slope: velocity(atan2(velocity(s) - offset, height)),
            pressure: sensitivity(atan2(velocity(s) - offset, height), [base, offset, rise]),
            curvature: sensitivity(
                cross(velocity(pitch), acceleration(pitch))
                    / (norm(velocity(pitch)) * dot(velocity(pitch), velocity(pitch))),
                [lift],
            ),
        }
    }

    /// That of a roller on an arm.
    struct SwingingCam {
        unit mm;
        param swing = 24deg;
        param base = 42mm;
        param pivot = 95mm;
        param arm = 80mm;
        param roller = 10mm;
        input theta = 60deg in 0deg..360deg;
        let way = piecewise(theta, [
            (0deg, 0deg), (40deg, 0deg), (150deg, swing, modified_sine), (190deg, swing), (310deg, 0deg, poly345),
            (360deg, 0deg),
        ]);
        let psi = acos((pivot * pivot + arm * arm - base * base) / (2 * pivot * arm)) + way;
        let pitch = rotate((pivot, 0) + polar(arm, 180deg - psi), -theta);
    }

    impl SwingingCam {
        fn cam(theta) -> SwingingContact {
            psi, first: velocity(psi), second: acceleration(psi),
            pitch,
            profile: pitch - roller / norm(velocity(pitch)) * (-velocity(pitch).y, velocity(pitch).x),
            pressure: atan2(arm * (1 + velocity(psi)) - pivot * cos(psi), pivot * sin(psi)),
            curvature: -cross(velocity(pitch), acceleration(pitch))
                / (norm(velocity(pitch)) * dot(velocity(pitch), velocity(pitch))),
            sliding: norm(velocity(pitch)) - roller * (1 + velocity(psi)),
        }
    }

    /// That of a flat face.
    struct FlatCam {
        unit mm;
        param lift = 15mm;
        param base = 38mm;
        param rise = 150deg;
        param back = 310deg;
        input theta = 60deg in 0deg..360deg;
        let s = piecewise(theta, [
            (0deg, 0mm), (40deg, 0mm), (rise, lift, modified_sine), (190deg, lift), (back, 0mm, poly345),
            (360deg, 0mm),
        ]);
        let height = base + s;
    }

    impl FlatCam {
        fn cam(theta) -> FlatContact {
            s, first: velocity(s), second: acceleration(s),
            pitch: rotate((0, height), -theta),
            profile: rotate((velocity(s), height), -theta),
            radius: height + acceleration(s),
            sliding: height,
        }
    }
}

/// The same cam in the language, with derivatives and sensitivities.
#[test]
fn quantities_of_the_language_are_those_of_the_cam() {
    let linkage = RollerCam::default().assemble().expect("it has no loop");
    let cam = cam("roller");
    let step = 1e-6;
    let other = |change: fn(&mut RollerCam, f64), by: f64| {
        let mut dimensions = RollerCam::default();
        change(&mut dimensions, by);
        dimensions.assemble().expect("it has no loop")
    };
    let changes: [fn(&mut RollerCam, f64); 4] = [
        |own, by| own.base += by,
        |own, by| own.offset += by,
        |own, by| own.rise += by,
        |own, by| own.lift += by,
    ];
    let beside = changes.map(|change| [step, -step].map(|by| other(change, by)));
    for k in 0..120 {
        let theta = 0.01 + 0.052 * f64::from(k);
        let (own, expected) = (linkage.cam(theta), cam.contact(theta));
        assert!((own.pitch.x - expected.pitch[0]).hypot(own.pitch.y - expected.pitch[1]) < 1e-12);
        assert!(
            (own.profile.x - expected.profile[0]).hypot(own.profile.y - expected.profile[1])
                < 1e-12
        );
        assert!((own.pressure - expected.pressure_angle).abs() < 1e-13);
        assert!((own.curvature - expected.pitch_curvature).abs() < 1e-14);
        assert!((own.sliding - expected.sliding).abs() < 1e-12);
        let accuracy = linkage.accuracy(theta);
        let slope = [step, -step].map(|by| linkage.cam(theta + by).pressure);
        assert!(
            ((slope[0] - slope[1]) / (2.0 * step) - accuracy.slope).abs() < 1e-6,
            "{theta}"
        );
        for (index, [up, down]) in beside.iter().enumerate() {
            let [up, down] = [up, down].map(|own| own.cam(theta));
            let [found, difference] = match index {
                3 => [-accuracy.curvature[0], up.curvature - down.curvature],
                _ => [accuracy.pressure[index], up.pressure - down.pressure],
            };
            assert!(
                (difference / (2.0 * step) - found).abs() < 1e-7,
                "{theta} {index}"
            );
        }
    }
}

#[test]
fn a_swinging_roller_has_thirteen_digits() {
    let linkage = SwingingCam::default().assemble().expect("it has no loop");
    let cam = cam("swinging");
    let mut count = 0;
    for (_, numbers) in references("contact").filter(|own| own.0 == "swinging") {
        let own = linkage.cam(numbers[0].to_radians());
        let found = [
            own.psi,
            own.first,
            own.second,
            own.pitch.x / 40.0,
            own.pitch.y / 40.0,
            own.profile.x / 40.0,
            own.profile.y / 40.0,
            own.pressure,
            own.curvature * 20.0,
        ];
        let scales = [
            1.0,
            1.0,
            1.0,
            40.0,
            40.0,
            40.0,
            40.0,
            1.0_f64.to_degrees(),
            0.05,
        ];
        for (k, (found, scale)) in found.iter().zip(scales).enumerate() {
            let expected = numbers[k + 1] / scale;
            assert!(
                (found - expected).abs() < 1e-13,
                "{} {k}: {found} {expected}",
                numbers[0]
            );
        }
        let radius = own.curvature.recip() - 10.0;
        assert!(
            (radius.recip() - numbers[10].recip()).abs() < 1e-14,
            "{}",
            numbers[0]
        );
        let sliding = cam.contact(numbers[0].to_radians()).sliding;
        assert!((own.sliding - sliding).abs() < 1e-12, "{}", numbers[0]);
        count += 1;
    }
    assert_eq!(count, 12);
}

#[test]
fn a_flat_face_has_thirteen_digits() {
    let [rise, back] = [100.0, 260.0].map(f64::to_radians);
    let fast = FlatCam {
        rise,
        back,
        base: 20.0,
        ..FlatCam::default()
    };
    for (case, dimensions) in [("flat", FlatCam::default()), ("flat_undercut", fast)] {
        let linkage = dimensions.assemble().expect("it has no loop");
        let cam = cam(case);
        let mut count = 0;
        for (_, numbers) in references("contact").filter(|own| own.0 == case) {
            let own = linkage.cam(numbers[0].to_radians());
            let found = [
                own.s,
                own.first,
                own.second,
                own.pitch.x,
                own.pitch.y,
                own.profile.x,
                own.profile.y,
                own.radius,
            ];
            for (k, (found, index)) in found.iter().zip([1, 2, 3, 4, 5, 6, 7, 10]).enumerate() {
                let error = (found - numbers[index]) / numbers[index].abs().max(40.0);
                assert!(error.abs() < 1e-13, "{case} {} {k}: {found}", numbers[0]);
            }
            assert!((own.sliding - cam.contact(numbers[0].to_radians()).sliding).abs() < 1e-13);
            count += 1;
        }
        assert_eq!(count, 12, "{case}");
    }
}
