//! Scissors that a cylinder drives, in the ways in which one writes them: with one angle for both arms in closed form, with an angle for each arm and a
//! slide as a coupled group. By the law of cosines all are one mechanism.

use linkage_interpreted::interpreted;

interpreted! {
    /// Both arms have one angle; the cylinder stands on the foot that slides and pushes a point of the other arm.
    pub struct OneAngle {
        unit mm;
        param arm = 1000mm;
        param eye = (750mm, 60mm);
        input stroke = 560mm in 480mm..740mm;
        unknown tilt = 30deg;
        let foot = (arm * cos(tilt), 0mm);
        let top = polar(arm, tilt);
        loop distance(foot, rotate(eye, tilt)) = stroke;
    }
    impl OneAngle {
        pub fn lift(stroke) -> OneLift { tilt, top, v: velocity(top), a: acceleration(top), s: sensitivity(tilt), m: margin() }
    }
}

interpreted! {
    /// Two arms with a pin between them, and what has to be horizontal follows.
    pub struct TwoAngles {
        unit mm;
        param arm = 1000mm;
        param eye = (750mm, 60mm);
        input stroke = 560mm in 480mm..740mm;
        unknown tilt = 30deg;
        unknown other = 150deg;
        unknown foot = 866mm;
        unknown lean = 110deg;
        unknown shoe = 866mm;
        let top = polar(arm, tilt);
        loop polar(arm / 2, tilt) = (foot, 0mm) + polar(arm / 2, other);
        loop (foot, 0mm) + polar(stroke, lean) = rotate(eye, tilt);
        loop shoe = top.x;
        loop (foot, 0mm) + polar(arm, other) = (0mm, top.y) redundant;
    }
    impl TwoAngles {
        pub fn lift(stroke) -> TwoLift { tilt, top, foot, shoe, v: velocity(top), a: acceleration(top), s: sensitivity(tilt) }
    }
}

interpreted! {
    /// The cylinder stands on the ground.
    pub struct OnGround {
        unit mm;
        param arm = 1000mm;
        input stroke = 500mm in 445mm..700mm;
        unknown tilt = 30deg;
        loop distance((150mm, -50mm), polar(0.6 * arm, tilt)) = stroke;
    }
    impl OnGround {
        pub fn lift(stroke) -> GroundLift { tilt }
    }
}

/// How long the cylinder is.
fn stroke(tilt: f64) -> f64 {
    let (sin, cos) = tilt.sin_cos();
    let x = 750.0 * cos - 60.0 * sin - 1000.0 * cos;
    let y = 750.0 * sin + 60.0 * cos;
    x.hypot(y)
}

#[test]
fn both_ways_of_writing_are_exact_and_one_is_in_closed_form() {
    assert_eq!(
        OneAngle::structure().groups[0].kind,
        "A cos x + B sin x = C"
    );
    assert_eq!(OnGround::structure().groups[0].kind, "RRR");
    assert_eq!(OneAngle::default().assemblies().expect("all").len(), 2);
    let one = OneAngle::default().assemble().expect("it assembles");
    let two = TwoAngles::default().assemble().expect("it assembles");
    for k in 0..=20 {
        // The range of strokes, by the angle.
        let tilt = (30.0 + 1.4 * f64::from(k)).to_radians();
        let long = stroke(tilt);
        let (a, b) = (one.lift(long), two.lift(long));
        // The slope of the stroke, by differences of sixth order.
        let step = 1e-2;
        let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
        let slope: f64 = weights
            .iter()
            .map(|(n, w)| w * (stroke(tilt + n * step) - stroke(tilt - n * step)))
            .sum::<f64>()
            / (60.0 * step);
        for (found, [x, y], v, foot) in [
            (a.tilt, [a.top.x, a.top.y], a.v, a.top.x),
            (b.tilt, [b.top.x, b.top.y], b.v, b.foot),
        ] {
            assert!((found - tilt).abs() < 2e-14, "{tilt}: {found}");
            assert!((x - 1000.0 * tilt.cos()).abs() < 2e-11);
            assert!((y - 1000.0 * tilt.sin()).abs() < 2e-11);
            assert!((foot - 1000.0 * tilt.cos()).abs() < 2e-11);
            assert!((v.y - 1000.0 * tilt.cos() / slope).abs() < 1e-9, "{}", v.y);
        }
        assert!((a.a - b.a).norm() < 1e-11 * a.a.norm());
        assert!((b.shoe - b.foot).abs() < 2e-11);
        for (a, b) in a.s.into_iter().zip(b.s) {
            assert!((a - b).abs() < 1e-12 * a.abs().max(1e-3), "{a} {b}");
        }
        assert!(a.m > 0.1 && a.m <= 1.0);
    }
}

#[test]
fn beyond_its_reach_there_is_no_position() {
    // The eye is 1000 mm from the foot's end of the arm where both arms lie flat or stand.
    let one = OneAngle::default().assemble().expect("it assembles");
    assert!(one.lift(240.0).tilt.is_nan() && one.lift(760.0).tilt.is_nan());
}
